//! What a sample met on its way.

/// A digest of the objects that a path met and of the lights that reached them. Neighbours that differ have an edge of an
/// object, of a mirror image or of a shadow between them; equal ones have none that was seen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Trail(pub u32);

impl Trail {
    /// After an object of this packed name.
    #[inline(always)]
    pub(super) fn after(self, name: u32) -> Self {
        self.digest(name)
    }

    /// After a light of this row that reached it.
    #[inline(always)]
    pub(super) fn lit_by(self, row: usize) -> Self {
        // Rows are far fewer than 2^32; what is cut off would only make two lights look alike.
        self.digest(!u32::try_from(row).unwrap_or(0))
    }

    #[inline(always)]
    fn digest(self, met: u32) -> Self {
        // An odd factor near the golden section spreads neighbouring numbers over all bits.
        Self((self.0 ^ met).wrapping_mul(0x9e37_79b1).rotate_left(13))
    }
}

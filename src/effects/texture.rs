//! Looking up a texture.

use crate::geometry::Real;

/// The texel of an image of `size` texels along one axis that covers position `along` (0 to 1).
#[inline(always)]
pub fn texel_index<T: Real>(along: T, size: u32) -> u32 {
    let index = (along * T::from_u32(size)).to_f64();
    // 1 itself, and whatever rounding makes of the last texel, belongs to the last.
    whole(index).min(size - 1)
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "truncation is the definition, and `as` saturates below 0"
)]
#[inline(always)]
fn whole(index: f64) -> u32 {
    index as u32
}

//! What is seen where there is no surface.

use crate::geometry::{Real, Vector};

use super::Rgb;

/// The colour of directions, from straight down to straight up.
#[derive(Clone, Copy, Debug)]
pub struct Gradient<T> {
    /// Straight down.
    pub below: Rgb<T>,
    /// Straight up.
    pub above: Rgb<T>,
}

impl<T: Real> Gradient<T> {
    /// The colour in a unit direction: in proportion to its height. Where both ends are the same, exactly that.
    #[inline(always)]
    pub fn toward(&self, direction: Vector<T>) -> Rgb<T> {
        let height = (T::ONE + direction.z) / T::TWO;
        let part = |below: T, above: T| below + (above - below) * height;
        Rgb {
            r: part(self.below.r, self.above.r),
            g: part(self.below.g, self.above.g),
            b: part(self.below.b, self.above.b),
        }
    }
}

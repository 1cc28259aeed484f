//! Loss of light within a body.

use crate::geometry::Real;

use super::Rgb;

/// What is left of white light after a way through a body that absorbs, in each channel, this share of it in each unit
/// of a short way: `exp(-absorption * distance)` (the law of Beer and Lambert).
#[inline(always)]
pub fn left_by<T: Real>(absorption: Rgb<T>, distance: T) -> Rgb<T> {
    let left = |absorption: T| (-(absorption * distance)).exp();
    Rgb { r: left(absorption.r), g: left(absorption.g), b: left(absorption.b) }
}

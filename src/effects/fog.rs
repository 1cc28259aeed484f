//! Fog.

use crate::geometry::Real;

use super::Rgb;

/// Fog of the same density everywhere.
#[derive(Clone, Copy, Debug)]
pub struct Haze<T> {
    /// Share of the light that is lost in each unit of a short way, above 0.
    pub density: T,
    /// What takes the place of the light that is lost.
    pub color: Rgb<T>,
}

impl<T: Real> Haze<T> {
    /// The share of the light that is left after a distance: `exp(-density * distance)`.
    #[inline(always)]
    pub fn left_after(&self, distance: T) -> T {
        (-(self.density * distance)).exp()
    }
}

//! Loss of light within a body.

use glam::DVec3;

use crate::components::Absorption;
use crate::components::range::DENSITY;
use crate::geometry::Real;

use super::{Bearer, EffectComponent, Number, Rgb};

impl EffectComponent for Absorption {
    /// Absorption in 1/unit.
    type Row<T: Real> = Rgb<T>;

    fn numbers(&self) -> impl IntoIterator<Item = Number> {
        Number::of_vector("Absorption", self.0, &DENSITY)
    }

    fn does_nothing(&self) -> bool {
        self.0 == DVec3::ZERO
    }

    fn row<T: Real>(&self, bearer: &Bearer<'_>) -> Option<Rgb<T>> {
        let per_unit = self.0.map(|channel| bearer.unit.per_length(channel));
        // Beyond the largest number, absorption times a distance of 0 would be NaN.
        Some(Rgb::from_dvec3(per_unit.min(DVec3::splat(T::MAX.to_f64()))))
    }
}

/// What is left of white light after a way through a body that absorbs, in each channel, this share of it in each unit
/// of a short way: `exp(-absorption * distance)` (the law of Beer and Lambert).
#[inline(always)]
pub fn left_by<T: Real>(absorption: Rgb<T>, distance: T) -> Rgb<T> {
    let left = |absorption: T| (-(absorption * distance)).exp();
    Rgb { r: left(absorption.r), g: left(absorption.g), b: left(absorption.b) }
}

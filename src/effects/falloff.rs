//! Loss of light over distance.

use crate::components::Falloff;
use crate::components::range::FALLOFF;
use crate::geometry::Real;

use super::{Bearer, EffectComponent, Number};

impl EffectComponent for Falloff {
    /// Falloff in 1/unit^2.
    type Row<T: Real> = T;

    fn numbers(&self) -> impl IntoIterator<Item = Number> {
        [Number::new("Falloff", self.0, &FALLOFF)]
    }

    fn does_nothing(&self) -> bool {
        self.0 == 0.0
    }

    fn row<T: Real>(&self, bearer: &Bearer<'_>) -> Option<T> {
        // Beyond the largest number, falloff times a distance of 0 would be NaN.
        Some(T::from_f64(bearer.unit.per_area(self.0)).at_most(T::MAX))
    }
}

/// `exp(-distance^2 * falloff)`, for a squared distance and a falloff >= 0 in 1/unit^2: 1 near the light, exactly
/// 0 far beyond it.
#[inline(always)]
pub fn attenuation<T: Real>(distance_squared: T, falloff: T) -> T {
    (-(distance_squared * falloff)).exp()
}

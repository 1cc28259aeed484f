//! Fog.

use crate::components::Fog;
use crate::components::range::{COLOR, DENSITY};
use crate::geometry::Real;

use super::{Bearer, EffectComponent, Number, Rgb};

impl EffectComponent for Fog {
    type Row<T: Real> = Haze<T>;

    fn numbers(&self) -> impl IntoIterator<Item = Number> {
        let color = Number::of_vector("Fog.color", self.color, &COLOR);
        [Number::new("Fog.density", self.density, &DENSITY)].into_iter().chain(color)
    }

    fn does_nothing(&self) -> bool {
        self.density == 0.0
    }

    fn row<T: Real>(&self, bearer: &Bearer<'_>) -> Option<Haze<T>> {
        // Beyond the largest number, the density times a distance of 0 would be NaN.
        let density = T::from_f64(bearer.unit.per_length(self.density)).at_most(T::MAX);
        Some(Haze { density, color: Rgb::from_dvec3(self.color) })
    }
}

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

//! How much light counts.

use crate::components::ExposureStops;
use crate::components::range::STOPS;
use crate::geometry::Real;

use super::{Bearer, EffectComponent, Number};

impl EffectComponent for ExposureStops {
    type Row<T: Real> = Self;

    fn numbers(&self) -> impl IntoIterator<Item = Number> {
        [Number::new("ExposureStops", self.0, &STOPS)]
    }

    fn does_nothing(&self) -> bool {
        self.0 == 0.0
    }

    fn row<T: Real>(&self, _bearer: &Bearer<'_>) -> Option<Self> {
        Some(*self)
    }
}

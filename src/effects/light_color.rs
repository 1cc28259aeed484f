//! Colours of lights.

use glam::DVec3;

use crate::components::LightColor;
use crate::components::range::LIGHT_COLOR;
use crate::geometry::Real;

use super::{Bearer, EffectComponent, Number, Rgb};

impl EffectComponent for LightColor {
    type Row<T: Real> = Rgb<T>;

    fn numbers(&self) -> impl IntoIterator<Item = Number> {
        Number::of_vector("LightColor", self.0, &LIGHT_COLOR)
    }

    fn does_nothing(&self) -> bool {
        self.0 == DVec3::ONE
    }

    fn row<T: Real>(&self, _bearer: &Bearer<'_>) -> Option<Rgb<T>> {
        Some(Rgb::from_dvec3(self.0))
    }
}

//! Parallel light.

use crate::components::Directional;
use crate::components::range::COORDINATE;
use crate::geometry::{Real, Vector};

use super::{Bearer, EffectComponent, Number};

impl EffectComponent for Directional {
    /// Against the light, unit.
    type Row<T: Real> = Vector<T>;

    fn numbers(&self) -> impl IntoIterator<Item = Number> {
        Number::of_vector("Directional.direction", self.direction, &COORDINATE)
    }

    fn does_nothing(&self) -> bool {
        false
    }

    fn row<T: Real>(&self, _bearer: &Bearer<'_>) -> Option<Vector<T>> {
        // In double first: in single its squares, or even itself, could underflow.
        let unit = Vector::<f64>::from_dvec3(-self.direction).unit();
        Some(Vector::<T>::from_dvec3(unit.to_dvec3()).unit())
    }
}

//! Mirror reflection.

use crate::components::Mirror;
use crate::components::range::COEFFICIENT;
use crate::geometry::{Real, Vector};

use super::{Bearer, EffectComponent, Number};

impl EffectComponent for Mirror {
    /// Reflectance.
    type Row<T: Real> = T;

    fn numbers(&self) -> impl IntoIterator<Item = Number> {
        [Number::new("Mirror", self.0, &COEFFICIENT)]
    }

    fn does_nothing(&self) -> bool {
        self.0 == 0.0
    }

    fn row<T: Real>(&self, _bearer: &Bearer<'_>) -> Option<T> {
        Some(T::from_f64(self.0))
    }
}

/// The unit direction in which a ray of unit `direction` goes on after a mirror with unit `normal`.
#[inline(always)]
pub fn reflect<T: Real>(direction: Vector<T>, normal: Vector<T>) -> Vector<T> {
    (direction - normal * (T::TWO * direction.dot(normal))).unit()
}

/// [`reflect`], bit for bit and without branches: unit vectors give no short one.
#[inline(always)]
pub fn reflect_long<T: Real>(direction: Vector<T>, normal: Vector<T>) -> Vector<T> {
    (direction - normal * (T::TWO * direction.dot(normal))).unit_of_long()
}

//! Mirror reflection.

use crate::geometry::{Real, Vector};

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

//! Diffuse reflection.

use crate::geometry::{Real, Vector};

/// Lambert's cosine of a light in direction `to_light` (unit) on a surface with unit `normal`; the light counts
/// only where this is above 0.
#[inline(always)]
pub fn lambert<T: Real>(to_light: Vector<T>, normal: Vector<T>) -> T {
    to_light.dot(normal)
}

//! The cone of a spotlight.

use crate::geometry::{Real, Vector};

/// A cone around `axis` (unit, away from the light) that lights all directions within its cutoff angle, the angle
/// itself included.
#[derive(Clone, Copy, Debug)]
pub struct Cone<T> {
    axis: Vector<T>,
    sine: T,
    cosine: T,
}

impl<T: Real> Cone<T> {
    /// A cone around a vector that is not zero, with a cutoff of 0 to 180 degrees between axis and side.
    pub fn new(axis: Vector<T>, cutoff_degrees: f64) -> Self {
        let (sine, cosine) = sin_cos_degrees(cutoff_degrees);
        Self { axis: axis.unit(), sine: T::from_f64(sine), cosine: T::from_f64(cosine) }
    }

    /// Whether a point lies in the cone, given the vector (of any length) from the light to it.
    ///
    /// `acos` of a dot product is useless for narrow cones and NaN when rounding takes the product above 1. With
    /// the sine from the cross product, `angle <= cutoff` is `sin(angle - cutoff) <= 0`, which takes no inverse
    /// function at all and is well conditioned everywhere (W. Kahan on angles between vectors).
    #[inline(always)]
    pub fn contains(&self, from_light: Vector<T>) -> bool {
        let along = self.axis.dot(from_light);
        let across = self.axis.cross(from_light).length();
        // sin(angle - cutoff) is 0 at angle 180 and cutoff 0, too: a cone below 90 degrees lights nothing behind.
        across * self.cosine <= along * self.sine && (self.cosine <= T::ZERO || along > T::ZERO)
    }
}

/// Sine and cosine, exact at 0, 90 and 180 degrees.
fn sin_cos_degrees(degrees: f64) -> (f64, f64) {
    let radians = f64::to_radians;
    if degrees <= 45.0 {
        (libm::sin(radians(degrees)), libm::cos(radians(degrees)))
    } else if degrees <= 135.0 {
        (libm::cos(radians(90.0 - degrees)), libm::sin(radians(90.0 - degrees)))
    } else {
        (libm::sin(radians(180.0 - degrees)), -libm::cos(radians(180.0 - degrees)))
    }
}

//! The cone of a spotlight.

use core::f64::consts::FRAC_1_SQRT_2;

use glam::DVec3;

use crate::components::SpotCone;
use crate::components::range::{COORDINATE, CUTOFF};
use crate::geometry::{Real, Vector};

use super::{Bearer, EffectComponent, Number};

impl EffectComponent for SpotCone {
    type Row<T: Real> = Cone<T>;

    fn numbers(&self) -> impl IntoIterator<Item = Number> {
        let target = Number::of_vector("SpotCone.target", self.target, &COORDINATE);
        target.into_iter().chain([Number::new("SpotCone.cutoff", self.cutoff, &CUTOFF)])
    }

    fn does_nothing(&self) -> bool {
        self.cutoff == 180.0
    }

    fn row<T: Real>(&self, bearer: &Bearer<'_>) -> Option<Cone<T>> {
        Some(Cone::new(cone_axis(bearer.position, bearer.unit.point(self.target)), self.cutoff))
    }
}

/// From a light to the point that its cone's axis runs through.
pub fn cone_axis<T: Real>(light: DVec3, target: DVec3) -> Vector<T> {
    Vector::from_dvec3(target) - Vector::from_dvec3(light)
}

/// A cone around `axis` (of any length, away from the light) that lights all directions within its cutoff angle, the angle
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
        let axis = axis.to_dvec3();
        // Saturating: the exponent of zero or NaN, which the systems report and never trace, is the least integer.
        let unit = libm::ldexp(1.0, 0_i32.saturating_sub(libm::ilogb(axis.abs().max_element())));
        Self { axis: Vector::from_dvec3(axis * unit), sine: T::from_f64(sine), cosine: T::from_f64(cosine) }
    }

    /// Whether a point lies in the cone, given the vector (of any length) from the light to it.
    ///
    /// `acos` of a dot product is useless for narrow cones and NaN when rounding takes the product above 1. With
    /// the sine from the cross product, `angle <= cutoff` is `sin(angle - cutoff) <= 0`, which takes no inverse
    /// function at all and is well conditioned everywhere (W. Kahan on angles between vectors). Neither vector is
    /// normalised, the axis only scaled by a power of two: the product of a vector with itself is then exactly 0, and
    /// even cutoff 0 lights its target.
    #[inline(always)]
    pub fn contains(&self, from_light: Vector<T>) -> bool {
        let along = self.axis.dot(from_light);
        let across = self.axis.cross(from_light).length();
        // sin(angle - cutoff) is 0 at angle 180 and cutoff 0, too: a cone below 90 degrees lights nothing behind.
        across * self.cosine <= along * self.sine && (self.cosine <= T::ZERO || along > T::ZERO)
    }
}

/// Sine and cosine of 0 to 180 degrees, exact at multiples of 90 and equal in magnitude at 45 and 135.
fn sin_cos_degrees(degrees: f64) -> (f64, f64) {
    if degrees <= 45.0 {
        sin_cos_octant(degrees)
    } else if degrees <= 135.0 {
        let (sine, cosine) = sin_cos_octant((90.0 - degrees).abs());
        (cosine, sine.copysign(90.0 - degrees))
    } else {
        let (sine, cosine) = sin_cos_octant(180.0 - degrees);
        (sine, -cosine)
    }
}

/// Sine and cosine of 0 to 45 degrees.
fn sin_cos_octant(degrees: f64) -> (f64, f64) {
    if degrees == 45.0 {
        return (FRAC_1_SQRT_2, FRAC_1_SQRT_2);
    }
    let radians = degrees.to_radians();
    (libm::sin(radians), libm::cos(radians))
}

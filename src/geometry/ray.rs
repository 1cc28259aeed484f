//! Rays, crossings, and what every convex shape can answer.

use super::{Real, Vector};

/// A half-line `origin + t * direction`, `t > 0`. The direction is never zero; it need not have length 1.
#[derive(Clone, Copy, Debug)]
pub struct Ray<T> {
    /// Where `t = 0` lies.
    pub origin: Vector<T>,
    /// The step for `t = 1`, in world units.
    pub direction: Vector<T>,
}

impl<T: Real> Ray<T> {
    /// The point at parameter `t`.
    #[inline(always)]
    pub fn at(&self, t: T) -> Vector<T> {
        self.origin + self.direction * t
    }

    /// The same ray in double precision.
    pub(super) fn in_double(&self) -> Ray<f64> {
        Ray { origin: self.origin.in_double(), direction: self.direction.in_double() }
    }
}

/// From which side of a boundary a ray arrives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// From the open space around the body: the ray enters.
    Outside,
    /// From within the body: the ray leaves.
    Inside,
}

/// Where a ray crosses the boundary of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing<T> {
    /// Ray parameter, finite and above 0 (0 itself only from [`Convex::exit`]).
    pub t: T,
    /// Which face, by the shape's own numbering; 0 where there is one only.
    pub face: u8,
    /// The side the ray comes from.
    pub side: Side,
}

/// A point on a boundary, snapped onto it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint<T> {
    /// World position; on its face as exactly as the precision can say.
    pub point: Vector<T>,
    /// Unit normal, pointing out of the body.
    pub normal: Vector<T>,
}

/// A closed convex body: the only kind of shape there is, see the room's own page for why.
pub trait Convex<T: Real>: Copy {
    /// The first crossing at `t > 0`, or `None`. Touching counts: the body is a closed set.
    fn intersect(&self, ray: &Ray<T>) -> Option<Crossing<T>>;

    /// Where a ray leaves that starts on face `from` and heads into the body: it always does, at `t >= 0`.
    fn exit(&self, ray: &Ray<T>, from: u8) -> Crossing<T>;

    /// The surface point of a crossing that this ray was found to have.
    fn locate(&self, ray: &Ray<T>, crossing: &Crossing<T>) -> SurfacePoint<T>;
}

//! The horizontal plane.

use super::{Meeting, Straight};
use crate::geometry::{PlaneShape, Ray, Real, SurfacePoint, Vector};

impl<T: Real> Straight<T> for PlaneShape<T> {
    #[inline(always)]
    fn may_meet(&self, ray: &Ray<T>) -> bool {
        // The quotient is above 0 only where its parts have the same sign. Few rays run towards a floor, and shadow rays
        // hardly ever: this saves them the division.
        let (room, rise) = (self.height - ray.origin.z, ray.direction.z);
        ((room > T::ZERO) & (rise > T::ZERO)) | ((room < T::ZERO) & (rise < T::ZERO))
    }

    #[inline(always)]
    fn meet(&self, ray: &Ray<T>) -> Meeting<T> {
        let t = (self.height - ray.origin.z) / ray.direction.z;
        let meets = (t > T::ZERO) & (t < T::INFINITY);
        Meeting { t: if meets { t } else { T::NAN }, face: 0, inside: false, unsure: false }
    }

    #[inline(always)]
    fn surface(&self, ray: &Ray<T>, meeting: &Meeting<T>) -> SurfacePoint<T> {
        let at = ray.at(meeting.t);
        let up = if ray.direction.z > T::ZERO { -T::ONE } else { T::ONE };
        SurfacePoint {
            point: Vector::new(at.x, at.y, self.height),
            normal: Vector::new(T::ZERO, T::ZERO, up),
        }
    }
}

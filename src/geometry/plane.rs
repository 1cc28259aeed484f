//! The horizontal plane that the checkerboard lies in.

use super::{Convex, Crossing, Ray, Real, Side, SurfacePoint, Vector};

/// The plane at one height, without thickness: a ray leaves it on the side it came from.
#[derive(Clone, Copy, Debug)]
pub struct PlaneShape<T> {
    /// The plane's z.
    pub height: T,
}

impl<T: Real> Convex<T> for PlaneShape<T> {
    #[inline(always)]
    fn intersect(&self, ray: &Ray<T>) -> Option<Crossing<T>> {
        // The same true division as a cube's face: coplanar faces then tie exactly and a key can decide.
        let t = (self.height - ray.origin.z) / ray.direction.z;
        // 0/0 within the plane is NaN and compares false; x/0 is infinite.
        (t > T::ZERO && t.is_finite()).then_some(Crossing { t, face: 0, side: Side::Outside })
    }

    /// There is no inside to leave; by the contract of [`Convex::exit`] this is the start itself.
    fn exit(&self, _ray: &Ray<T>, _from: u8) -> Crossing<T> {
        Crossing { t: T::ZERO, face: 0, side: Side::Outside }
    }

    #[inline(always)]
    fn locate(&self, ray: &Ray<T>, crossing: &Crossing<T>) -> SurfacePoint<T> {
        let mut point = ray.at(crossing.t);
        point.z = self.height;
        let up = if ray.direction.z > T::ZERO { -T::ONE } else { T::ONE };
        SurfacePoint { point, normal: Vector::new(T::ZERO, T::ZERO, up) }
    }
}

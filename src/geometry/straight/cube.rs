//! The cube.

use super::{Meeting, Span, Straight};
use crate::geometry::clip::is_close;
use crate::geometry::{CubeShape, Ray, Real, SurfacePoint, Vector};

impl<T: Real> CubeShape<T> {
    #[inline(always)]
    fn cut(span: &mut Span<T>, [low, high]: [T; 2], direction: T, [low_face, high_face]: [u32; 2]) {
        let forwards = direction > T::ZERO;
        let is_parallel = !(forwards | (direction < T::ZERO));
        let near = (if forwards { low } else { high }) / direction;
        let far = (if forwards { high } else { low }) / direction;
        let near_face = if forwards { low_face } else { high_face };
        let far_face = if forwards { high_face } else { low_face };
        span.enter_at(if is_parallel { -T::INFINITY } else { near }, near_face);
        span.leave_at(if is_parallel { T::INFINITY } else { far }, far_face);
        span.outside |= is_parallel & ((low > T::ZERO) | (high < T::ZERO));
    }
}

impl<T: Real> Straight<T> for CubeShape<T> {
    #[inline(always)]
    fn may_meet(&self, _ray: &Ray<T>) -> bool {
        true
    }

    #[inline(always)]
    fn meet(&self, ray: &Ray<T>) -> Meeting<T> {
        let mut span = Span::whole();
        let low = self.min - ray.origin;
        let high = self.max - ray.origin;
        Self::cut(&mut span, [low.x, high.x], ray.direction.x, [0, 1]);
        Self::cut(&mut span, [low.y, high.y], ray.direction.y, [2, 3]);
        Self::cut(&mut span, [low.z, high.z], ray.direction.z, [4, 5]);
        span.first_ahead(is_close(span.enter, span.leave) & !span.outside)
    }

    #[inline(always)]
    fn surface(&self, ray: &Ray<T>, meeting: &Meeting<T>) -> SurfacePoint<T> {
        let at = ray.at(meeting.t).clamp(self.min, self.max);
        let is_high = meeting.face & 1 == 1;
        let axis = meeting.face >> 1;
        let sign = if is_high { T::ONE } else { -T::ONE };
        let on = |own: u32, low: T, high: T, free: T| {
            let face = if is_high { high } else { low };
            (if axis == own { face } else { free }, if axis == own { sign } else { T::ZERO })
        };
        let (x, normal_x) = on(0, self.min.x, self.max.x, at.x);
        let (y, normal_y) = on(1, self.min.y, self.max.y, at.y);
        let (z, normal_z) = on(2, self.min.z, self.max.z, at.z);
        SurfacePoint { point: Vector::new(x, y, z), normal: Vector::new(normal_x, normal_y, normal_z) }
    }
}

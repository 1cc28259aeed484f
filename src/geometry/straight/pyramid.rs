//! The pyramid.

use super::{Meeting, Span, Straight};
use crate::geometry::pyramid::{BASE, across, is_certain, least};
use crate::geometry::{PyramidShape, Ray, Real, SurfacePoint, Vector};

impl<T: Real> PyramidShape<T> {
    #[inline(always)]
    fn cut(span: &mut Span<T>, room: T, slope: T, face: u32) {
        // A slope of 0 is in no hurry: what it leads to is unsure.
        let t = room / slope;
        let enters = slope < T::ZERO;
        span.enter_at(if enters { t } else { -T::INFINITY }, face);
        span.leave_at(if enters { T::INFINITY } else { t }, face);
    }

    /// The half-space above the base, to which level rays are parallel.
    #[inline(always)]
    fn cut_base(&self, span: &mut Span<T>, ray: &Ray<T>) {
        let (room, slope) = (ray.origin.z - self.base, -ray.direction.z);
        let t = room / slope;
        let enters = slope < T::ZERO;
        let leaves = slope > T::ZERO;
        span.enter_at(if enters { t } else { -T::INFINITY }, BASE.into());
        span.leave_at(if leaves { t } else { T::INFINITY }, BASE.into());
        span.outside |= !enters & !leaves & (room < T::ZERO);
    }

    /// The normal of a face; `face` 0 to 3 by the axis and direction it looks in.
    #[inline(always)]
    fn straight_normal(&self, face: u32) -> Vector<T> {
        // All side faces lean alike: one root and two quotients do for every ray.
        let side = Vector::new(self.height, T::ZERO, self.half_width).unit_of_long();
        let out = if face & 1 == 1 { side.x } else { -side.x };
        let is_base = face == u32::from(BASE);
        Vector::new(
            if face < 2 { out } else { T::ZERO },
            if (face < 2) | is_base { T::ZERO } else { out },
            if is_base { -T::ONE } else { side.z },
        )
    }
}

impl<T: Real> Straight<T> for PyramidShape<T> {
    #[inline(always)]
    fn may_meet(&self, _ray: &Ray<T>) -> bool {
        true
    }

    #[inline(always)]
    fn meet(&self, ray: &Ray<T>) -> Meeting<T> {
        let mut span = Span::whole();
        let (room, slope) = (self.products(self.apex - ray.origin), self.products(ray.direction));
        let ([room_0, room_1, room_2, room_3], [slope_0, slope_1, slope_2, slope_3]) =
            (across(room), across(slope));
        Self::cut(&mut span, room_0, slope_0, 0);
        Self::cut(&mut span, room_1, slope_1, 1);
        Self::cut(&mut span, room_2, slope_2, 2);
        Self::cut(&mut span, room_3, slope_3, 3);
        self.cut_base(&mut span, ray);
        let is_certain = is_certain(room, slope, least(slope), [span.enter, span.leave]);
        let meeting = span.first_ahead(!is_certain & !span.outside);
        // Few rays start within, and of those the kernel with branches tells whether they leave from a face.
        let starts_within = meeting.inside & (meeting.t > T::ZERO);
        Meeting {
            t: if starts_within { T::NAN } else { meeting.t },
            unsure: meeting.unsure | starts_within,
            ..meeting
        }
    }

    #[inline(always)]
    fn surface(&self, ray: &Ray<T>, meeting: &Meeting<T>) -> SurfacePoint<T> {
        let normal = self.straight_normal(meeting.face);
        let at = ray.at(meeting.t);
        let on_side = at - normal * (at - self.apex).dot(normal);
        let side_z = on_side.z.at_least(self.base).at_most(self.apex.z);
        let is_base = meeting.face == u32::from(BASE);
        let point = Vector::new(
            if is_base { at.x } else { on_side.x },
            if is_base { at.y } else { on_side.y },
            if is_base { self.base } else { side_z },
        );
        SurfacePoint { point, normal }
    }
}

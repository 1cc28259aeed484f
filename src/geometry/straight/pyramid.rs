//! The pyramid.

use super::{Meeting, Span, Straight};
use crate::geometry::pyramid::{BASE, SIDES};
use crate::geometry::{PyramidShape, Ray, Real, SurfacePoint, Vector};

impl<T: Real> PyramidShape<T> {
    #[inline(always)]
    fn cut(span: &mut Span<T>, room: T, slope: T, face: u32) {
        let t = room / slope;
        let enters = slope < T::ZERO;
        let leaves = slope > T::ZERO;
        span.enter_at(if enters { t } else { -T::INFINITY }, face);
        span.leave_at(if leaves { t } else { T::INFINITY }, face);
        span.outside |= !enters & !leaves & (room < T::ZERO);
    }

    /// How far from the plane of a side face looking along x (or y) rounding may have put the ray's origin.
    #[inline(always)]
    fn side_rounding(&self, ray: &Ray<T>, along_x: bool) -> T {
        let sideways = if along_x {
            self.apex.x.abs() + ray.origin.x.abs()
        } else {
            self.apex.y.abs() + ray.origin.y.abs()
        };
        let upwards = self.apex.z.abs() + ray.origin.z.abs();
        let four = T::TWO * T::TWO;
        four * T::ULP * (self.height * sideways + self.half_width * upwards)
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
        let to_apex = self.apex - ray.origin;
        let (room_0, slope_0) = self.side(ray, to_apex, SIDES[0]);
        let (room_1, slope_1) = self.side(ray, to_apex, SIDES[1]);
        let (room_2, slope_2) = self.side(ray, to_apex, SIDES[2]);
        let (room_3, slope_3) = self.side(ray, to_apex, SIDES[3]);
        Self::cut(&mut span, room_0, slope_0, 0);
        Self::cut(&mut span, room_1, slope_1, 1);
        Self::cut(&mut span, room_2, slope_2, 2);
        Self::cut(&mut span, room_3, slope_3, 3);
        Self::cut(&mut span, ray.origin.z - self.base, -ray.direction.z, u32::from(BASE));
        let meeting = span.first_ahead();
        let low_room = if meeting.face == 0 { room_0 } else { room_1 };
        let high_room = if meeting.face == 2 { room_2 } else { room_3 };
        let along_x = meeting.face < 2;
        let room = if along_x { low_room } else { high_room };
        let is_side = meeting.face < u32::from(BASE);
        let leaves = meeting.inside & is_side & (room <= self.side_rounding(ray, along_x));
        let unsure = meeting.unsure | self.is_along_side(ray, [slope_0, slope_1, slope_2, slope_3]);
        Meeting { t: if leaves | unsure { T::NAN } else { meeting.t }, unsure, ..meeting }
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

//! The sphere.

use super::{Meeting, Straight};
use crate::geometry::compensated::square_excess;
use crate::geometry::{Ray, Real, SphereShape, SurfacePoint};

impl<T: Real> Straight<T> for SphereShape<T> {
    #[inline(always)]
    fn may_meet(&self, ray: &Ray<T>) -> bool {
        // The distance of the line, squared and times `a`, without the chord's root and quotient. Both sides are sums of
        // a few products, and the chord is right to a few units in the last place of the offset: 32 are allowed for all
        // of them. What underflows is far below the floor.
        let offset = ray.origin - self.center;
        let (a, h) = (ray.direction.dot(ray.direction), offset.dot(ray.direction));
        let square = offset.dot(offset);
        let room = self.radius * self.radius + square * (T::from_u32(32) * T::ULP);
        let passes_by = square * a - h * h > room * a + T::SQUARE_FLOOR;
        !passes_by
    }

    #[inline(always)]
    fn may_meet_before(&self, ray: &Ray<T>, inverse_length: T, inverse_square: T, reach: T) -> bool {
        let offset = self.center - ray.origin;
        let along = offset.dot(ray.direction) * inverse_square;
        let across = offset - ray.direction * along;
        let size = (offset.x.abs() + offset.y.abs()) + offset.z.abs();
        let radius = self.radius + size * (T::from_u32(16) * T::ULP);
        let half = radius * inverse_length;
        let passes_by = across.dot(across) > radius * radius;
        !(passes_by | (along + half < T::ZERO) | (along - half > reach))
    }

    #[inline(always)]
    fn meet(&self, ray: &Ray<T>) -> Meeting<T> {
        let chord = self.chord(ray);
        let c = square_excess(chord.offset, chord.offset_error, self.radius);
        let leaves = (chord.h < T::ZERO) & (c < T::ZERO) & (-c <= self.surface_rounding());
        let q = chord.h + chord.discriminant(c, self.radius).sqrt().copysign(chord.h);
        let (c_root, q_root) = (c / q, q / chord.a);
        let ahead = chord.h > T::ZERO;
        let near = if ahead { c_root } else { q_root };
        let far = if ahead { q_root } else { c_root };
        let outside = near > T::ZERO;
        let t = if outside { near } else { far };
        let passes_by = chord.half_squared < T::ZERO;
        let meets = !leaves & !passes_by & (t > T::ZERO) & (t < T::INFINITY);
        Meeting { t: if meets { t } else { T::NAN }, face: 0, inside: !outside, unsure: false }
    }

    #[inline(always)]
    fn surface(&self, ray: &Ray<T>, meeting: &Meeting<T>) -> SurfacePoint<T> {
        let chord = self.chord(ray);
        let half = (chord.half_squared.at_least(T::ZERO) / chord.a).sqrt();
        let along = if meeting.inside { half } else { -half };
        let normal = (chord.middle + ray.direction * along).unit_of_long();
        SurfacePoint { point: self.center + normal * self.radius, normal }
    }
}

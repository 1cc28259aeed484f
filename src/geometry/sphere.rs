//! The sphere: stable from a pebble at the horizon to a planet under one's feet.

use super::compensated::{square_excess, two_diff_vector};
use super::{Convex, Crossing, Ray, Real, Side, SurfacePoint, Vector};

/// A closed ball.
#[derive(Clone, Copy, Debug)]
pub struct SphereShape<T> {
    /// Centre.
    pub center: Vector<T>,
    /// Radius, above 0.
    pub radius: T,
}

/// The chord that a line cuts out of a ball, with `t = 0` at the ray's origin.
pub(super) struct Chord<T> {
    /// Origin relative to the centre, and what rounding took from it.
    pub(super) offset: Vector<T>,
    pub(super) offset_error: Vector<T>,
    /// Squared length of the direction.
    pub(super) a: T,
    /// `a` times the parameter of the chord's middle.
    pub(super) h: T,
    /// The chord's middle relative to the centre.
    pub(super) middle: Vector<T>,
    /// Squared half chord, in world units; negative where the line misses.
    pub(super) half_squared: T,
}

impl<T: Real> Chord<T> {
    /// The square of `a` times half the chord's length in steps of `t`, for a line that hits; `c` is `|offset|^2 - r^2`.
    ///
    /// From afar `h^2` and `a c` nearly cancel and the perpendicular form is right; near the surface, or from inside,
    /// they do not, and the error of `h` is all that counts. The two are about equally good where the way to the
    /// middle, squared, is a third of `|offset|^2`.
    #[inline(always)]
    pub(super) fn discriminant(&self, c: T, radius: T) -> T {
        let h_squared = self.h * self.h;
        let is_near = T::from_u32(3) * h_squared < self.a * (c + radius * radius);
        if is_near { h_squared - self.a * c } else { self.a * self.half_squared }
    }
}

impl<T: Real> SphereShape<T> {
    /// How far below 0 rounding alone can bring `|o - c|^2 - r^2` for a point on the surface, as
    /// [`locate`](Convex::locate) gives it: half a unit in the last place of each coordinate and three of the normal.
    #[inline(always)]
    pub(super) fn surface_rounding(&self) -> T {
        let center = self.center.x.abs() + self.center.y.abs() + self.center.z.abs();
        let four = T::TWO * T::TWO;
        T::TWO * self.radius * T::ULP * (center + four * self.radius)
    }

    #[inline(always)]
    pub(super) fn chord(&self, ray: &Ray<T>) -> Chord<T> {
        let direction = ray.direction;
        let (offset, offset_error) = two_diff_vector(ray.origin, self.center);
        let a = direction.dot(direction);
        let h = -(offset.dot(direction) + offset_error.dot(direction));
        // The middle is the part of the offset perpendicular to the ray. What rounding leaves along the ray adds to
        // the square of its length only in second order; projecting once more was measured to improve nothing. What
        // rounding took from the offset is added last, when the rest has become small.
        let middle = (offset + direction * (h / a)) + offset_error;
        // r^2 - |m|^2 in factored form: the difference is formed before anything is squared (Haines, Ray Tracing
        // Gems, chapter 7, has the perpendicular form).
        let distance = middle.length();
        let half_squared = (self.radius - distance) * (self.radius + distance);
        Chord { offset, offset_error, a, h, middle, half_squared }
    }
}

impl<T: Real> Convex<T> for SphereShape<T> {
    /// Textbook `b^2 - 4ac` loses all digits when the sphere is small and far; the perpendicular form alone loses
    /// them when it is huge and near. Here each is used where it is the better one, `c` is compensated, and the two
    /// roots come from `q` without cancellation: both ends keep `t` to a few units in the last place.
    #[inline(always)]
    fn intersect(&self, ray: &Ray<T>) -> Option<Crossing<T>> {
        // 1. The chord; a negative square means that the line passes by.
        let chord = self.chord(ray);
        if chord.half_squared < T::ZERO {
            return None;
        }
        // 2. c = |offset|^2 - r^2 tells inside from outside and is the product of the roots times a.
        let c = square_excess(chord.offset, chord.offset_error, self.radius);
        // A ray that leaves from a point on the surface does not meet it, whichever way the point was rounded: it may
        // have been found on a twin of this ball.
        if chord.h < T::ZERO && c < T::ZERO && -c <= self.surface_rounding() {
            return None;
        }
        // 3. q has the larger magnitude of the two numerators, so nothing cancels in it.
        let q = chord.h + chord.discriminant(c, self.radius).sqrt().copysign(chord.h);
        let (near, far) = if chord.h > T::ZERO { (c / q, q / chord.a) } else { (q / chord.a, c / q) };
        // 4. The first root ahead. A quotient 0/0 (tangent at the origin itself) compares false: no crossing.
        let (t, side) = if near > T::ZERO { (near, Side::Outside) } else { (far, Side::Inside) };
        (t > T::ZERO && t.is_finite()).then_some(Crossing { t, face: 0, side })
    }

    #[inline(always)]
    fn exit(&self, ray: &Ray<T>, _from: u8) -> Crossing<T> {
        // The origin is a root already, so the other one is twice the way to the chord's middle.
        let chord = self.chord(ray);
        let t = (T::TWO * chord.h / chord.a).at_least(T::ZERO);
        Crossing { t, face: 0, side: Side::Inside }
    }

    #[inline(always)]
    fn locate(&self, ray: &Ray<T>, crossing: &Crossing<T>) -> SurfacePoint<T> {
        // From quantities relative to the centre; subtracting the centre from a world point would lose digits.
        let chord = self.chord(ray);
        let half = (chord.half_squared.at_least(T::ZERO) / chord.a).sqrt();
        let along = match crossing.side {
            Side::Outside => -half,
            Side::Inside => half,
        };
        let normal = (chord.middle + ray.direction * along).unit();
        SurfacePoint { point: self.center + normal * self.radius, normal }
    }
}

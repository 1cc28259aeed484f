//! The square pyramid as the meeting of five half-spaces.

use glam::DVec3;

use super::clip::Span;
use super::{Convex, Crossing, Ray, Real, Side, SurfacePoint, Vector};

/// A closed pyramid on a square base parallel to the xy plane, apex above its middle.
/// Faces: 0 and 1 look towards -x and +x, 2 and 3 towards -y and +y, 4 is the base.
#[derive(Clone, Copy, Debug)]
pub struct PyramidShape<T> {
    /// Tip.
    pub apex: Vector<T>,
    /// The base's z.
    pub base: T,
    /// Half the width of the base.
    pub half_width: T,
    /// Height of the tip above the base.
    pub height: T,
}

pub(super) const BASE: u8 = 4;
/// Axis and direction in which a side face looks.
pub(super) const SIDES: [(usize, bool); 4] = [(0, false), (0, true), (1, false), (1, true)];

impl<T: Real> PyramidShape<T> {
    /// The pyramid whose base has its least corner at `corner` and extends by `width` along x and y; the apex is
    /// `height` above the base's middle.
    pub fn new(corner: DVec3, width: f64, height: f64) -> Self {
        let half_width = 0.5 * width;
        Self {
            apex: Vector::from_dvec3(corner + DVec3::new(half_width, half_width, height)),
            base: T::from_f64(corner.z),
            half_width: T::from_f64(half_width),
            height: T::from_f64(height),
        }
    }

    /// Half-space `t * slope <= room` of a side face. The offset is taken from the apex, and the normal
    /// `(height, half width)` is not normalised: both are exact for exact inputs.
    #[inline(always)]
    pub(super) fn side(&self, ray: &Ray<T>, to_apex: Vector<T>, (axis, positive): (usize, bool)) -> (T, T) {
        let out = if positive { self.height } else { -self.height };
        let room = out * to_apex[axis] + self.half_width * to_apex.z;
        let slope = out * ray.direction[axis] + self.half_width * ray.direction.z;
        (room, slope)
    }

    /// Whether the origin of a ray is in the plane of a side face as nearly as rounding allows: that of the point
    /// itself, a few units in the last place of each coordinate, and that of its offset from the apex.
    #[cold]
    fn is_on_side(&self, ray: &Ray<T>, to_apex: Vector<T>, face: u8) -> bool {
        let Some(&(axis, positive)) = SIDES.get(usize::from(face)) else { return false };
        let (room, _) = self.side(ray, to_apex, (axis, positive));
        let sideways = self.apex[axis].abs() + ray.origin[axis].abs();
        let upwards = self.apex.z.abs() + ray.origin.z.abs();
        let four = T::TWO * T::TWO;
        room <= four * T::ULP * (self.height * sideways + self.half_width * upwards)
    }

    #[inline(always)]
    fn normal(&self, face: u8) -> Vector<T> {
        let Some(&(axis, positive)) = SIDES.get(usize::from(face)) else {
            return Vector::new(T::ZERO, T::ZERO, -T::ONE);
        };
        let out = if positive { self.height } else { -self.height };
        Vector::new(T::ZERO, T::ZERO, self.half_width).with(axis, out).unit()
    }
}

impl<T: Real> Convex<T> for PyramidShape<T> {
    #[inline(always)]
    fn intersect(&self, ray: &Ray<T>) -> Option<Crossing<T>> {
        let mut span = Span::whole();
        let to_apex = self.apex - ray.origin;
        for (face, side) in (0..BASE).zip(SIDES) {
            let (room, slope) = self.side(ray, to_apex, side);
            span.cut(room, slope, face)?;
        }
        span.cut(ray.origin.z - self.base, -ray.direction.z, BASE)?;
        let crossing = span.first_ahead()?;
        // A ray that leaves from a point on a face does not meet it, whichever way the point was rounded: it may have
        // been found on a face of another pyramid in the same plane.
        let leaves = crossing.side == Side::Inside && self.is_on_side(ray, to_apex, crossing.face);
        (!leaves).then_some(crossing)
    }

    #[inline(always)]
    fn exit(&self, ray: &Ray<T>, from: u8) -> Crossing<T> {
        let mut span = Span::whole();
        let to_apex = self.apex - ray.origin;
        for (face, side) in (0..BASE).zip(SIDES) {
            let (room, slope) = self.side(ray, to_apex, side);
            if slope > T::ZERO && face != from {
                span.leave_at(room / slope, face);
            }
        }
        if ray.direction.z < T::ZERO && from != BASE {
            span.leave_at((self.base - ray.origin.z) / ray.direction.z, BASE);
        }
        span.last()
    }

    #[inline(always)]
    fn locate(&self, ray: &Ray<T>, crossing: &Crossing<T>) -> SurfacePoint<T> {
        let normal = self.normal(crossing.face);
        let mut point = ray.at(crossing.t);
        if crossing.face == BASE {
            point.z = self.base;
        } else {
            point = point - normal * (point - self.apex).dot(normal);
            point.z = point.z.at_least(self.base).at_most(self.apex.z);
        }
        SurfacePoint { point, normal }
    }
}

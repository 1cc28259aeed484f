//! The square pyramid as the meeting of five half-spaces.

use glam::DVec3;

use super::clip::{ExactCut, Span, first_ahead_exactly, is_single};
use super::expansion::Expansion;
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

    /// Those of all side faces. One by one: whether closures of arrays are inlined is the compiler's mood.
    #[inline(always)]
    fn sides(&self, ray: &Ray<T>, to_apex: Vector<T>) -> [(T, T); 4] {
        let side = |index: usize| self.side(ray, to_apex, SIDES[index]);
        [side(0), side(1), side(2), side(3)]
    }

    /// What the half-spaces leave of a ray's line; `None` where it is parallel to one and outside.
    #[inline(always)]
    fn clip(&self, ray: &Ray<T>, sides: [(T, T); 4]) -> Option<Span<T>> {
        let mut span = Span::whole();
        for (face, (room, slope)) in (0..BASE).zip(sides) {
            span.cut(room, slope, face)?;
        }
        span.cut(ray.origin.z - self.base, -ray.direction.z, BASE)?;
        Some(span)
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

    /// Whether a ray runs along a side face so nearly that rounding may have changed which way it crosses the face, or on
    /// which side of it a parallel ray runs; from its slopes against the four.
    #[inline(always)]
    pub(super) fn is_along_side(&self, ray: &Ray<T>, slopes: [T; 4]) -> bool {
        let [a, b, c, d] = slopes;
        let rise = self.half_width * ray.direction.z;
        let little = rise * rise * T::CLOSE;
        ((a * b).abs() <= little) | ((c * d).abs() <= little)
    }

    /// [`Convex::intersect`] of a ray along a side face: exactly, unless it is level and so far away from the planes which it
    /// is parallel to that rounding cannot have moved it to their other side. There are two roundings of the offset from
    /// the apex, one of each product and one of their sum.
    #[cold]
    #[inline(never)]
    fn intersect_along(&self, ray: &Ray<T>) -> Option<Crossing<T>> {
        let to_apex = self.apex - ray.origin;
        let sides = self.sides(ray, to_apex);
        let four = T::TWO * T::TWO;
        let is_clear = |((axis, _), (room, slope)): ((usize, bool), (T, T))| {
            let size = self.height * to_apex[axis].abs() + self.half_width * to_apex.z.abs();
            slope != T::ZERO || room.abs() > four * T::ULP * size
        };
        let is_certain = ray.direction.z == T::ZERO && SIDES.into_iter().zip(sides).all(is_clear);
        match self.clip(ray, sides) {
            Some(span) if is_certain && !span.is_close() => span.first_ahead(),
            None if is_certain => None,
            _ => self.intersect_exactly(ray),
        }
    }

    /// [`Convex::intersect`] where rounding cannot tell: no line passes between two pyramids that touch.
    #[cold]
    #[inline(never)]
    fn intersect_exactly(&self, ray: &Ray<T>) -> Option<Crossing<T>> {
        let [base, half_width, height] = [self.base, self.half_width, self.height].map(T::to_f64);
        let (pyramid, double) =
            (PyramidShape { apex: self.apex.in_double(), base, half_width, height }, ray.in_double());
        let decided = if is_single::<T>() {
            pyramid.intersect(&double)
        } else {
            first_ahead_exactly(&pyramid.exact_cuts(&double))
        };
        let Crossing { t, face, side } = decided?;
        // The base by the usual quotient, which is that of a plane at the same height.
        let t = if face == BASE { (ray.origin.z - self.base) / -ray.direction.z } else { T::from_f64(t) };
        (t > T::ZERO && t.is_finite()).then_some(Crossing { t, face, side })
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

impl PyramidShape<f64> {
    /// The half-spaces of all faces, as a ray sees them.
    fn exact_cuts(&self, ray: &Ray<f64>) -> [ExactCut; 5] {
        let exact = |v: Vector<f64>| [v.x, v.y, v.z].map(Expansion::of);
        let [height, half_width, base] = [self.height, self.half_width, self.base].map(Expansion::of);
        let [origin, direction, apex] = [ray.origin, ray.direction, self.apex].map(exact);
        let to_apex: [Expansion; 3] = core::array::from_fn(|axis| &apex[axis] - &origin[axis]);
        let [a, b, c, d] = SIDES.map(|(axis, positive)| {
            let out = if positive { height.clone() } else { -&height };
            let across = |v: &[Expansion; 3]| &(&out * &v[axis]) + &(&half_width * &v[2]);
            ExactCut { room: across(&to_apex), slope: across(&direction) }
        });
        [a, b, c, d, ExactCut { room: &origin[2] - &base, slope: -&direction[2] }]
    }
}

impl<T: Real> Convex<T> for PyramidShape<T> {
    #[inline(always)]
    fn intersect(&self, ray: &Ray<T>) -> Option<Crossing<T>> {
        let to_apex = self.apex - ray.origin;
        let sides = self.sides(ray, to_apex);
        let slopes = [sides[0].1, sides[1].1, sides[2].1, sides[3].1];
        let crossing = match self.clip(ray, sides) {
            _ if self.is_along_side(ray, slopes) => self.intersect_along(ray),
            Some(span) if span.is_close() => self.intersect_exactly(ray),
            span => span?.first_ahead(),
        }?;
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

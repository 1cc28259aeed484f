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

/// The sums of [`PyramidShape::products`] for the four sides: in the half-space of a side `t * slope <= room`, of which
/// the room is that of the offset from the origin to the apex, the slope that of the direction.
#[inline(always)]
pub(super) fn across<T: Real>(products: Vector<T>) -> [T; 4] {
    let Vector { x, y, z } = products;
    [z - x, z + x, z - y, z + y]
}

/// The least magnitude among the slopes of the sides.
#[inline(always)]
pub(super) fn least<T: Real>(slope: Vector<T>) -> T {
    let (x, y, z) = (slope.x.abs(), slope.y.abs(), slope.z.abs());
    (x - z).abs().at_most((y - z).abs())
}

/// The least magnitude among the slopes of the sides that a level ray is not parallel to.
fn least_of_crossed<T: Real>(slope: Vector<T>) -> T {
    let [x, y] = [slope.x, slope.y].map(|slope| if slope == T::ZERO { T::INFINITY } else { slope.abs() });
    x.at_most(y)
}

/// Whether rounding cannot have changed in which order a line enters, leaves and starts, given the products of the sides
/// and the least magnitude of a slope.
///
/// With `u` half a unit in the last place, a room is off by `3 u` times the sum of its products' magnitudes (the offset,
/// the products, their sum), a slope by `2 u` times that of its own, a quotient by `u`. Where the least slope is above
/// `8 u` times that sum, which follows if the answer is yes, an end of the span is off by at most
/// `u (4 size of rooms + 4 t * size of slopes) / least slope`; two are compared, and twice as much is allowed for.
#[inline(always)]
pub(super) fn is_certain<T: Real>(
    room: Vector<T>,
    slope: Vector<T>,
    least: T,
    [enter, leave]: [T; 2],
) -> bool {
    let size = |v: Vector<T>| v.x.abs().at_least(v.y.abs()) + v.z.abs();
    let length = enter.abs() + leave.abs();
    // Which end comes first matters, and which lies ahead, unless the line has left by then.
    let ahead = if leave > T::ZERO { enter.abs().at_most(leave) } else { T::INFINITY };
    let gap = (enter - leave).abs().at_most(ahead);
    let blur = T::from_u32(8) * T::ULP * (size(room) + size(slope) * length);
    // No by itself where a slope is 0, or an end infinite.
    least * gap > blur
}

/// Whether a level ray is away, by more than the rounding of four operations, from all sides that it is parallel to.
fn is_clear_of_parallels<T: Real>(room: Vector<T>, slope: Vector<T>) -> bool {
    let four = T::TWO * T::TWO;
    let is_clear = |room_across: T, slope_across: T| {
        let (sideways, upwards) = (room_across.abs(), room.z.abs());
        slope_across != T::ZERO || (sideways - upwards).abs() > four * T::ULP * (sideways + upwards)
    };
    is_clear(room.x, slope.x) && is_clear(room.y, slope.y)
}

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

    /// The products that the half-spaces of the sides are made of: a side's normal `(height, half width)` is not
    /// normalised, and is exact for exact inputs.
    #[inline(always)]
    pub(super) fn products(&self, v: Vector<T>) -> Vector<T> {
        Vector::new(self.height * v.x, self.height * v.y, self.half_width * v.z)
    }

    /// What the half-spaces leave of a ray's line; `None` where it is parallel to one and outside.
    #[inline(always)]
    fn clip(&self, ray: &Ray<T>, rooms: [T; 4], slopes: [T; 4]) -> Option<Span<T>> {
        let mut span = Span::whole();
        for (face, (room, slope)) in (0..BASE).zip(rooms.into_iter().zip(slopes)) {
            span.cut(room, slope, face)?;
        }
        span.cut(ray.origin.z - self.base, -ray.direction.z, BASE)?;
        Some(span)
    }

    /// Whether the origin of a ray is in the plane of a side face as nearly as rounding allows: that of the point
    /// itself, a few units in the last place of each coordinate, and that of its offset from the apex.
    #[cold]
    fn is_on_side(&self, ray: &Ray<T>, room: T, face: u8) -> bool {
        let Some(&(axis, _)) = SIDES.get(usize::from(face)) else { return false };
        let sideways = self.apex[axis].abs() + ray.origin[axis].abs();
        let upwards = self.apex.z.abs() + ray.origin.z.abs();
        let four = T::TWO * T::TWO;
        room <= four * T::ULP * (self.height * sideways + self.half_width * upwards)
    }

    /// [`Convex::intersect`] of a ray of which [`is_certain`] does not know enough: exactly, unless it is level and so far
    /// away from the planes which it is parallel to that rounding cannot have moved it to their other side.
    #[cold]
    #[inline(never)]
    fn intersect_closely(&self, ray: &Ray<T>) -> Option<Crossing<T>> {
        let (room, slope) = (self.products(self.apex - ray.origin), self.products(ray.direction));
        if ray.direction.z == T::ZERO && is_clear_of_parallels(room, slope) {
            let least = least_of_crossed(slope);
            match self.clip(ray, across(room), across(slope)) {
                Some(span) if is_certain(room, slope, least, span.ends()) => return span.first_ahead(),
                None => return None,
                _ => {}
            }
        }
        self.intersect_exactly(ray)
    }

    /// [`Convex::intersect`] where rounding cannot tell: no line passes between two pyramids that touch.
    #[cold]
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
        let (room, slope) = (self.products(self.apex - ray.origin), self.products(ray.direction));
        let rooms = across(room);
        let crossing = match self.clip(ray, rooms, across(slope)) {
            Some(span) if is_certain(room, slope, least(slope), span.ends()) => span.first_ahead(),
            _ => self.intersect_closely(ray),
        }?;
        // A ray that leaves from a point on a face does not meet it, whichever way the point was rounded: it may have
        // been found on a face of another pyramid in the same plane.
        let leaves = crossing.side == Side::Inside
            && rooms
                .get(usize::from(crossing.face))
                .is_some_and(|&room| self.is_on_side(ray, room, crossing.face));
        (!leaves).then_some(crossing)
    }

    #[inline(always)]
    fn exit(&self, ray: &Ray<T>, from: u8) -> Crossing<T> {
        let mut span = Span::whole();
        let (room, slope) = (self.products(self.apex - ray.origin), self.products(ray.direction));
        for (face, (room, slope)) in (0..BASE).zip(across(room).into_iter().zip(across(slope))) {
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

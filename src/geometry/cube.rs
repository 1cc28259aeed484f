//! The axis-parallel cube as the meeting of three slabs.

use glam::DVec3;

use super::clip::{ExactCut, Span, first_ahead_exactly, is_single};
use super::expansion::Expansion;
use super::{Convex, Crossing, Ray, Real, SurfacePoint, Vector};

/// A closed box with faces parallel to the axes. Face `2k` is the low, `2k + 1` the high one of axis `k`.
#[derive(Clone, Copy, Debug)]
pub struct CubeShape<T> {
    /// The corner with the least coordinates.
    pub min: Vector<T>,
    /// The opposite corner.
    pub max: Vector<T>,
}

impl<T: Real> CubeShape<T> {
    /// The cube that extends by `side` along each axis from its least corner.
    pub fn new(min: DVec3, side: f64) -> Self {
        Self { min: Vector::from_dvec3(min), max: Vector::from_dvec3(min + DVec3::splat(side)) }
    }

    /// [`Convex::intersect`] where rounding cannot tell.
    #[cold]
    #[inline(never)]
    fn intersect_exactly(&self, ray: &Ray<T>) -> Option<Crossing<T>> {
        let cube = CubeShape { min: self.min.in_double(), max: self.max.in_double() };
        let double = ray.in_double();
        let decided = if is_single::<T>() {
            cube.intersect(&double)
        } else {
            first_ahead_exactly(&cube.exact_cuts(&double))
        };
        let Crossing { face, side, .. } = decided?;
        // By the usual quotient, which is that of other shapes in the same plane.
        let (axis, plane) = self.plane(face);
        let t = (plane - ray.origin[axis]) / ray.direction[axis];
        (t > T::ZERO && t.is_finite()).then_some(Crossing { t, face, side })
    }

    /// Axis and coordinate of a face.
    #[inline(always)]
    fn plane(&self, face: u8) -> (usize, T) {
        let axis = usize::from(face / 2);
        (axis, if face % 2 == 0 { self.min[axis] } else { self.max[axis] })
    }
}

impl CubeShape<f64> {
    /// The half-spaces of all faces, as a ray sees them.
    fn exact_cuts(&self, ray: &Ray<f64>) -> [ExactCut; 6] {
        core::array::from_fn(|face| {
            let (axis, is_low) = (face / 2, face % 2 == 0);
            let [origin, slope] = [ray.origin[axis], ray.direction[axis]].map(Expansion::of);
            let plane = Expansion::of(if is_low { self.min[axis] } else { self.max[axis] });
            if is_low {
                ExactCut { room: &origin - &plane, slope: -&slope }
            } else {
                ExactCut { room: &plane - &origin, slope }
            }
        })
    }
}

const AXIS_NORMALS: [[f64; 3]; 6] =
    [[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0], [0.0, 0.0, 1.0]];
const FACES: [[u8; 2]; 3] = [[0, 1], [2, 3], [4, 5]];

impl<T: Real> Convex<T> for CubeShape<T> {
    /// A ray parallel to a slab takes a branch of its own: the usual `0 * inf` would drop rays that run within a
    /// face, a whole scanline when the camera stands level with the cube's top.
    #[inline(always)]
    fn intersect(&self, ray: &Ray<T>) -> Option<Crossing<T>> {
        let mut span = Span::whole();
        for (axis, [low_face, high_face]) in FACES.into_iter().enumerate() {
            let direction = ray.direction[axis];
            let low = self.min[axis] - ray.origin[axis];
            let high = self.max[axis] - ray.origin[axis];
            if direction > T::ZERO {
                span.enter_at(low / direction, low_face);
                span.leave_at(high / direction, high_face);
            } else if direction < T::ZERO {
                span.enter_at(high / direction, high_face);
                span.leave_at(low / direction, low_face);
            } else if low > T::ZERO || high < T::ZERO {
                return None;
            }
        }
        if span.is_close() { self.intersect_exactly(ray) } else { span.first_ahead() }
    }

    #[inline(always)]
    fn exit(&self, ray: &Ray<T>, from: u8) -> Crossing<T> {
        let mut span = Span::whole();
        for (axis, [low_face, high_face]) in FACES.into_iter().enumerate() {
            let direction = ray.direction[axis];
            if direction > T::ZERO && high_face != from {
                span.leave_at((self.max[axis] - ray.origin[axis]) / direction, high_face);
            } else if direction < T::ZERO && low_face != from {
                span.leave_at((self.min[axis] - ray.origin[axis]) / direction, low_face);
            }
        }
        span.last()
    }

    #[inline(always)]
    fn locate(&self, ray: &Ray<T>, crossing: &Crossing<T>) -> SurfacePoint<T> {
        let (axis, plane) = self.plane(crossing.face);
        let point = ray.at(crossing.t).clamp(self.min, self.max).with(axis, plane);
        let [x, y, z] = AXIS_NORMALS[usize::from(crossing.face)];
        SurfacePoint { point, normal: Vector::new(T::from_f64(x), T::from_f64(y), T::from_f64(z)) }
    }
}

//! A ray, prepared for boxes and for leaves.

use crate::geometry::{Ray, Real, Vector};

use super::WIDTH;
use super::fit::Node;

/// A ray as boxes see it.
#[derive(Clone, Copy, Debug)]
pub(in crate::trace) struct TreeRay<T> {
    pub(super) ray: Ray<T>,
    /// Inverse direction; where that would be too large, the largest number that leaves room for slack.
    inverse: Vector<T>,
    /// The origin moved away from near and from far planes by what rounding may do.
    near_origin: Vector<T>,
    far_origin: Vector<T>,
    /// Which of a node's bounds are near, and which far, along each axis.
    near: [usize; 3],
    far: [usize; 3],
    /// The inverse of the direction's length, and its square.
    pub(super) inverse_length: T,
    pub(super) inverse_square: T,
}

/// What a ray found in a node or a leaf. It lies in memory and not in registers: stores of many numbers side by side
/// are what makes a compiler do many at a time.
#[derive(Clone, Debug)]
pub(super) struct Found<T> {
    /// Where each child is entered, or each shape met.
    pub(super) distances: [T; WIDTH],
    /// 1 for each that counts.
    pub(super) flags: [u8; WIDTH],
    /// Of shapes the [`FaceCode`](crate::trace::hit::FaceCode) of what is met.
    pub(super) faces: [u32; WIDTH],
}

impl<T: Real> Found<T> {
    pub(super) const NONE: Self = Self { distances: [T::ZERO; WIDTH], flags: [0; WIDTH], faces: [0; WIDTH] };

    /// The numbers of those that count, the least first.
    #[inline(always)]
    pub(super) fn counted(&self) -> Slots {
        Slots(u128::from_le_bytes(self.flags))
    }
}

/// Numbers of children or shapes, a byte each.
#[derive(Clone, Copy)]
pub(super) struct Slots(u128);

impl Slots {
    #[inline(always)]
    pub(super) fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// Takes the least one out, of at least one.
    #[inline(always)]
    pub(super) fn take(&mut self) -> usize {
        let slot = self.0.trailing_zeros() as usize / 8 % WIDTH;
        self.0 &= self.0.wrapping_sub(1);
        slot
    }
}

/// What is computed from a ray alone: for several rays at once where there are several.
#[derive(Clone, Copy, Debug)]
pub(in crate::trace) struct RayNumbers<T> {
    /// Inverse direction; where that would be too large, the largest number that leaves room for slack.
    pub(in crate::trace) inverse: Vector<T>,
    /// What rounding may do to the origin.
    pub(in crate::trace) pad: T,
    /// The inverse of the direction's length, and its square.
    pub(in crate::trace) inverse_length: T,
    pub(in crate::trace) inverse_square: T,
}

impl<T: Real> RayNumbers<T> {
    /// Of a ray in a tree whose shapes are found with this much rounding.
    #[inline(always)]
    pub(in crate::trace) fn new(ray: &Ray<T>, rounding: T) -> Self {
        let (origin, direction) = (ray.origin, ray.direction);
        let inverse = |along: T| inverse(along, along < T::ZERO);
        let square = direction.dot(direction);
        Self {
            inverse: Vector::new(inverse(direction.x), inverse(direction.y), inverse(direction.z)),
            pad: rounding * ((origin.x.abs() + origin.y.abs()) + origin.z.abs()),
            inverse_length: T::ONE / square.sqrt(),
            inverse_square: T::ONE / square,
        }
    }
}

impl<T: Real> TreeRay<T> {
    /// Prepares a ray for a tree whose shapes are found with this much rounding.
    #[inline(always)]
    pub(in crate::trace) fn new(ray: Ray<T>, rounding: T) -> Self {
        Self::of(ray, &RayNumbers::new(&ray, rounding))
    }

    /// A ray and its numbers.
    #[inline(always)]
    pub(in crate::trace) fn of(ray: Ray<T>, numbers: &RayNumbers<T>) -> Self {
        let &RayNumbers { inverse, pad, inverse_length, inverse_square } = numbers;
        let axis = |at: T, direction: T, number: usize| {
            let backwards = direction < T::ZERO;
            let towards = if backwards { -pad } else { pad };
            let planes = if backwards { (number + 3, number) } else { (number, number + 3) };
            (at + towards, at - towards, planes)
        };
        let (near_x, far_x, px) = axis(ray.origin.x, ray.direction.x, 0);
        let (near_y, far_y, py) = axis(ray.origin.y, ray.direction.y, 1);
        let (near_z, far_z, pz) = axis(ray.origin.z, ray.direction.z, 2);
        Self {
            ray,
            inverse,
            near_origin: Vector::new(near_x, near_y, near_z),
            far_origin: Vector::new(far_x, far_y, far_z),
            near: [px.0, py.0, pz.0],
            far: [px.1, py.1, pz.1],
            inverse_length,
            inverse_square,
        }
    }

    /// In which children the ray may meet something at up to a limit with slack, and where it enters them.
    ///
    /// A bound of a slab is one subtraction, one inverse and one product: wrong by less than two units in the last
    /// place. The slack is eight, on the far side.
    #[inline(always)]
    pub(super) fn enter(&self, node: &Node<T>, limit: T, found: &mut Found<T>) {
        let (bounds, near, far) = (&node.bounds, self.near, self.far);
        let (near_x, near_y, near_z) = (&bounds[near[0]], &bounds[near[1]], &bounds[near[2]]);
        let (far_x, far_y, far_z) = (&bounds[far[0]], &bounds[far[1]], &bounds[far[2]]);
        let inverse = self.inverse;
        let far_inverse = inverse * slack();
        for slot in 0..WIDTH {
            let x = (near_x[slot] - self.near_origin.x) * inverse.x;
            let y = (near_y[slot] - self.near_origin.y) * inverse.y;
            let z = (near_z[slot] - self.near_origin.z) * inverse.z;
            let entry = larger(larger(x, y), larger(z, T::ZERO));
            let x = (far_x[slot] - self.far_origin.x) * far_inverse.x;
            let y = (far_y[slot] - self.far_origin.y) * far_inverse.y;
            let z = (far_z[slot] - self.far_origin.z) * far_inverse.z;
            let exit = smaller(smaller(x, y), smaller(z, limit));
            found.distances[slot] = entry;
            found.flags[slot] = u8::from(entry <= exit);
        }
    }
}

/// What the far side of a comparison is multiplied by.
#[inline(always)]
pub(super) fn slack<T: Real>() -> T {
    T::ONE + T::from_u32(8) * T::ULP
}

#[inline(always)]
pub(super) fn larger<T: Real>(a: T, b: T) -> T {
    if a > b { a } else { b }
}

#[inline(always)]
pub(super) fn smaller<T: Real>(a: T, b: T) -> T {
    if a < b { a } else { b }
}

/// A slab that a ray runs along is entered long ago or never: a very large number tells as well as infinity, and makes no
/// NaN with 0. Its sign goes with the planes that are near, whichever zero the direction has.
#[inline(always)]
pub(super) fn inverse<T: Real>(direction: T, backwards: bool) -> T {
    let (inverse, most) = (T::ONE / direction, T::MAX / T::TWO);
    let limit = if backwards { -most } else { most };
    if inverse.abs() < most { inverse } else { limit }
}

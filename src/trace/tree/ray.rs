//! A ray, prepared for boxes and for leaves.

use core::hint::black_box;

use crate::geometry::{Ray, Real, Vector};

use super::WIDTH;
use super::fit::Node;

/// A ray, and what boxes and leaves ask of it.
#[derive(Clone, Copy, Debug)]
pub(in crate::trace) struct TreeRay<T> {
    pub(super) ray: Ray<T>,
    pub(super) numbers: RayNumbers<T>,
    /// Which of a node's bounds are near, and which far, along each axis.
    near: [usize; 3],
    far: [usize; 3],
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

/// What several rays found in a node.
#[derive(Clone, Debug)]
pub(super) struct Entered<T> {
    /// Where the first of them enters each child, or infinity.
    pub(super) distances: [T; WIDTH],
    /// Which of them do, a bit each.
    pub(super) rays: [u32; WIDTH],
}

impl<T: Real> Entered<T> {
    pub(super) const NONE: Self = Self { distances: [T::INFINITY; WIDTH], rays: [0; WIDTH] };

    /// The numbers of the children that a ray enters, the least first.
    #[inline(always)]
    pub(super) fn counted(&self) -> Slots {
        let mut flags = [0; WIDTH];
        for (flag, rays) in flags.iter_mut().zip(&self.rays) {
            *flag = u8::from(*rays != 0);
        }
        // Compilers would make the number out of flags that they look at one by one: seventy instructions.
        Slots(u128::from_le_bytes(black_box(flags)))
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
    /// The same with slack.
    pub(in crate::trace) far_inverse: Vector<T>,
    /// The origin moved away from near and from far planes by what rounding may do.
    pub(in crate::trace) near_origin: Vector<T>,
    pub(in crate::trace) far_origin: Vector<T>,
    /// The inverse of the direction's length, and its square.
    pub(in crate::trace) inverse_length: T,
    pub(in crate::trace) inverse_square: T,
}

impl<T: Real> RayNumbers<T> {
    /// Of a ray in a tree whose shapes are found with this much rounding.
    #[inline(always)]
    pub(in crate::trace) fn new(ray: &Ray<T>, rounding: T) -> Self {
        let Ray { origin, direction } = *ray;
        let inverse = |along: T| inverse(along, along < T::ZERO);
        let inverse = Vector::new(inverse(direction.x), inverse(direction.y), inverse(direction.z));
        let pad = rounding * ((origin.x.abs() + origin.y.abs()) + origin.z.abs());
        let towards = |along: T| if along < T::ZERO { -pad } else { pad };
        let towards = Vector::new(towards(direction.x), towards(direction.y), towards(direction.z));
        let square = direction.dot(direction);
        Self {
            inverse,
            far_inverse: inverse * slack(),
            near_origin: origin + towards,
            far_origin: origin - towards,
            inverse_length: T::ONE / square.sqrt(),
            inverse_square: T::ONE / square,
        }
    }
}

impl<T: Real> TreeRay<T> {
    /// Prepares a ray for a tree whose shapes are found with this much rounding.
    #[inline(always)]
    pub(in crate::trace) fn new(ray: Ray<T>, rounding: T) -> Self {
        Self::of(ray, RayNumbers::new(&ray, rounding))
    }

    /// A ray and its numbers.
    #[inline(always)]
    pub(in crate::trace) fn of(ray: Ray<T>, numbers: RayNumbers<T>) -> Self {
        let planes =
            |along: T, axis: usize| if along < T::ZERO { (axis + 3, axis) } else { (axis, axis + 3) };
        let Vector { x, y, z } = ray.direction;
        let (x, y, z) = (planes(x, 0), planes(y, 1), planes(z, 2));
        Self { ray, numbers, near: [x.0, y.0, z.0], far: [x.1, y.1, z.1] }
    }

    #[inline(always)]
    fn planes<'a>(&self, node: &'a Node<T>) -> Planes<'a, T> {
        let (bounds, near, far) = (&node.bounds, self.near, self.far);
        let (x, y) = ((&bounds[near[0]], &bounds[far[0]]), (&bounds[near[1]], &bounds[far[1]]));
        [x, y, (&bounds[near[2]], &bounds[far[2]])]
    }

    /// In which children the ray may meet something at up to a limit with slack, and where it enters them.
    #[inline(always)]
    pub(super) fn enter(&self, node: &Node<T>, limit: T, found: &mut Found<T>) {
        let planes = self.planes(node);
        for slot in 0..WIDTH {
            let (entry, exit) = self.numbers.cross(&planes, slot, limit);
            found.distances[slot] = entry;
            found.flags[slot] = u8::from(entry <= exit);
        }
    }

    /// The same for a ray of several, which this bit stands for.
    #[inline(always)]
    pub(super) fn enter_with_others(&self, node: &Node<T>, limit: T, bit: u32, found: &mut Entered<T>) {
        let planes = self.planes(node);
        for slot in 0..WIDTH {
            let (entry, exit) = self.numbers.cross(&planes, slot, limit);
            let (distance, bit) = if entry <= exit { (entry, bit) } else { (T::INFINITY, 0) };
            found.distances[slot] = smaller(found.distances[slot], distance);
            found.rays[slot] |= bit;
        }
    }
}

/// The near and the far planes of a node along each axis.
type Planes<'a, T> = [(&'a [T; WIDTH], &'a [T; WIDTH]); 3];

impl<T: Real> RayNumbers<T> {
    /// Where the ray enters the box of a child and where it leaves it, at up to a limit with slack: it may meet something
    /// in there unless the second is less.
    ///
    /// A bound of a slab is one subtraction, one inverse and one product: wrong by less than two units in the last
    /// place. The slack is eight, on the far side.
    #[inline(always)]
    fn cross(&self, planes: &Planes<'_, T>, slot: usize, limit: T) -> (T, T) {
        let [(near_x, far_x), (near_y, far_y), (near_z, far_z)] = planes;
        let x = (near_x[slot] - self.near_origin.x) * self.inverse.x;
        let y = (near_y[slot] - self.near_origin.y) * self.inverse.y;
        let z = (near_z[slot] - self.near_origin.z) * self.inverse.z;
        let entry = larger(larger(x, y), larger(z, T::ZERO));
        let x = (far_x[slot] - self.far_origin.x) * self.far_inverse.x;
        let y = (far_y[slot] - self.far_origin.y) * self.far_inverse.y;
        let z = (far_z[slot] - self.far_origin.z) * self.far_inverse.z;
        (entry, smaller(smaller(x, y), smaller(z, limit)))
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

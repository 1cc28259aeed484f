//! Where a ray has still to go.

use crate::geometry::Real;

use super::WIDTH;
use super::fit::Node;
use super::ray::{Found, Slots};

/// Fifteen children a level and one more: no tree has as many levels as this asks. Each takes one of the splits of its rows
/// at least, of which there are at most `DEEP` in `collapse.rs`, and then one for each time that 2^30 rows can be halved.
pub(super) const STACK_SIZE: usize = 1024;

/// A child and where the ray enters it, in one number that is the less the nearer it is.
///
/// The distance is rounded to single precision, which keeps the order of any two that are compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Entry(u64);

impl Entry {
    pub(super) const ZERO: Self = Self(0);

    #[inline(always)]
    pub(super) fn new<T: Real>(distance: T, code: u32) -> Self {
        let distance = f32::from_f64(distance.to_f64()).to_bits();
        Self(u64::from(distance) << 32 | u64::from(code))
    }

    /// The first of the children that are left, of at least one.
    #[inline(always)]
    fn take<T: Real>(node: &Node<T>, found: &Found<T>, left: &mut Slots) -> Self {
        let slot = left.take();
        Self::new(found.distances[slot], node.children[slot % WIDTH])
    }

    /// Whether it is at up to a limit, which may be below 0.
    #[inline(always)]
    pub(super) fn is_within<T: Real>(self, limit: T) -> bool {
        self.distance() <= f32::from_f64(limit.to_f64())
    }

    #[inline(always)]
    fn distance(self) -> f32 {
        f32::from_bits((self.0 >> 32) as u32)
    }

    /// The code of the child.
    #[inline(always)]
    #[expect(clippy::cast_possible_truncation, reason = "it is the lower half")]
    pub(super) fn code(self) -> u32 {
        self.0 as u32
    }
}

/// Children, the nearest last.
#[derive(Clone, Debug)]
pub(in crate::trace) struct Stack {
    entries: [Entry; STACK_SIZE],
}

impl Stack {
    pub(in crate::trace) const fn new() -> Self {
        Self { entries: [Entry(0); STACK_SIZE] }
    }

    /// Takes the last child that is entered at up to `limit` off a stack of this height.
    #[inline(always)]
    pub(super) fn pop<T: Real>(&self, height: &mut usize, limit: T) -> Option<u32> {
        let last = Entry::new(limit, u32::MAX);
        while *height > 0 {
            *height -= 1;
            let entry = self.entries[*height % STACK_SIZE];
            if entry <= last {
                return Some(entry.code());
            }
        }
        None
    }

    /// Puts the children just found, of which there is one, onto a stack of this height, but for the nearest, which is
    /// returned. The nearest of them comes last if `SORTED`.
    #[inline(always)]
    pub(super) fn push<T: Real, const SORTED: bool>(
        &mut self,
        node: &Node<T>,
        found: &Found<T>,
        height: &mut usize,
    ) -> u32 {
        let (mut left, base) = (found.counted(), *height);
        let mut nearest = Entry::take(node, found, &mut left);
        while !left.is_empty() {
            let other = Entry::take(node, found, &mut left);
            let farther = nearest.max(other);
            nearest = nearest.min(other);
            let mut place = *height;
            while SORTED && place > base && self.entries[(place - 1) % STACK_SIZE] < farther {
                self.entries[place % STACK_SIZE] = self.entries[(place - 1) % STACK_SIZE];
                place -= 1;
            }
            self.entries[place % STACK_SIZE] = farther;
            *height += 1;
        }
        nearest.code()
    }
}

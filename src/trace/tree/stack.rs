//! Where a ray has still to go.

use crate::geometry::Real;

use super::WIDTH;
use super::fit::Node;
use super::ray::{Eight, Slots};

/// Seven children a level and one more: no tree has as many levels as this asks, see `DEEP` in `build.rs`.
const STACK_SIZE: usize = 256;

/// A child and where the ray enters it, in one number that is the less the nearer it is.
///
/// The distance is rounded to single precision, which keeps the order of any two that are compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Entry(u64);

impl Entry {
    #[inline(always)]
    pub(super) fn new<T: Real>(distance: T, code: u32) -> Self {
        let distance = f32::from_f64(distance.to_f64()).to_bits();
        Self(u64::from(distance) << 32 | u64::from(code))
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
pub(in crate::trace) struct Stack<T> {
    entries: [Entry; STACK_SIZE],
    pub(super) found: Eight<T>,
}

impl<T: Real> Stack<T> {
    pub(in crate::trace) fn new() -> Self {
        Self { entries: [Entry(0); STACK_SIZE], found: Eight::NONE }
    }

    /// Takes the last child that is entered at up to `limit` off a stack of this height.
    #[inline(always)]
    pub(super) fn pop(&self, height: &mut usize, limit: T) -> Option<u32> {
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
    pub(super) fn push<const SORTED: bool>(
        &mut self,
        node: &Node<T>,
        found: Slots,
        height: &mut usize,
    ) -> u32 {
        let (mut found, base) = (found, *height);
        let mut nearest = self.entry(node, &mut found);
        while !found.is_empty() {
            let other = self.entry(node, &mut found);
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

    #[inline(always)]
    fn entry(&self, node: &Node<T>, found: &mut Slots) -> Entry {
        let slot = found.take();
        Entry::new(self.found.distances[slot], node.children[slot % WIDTH])
    }
}

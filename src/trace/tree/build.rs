//! Who is whose child.

use crate::geometry::{Bounded, Bounds3, Real};
use crate::trace::ShapeColumns;

use super::collapse::Halving;
use super::split::{Item, Range};
use super::{Child, SMALLEST_TREE, WIDTH};

/// The root is a node.
const _: () = assert!(SMALLEST_TREE > WIDTH);

/// Two pieces of work that may be done at the same time.
pub trait Fork: Sync {
    /// Does both.
    fn join<A: Send, B: Send>(
        &self,
        first: impl FnOnce() -> A + Send,
        second: impl FnOnce() -> B + Send,
    ) -> (A, B);
}

/// One piece of work after the other.
#[derive(Clone, Copy, Debug)]
pub struct Sequential;

impl Fork for Sequential {
    fn join<A: Send, B: Send>(
        &self,
        first: impl FnOnce() -> A + Send,
        second: impl FnOnce() -> B + Send,
    ) -> (A, B) {
        (first(), second())
    }
}

/// Fewer items than this are not worth a thread.
pub(super) const WORTH_A_THREAD: usize = 8192;

/// Nodes and leaves without boxes; see [`Child`] for the numbers.
#[derive(Default)]
pub(super) struct Topology {
    pub(super) nodes: Vec<[u32; WIDTH]>,
    pub(super) leaves: Vec<[u32; WIDTH]>,
}

/// The topology of a table.
pub(super) fn topology<T: Real, C>(shapes: &C, fork: &impl Fork) -> Topology
where
    C: ShapeColumns<T, Shape: Bounded<T>> + Sync,
{
    let mut items = items(shapes, fork);
    let halving = Halving::of(Range::of(&mut items), fork);
    let mut topology = Topology::default();
    topology.add(&halving, halving.whole(), &items);
    topology
}

/// Shapes as boxes in a cube of side 1, in single precision: good enough to choose by.
fn items<T: Real, C>(shapes: &C, fork: &impl Fork) -> Vec<Item>
where
    C: ShapeColumns<T, Shape: Bounded<T>> + Sync,
{
    let bounds = |row: usize| shapes.shape(row).bounds();
    let all = union(fork, 0, shapes.len(), &bounds);
    let extent = all.high - all.low;
    let largest = extent.x.at_least(extent.y).at_least(extent.z);
    let scale = if largest > T::ZERO { T::ONE / largest } else { T::ONE };
    let mut items = vec![Item::default(); shapes.len()];
    fill(fork, 0, &mut items, &|row| {
        let bounds = bounds(row);
        Item::new((bounds.low - all.low) * scale, (bounds.high - all.low) * scale, row)
    });
    items
}

fn union<T: Real>(
    fork: &impl Fork,
    first: usize,
    end: usize,
    bounds: &(impl Fn(usize) -> Bounds3<T> + Sync),
) -> Bounds3<T> {
    if end - first <= WORTH_A_THREAD {
        return (first..end).fold(Bounds3::EMPTY, |all, row| all.with(&bounds(row)));
    }
    let middle = usize::midpoint(first, end);
    let (a, b) = fork.join(|| union(fork, first, middle, bounds), || union(fork, middle, end, bounds));
    a.with(&b)
}

/// Fills a slice whose first element has this number.
pub(super) fn fill<V: Send>(
    fork: &impl Fork,
    first: usize,
    values: &mut [V],
    value: &(impl Fn(usize) -> V + Sync),
) {
    if values.len() <= WORTH_A_THREAD {
        for (place, number) in values.iter_mut().zip(first..) {
            *place = value(number);
        }
        return;
    }
    let middle = values.len() / 2;
    let (low, high) = values.split_at_mut(middle);
    fork.join(|| fill(fork, first, low, value), || fill(fork, first + middle, high, value));
}

impl Topology {
    /// Adds a part of the items, and returns its code.
    fn add(&mut self, halving: &Halving, part: u32, items: &[Item]) -> u32 {
        if let Some(held) = halving.leaf(part, items) {
            return self.add_leaf(held);
        }
        let node = self.nodes.len();
        self.nodes.push([Child::NOTHING; WIDTH]);
        for (slot, child) in halving.children(part).enumerate() {
            self.nodes[node][slot] = self.add(halving, child, items);
        }
        number(node)
    }

    fn add_leaf(&mut self, items: &[Item]) -> u32 {
        let leaf = number(self.leaves.len());
        let last = items.len() - 1;
        self.leaves.push(core::array::from_fn(|slot| items[slot.min(last)].row()));
        Child::LEAF | leaf
    }
}

/// Nodes, leaves and parts of items are at most twice as many as rows, of which there are far fewer than 2^30.
pub(super) fn number(count: usize) -> u32 {
    u32::try_from(count).unwrap_or(Child::LEAF - 1)
}

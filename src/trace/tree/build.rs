//! Who is whose child.

use crate::geometry::{Bounded, Bounds3, Real};
use crate::trace::ShapeColumns;

use super::split::{Item, Range, split};
use super::{Child, WIDTH};

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
const WORTH_A_THREAD: usize = 8192;
/// Below this depth halves are taken, so that no stack of a traversal overflows.
const DEEP: u32 = 20;

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
    let mut whole = Topology::default();
    whole.grow(Range::of(&mut items), 0, fork);
    whole
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
    /// Adds the subtree over some items, and returns its code.
    fn grow(&mut self, range: Range<'_>, depth: u32, fork: &impl Fork) -> u32 {
        if depth > 0 && range.items.len() <= WIDTH {
            return self.add_leaf(range.items);
        }
        let node = self.nodes.len();
        self.nodes.push([Child::NOTHING; WIDTH]);
        let ranges = if range.items.len() > WORTH_A_THREAD {
            halves(range, WIDTH, depth, fork)
        } else {
            largest_first(range, depth)
        };
        let codes = self.grow_all(ranges, depth + 1, fork);
        for (place, code) in self.nodes[node].iter_mut().zip(codes) {
            *place = code;
        }
        number(node)
    }

    fn grow_all(&mut self, ranges: Vec<Range<'_>>, depth: u32, fork: &impl Fork) -> Vec<u32> {
        if ranges.iter().map(|range| range.items.len()).sum::<usize>() <= WORTH_A_THREAD {
            return ranges.into_iter().map(|range| self.grow(range, depth, fork)).collect();
        }
        let parts = separately(ranges, depth, fork);
        parts.into_iter().map(|(part, code)| self.append(part, code)).collect()
    }

    fn add_leaf(&mut self, items: &[Item]) -> u32 {
        let leaf = number(self.leaves.len());
        let last = items.len() - 1;
        self.leaves.push(core::array::from_fn(|slot| items[slot.min(last)].row()));
        Child::LEAF | leaf
    }

    /// Takes over a subtree that was built apart, and returns its code here.
    fn append(&mut self, part: Self, code: u32) -> u32 {
        let (nodes, leaves) = (number(self.nodes.len()), number(self.leaves.len()));
        let moved = |code: u32| match Child::of(code) {
            Child::Nothing => code,
            Child::Leaf(_) => code + leaves,
            Child::Node(_) => code + nodes,
        };
        self.nodes.extend(part.nodes.into_iter().map(|children| children.map(moved)));
        self.leaves.extend(part.leaves);
        moved(code)
    }
}

fn separately(mut ranges: Vec<Range<'_>>, depth: u32, fork: &impl Fork) -> Vec<(Topology, u32)> {
    if ranges.len() > 1 {
        let second = ranges.split_off(ranges.len() / 2);
        let (mut a, b) = fork.join(|| separately(ranges, depth, fork), || separately(second, depth, fork));
        a.extend(b);
        return a;
    }
    let grown = ranges.into_iter().map(|range| {
        let mut part = Topology::default();
        let code = part.grow(range, depth, fork);
        (part, code)
    });
    grown.collect()
}

/// Splits many items into `count` ranges, a power of two, halves at the same time.
fn halves<'a>(range: Range<'a>, count: usize, depth: u32, fork: &impl Fork) -> Vec<Range<'a>> {
    if count == 1 || range.items.len() <= WIDTH {
        return vec![range];
    }
    let (low, high) = if depth < DEEP { split(range) } else { range.halved() };
    let (mut low, high) =
        fork.join(|| halves(low, count / 2, depth, fork), || halves(high, count / 2, depth, fork));
    low.extend(high);
    low
}

/// Splits few items into up to eight ranges, always the one of the largest surface next.
fn largest_first(range: Range<'_>, depth: u32) -> Vec<Range<'_>> {
    let mut ranges = Vec::with_capacity(WIDTH);
    ranges.push(range);
    while ranges.len() < WIDTH {
        let candidates = ranges.iter().enumerate().filter(|(_, range)| range.items.len() > WIDTH);
        let Some((index, _)) = candidates.max_by(|(_, a), (_, b)| a.area().total_cmp(&b.area())) else {
            break;
        };
        let range = ranges.swap_remove(index);
        let (low, high) = if depth < DEEP { split(range) } else { range.halved() };
        ranges.push(low);
        ranges.push(high);
    }
    ranges
}

/// Nodes and leaves are fewer than rows, of which there are far fewer than 2^30.
fn number(count: usize) -> u32 {
    u32::try_from(count).unwrap_or(Child::LEAF - 1)
}

//! Which of the nodes with two children become nodes with sixteen: those that make the sum of the nodes' surfaces least, by
//! dynamic programming (H. Ylitie, T. Karras and S. Laine, "Efficient Incoherent Ray Traversal on GPUs Through Compressed
//! Wide BVHs", High Performance Graphics 2017).
//!
//! Leaves are what they are, so the nodes are all that a choice can save. With eight children a node, always opening the
//! largest part left the last level with two or three leaves a node: random rays among 1e3, 1e4 and 1e5 spheres looked at
//! 4.8, 9.3 and 17.2 nodes, with the least surface at 3.9, 7.8 and 14.4.

use super::WIDTH;
use super::build::{Fork, WORTH_A_THREAD, number};
use super::split::{Item, Range, split};

/// Below so many splits halves are taken, so that no stack of a traversal overflows, see `STACK_SIZE`.
const DEEP: u32 = 40;

/// All children of a node.
const ALL: u8 = 16;
const _: () = assert!(ALL as usize == WIDTH);

/// Items split in two until a leaf holds what is left.
#[derive(Default)]
pub(super) struct Halving {
    /// Halves come before what they are halves of; the whole is the last.
    parts: Vec<Part>,
}

/// Items that lie side by side.
#[derive(Clone, Copy)]
struct Part {
    first: u32,
    count: u32,
    /// What they are split into, unless a leaf holds them.
    halves: Option<[u32; 2]>,
    /// The least sum of surfaces of nodes when 1, 2 ... 16 or fewer children of a node hold the items.
    cost: [f32; WIDTH],
    /// How many of these children the first half is given; none where all are one child.
    share: [u8; WIDTH],
    /// The same inside that one child.
    inner_share: u8,
}

impl Halving {
    /// Splits items; many at the same time.
    pub(super) fn of(range: Range<'_>, fork: &impl Fork) -> Self {
        let mut halving = Self::default();
        halving.add(range, 0, 0, fork);
        halving
    }

    /// Adds items of which the first has this number, and which were split off so many times. Returns their number.
    fn add(&mut self, range: Range<'_>, first: u32, depth: u32, fork: &impl Fork) -> u32 {
        let count = range.items.len();
        let part = if count <= WIDTH {
            Part::leaf(first, number(count))
        } else {
            let area = range.area();
            let (low, high) = if depth < DEEP { split(range) } else { range.halved() };
            let (middle, deeper) = (first + number(low.items.len()), depth + 1);
            let halves = if count > WORTH_A_THREAD {
                let part = |range, first| {
                    let mut part = Self::default();
                    part.add(range, first, deeper, fork);
                    part
                };
                let (low, high) = fork.join(|| part(low, first), || part(high, middle));
                [self.append(low), self.append(high)]
            } else {
                [self.add(low, first, deeper, fork), self.add(high, middle, deeper, fork)]
            };
            let costs = halves.map(|half| self.parts[half as usize].cost);
            Part::of_halves(first, number(count), area, halves, &costs)
        };
        self.parts.push(part);
        self.whole()
    }

    /// Takes over what was split apart, and returns the number of its whole here.
    fn append(&mut self, other: Self) -> u32 {
        let before = number(self.parts.len());
        let moved =
            |part: Part| Part { halves: part.halves.map(|halves| halves.map(|half| half + before)), ..part };
        if before == 0 {
            self.parts = other.parts;
        } else {
            self.parts.extend(other.parts.into_iter().map(moved));
        }
        self.whole()
    }

    /// The part that holds all items.
    pub(super) fn whole(&self) -> u32 {
        number(self.parts.len()) - 1
    }

    /// The items of a part that a leaf holds.
    pub(super) fn leaf<'a>(&self, part: u32, items: &'a [Item]) -> Option<&'a [Item]> {
        let Part { first, count, halves, .. } = self.parts[part as usize];
        halves.is_none().then(|| &items[first as usize..][..count as usize])
    }

    /// The children of the node that a part becomes, up to sixteen.
    pub(super) fn children(&self, part: u32) -> impl Iterator<Item = u32> {
        let (mut children, mut count) = ([0; WIDTH], 0);
        let Part { halves, inner_share, .. } = self.parts[part as usize];
        if let Some([low, high]) = halves {
            let mut take = |child| {
                children[count % WIDTH] = child;
                count += 1;
            };
            self.collect(low, inner_share, &mut take);
            self.collect(high, ALL - inner_share, &mut take);
        }
        children.into_iter().take(count)
    }

    /// The children that hold a part, at most so many.
    fn collect(&self, part: u32, most: u8, take: &mut impl FnMut(u32)) {
        let Part { halves, share, .. } = self.parts[part as usize];
        match (halves, share[most as usize - 1]) {
            (Some([low, high]), share) if share > 0 => {
                self.collect(low, share, take);
                self.collect(high, most - share, take);
            }
            _ => take(part),
        }
    }
}

impl Part {
    fn leaf(first: u32, count: u32) -> Self {
        Self { first, count, halves: None, cost: [0.0; WIDTH], share: [0; WIDTH], inner_share: 0 }
    }

    fn of_halves(first: u32, count: u32, area: f32, halves: [u32; 2], costs: &[[f32; WIDTH]; 2]) -> Self {
        let (inner, inner_share) = cheapest(costs, WIDTH);
        let alone = area + inner;
        let (mut cost, mut share) = ([alone; WIDTH], [0; WIDTH]);
        for most in 2..=WIDTH {
            let (apart, low) = cheapest(costs, most);
            if apart <= alone {
                (cost[most - 1], share[most - 1]) = (apart, low);
            }
        }
        Self { first, count, halves: Some(halves), cost, share, inner_share }
    }
}

/// The least cost of two halves that so many children hold, of at least two, and how many of them hold the first half.
fn cheapest([low, high]: &[[f32; WIDTH]; 2], most: usize) -> (f32, u8) {
    let mut best = (f32::INFINITY, 1);
    for (share, number) in (1..most).zip(1..) {
        let cost = low[share - 1] + high[most - share - 1];
        if cost < best.0 {
            best = (cost, number);
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::super::build::Sequential;
    use super::*;
    use crate::geometry::{Real, Vector};

    /// Small boxes strewn over a cube, always the same ones.
    fn items(count: u32) -> Vec<Item> {
        let at = |row: u32, step: u32| f64::from(row.wrapping_mul(step) % 1009) / 1009.0;
        let item = |row: u32| {
            let low = Vector::new(at(row, 331), at(row, 787), at(row, 503));
            Item::new(low, low + Vector::new(0.01, 0.02, 0.01), row as usize)
        };
        (0..count).map(item).collect()
    }

    fn halving(count: u32) -> (Halving, Vec<Item>) {
        let mut items = items(count);
        (Halving::of(Range::of(&mut items), &Sequential), items)
    }

    /// The surface of the node that a part would become.
    fn area(halving: &Halving, part: u32) -> f32 {
        let Part { cost, halves, .. } = halving.parts[part as usize];
        halves.map_or(0.0, |halves| cost[0] - cheapest(&costs(halving, halves), WIDTH).0)
    }

    fn costs(halving: &Halving, halves: [u32; 2]) -> [[f32; WIDTH]; 2] {
        halves.map(|half| halving.parts[half as usize].cost)
    }

    /// The sum of the surfaces of the nodes that were chosen, and the rows that their leaves hold.
    fn chosen(halving: &Halving, part: u32, items: &[Item], rows: &mut Vec<u32>) -> f32 {
        if let Some(held) = halving.leaf(part, items) {
            rows.extend(held.iter().map(Item::row));
            return 0.0;
        }
        let children: Vec<_> = halving.children(part).collect();
        assert!((2..=WIDTH).contains(&children.len()), "{children:?}");
        area(halving, part) + children.iter().map(|&child| chosen(halving, child, items, rows)).sum::<f32>()
    }

    /// The least sum there is: of every choice of parts that become nodes, as the bits of a number say.
    fn least(halving: &Halving) -> f32 {
        let whole = halving.whole();
        let inner: Vec<u32> =
            (0..whole).filter(|&part| halving.parts[part as usize].halves.is_some()).collect();
        assert!(inner.len() < 20, "{} parts are too many to try", inner.len());
        let is_node = |bits: u32, part: u32| {
            inner.iter().position(|&other| other == part).is_none_or(|place| bits >> place & 1 == 1)
        };
        let choices = 0..1_u32 << inner.len();
        let sums = choices.filter_map(|bits| {
            let nodes = inner.iter().copied().filter(|&part| is_node(bits, part)).chain([whole]);
            nodes
                .map(|node| {
                    (width(halving, node, &|part| is_node(bits, part)) <= WIDTH).then(|| area(halving, node))
                })
                .sum()
        });
        sums.fold(f32::INFINITY, f32::min)
    }

    /// The children of a node, where these parts are nodes or leaves of their own.
    fn width(halving: &Halving, node: u32, is_child: &impl Fn(u32) -> bool) -> usize {
        let halves = halving.parts[node as usize].halves.into_iter().flatten();
        halves.map(|half| if is_child(half) { 1 } else { width(halving, half, is_child) }).sum()
    }

    /// Every row is in one leaf, and no other choice of nodes has less surface.
    #[test]
    fn the_nodes_have_the_least_surface() {
        for count in [24, 40, 57, 73, 90] {
            let (halving, items) = halving(count);
            let mut rows = Vec::new();
            let sum = chosen(&halving, halving.whole(), &items, &mut rows);
            let best = least(&halving);
            assert!((sum - best).abs() <= best * 16.0 * f32::ULP, "{count} rows: {sum}, not {best}");
            rows.sort_unstable();
            assert!(rows.iter().copied().eq(0..count), "{count} rows: {rows:?}");
        }
    }

    /// Parts that were split at the same time are put together.
    #[test]
    fn many_items_are_split_apart_as_well() {
        let count = number(3 * WORTH_A_THREAD);
        let (halving, items) = halving(count);
        let mut rows = Vec::new();
        chosen(&halving, halving.whole(), &items, &mut rows);
        rows.sort_unstable();
        assert!(rows.iter().copied().eq(0..count));
    }
}

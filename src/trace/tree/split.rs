//! Splitting items in two by the surface area heuristic (J. D. `MacDonald` and K. S. Booth, "Heuristics for Ray Tracing
//! Using Space Subdivision", The Visual Computer 6, 1990), with a few bins an axis.

use crate::geometry::{Real, Vector};

use super::WIDTH;
use super::build::Fork;

/// A row's box. The fourth component of `low` is its row.
#[derive(Clone, Copy, Default)]
pub(super) struct Item {
    low: [f32; 4],
    high: [f32; 4],
}

impl Item {
    pub(super) fn new<T: Real>(low: Vector<T>, high: Vector<T>, row: usize) -> Self {
        let rounded = |v: Vector<T>| [v.x, v.y, v.z].map(|value| f32::from_f64(value.to_f64()));
        let ([low_x, low_y, low_z], [high_x, high_y, high_z]) = (rounded(low), rounded(high));
        // Rows are far fewer than 2^32.
        let row = f32::from_bits(u32::try_from(row).unwrap_or(0));
        Self { low: [low_x, low_y, low_z, row], high: [high_x, high_y, high_z, 0.0] }
    }

    pub(super) fn row(&self) -> u32 {
        self.low[3].to_bits()
    }

    /// Twice the middle.
    #[inline(always)]
    fn middle(&self) -> [f32; 4] {
        core::array::from_fn(|axis| self.low[axis] + self.high[axis])
    }
}

/// A box that grows; its fourth component means nothing.
#[derive(Clone, Copy)]
struct Extent {
    low: [f32; 4],
    high: [f32; 4],
}

impl Extent {
    const EMPTY: Self = Self { low: [f32::INFINITY; 4], high: [f32::NEG_INFINITY; 4] };

    #[inline(always)]
    fn add(&mut self, low: &[f32; 4], high: &[f32; 4]) {
        for axis in 0..4 {
            self.low[axis] = if low[axis] < self.low[axis] { low[axis] } else { self.low[axis] };
            self.high[axis] = if high[axis] > self.high[axis] { high[axis] } else { self.high[axis] };
        }
    }

    #[inline(always)]
    fn join(mut self, other: &Self) -> Self {
        self.add(&other.low, &other.high);
        self
    }

    /// Half of the surface.
    fn area(&self) -> f32 {
        let [x, y, z] = core::array::from_fn(|axis| (self.high[axis] - self.low[axis]).max(0.0));
        x * y + y * z + z * x
    }
}

/// Items with the box around them and the one around their middles.
pub(super) struct Range<'a> {
    pub(super) items: &'a mut [Item],
    around: Extent,
    middles: Extent,
}

impl<'a> Range<'a> {
    pub(super) fn of(items: &'a mut [Item]) -> Self {
        let (mut around, mut middles) = (Extent::EMPTY, Extent::EMPTY);
        for item in items.iter() {
            let middle = item.middle();
            around.add(&item.low, &item.high);
            middles.add(&middle, &middle);
        }
        Self { items, around, middles }
    }

    pub(super) fn area(&self) -> f32 {
        self.around.area()
    }

    /// The first and the second half, as they lie.
    pub(super) fn halved(self) -> (Self, Self) {
        let (low, high) = self.items.split_at_mut(self.items.len() / 2);
        (Range::of(low), Range::of(high))
    }
}

const BINS: usize = 16;

/// What falls between two parallel planes.
#[derive(Clone, Copy)]
struct Bin {
    around: Extent,
    count: usize,
}

const EMPTY_BIN: Bin = Bin { around: Extent::EMPTY, count: 0 };

/// Bins along each axis.
struct Bins([[Bin; BINS]; 3]);

/// Where the bins of a range lie.
#[derive(Clone, Copy)]
struct Grid {
    low: [f32; 4],
    scale: [f32; 4],
}

/// Items of bins below `end` along `axis` go to one side.
#[derive(Clone, Copy)]
struct Cut {
    axis: usize,
    end: usize,
}

/// More items than this are counted by more than one thread.
const MANY: usize = 65536;

/// Splits more than one item in two.
pub(super) fn split<'a>(range: Range<'a>, fork: &impl Fork) -> (Range<'a>, Range<'a>) {
    let grid = Grid::of(&range.middles);
    let Some(cut) = best_cut(&bins(range.items, &grid, fork)) else {
        return range.halved();
    };
    let count = partition(range.items, |item| grid.bin(&item.middle(), cut.axis) < cut.end);
    let (low, high) = range.items.split_at_mut(count);
    if low.len() + high.len() > MANY {
        fork.join(|| Range::of(low), || Range::of(high))
    } else {
        (Range::of(low), Range::of(high))
    }
}

fn bins(items: &[Item], grid: &Grid, fork: &impl Fork) -> Bins {
    if items.len() > MANY {
        let (low, high) = items.split_at(items.len() / 2);
        let (a, b) = fork.join(|| bins(low, grid, fork), || bins(high, grid, fork));
        return a.join(&b);
    }
    let mut bins = Bins([[EMPTY_BIN; BINS]; 3]);
    for item in items {
        let middle = item.middle();
        for (axis, bins) in bins.0.iter_mut().enumerate() {
            let bin = &mut bins[grid.bin(&middle, axis)];
            bin.around.add(&item.low, &item.high);
            bin.count += 1;
        }
    }
    bins
}

impl Bins {
    fn join(mut self, other: &Self) -> Self {
        for (bin, other) in self.0.iter_mut().flatten().zip(other.0.iter().flatten()) {
            bin.around = bin.around.join(&other.around);
            bin.count += other.count;
        }
        self
    }
}

impl Grid {
    #[expect(clippy::cast_precision_loss, reason = "sixteen")]
    fn of(middles: &Extent) -> Self {
        let scale = core::array::from_fn(|axis| {
            let extent = middles.high[axis] - middles.low[axis];
            if extent > 0.0 { BINS as f32 / extent } else { 0.0 }
        });
        Self { low: middles.low, scale }
    }

    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "`as` saturates at 0")]
    #[inline(always)]
    fn bin(&self, middle: &[f32; 4], axis: usize) -> usize {
        let at = (middle[axis] - self.low[axis]) * self.scale[axis];
        (at as i32 as usize).min(BINS - 1)
    }
}

/// The cut with the least sum of surface times leaves; `None` where all items are in one bin.
fn best_cut(bins: &Bins) -> Option<Cut> {
    let mut best = None;
    let mut least = f32::INFINITY;
    for (axis, bins) in bins.0.iter().enumerate() {
        let after = costs_from_the_end(bins);
        let mut before = EMPTY_BIN;
        for end in 1..BINS {
            before = before.join(&bins[end - 1]);
            let (Some(cost_before), Some(cost_after)) = (before.cost(), after[end]) else { continue };
            if cost_before + cost_after < least {
                least = cost_before + cost_after;
                best = Some(Cut { axis, end });
            }
        }
    }
    best
}

/// For each bin the cost of it and all that follow.
fn costs_from_the_end(bins: &[Bin; BINS]) -> [Option<f32>; BINS] {
    let mut costs = [None; BINS];
    let mut after = EMPTY_BIN;
    for (cost, bin) in costs.iter_mut().zip(bins).rev() {
        after = after.join(bin);
        *cost = after.cost();
    }
    costs
}

impl Bin {
    fn join(&self, other: &Self) -> Self {
        Self { around: self.around.join(&other.around), count: self.count + other.count }
    }

    /// Surface times leaves, if anything is there.
    #[expect(clippy::cast_precision_loss, reason = "a heuristic")]
    fn cost(&self) -> Option<f32> {
        (self.count > 0).then(|| self.around.area() * self.count.div_ceil(WIDTH) as f32)
    }
}

/// Moves the items of which something is true to the front, and counts them.
fn partition(items: &mut [Item], goes_first: impl Fn(&Item) -> bool) -> usize {
    let (mut low, mut high) = (0, items.len());
    loop {
        while low < high && goes_first(&items[low]) {
            low += 1;
        }
        while low < high && !goes_first(&items[high - 1]) {
            high -= 1;
        }
        if low >= high {
            return low;
        }
        items.swap(low, high - 1);
    }
}

//! Splitting items in two by the surface area heuristic (J. D. `MacDonald` and K. S. Booth, "Heuristics for Ray Tracing
//! Using Space Subdivision", The Visual Computer 6, 1990), with a few bins an axis.

use crate::geometry::{Real, Vector};

use super::WIDTH;

/// A row's box. Its last component but four is no coordinate: it says the row.
#[derive(Clone, Copy, Default)]
pub(super) struct Item(Extent);

/// A row in place of a coordinate is a normal number: arithmetic with others takes many times as long.
const ROW_ZERO: u32 = f32::MIN_POSITIVE.to_bits();

impl Item {
    pub(super) fn new<T: Real>(low: Vector<T>, high: Vector<T>, row: usize) -> Self {
        let [x, y, z] = [low.x, low.y, low.z].map(single);
        let [far_x, far_y, far_z] = [high.x, high.y, high.z].map(single);
        // Rows are far fewer than 2^31.
        let row = f32::from_bits(ROW_ZERO + u32::try_from(row).unwrap_or(0));
        Self(Extent([x, y, z, row, -far_x, -far_y, -far_z, 0.0]))
    }

    pub(super) fn row(&self) -> u32 {
        self.0.0[3].to_bits() - ROW_ZERO
    }

    /// Twice the middle along an axis.
    #[inline(always)]
    fn middle(&self, axis: usize) -> f32 {
        self.0.0[axis] - self.0.0[axis + 4]
    }
}

fn single<T: Real>(value: T) -> f32 {
    f32::from_f64(value.to_f64())
}

/// A box that grows: the least x, y, z and the greatest, these with the opposite sign, so that eight numbers are compared
/// alike. The fourth and the eighth mean nothing.
#[derive(Clone, Copy, Default)]
struct Extent([f32; 8]);

impl Extent {
    const EMPTY: Self = Self([f32::INFINITY; 8]);

    #[inline(always)]
    fn around_point([x, y, z, w]: [f32; 4]) -> Self {
        Self([x, y, z, w, -x, -y, -z, -w])
    }

    #[inline(always)]
    fn add(&mut self, other: &Self) {
        for (most, other) in self.0.iter_mut().zip(&other.0) {
            *most = if *other < *most { *other } else { *most };
        }
    }

    #[inline(always)]
    fn join(mut self, other: &Self) -> Self {
        self.add(other);
        self
    }

    /// From the least to the greatest, along each axis.
    #[inline(always)]
    fn size(&self) -> [f32; 3] {
        core::array::from_fn(|axis| -self.0[axis + 4] - self.0[axis])
    }

    /// Half of the surface.
    #[inline(always)]
    fn area(&self) -> f32 {
        let [x, y, z] = self.size().map(|length| length.max(0.0));
        x * y + y * z + z * x
    }
}

/// Items with the box around them and the one around their middles.
pub(super) struct Range<'a> {
    pub(super) items: &'a mut [Item],
    extents: Extents,
}

/// The box around items, and the one around their middles.
#[derive(Clone, Copy)]
struct Extents {
    around: Extent,
    middles: Extent,
}

impl Extents {
    const EMPTY: Self = Self { around: Extent::EMPTY, middles: Extent::EMPTY };

    #[inline(always)]
    fn add(&mut self, item: &Item) {
        self.around.add(&item.0);
        self.middles.add(&Extent::around_point(core::array::from_fn(|axis| item.middle(axis))));
    }
}

impl<'a> Range<'a> {
    pub(super) fn of(items: &'a mut [Item]) -> Self {
        let mut extents = Extents::EMPTY;
        items.iter().for_each(|item| extents.add(item));
        Self { items, extents }
    }

    pub(super) fn area(&self) -> f32 {
        self.extents.around.area()
    }

    /// The first and the second half, as they lie.
    pub(super) fn halved(self) -> (Self, Self) {
        let (low, high) = self.items.split_at_mut(self.items.len() / 2);
        (Range::of(low), Range::of(high))
    }

    /// Moves the items of which something is true to the front, and parts them from the others.
    ///
    /// Every item is swapped with the first of those that stay behind, itself if need be: which side it goes to cannot be
    /// predicted, and a branch would be wrong half of the time.
    fn parted(self, goes_first: impl Fn(&Item) -> bool) -> (Self, Self) {
        let mut end = 0;
        for at in 0..self.items.len() {
            let is_first = goes_first(&self.items[at]);
            self.items.swap(end, at);
            end += usize::from(is_first);
        }
        let (low, high) = self.items.split_at_mut(end);
        (Range::of(low), Range::of(high))
    }
}

/// Splits more than one item in two.
pub(super) fn split(range: Range<'_>) -> (Range<'_>, Range<'_>) {
    // With few items, what is done for each bin takes most of the time.
    if range.items.len() <= FEW { split_by::<8>(range) } else { split_by::<16>(range) }
}

/// At most so many items are counted in fewer bins.
const FEW: usize = 64;
/// At least so many items are counted: of twice as many every second, and so on. It does not take more to tell where
/// a good cut is.
const COUNTED: usize = 1024;

fn split_by<const BINS: usize>(range: Range<'_>) -> (Range<'_>, Range<'_>) {
    let grid = Grid::of::<BINS>(&range.extents.middles);
    let step = (range.items.len() / COUNTED).max(1);
    match Bins::<BINS>::of(range.items.iter().step_by(step), &grid).best_cut(step) {
        Some(cut) => range.parted(|item| grid.place::<BINS>(item, cut.axis) < cut.end),
        None => range.halved(),
    }
}

/// What falls between two parallel planes.
#[derive(Clone, Copy)]
struct Bin {
    around: Extent,
    count: usize,
}

const EMPTY_BIN: Bin = Bin { around: Extent::EMPTY, count: 0 };

/// Bins along each axis.
struct Bins<const BINS: usize>([[Bin; BINS]; 3]);

/// Where the bins of a range lie.
#[derive(Clone, Copy)]
struct Grid {
    low: [f32; 3],
    scale: [f32; 3],
}

/// Items of bins below `end` along `axis` go to one side.
#[derive(Clone, Copy)]
struct Cut {
    axis: usize,
    end: usize,
}

impl Grid {
    #[expect(clippy::cast_precision_loss, reason = "sixteen at most")]
    fn of<const BINS: usize>(middles: &Extent) -> Self {
        let scale = middles.size().map(|size| if size > 0.0 { BINS as f32 / size } else { 0.0 });
        let [x, y, z, ..] = middles.0;
        Self { low: [x, y, z], scale }
    }

    /// The number of an item's bin along an axis.
    ///
    /// A number that is much larger than another is added to it, which leaves the other's nearest whole number in the last
    /// digits: a conversion would ask about NaN and about numbers that do not fit.
    #[inline(always)]
    fn place<const BINS: usize>(&self, item: &Item, axis: usize) -> usize {
        const LARGE: f32 = 12_582_912.0;
        let at = (item.middle(axis) - self.low[axis]) * self.scale[axis];
        let place = ((at - 0.5) + LARGE).to_bits().wrapping_sub(LARGE.to_bits());
        (place as usize).min(BINS - 1)
    }
}

impl<const BINS: usize> Bins<BINS> {
    fn of<'a>(items: impl Iterator<Item = &'a Item>, grid: &Grid) -> Self {
        let mut bins = Self([[EMPTY_BIN; BINS]; 3]);
        for item in items {
            for (axis, bins) in bins.0.iter_mut().enumerate() {
                let bin = &mut bins[grid.place::<BINS>(item, axis)];
                bin.around.add(&item.0);
                bin.count += 1;
            }
        }
        bins
    }

    /// The cut with the least sum of surface times leaves, where each counted item stands for `step`; `None` where
    /// all are in one bin.
    fn best_cut(&self, step: usize) -> Option<Cut> {
        let mut best = None;
        let mut least = f32::INFINITY;
        for (axis, bins) in self.0.iter().enumerate() {
            let after = costs_from_the_end(bins, step);
            let mut before = EMPTY_BIN;
            for end in 1..BINS {
                before = before.join(&bins[end - 1]);
                let (Some(cost_before), Some(cost_after)) = (before.cost(step), after[end]) else { continue };
                if cost_before + cost_after < least {
                    least = cost_before + cost_after;
                    best = Some(Cut { axis, end });
                }
            }
        }
        best
    }
}

/// For each bin the cost of it and all that follow.
fn costs_from_the_end<const BINS: usize>(bins: &[Bin; BINS], step: usize) -> [Option<f32>; BINS] {
    let mut costs = [None; BINS];
    let mut after = EMPTY_BIN;
    for (cost, bin) in costs.iter_mut().zip(bins).rev() {
        after = after.join(bin);
        *cost = after.cost(step);
    }
    costs
}

impl Bin {
    fn join(&self, other: &Self) -> Self {
        Self { around: self.around.join(&other.around), count: self.count + other.count }
    }

    /// Surface times leaves, if anything is there.
    #[expect(clippy::cast_precision_loss, reason = "a heuristic")]
    fn cost(&self, step: usize) -> Option<f32> {
        (self.count > 0).then(|| self.around.area() * (self.count * step).div_ceil(WIDTH) as f32)
    }
}

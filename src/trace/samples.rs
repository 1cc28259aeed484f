//! Sample points within a pixel.

/// A regular grid of sample points in each pixel: those of a picture that is `side` times finer. One pass over the
/// picture takes one of them in every pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SampleGrid {
    side: u32,
}

/// One point of the grid, as an offset in pixels of the finer picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SamplePoint {
    /// From the left.
    pub column: u32,
    /// From the top.
    pub row: u32,
}

impl SampleGrid {
    /// The pixel's centre alone.
    pub const CENTER: Self = Self { side: 1 };

    /// `side` by `side` points; 0 is taken for 1.
    pub fn new(side: u32) -> Self {
        Self { side: side.max(1) }
    }

    /// Points along each side of a pixel.
    pub fn side(self) -> u32 {
        self.side
    }

    /// Points in a pixel, which is the number of passes.
    pub fn count(self) -> u32 {
        self.side * self.side
    }

    /// The point that a pass takes. A grid with a point in the pixel's centre begins there, and each `side` points
    /// in a row lie in as many rows and columns, so that a picture can be looked at before it is complete. The order
    /// is the same for everyone, because the last digit of a sum depends on it.
    #[inline(never)]
    pub fn point(self, pass: u32) -> SamplePoint {
        let side = self.side;
        let (round, turn) = (pass / side % side, pass % side);
        let column = turn * stride(side);
        let row = (column % side) * stride(side) + round;
        SamplePoint { column: (side / 2 + column) % side, row: (side / 2 + row) % side }
    }

    /// The moment of a pass, as a share of the time that all passes take together, 0 to 1: the middle of a part of its
    /// own, of as many equal parts as there are passes. Those of passes that follow each other lie far apart.
    pub fn moment(self, pass: u32) -> f64 {
        let count = self.count();
        let part = u64::from(pass) * u64::from(stride(count)) % u64::from(count);
        // Begins with the middle one, so that a single sample shows the middle of the time.
        let part = (part + u64::from(count / 2)) % u64::from(count);
        (f64::from(u32::try_from(part).unwrap_or(0)) + 0.5) / f64::from(count)
    }
}

/// A step near the golden section of a number, and prime to it, so that it meets every number below.
fn stride(count: u32) -> u32 {
    let section = (count * 5 / 8).max(1);
    (section..).find(|&stride| greatest_common_divisor(stride, count) == 1).unwrap_or(1)
}

fn greatest_common_divisor(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(grid: SampleGrid) -> Vec<SamplePoint> {
        (0..grid.count()).map(|pass| grid.point(pass)).collect()
    }

    fn distinct(values: impl Iterator<Item = u32>) -> usize {
        values.collect::<std::collections::BTreeSet<_>>().len()
    }

    #[test]
    fn every_point_is_taken_once_and_an_odd_grid_starts_in_the_middle() {
        for side in 1..=64 {
            let grid = SampleGrid::new(side);
            let mut points = points(grid);
            if side % 2 == 1 {
                assert_eq!(points[0], SamplePoint { column: side / 2, row: side / 2 }, "side {side}");
            }
            points.sort_by_key(|point| (point.row, point.column));
            points.dedup();
            assert_eq!(points.len(), grid.count() as usize, "side {side}");
            assert!(points.iter().all(|point| point.row < side && point.column < side), "side {side}");
        }
    }

    #[test]
    fn each_round_lies_in_as_many_rows_and_columns() {
        for side in 1..=64 {
            for round in points(SampleGrid::new(side)).chunks(side as usize) {
                assert_eq!(distinct(round.iter().map(|point| point.row)), side as usize, "side {side}");
                assert_eq!(distinct(round.iter().map(|point| point.column)), side as usize, "side {side}");
            }
        }
    }

    #[test]
    fn the_moments_of_all_passes_are_evenly_spaced() {
        for side in 1..=64 {
            let grid = SampleGrid::new(side);
            let mut moments: Vec<f64> = (0..grid.count()).map(|pass| grid.moment(pass)).collect();
            if side % 2 == 1 {
                assert_eq!(moments[0], 0.5, "side {side}");
            }
            moments.sort_by(f64::total_cmp);
            for (part, moment) in (0..grid.count()).zip(moments) {
                assert_eq!(moment, (f64::from(part) + 0.5) / f64::from(grid.count()), "side {side}");
            }
        }
    }

    #[test]
    fn the_smallest_grids_are_these() {
        assert_eq!(SampleGrid::new(0), SampleGrid::CENTER);
        assert_eq!(points(SampleGrid::CENTER), [SamplePoint { column: 0, row: 0 }]);
        let all = points(SampleGrid::new(3)).into_iter().map(|point| (point.column, point.row));
        let expected = [(1, 1), (2, 2), (0, 0), (1, 2), (2, 0), (0, 1), (1, 0), (2, 1), (0, 2)];
        assert_eq!(all.collect::<Vec<_>>(), expected);
    }
}

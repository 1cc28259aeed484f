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

    /// The point that a pass takes. The first one is the pixel's centre where the grid has it, and each beginning
    /// of the sequence is spread over the pixel, so that a picture can be looked at before it is complete. The order
    /// is the same for everyone because the sum of a pixel depends on it in the last digit.
    pub fn point(self, pass: u32) -> SamplePoint {
        let index = (self.count() / 2 + pass * self.stride()) % self.count();
        SamplePoint { column: index % self.side, row: index / self.side }
    }

    /// A step about as long as the golden section of the grid, and prime to its length, so that it meets every point.
    fn stride(self) -> u32 {
        let section = self.count() * 5 / 8;
        (section.max(1)..).find(|&stride| greatest_common_divisor(stride, self.count()) == 1).unwrap_or(1)
    }
}

fn greatest_common_divisor(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_point_is_taken_once_and_an_odd_grid_starts_in_the_middle() {
        for side in 1..=64 {
            let grid = SampleGrid::new(side);
            let mut points: Vec<_> = (0..grid.count()).map(|pass| grid.point(pass)).collect();
            if side % 2 == 1 {
                assert_eq!(points[0], SamplePoint { column: side / 2, row: side / 2 }, "side {side}");
            }
            points.sort_by_key(|point| (point.row, point.column));
            points.dedup();
            assert_eq!(points.len(), grid.count() as usize, "side {side}");
            assert!(points.iter().all(|point| point.row < side && point.column < side));
        }
    }
}

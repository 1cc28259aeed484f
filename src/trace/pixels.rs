//! Which pixels are traced together, and where their samples go.

use crate::geometry::Vector;

use super::Trail;
use super::packet::{BLOCK, LANES, VectorLanes};

/// Columns and rows in the film of pixels that are traced together.
#[derive(Clone, Copy, Debug)]
pub(super) struct PixelLanes {
    pub(super) columns: [u32; LANES],
    pub(super) rows: [u32; LANES],
    /// How many there are; what follows is idle.
    pub(super) count: usize,
}

impl PixelLanes {
    pub(super) const NONE: Self = Self { columns: [0; LANES], rows: [0; LANES], count: 0 };

    /// A rectangle of at most as many pixels as there are lanes, row by row.
    #[inline(always)]
    pub(super) fn rectangle((left, top): (u32, u32), (width, height): (u32, u32)) -> Self {
        // Nearly all are as wide as a block: a form without pushes, and rows written as slices, saved 3 % of a frame.
        if width == BLOCK[0] {
            return Self::rows_of::<{ BLOCK[0] }>(left, top, height);
        }
        let mut pixels = Self::NONE;
        for (row, column) in (0..height).flat_map(|row| (0..width).map(move |column| (row, column))) {
            pixels.push(left + column, top + row);
        }
        pixels
    }

    #[inline(always)]
    fn rows_of<const WIDTH: u32>(left: u32, top: u32, height: u32) -> Self {
        let mut pixels = Self { count: (WIDTH * height) as usize, ..Self::NONE };
        for ((column, row), lane) in pixels.columns.iter_mut().zip(&mut pixels.rows).zip(0..) {
            *column = left + lane % WIDTH;
            *row = top + lane / WIDTH;
        }
        pixels
    }

    /// One more pixel; there must be room.
    #[inline(always)]
    pub(super) fn push(&mut self, column: u32, row: u32) {
        self.columns[self.count] = column;
        self.rows[self.count] = row;
        self.count += 1;
    }
}

/// Samples of the pixels of a packet.
#[derive(Clone, Copy, Debug)]
pub(super) struct SampleLanes {
    /// Red, green and blue as x, y and z, 0 to 1.
    pub(super) colors: VectorLanes<f64>,
    /// What the samples met, if that was asked for.
    pub(super) trails: [Trail; LANES],
}

impl SampleLanes {
    /// Nothing met, nothing seen.
    pub(super) fn black() -> Self {
        Self { colors: VectorLanes::zero(), trails: [Trail::default(); LANES] }
    }

    /// The colour of a lane.
    #[inline(always)]
    pub(super) fn get(&self, lane: usize) -> [f64; 3] {
        let color = self.colors.get(lane);
        [color.x, color.y, color.z]
    }

    /// Sets a lane.
    pub(super) fn set(&mut self, lane: usize, color: [f64; 3], trail: Trail) {
        let [x, y, z] = color;
        self.colors.set(lane, Vector::new(x, y, z));
        self.trails[lane] = trail;
    }
}

/// Pixels to be traced.
pub(super) trait PixelQueue {
    /// The next ones; none are left when there are none among them.
    fn next(&mut self) -> PixelLanes;

    /// Takes the samples of those that were given out last.
    fn put(&mut self, samples: &SampleLanes);
}

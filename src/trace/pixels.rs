//! Which pixels are traced together, and where their samples go.

use super::Trail;
use super::packet::{BLOCK, LANES};

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
        let (columns, rows) = const { places(WIDTH) };
        let mut pixels = Self { columns, rows, count: (WIDTH * height) as usize };
        for lane in 0..LANES {
            pixels.columns[lane] += left;
            pixels.rows[lane] += top;
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

/// Columns and rows of all lanes in rows of this width.
const fn places(width: u32) -> ([u32; LANES], [u32; LANES]) {
    let (mut columns, mut rows) = ([0; LANES], [0; LANES]);
    let mut lane = 0;
    while (lane as usize) < LANES {
        columns[lane as usize] = lane % width;
        rows[lane as usize] = lane / width;
        lane += 1;
    }
    (columns, rows)
}

/// Samples of the pixels of a packet.
#[derive(Clone, Copy, Debug)]
pub(super) struct SampleLanes {
    /// Red, green and blue, 0 to 1: as a film holds them, so that rows of a block are copied as they are.
    pub(super) colors: [[f64; 3]; LANES],
    /// What the samples met, if that was asked for.
    pub(super) trails: [Trail; LANES],
}

impl SampleLanes {
    /// Nothing met, nothing seen.
    pub(super) fn black() -> Self {
        Self { colors: [[0.0; 3]; LANES], trails: [Trail::default(); LANES] }
    }

    /// Sets a lane.
    pub(super) fn set(&mut self, lane: usize, color: [f64; 3], trail: Trail) {
        self.colors[lane] = color;
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

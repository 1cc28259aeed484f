//! Samples where they matter: which pixels of a film want more of them.
//!
//! The points of a [`SampleGrid`](super::SampleGrid) are taken one after the other, first in every pixel, then only where the
//! picture is not known well enough yet. A pixel that takes them all has the very bits that it has without any of this.
//!
//! After the first sample a pixel goes on if it differs from a neighbour that met other things, or lies where the picture
//! bends (an edge of a pattern, a highlight). Later it goes on while its own samples differ: T. Whitted, "An Improved
//! Illumination Model for Shaded Display", CACM 23(6), 1980, subdivides by contrast; what the rays met finds the edges of
//! objects and shadows as well where mirrors show them.

use crate::film::Film;
use crate::geometry::Real;

use super::{Counts, Exposure, Simd, Trail};

/// Rows of a film that one thread refines: few enough that all threads have work to the end.
const BAND_HEIGHT: u32 = 8;
/// Rows and columns that are refined together, as far as they want it.
const BLOCK: u32 = 4;

/// What is known of the samples of a film, while it is traced and afterwards.
#[derive(Clone, Debug)]
pub struct Refinement {
    side: u32,
    threshold: f64,
    /// Samples that each pixel has.
    samples: Vec<u16>,
    /// Sums of the squares of the samples' channels.
    squares: Vec<[f32; 3]>,
    /// What the first sample met.
    trails: Vec<Trail>,
    /// Columns and rows of the pixels that want more, by bands.
    wanting: Vec<Vec<[u32; 2]>>,
}

/// Some rows of a film that is being refined.
#[derive(Debug)]
pub struct RefinedBand<'a> {
    top: u32,
    side: u32,
    threshold: f64,
    sums: &'a mut [[f64; 3]],
    samples: &'a mut [u16],
    squares: &'a mut [[f32; 3]],
    trails: &'a mut [Trail],
    wanting: &'a mut Vec<[u32; 2]>,
}

impl Refinement {
    /// For a film of `side` by `side` pixels, each of which is done as soon as its error is expected to be no more than
    /// the threshold. All want their first sample.
    pub fn new(side: u32, threshold: f64) -> Self {
        let count = side as usize * side as usize;
        let tops = (0..side).step_by(BAND_HEIGHT as usize);
        Self {
            side,
            threshold,
            samples: vec![0; count],
            squares: vec![[0.0; 3]; count],
            trails: vec![Trail::default(); count],
            wanting: tops.map(|top| pixels_of(side, top).collect()).collect(),
        }
    }

    /// Samples that each pixel has, top row first.
    pub fn samples(&self) -> &[u16] {
        &self.samples
    }

    /// Samples that a pixel has on average.
    pub fn mean_samples(&self) -> f64 {
        let sum: f64 = self.samples.iter().map(|&samples| f64::from(samples)).sum();
        sum / (f64::from(self.side) * f64::from(self.side)).max(1.0)
    }

    /// Whether no pixel wants more.
    pub fn is_done(&self) -> bool {
        self.wanting.iter().all(Vec::is_empty)
    }

    /// Whether pixels are asked after this many samples if they want more: after the first one, and whenever their number
    /// has doubled from a row of the grid on.
    pub fn is_checked_after(samples: u32, side: u32) -> bool {
        samples == 1 || (samples.is_multiple_of(side) && (samples / side).is_power_of_two())
    }

    /// Cut into rows, with those of the film, which must have the same size.
    pub fn bands<'a>(&'a mut self, film: &'a mut Film) -> Vec<RefinedBand<'a>> {
        let rows = BAND_HEIGHT as usize * self.side as usize;
        let (side, threshold) = (self.side, self.threshold);
        let parts = film.pixels_mut().chunks_mut(rows).zip(self.samples.chunks_mut(rows));
        let parts = parts.zip(self.squares.chunks_mut(rows)).zip(self.trails.chunks_mut(rows));
        let tops = (0..side).step_by(BAND_HEIGHT as usize);
        tops.zip(parts.zip(&mut self.wanting))
            .map(|(top, ((((sums, samples), squares), trails), wanting))| RefinedBand {
                top,
                side,
                threshold,
                sums,
                samples,
                squares,
                trails,
                wanting,
            })
            .collect()
    }

    /// The errors (0 to 1) to be expected of the pixels of a film that has one sample of each, as those that have met what
    /// and look how around them tell; top row first.
    pub fn expected_errors(&self, film: &Film) -> Vec<f64> {
        let around = Around { side: self.side, colors: film.pixels(), trails: &self.trails };
        let pixels = (0..self.side).flat_map(|row| (0..self.side).map(move |column| (column, row)));
        pixels.map(|(column, row)| around.error(column, row)).collect()
    }

    /// After the first sample: the pixels of each band that want more, and what is around them.
    pub fn bands_around<'a>(&'a mut self, film: &'a Film) -> impl Iterator<Item = BandAround<'a>> {
        let Self { side, threshold, trails, wanting, .. } = self;
        let around = Around { side: *side, colors: film.pixels(), trails };
        wanting.iter_mut().map(move |wanting| BandAround { around, threshold: *threshold, wanting })
    }

    /// Makes means of the sums.
    pub fn divide(&self, film: &mut Film) {
        for (pixel, &samples) in film.pixels_mut().iter_mut().zip(&self.samples) {
            let count = f64::from(samples.max(1));
            *pixel = pixel.map(|channel| channel / count);
        }
    }
}

/// Some rows of a film of single samples, and what is around them.
#[derive(Debug)]
pub struct BandAround<'a> {
    around: Around<'a>,
    threshold: f64,
    wanting: &'a mut Vec<[u32; 2]>,
}

impl BandAround<'_> {
    /// Lets the pixels go that what is around them says enough of. Returns how many.
    pub fn look(&mut self) -> u64 {
        let Self { around, threshold, wanting } = self;
        let before = wanting.len();
        wanting.retain(|&[column, row]| around.error(column, row) > *threshold);
        (before - wanting.len()) as u64
    }
}

impl RefinedBand<'_> {
    /// Takes one more sample of each pixel that wants one.
    pub fn trace<T: Real>(&mut self, exposure: &Exposure<'_, T>, simd: Simd, pass: u32) -> Counts {
        let Self { top, side, sums, samples, squares, trails, wanting, .. } = self;
        exposure.trace_listed(simd, pass, wanting, |place, color, trail| {
            let [column, row] = wanting[place];
            let index = (row - *top) as usize * *side as usize + column as usize;
            for channel in 0..3 {
                sums[index][channel] += color[channel];
                let single = narrow(color[channel]);
                squares[index][channel] += single * single;
            }
            samples[index] += 1;
            if pass == 0 {
                sums[index] = color;
                trails[index] = trail;
            }
        })
    }

    /// Lets the pixels go whose own samples say enough. Returns how many.
    pub fn look_inside(&mut self) -> u64 {
        let Self { top, side, threshold, sums, samples, squares, wanting, .. } = self;
        let before = wanting.len();
        wanting.retain(|&[column, row]| {
            let index = (row - *top) as usize * *side as usize + column as usize;
            error_of_mean(sums[index], squares[index], samples[index]) > *threshold
        });
        (before - wanting.len()) as u64
    }

    /// Pixels that want more.
    pub fn wanting(&self) -> u64 {
        self.wanting.len() as u64
    }
}

/// The error to expect of a mean, 0 to 1: the samples' standard deviation by the 3/4th power of their number. That is how
/// the share of a pixel on one side of an edge is found by points of a regular grid; noise goes down by the square root.
pub fn error_of_mean(sums: [f64; 3], squares: [f32; 3], samples: u16) -> f64 {
    let count = f64::from(samples);
    let variance = |channel: usize| {
        let mean = sums[channel] / count;
        (f64::from(squares[channel]) / count - mean * mean).max(0.0)
    };
    let largest = variance(0).max(variance(1)).max(variance(2));
    largest.sqrt() / (count.sqrt() * count.sqrt().sqrt())
}

/// Single samples, and what is beside them.
#[derive(Clone, Copy, Debug)]
struct Around<'a> {
    side: u32,
    colors: &'a [[f64; 3]],
    trails: &'a [Trail],
}

impl Around<'_> {
    /// The error to expect of one sample in the middle of a pixel, 0 to 1: three tenths of the contrast, which is the
    /// standard deviation of the share of a pixel behind an edge that lies anywhere in it.
    fn error(&self, column: u32, row: u32) -> f64 {
        const SHARE: f64 = 0.3;
        let here = self.index(column, row);
        let mut most = 0.0_f64;
        for (right, down) in [(1, 0), (0, 1), (1, 1), (1, -1)] {
            let ways = [self.beside(column, row, (right, down)), self.beside(column, row, (-right, -down))];
            for there in ways.into_iter().flatten().filter(|&there| self.trails[there] != self.trails[here]) {
                most = most.max(contrast(self.colors[here], self.colors[there]));
            }
            let [one, other] = ways.map(|there| self.colors[there.unwrap_or(here)]);
            most = most.max(bend(one, self.colors[here], other));
        }
        SHARE * most
    }

    fn index(&self, column: u32, row: u32) -> usize {
        row as usize * self.side as usize + column as usize
    }

    fn beside(&self, column: u32, row: u32, (right, down): (i32, i32)) -> Option<usize> {
        let column = column.checked_add_signed(right).filter(|&column| column < self.side)?;
        let row = row.checked_add_signed(down).filter(|&row| row < self.side)?;
        Some(self.index(column, row))
    }
}

/// The largest difference of a channel.
fn contrast(a: [f64; 3], b: [f64; 3]) -> f64 {
    largest(|channel| a[channel] - b[channel])
}

/// How far a channel in the middle is from the line through those beside it, doubled.
fn bend(one: [f64; 3], middle: [f64; 3], other: [f64; 3]) -> f64 {
    largest(|channel| 2.0 * middle[channel] - one[channel] - other[channel])
}

fn largest(of_channel: impl Fn(usize) -> f64) -> f64 {
    (0..3).map(|channel| of_channel(channel).abs()).fold(0.0, f64::max)
}

/// The pixels of a band, block by block, so that those near each other are traced together.
fn pixels_of(side: u32, top: u32) -> impl Iterator<Item = [u32; 2]> {
    let bottom = (top + BAND_HEIGHT).min(side);
    let blocks = (top..bottom)
        .step_by(BLOCK as usize)
        .flat_map(move |row| (0..side).step_by(BLOCK as usize).map(move |column| (column, row)));
    blocks.flat_map(move |(left, above)| {
        (above..(above + BLOCK).min(bottom))
            .flat_map(move |row| (left..(left + BLOCK).min(side)).map(move |column| [column, row]))
    })
}

#[expect(clippy::cast_possible_truncation, reason = "an estimate needs no more")]
fn narrow(channel: f64) -> f32 {
    channel as f32
}

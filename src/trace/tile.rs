//! A rectangle of pixels.

use crate::film::FilmBand;
use crate::geometry::Real;

use super::packet::{BLOCK_SIDE, Block, Bounds, Scratch};
use super::radiance::radiance;
use super::{CameraRays, Counts, Kernel, SampleGrid, SampleId, SceneTables, Simd};

/// What a picture is traced from, and how.
#[derive(Clone, Copy, Debug)]
pub struct Exposure<'a, T: Real> {
    /// Objects and lights.
    pub tables: &'a SceneTables<T>,
    /// Rays through the centres of the picture's pixels.
    pub camera: &'a CameraRays<T>,
    /// Rays that may follow each other.
    pub level: u32,
    /// Where pixels are sampled.
    pub grid: SampleGrid,
    /// What to trace with: one that has the effects of tables and camera. Which one decides about time alone.
    pub kernel: Kernel,
}

impl<T: Real> Exposure<'_, T> {
    /// One sample of every pixel of a band of rows, clamped to 0..=1: the first pass sets the pixels, later ones add to
    /// them, and after the last they hold the sum over the grid. The band is traced tile by tile, each as wide as it is
    /// high. `keep_going` is asked before each four rows of a tile; what comes after a no keeps what it held.
    pub fn trace_band(
        &self,
        simd: Simd,
        pass: u32,
        band: &mut FilmBand<'_>,
        keep_going: impl Fn() -> bool,
    ) -> Counts {
        // The samples of a pixel are the pixel centres of a finer picture.
        let camera = self.camera.refined(self.grid.side());
        let bounds = Bounds::new(self.tables);
        let gain = camera.effects().gain();
        let task = BandTask { exposure: self, camera: &camera, bounds: &bounds, pass, gain };
        let mut counts = Counts::default();
        let mut scratch = Scratch::new();
        let (side, height) = (band.side(), band.height());
        let tiles = (0..side).step_by(height.max(1) as usize);
        let strips =
            tiles.flat_map(|left| (0..height).step_by(BLOCK_SIDE as usize).map(move |row| (left, row)));
        for (left, row) in strips.take_while(|_| keep_going()) {
            let size = (height.min(side - left), BLOCK_SIDE.min(height - row));
            counts +=
                simd.trace(self.kernel, &task, &mut Band { film: &mut *band, left, row, size }, &mut scratch);
        }
        counts
    }
}

/// Some rows of a tile.
pub(super) struct Band<'a, 'b> {
    film: &'a mut FilmBand<'b>,
    /// Its first column, and its first row in the band of the film.
    left: u32,
    row: u32,
    /// Columns and rows.
    size: (u32, u32),
}

/// What bands are traced from.
pub(super) struct BandTask<'a, T: Real> {
    exposure: &'a Exposure<'a, T>,
    camera: &'a CameraRays<T>,
    bounds: &'a Bounds<T>,
    pass: u32,
    /// What all light is multiplied by before it is cut off; packets are for cameras with 1.
    gain: f64,
}

impl<T: Real> BandTask<'_, T> {
    /// Traces a band block by block, with the effects of these bits.
    #[inline(always)]
    pub(super) fn trace_packets<const EFFECTS: u32>(
        &self,
        band: &mut Band<'_, '_>,
        scratch: &mut Scratch<T>,
    ) -> Counts {
        let mut counts = Counts::default();
        let Exposure { tables, level, grid, .. } = *self.exposure;
        let (side, point) = (grid.side(), grid.point(self.pass));
        let block = Block { tables, bounds: self.bounds, camera: self.camera, level, step: side };
        let (width, height) = band.size;
        for first in (0..width).step_by(BLOCK_SIDE as usize) {
            let corner = ((band.left + first) * side + point.column, band.top() * side + point.row);
            let columns = (width - first).min(BLOCK_SIDE);
            let put = |row: u32, column: u32, sample| {
                self.put(band.pixel(row, first + column), sample);
            };
            if level == 0 {
                blacken(columns, height, put);
            } else {
                block.trace::<EFFECTS>(corner, (columns, height), scratch, &mut counts, put);
            }
        }
        counts
    }

    /// Traces a band pixel by pixel, with every effect.
    pub(super) fn trace_each(&self, band: &mut Band<'_, '_>) -> Counts {
        let mut counts = Counts::default();
        let (width, height) = band.size;
        for (row, column) in (0..height).flat_map(|row| (0..width).map(move |column| (row, column))) {
            let sample = self.sample(band.left + column, band.top() + row, &mut counts);
            self.put(band.pixel(row, column), sample);
        }
        counts
    }

    fn sample(&self, column: u32, row: u32, counts: &mut Counts) -> [f64; 3] {
        let Exposure { tables, level, grid, .. } = *self.exposure;
        if level == 0 {
            return [0.0; 3];
        }
        let (side, point) = (grid.side(), grid.point(self.pass));
        let sample = SampleId { column, row, index: self.pass };
        let start = self.camera.sample(column * side + point.column, row * side + point.row, sample);
        counts.rays.primary += 1;
        let color = radiance(tables, start, level, sample, counts);
        counts.clamp(color.to_f64().map(|channel| channel * self.gain))
    }

    #[inline(always)]
    fn put(&self, pixel: &mut [f64; 3], sample: [f64; 3]) {
        if self.pass == 0 {
            *pixel = sample;
        } else {
            add(pixel, sample);
        }
    }
}

impl Band<'_, '_> {
    /// Its first row in the film.
    #[inline(always)]
    fn top(&self) -> u32 {
        self.film.top() + self.row
    }

    /// The pixel in this row and column of it.
    #[inline(always)]
    fn pixel(&mut self, row: u32, column: u32) -> &mut [f64; 3] {
        self.film.pixel_mut(self.row + row, self.left + column)
    }
}

/// At level 0 no ray is traced.
fn blacken(width: u32, height: u32, mut put: impl FnMut(u32, u32, [f64; 3])) {
    for row in 0..height {
        for column in 0..width {
            put(row, column, [0.0; 3]);
        }
    }
}

fn add(pixel: &mut [f64; 3], sample: [f64; 3]) {
    for (sum, channel) in pixel.iter_mut().zip(sample) {
        *sum += channel;
    }
}

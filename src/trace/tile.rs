//! A rectangle of pixels.

use crate::effects::Effect;
use crate::film::FilmTile;
use crate::geometry::Real;

use super::kernel::has;
use super::packet::{BLOCK_SIDE, Block, Bounds, Scratch};
use super::radiance::radiance_of;
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
    /// One sample of every pixel of a tile, clamped to 0..=1: the first pass sets the pixels, later ones add to them,
    /// and after the last they hold the sum over the grid. `keep_going` is asked before each band of four rows; the
    /// rows after a no keep what they held.
    pub fn trace_tile(
        &self,
        simd: Simd,
        pass: u32,
        tile: &mut FilmTile<'_>,
        keep_going: impl Fn() -> bool,
    ) -> Counts {
        // The samples of a pixel are the pixel centres of a finer picture.
        let camera = self.camera.refined(self.grid.side());
        let bounds = Bounds::new(self.tables);
        let gain = camera.effects().gain();
        let task = BandTask { exposure: self, camera: &camera, bounds: &bounds, pass, gain };
        let mut counts = Counts::default();
        let mut scratch = Scratch::new();
        let left = tile.left();
        for (top, rows) in tile.bands_mut(BLOCK_SIDE).take_while(|_| keep_going()) {
            counts += simd.trace(self.kernel, &task, &mut Band { left, top, rows }, &mut scratch);
        }
        counts
    }
}

/// Some rows of a tile.
pub(super) struct Band<'a, 'b> {
    left: u32,
    top: u32,
    rows: &'a mut [&'b mut [[f64; 3]]],
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
        let (width, height) = band.size();
        for first in (0..width).step_by(BLOCK_SIDE as usize) {
            let corner = ((band.left + first) * side + point.column, band.top * side + point.row);
            let columns = (width - first).min(BLOCK_SIDE);
            let put = |row: usize, column: usize, sample| {
                self.put(&mut band.rows[row][first as usize + column], sample);
            };
            if level == 0 {
                blacken(columns, height, put);
            } else {
                block.trace::<EFFECTS>(corner, (columns, height), scratch, &mut counts, put);
            }
        }
        counts
    }

    /// Traces a band pixel by pixel, with the effects of these bits.
    pub(super) fn trace_each<const EFFECTS: u32>(&self, band: &mut Band<'_, '_>) -> Counts {
        let mut counts = Counts::default();
        let (width, height) = band.size();
        for (row, column) in (0..height).flat_map(|row| (0..width).map(move |column| (row, column))) {
            let sample = self.sample::<EFFECTS>(band.left + column, band.top + row, &mut counts);
            self.put(&mut band.rows[row as usize][column as usize], sample);
        }
        counts
    }

    fn sample<const EFFECTS: u32>(&self, column: u32, row: u32, counts: &mut Counts) -> [f64; 3] {
        let Exposure { tables, level, grid, .. } = *self.exposure;
        if level == 0 {
            return [0.0; 3];
        }
        let (side, point) = (grid.side(), grid.point(self.pass));
        let sample = SampleId { column, row, index: self.pass };
        let start =
            self.camera.sample_of::<EFFECTS>(column * side + point.column, row * side + point.row, sample);
        counts.rays.primary += 1;
        let color = radiance_of::<T, EFFECTS>(tables, start, level, sample, counts);
        let color = color.to_f64();
        let exposed =
            if has::<EFFECTS>(Effect::Exposure) { color.map(|channel| channel * self.gain) } else { color };
        counts.clamp(exposed)
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
    /// Columns and rows.
    #[inline(always)]
    fn size(&self) -> (u32, u32) {
        (self.rows.first().map_or(0, |row| small(row.len())), small(self.rows.len()))
    }
}

/// At level 0 no ray is traced.
fn blacken(width: u32, height: u32, mut put: impl FnMut(usize, usize, [f64; 3])) {
    for row in 0..height as usize {
        for column in 0..width as usize {
            put(row, column, [0.0; 3]);
        }
    }
}

/// A number of pixels in a tile, which is no larger than a film.
#[inline(always)]
fn small(count: usize) -> u32 {
    u32::try_from(count).unwrap_or(0)
}

fn add(pixel: &mut [f64; 3], sample: [f64; 3]) {
    for (sum, channel) in pixel.iter_mut().zip(sample) {
        *sum += channel;
    }
}

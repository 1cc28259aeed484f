//! A rectangle of pixels.

use crate::film::FilmTile;
use crate::geometry::Real;

use super::{CameraRays, Counts, SampleGrid, SceneTables, radiance};

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
}

impl<T: Real> Exposure<'_, T> {
    /// One sample of every pixel of a tile, clamped to 0..=1: the first pass sets the pixels, later ones add to them,
    /// and after the last they hold the sum over the grid. `keep_going` is asked before each row; the rows after a no
    /// keep what they held.
    pub fn trace_tile(&self, pass: u32, tile: &mut FilmTile<'_>, keep_going: impl Fn() -> bool) -> Counts {
        // The samples of a pixel are the pixel centres of a finer picture.
        let side = self.grid.side();
        let camera = self.camera.refined(side);
        let point = self.grid.point(pass);
        let mut counts = Counts::default();
        let left = tile.left();
        for (row, pixels) in tile.rows_mut().take_while(|_| keep_going()) {
            for (column, pixel) in (left..).zip(pixels) {
                let at = (column * side + point.column, row * side + point.row);
                let sample = self.sample(&camera, at, &mut counts);
                if pass == 0 {
                    *pixel = sample;
                } else {
                    add(pixel, sample);
                }
            }
        }
        counts
    }

    fn sample(&self, camera: &CameraRays<T>, (column, row): (u32, u32), counts: &mut Counts) -> [f64; 3] {
        if self.level == 0 {
            return [0.0; 3];
        }
        counts.rays.primary += 1;
        let start = camera.ray(column, row);
        let color = radiance(self.tables, start.ray, start.reach, self.level, counts).to_f64();
        if color.iter().all(|channel| channel.is_finite()) {
            color.map(|channel| channel.clamp(0.0, 1.0))
        } else {
            counts.non_finite += 1;
            [0.0; 3]
        }
    }
}

fn add(pixel: &mut [f64; 3], sample: [f64; 3]) {
    for (sum, channel) in pixel.iter_mut().zip(sample) {
        *sum += channel;
    }
}

//! A rectangle of pixels.

use crate::film::FilmTile;
use crate::geometry::Real;

use super::{CameraRays, Counts, SceneTables, radiance};

/// Traces every pixel of a tile: one ray through each pixel centre, clamped to 0..=1 as the last step. `keep_going`
/// is asked before each row; the rows after a no keep what they held.
pub fn trace_tile<T: Real>(
    tables: &SceneTables<T>,
    camera: &CameraRays<T>,
    level: u32,
    tile: &mut FilmTile<'_>,
    keep_going: impl Fn() -> bool,
) -> Counts {
    let mut counts = Counts::default();
    let left = tile.left();
    for (row, pixels) in tile.rows_mut().take_while(|_| keep_going()) {
        for (column, pixel) in (left..).zip(pixels) {
            *pixel = trace_pixel(tables, camera, level, (column, row), &mut counts);
        }
    }
    counts
}

fn trace_pixel<T: Real>(
    tables: &SceneTables<T>,
    camera: &CameraRays<T>,
    level: u32,
    (column, row): (u32, u32),
    counts: &mut Counts,
) -> [f64; 3] {
    if level == 0 {
        return [0.0; 3];
    }
    counts.rays.primary += 1;
    let start = camera.ray(column, row);
    let color = radiance(tables, start.ray, start.reach, level, counts).to_f64();
    if color.iter().all(|channel| channel.is_finite()) {
        color.map(|channel| channel.clamp(0.0, 1.0))
    } else {
        counts.non_finite += 1;
        [0.0; 3]
    }
}

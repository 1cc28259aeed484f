//! Parts of a picture, and what its pixels cost.

use rayon::prelude::*;

use crate::film::Film;
use crate::geometry::Real;
use crate::trace::{Counts, Exposure, SampleId, radiance};

use super::trace::trace_film;
use super::{Monitor, Workers};

/// Square parts of a picture, of `side` by `side` pixels each, whose first pixels are at these columns and rows: traced in
/// parallel, each as [`Exposure`] and threshold say, and counted each by itself. `None` if there is no memory for their films.
pub fn trace_windows<T: Real>(
    exposure: &Exposure<'_, T>,
    threshold: Option<f64>,
    (corners, side): (&[[u32; 2]], u32),
    workers: &Workers,
) -> Option<(Vec<Film>, Vec<Counts>)> {
    let trace = |&corner: &[u32; 2]| {
        let mut film = Film::new(side)?;
        let exposure = Exposure { corner, ..*exposure };
        let (counts, _) = trace_film(&exposure, threshold, &mut film, workers, &Monitor::default());
        Some((film, counts))
    };
    let traced: Option<Vec<_>> = workers.pool.install(|| corners.par_iter().map(trace).collect());
    Some(traced?.into_iter().unzip())
}

/// How many rays the first sample of each pixel takes, of all kinds together; top row first.
pub fn count_rays<T: Real>(exposure: &Exposure<'_, T>, workers: &Workers) -> Vec<u32> {
    let side = exposure.camera.pixels();
    let camera = exposure.camera.refined(exposure.grid.side());
    let point = exposure.grid.point(0);
    let count = |column: u32, row: u32| {
        let step = exposure.grid.side();
        let sample = SampleId { column, row, index: 0 };
        let start = camera.sample(column * step + point.column, row * step + point.row, sample);
        let mut counts = Counts::default();
        radiance(exposure.tables, start, exposure.depth, sample, &mut counts);
        // The camera's own ray is counted by the caller; there is none at level 0.
        let own = u64::from(exposure.depth.level > 0);
        u32::try_from(counts.rays.total() + own).unwrap_or(u32::MAX)
    };
    workers.pool.install(|| {
        let rows = (0..side).into_par_iter();
        rows.flat_map_iter(|row| (0..side).map(move |column| (column, row)))
            .map(|(column, row)| count(column, row))
            .collect()
    })
}

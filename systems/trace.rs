//! Tables to film.

use bevy_ecs::prelude::*;
use rayon::prelude::*;

use crate::components::{Adaptive, Cutoff, Sampling, Snapshot};
use crate::film::{Film, FilmBand};
use crate::geometry::Real;
use crate::trace::{Counts, Depth, Exposure, Refinement, SampleGrid};

use super::{Frame, FrameError, Monitor, Tables, Workers, trace_adaptive};

/// Traces the frame, bands in parallel. Every pixel is a function of the tables alone, and counts are whole
/// numbers, so neither depends on which thread did what.
pub(super) fn trace<T: Real>(
    tables: Res<Tables<T>>,
    (snapshot, sampling): (Res<Snapshot>, Res<Sampling>),
    (adaptive, cutoff): (Option<Res<Adaptive>>, Option<Res<Cutoff>>),
    (workers, monitor): (Res<Workers>, Res<Monitor>),
    mut frame: ResMut<Frame>,
) {
    let frame = &mut *frame;
    frame.counts = Counts::default();
    frame.error = None;
    let problems = tables.problems();
    let Some(camera) = tables.camera.as_ref().filter(|_| problems.is_empty()) else {
        frame.error = Some(FrameError::World(problems));
        return;
    };
    if frame.film.side() != camera.pixels() {
        let Some(film) = Film::new(camera.pixels()) else {
            frame.error = Some(FrameError::Memory(camera.pixels()));
            return;
        };
        frame.film = film;
    }
    let grid = SampleGrid::new(sampling.side);
    let kernel = workers.kernel_for(tables.effects());
    let depth = Depth { level: snapshot.level, cutoff: T::from_f64(cutoff.map_or(0.0, |cutoff| cutoff.0)) };
    let exposure = Exposure { depth, grid, kernel, ..Exposure::new(&tables.scene, camera, snapshot.level) };
    let threshold = adaptive.map(|adaptive| adaptive.threshold);
    (frame.counts, frame.refinement) = trace_film(&exposure, threshold, &mut frame.film, &workers, &monitor);
    if monitor.is_cancelled() {
        frame.error = Some(FrameError::Cancelled);
    }
}

/// Traces a film with as many samples everywhere, or until their error is expected to be no more than a threshold.
pub(super) fn trace_film<T: Real>(
    exposure: &Exposure<'_, T>,
    threshold: Option<f64>,
    film: &mut Film,
    workers: &Workers,
    monitor: &Monitor,
) -> (Counts, Option<Refinement>) {
    match threshold {
        None => (trace_picture(exposure, film, workers, monitor), None),
        Some(threshold) => {
            let (counts, refinement) = trace_adaptive(exposure, threshold, film, workers, monitor);
            (counts, Some(refinement))
        }
    }
}

/// Traces every pass and leaves the mean of the samples in the film, which must have the camera's size.
pub fn trace_picture<T: Real>(
    exposure: &Exposure<'_, T>,
    film: &mut Film,
    workers: &Workers,
    monitor: &Monitor,
) -> Counts {
    let mut counts = Counts::default();
    for pass in (0..exposure.grid.count()).take_while(|_| !monitor.is_cancelled()) {
        counts += trace_pass(exposure, pass, film, workers, monitor);
    }
    film.divide(exposure.grid.count());
    counts
}

/// Traces one sample of every pixel, bands in parallel: the first pass sets the film, later ones add to it. Once the
/// monitor is cancelled, no further row is begun.
pub fn trace_pass<T: Real>(
    exposure: &Exposure<'_, T>,
    pass: u32,
    film: &mut Film,
    workers: &Workers,
    monitor: &Monitor,
) -> Counts {
    let effects = exposure.camera.effects();
    film.set_transfer(effects.transfer());
    let tables = exposure.tables.at(T::from_f64(effects.second(exposure.grid, pass)));
    let exposure = Exposure { tables: &tables, ..*exposure };
    let (side, height) = (film.side(), workers.tile_size);
    let length = film.band_length(height);
    workers.pool.install(|| {
        // Band by band to the end: the last one to be done should not be one of many.
        let bands = film.pixels_mut().par_chunks_mut(length).with_max_len(1).enumerate();
        let each = bands.map(|(number, pixels)| {
            let area = pixels.len() as u64;
            let mut band = FilmBand::new(side, height, number, pixels);
            let counts = exposure.trace_band(workers.simd, pass, &mut band, || !monitor.is_cancelled());
            if !monitor.is_cancelled() {
                monitor.tile_done(area);
            }
            counts
        });
        each.reduce(Counts::default, |mut sum, counts| {
            sum += counts;
            sum
        })
    })
}

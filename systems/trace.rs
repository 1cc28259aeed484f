//! Tables to film.

use bevy_ecs::prelude::*;
use bevy_ecs::system::SystemParam;
use rayon::prelude::*;

use crate::components::{Adaptive, Cutoff, Sampling, Snapshot};
use crate::film::{Film, FilmBand};
use crate::geometry::Real;
use crate::trace::{Counts, Depth, Exposure, Refinement, SampleGrid};

use super::{Frame, FrameError, Monitor, Tables, Workers, trace_adaptive};

/// What is asked of a frame.
#[derive(SystemParam)]
pub(super) struct Settings<'w> {
    snapshot: Res<'w, Snapshot>,
    sampling: Res<'w, Sampling>,
    adaptive: Option<Res<'w, Adaptive>>,
    cutoff: Option<Res<'w, Cutoff>>,
    pub(super) workers: Res<'w, Workers>,
    pub(super) monitor: Res<'w, Monitor>,
}

impl Settings<'_> {
    /// What the frame is traced from, and how; or what is wrong with the World.
    pub(super) fn exposure<'a, T: Real>(&self, tables: &'a Tables<T>) -> Result<Exposure<'a, T>, FrameError> {
        let problems = tables.problems();
        let Some(camera) = tables.camera.as_ref().filter(|_| problems.is_empty()) else {
            return Err(FrameError::World(problems));
        };
        let level = self.snapshot.level;
        let cutoff = T::from_f64(self.cutoff.as_ref().map_or(0.0, |cutoff| cutoff.0));
        Ok(Exposure {
            depth: Depth { level, cutoff },
            grid: SampleGrid::new(self.sampling.side),
            kernel: self.workers.kernel_for(tables.effects()),
            ..Exposure::new(&tables.scene, camera, level)
        })
    }

    /// The expected error at which a pixel needs no more samples, where that is asked for.
    pub(super) fn threshold(&self) -> Option<f64> {
        self.adaptive.as_ref().map(|adaptive| adaptive.threshold)
    }
}

/// Traces the frame, bands in parallel. Every pixel is a function of the tables alone, and counts are whole
/// numbers, so neither depends on which thread did what.
pub(super) fn trace<T: Real>(tables: Res<Tables<T>>, settings: Settings, mut frame: ResMut<Frame>) {
    let frame = &mut *frame;
    frame.counts = Counts::default();
    frame.error = settings.exposure(&tables).and_then(|exposure| expose(&exposure, &settings, frame)).err();
}

/// Traces the frame's film.
pub(super) fn expose<T: Real>(
    exposure: &Exposure<'_, T>,
    settings: &Settings,
    frame: &mut Frame,
) -> Result<(), FrameError> {
    let side = exposure.camera.pixels();
    if frame.film.side() != side {
        frame.film = Film::new(side).ok_or(FrameError::Memory(side))?;
    }
    let (workers, monitor) = (&settings.workers, &settings.monitor);
    (frame.counts, frame.refinement) =
        trace_film(exposure, settings.threshold(), &mut frame.film, workers, monitor);
    if monitor.is_cancelled() { Err(FrameError::Cancelled) } else { Ok(()) }
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
            let mut band = FilmBand::new(side, height, number, pixels);
            trace_band(&exposure, pass, &mut band, workers, monitor)
        });
        each.reduce(Counts::default, sum)
    })
}

/// Traces one sample of every pixel of a band, and tells the monitor, unless that is cancelled.
pub(super) fn trace_band<T: Real>(
    exposure: &Exposure<'_, T>,
    pass: u32,
    band: &mut FilmBand<'_>,
    workers: &Workers,
    monitor: &Monitor,
) -> Counts {
    let counts = exposure.trace_band(workers.simd, pass, band, || !monitor.is_cancelled());
    if !monitor.is_cancelled() {
        monitor.tile_done(u64::from(band.side()) * u64::from(band.height()));
    }
    counts
}

/// What two bands have counted together.
pub(super) fn sum(mut one: Counts, other: Counts) -> Counts {
    one += other;
    one
}

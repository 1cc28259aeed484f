//! Tables to film.

use bevy_ecs::prelude::*;
use rayon::prelude::*;

use crate::components::Snapshot;
use crate::film::Film;
use crate::geometry::Real;
use crate::trace::{CameraRays, Counts, SceneTables, trace_tile};

use super::{Frame, FrameError, Monitor, Tables, Workers};

/// Traces the frame, tiles in parallel. Every pixel is a function of the tables alone, and counts are whole
/// numbers, so neither depends on which thread did what.
pub(super) fn trace<T: Real>(
    tables: Res<Tables<T>>,
    snapshot: Res<Snapshot>,
    workers: Res<Workers>,
    monitor: Res<Monitor>,
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
    frame.counts = trace_film(&tables.scene, camera, snapshot.level, &mut frame.film, &workers, &monitor);
    if monitor.is_cancelled() {
        frame.error = Some(FrameError::Cancelled);
    }
}

fn trace_film<T: Real>(
    scene: &SceneTables<T>,
    camera: &CameraRays<T>,
    level: u32,
    film: &mut Film,
    workers: &Workers,
    monitor: &Monitor,
) -> Counts {
    let mut tiles = film.tiles_mut(workers.tile_size);
    workers.pool.install(|| {
        let each = tiles.par_iter_mut().map(|tile| {
            let counts = trace_tile(scene, camera, level, tile, || !monitor.is_cancelled());
            if !monitor.is_cancelled() {
                monitor.tile_done(tile.area());
            }
            counts
        });
        each.reduce(Counts::default, |mut sum, counts| {
            sum += counts;
            sum
        })
    })
}

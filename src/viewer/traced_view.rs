//! A view of the scene as it is traced beside the window: tables and camera of one moment, which a World that goes
//! on does not change.

use std::sync::Arc;

use crate::components::{CameraPose, Lens};
use crate::film::Film;
use crate::geometry::Real;
use crate::systems::{Monitor, Workers, count_rays, trace_adaptive, trace_pass, trace_picture};
use crate::trace::{CameraEffects, CameraRays, Counts, Depth, Exposure, Refinement, SampleGrid, SceneTables};

/// Tables of either precision, shared with the World that they were extracted from.
#[derive(Clone, Debug)]
pub(crate) enum SharedTables {
    /// Double.
    F64(Arc<SceneTables<f64>>),
    /// Single.
    F32(Arc<SceneTables<f32>>),
}

/// What is traced. The tables must be without problems, and the lens within its ranges.
#[derive(Clone, Debug)]
pub(crate) struct TracedView {
    /// Objects and lights.
    pub(crate) tables: SharedTables,
    /// The camera as the window has it; traced is its [`traced_pose`].
    pub(crate) pose: CameraPose,
    /// What the camera shows.
    pub(crate) lens: Lens,
    /// What the camera does beyond that of a pinhole.
    pub(crate) effects: CameraEffects,
    /// Rays that may follow each other.
    pub(crate) level: u32,
    /// Share of the light in a pixel, 0 to 1, up to which no ray is followed.
    pub(crate) cutoff: f64,
}

/// How pixels are sampled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Samples {
    /// The points in each pixel; with a threshold the most there are.
    pub(crate) grid: SampleGrid,
    /// Expected error, 0 to 1, at which a pixel gets no more; nothing where all get the same.
    pub(crate) threshold: Option<f64>,
}

impl Samples {
    /// The same points in all pixels.
    pub(crate) fn of(grid: SampleGrid) -> Self {
        Self { grid, threshold: None }
    }
}

/// The pose that `render` computes from the printed numbers of a pose: eye, `l` as the direction to look in, `u` as
/// up. Tracing this one gives the bytes that `render` writes. A pose that has no direction stays as it is.
pub(crate) fn traced_pose(pose: &CameraPose) -> CameraPose {
    CameraPose::looking(pose.position, pose.l, pose.u).unwrap_or(*pose)
}

impl TracedView {
    /// One sample of every pixel of a film of any size, see [`trace_pass`].
    pub(super) fn trace_pass(
        &self,
        (grid, pass): (SampleGrid, u32),
        film: &mut Film,
        workers: &Workers,
        monitor: &Monitor,
    ) -> Counts {
        match &self.tables {
            SharedTables::F64(tables) => self.pass_of(tables, (grid, pass), film, workers, monitor),
            SharedTables::F32(tables) => self.pass_of(tables, (grid, pass), film, workers, monitor),
        }
    }

    /// The whole picture, see [`trace_picture`] and [`trace_adaptive`].
    pub(super) fn trace_picture(
        &self,
        samples: Samples,
        film: &mut Film,
        workers: &Workers,
        monitor: &Monitor,
    ) -> (Counts, Option<Refinement>) {
        match &self.tables {
            SharedTables::F64(tables) => self.picture_of(tables, samples, film, workers, monitor),
            SharedTables::F32(tables) => self.picture_of(tables, samples, film, workers, monitor),
        }
    }

    /// Rays of the first sample of each pixel, see [`count_rays`].
    pub(super) fn count_rays(&self, grid: SampleGrid, pixels: u32, workers: &Workers) -> Vec<u32> {
        match &self.tables {
            SharedTables::F64(tables) => {
                count_rays(&self.exposure(tables, &self.rays(tables, pixels), grid, workers), workers)
            }
            SharedTables::F32(tables) => {
                count_rays(&self.exposure(tables, &self.rays(tables, pixels), grid, workers), workers)
            }
        }
    }

    fn pass_of<T: Real>(
        &self,
        tables: &SceneTables<T>,
        (grid, pass): (SampleGrid, u32),
        film: &mut Film,
        workers: &Workers,
        monitor: &Monitor,
    ) -> Counts {
        let rays = self.rays(tables, film.side());
        trace_pass(&self.exposure(tables, &rays, grid, workers), pass, film, workers, monitor)
    }

    fn picture_of<T: Real>(
        &self,
        tables: &SceneTables<T>,
        samples: Samples,
        film: &mut Film,
        workers: &Workers,
        monitor: &Monitor,
    ) -> (Counts, Option<Refinement>) {
        let rays = self.rays(tables, film.side());
        let exposure = self.exposure(tables, &rays, samples.grid, workers);
        match samples.threshold {
            None => (trace_picture(&exposure, film, workers, monitor), None),
            Some(threshold) => {
                let (counts, refinement) = trace_adaptive(&exposure, threshold, film, workers, monitor);
                (counts, Some(refinement))
            }
        }
    }

    fn rays<T: Real>(&self, tables: &SceneTables<T>, pixels: u32) -> CameraRays<T> {
        let pose = traced_pose(&self.pose);
        CameraRays::in_unit(&pose, &self.lens, pixels, tables.unit).with_effects(self.effects)
    }

    fn exposure<'a, T: Real>(
        &self,
        tables: &'a SceneTables<T>,
        camera: &'a CameraRays<T>,
        grid: SampleGrid,
        workers: &Workers,
    ) -> Exposure<'a, T> {
        let kernel = workers.kernel_for(tables.effects().union(self.effects.set()));
        let depth = Depth { level: self.level, cutoff: T::from_f64(self.cutoff) };
        Exposure { grid, kernel, depth, ..Exposure::new(tables, camera, self.level) }
    }
}

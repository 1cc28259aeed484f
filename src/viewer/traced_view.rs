//! A view of the scene as it is traced beside the window: tables and camera of one moment, which a World that goes
//! on does not change.

use std::sync::Arc;

use crate::components::{CameraPose, Lens};
use crate::film::Film;
use crate::geometry::Real;
use crate::systems::{Monitor, Workers, trace_pass, trace_picture};
use crate::trace::{CameraEffects, CameraRays, Counts, Exposure, Kernel, SampleGrid, SceneTables};

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
        let pixels = film.side();
        match &self.tables {
            SharedTables::F64(tables) => trace_pass(
                &self.exposure(tables, &self.rays(pixels), grid, self.kernel(tables, workers)),
                pass,
                film,
                workers,
                monitor,
            ),
            SharedTables::F32(tables) => trace_pass(
                &self.exposure(tables, &self.rays(pixels), grid, self.kernel(tables, workers)),
                pass,
                film,
                workers,
                monitor,
            ),
        }
    }

    /// The whole picture, see [`trace_picture`].
    pub(super) fn trace_picture(
        &self,
        grid: SampleGrid,
        film: &mut Film,
        workers: &Workers,
        monitor: &Monitor,
    ) -> Counts {
        let pixels = film.side();
        match &self.tables {
            SharedTables::F64(tables) => trace_picture(
                &self.exposure(tables, &self.rays(pixels), grid, self.kernel(tables, workers)),
                film,
                workers,
                monitor,
            ),
            SharedTables::F32(tables) => trace_picture(
                &self.exposure(tables, &self.rays(pixels), grid, self.kernel(tables, workers)),
                film,
                workers,
                monitor,
            ),
        }
    }

    fn rays<T: Real>(&self, pixels: u32) -> CameraRays<T> {
        CameraRays::new(&traced_pose(&self.pose), &self.lens, pixels).with_effects(self.effects)
    }

    fn kernel<T: Real>(&self, tables: &SceneTables<T>, workers: &Workers) -> Kernel {
        workers.kernel_for(tables.effects().union(self.effects.set()))
    }

    fn exposure<'a, T: Real>(
        &self,
        tables: &'a SceneTables<T>,
        camera: &'a CameraRays<T>,
        grid: SampleGrid,
        kernel: Kernel,
    ) -> Exposure<'a, T> {
        Exposure { grid, kernel, ..Exposure::new(tables, camera, self.level) }
    }
}

//! A World to be traced with one setting after another.

use bevy_ecs::prelude::*;

use crate::components::Precision;
use crate::film::Film;
use crate::geometry::Real;
use crate::systems::{
    Frame, FrameError, Tables, Workers, count_rays, extract_schedule, prepare, trace_schedule, trace_windows,
};
use crate::trace::{Counts, Depth, Exposure, Refinement, SampleGrid};

use super::Setting;

/// A World, and what traces it in either precision. It keeps the last setting.
pub struct Lab<'a> {
    world: &'a mut World,
    double: Schedules,
    single: Schedules,
}

struct Schedules {
    extract: Schedule,
    trace: Schedule,
}

/// A picture traced with some setting.
#[derive(Clone, Debug)]
pub struct Shot {
    /// The picture.
    pub film: Film,
    /// What was counted.
    pub counts: Counts,
    /// Milliseconds of the trace, by the clock that was given.
    pub milliseconds: f64,
    /// Samples of each pixel, where that was decided pixel by pixel.
    pub refinement: Option<Refinement>,
}

/// Square parts of a picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Windows {
    /// Columns and rows of their first pixels.
    pub corners: Vec<[u32; 2]>,
    /// Pixels along each side.
    pub side: u32,
}

/// Parts of a picture, traced.
#[derive(Clone, Debug)]
pub struct Glimpse {
    /// One for each window.
    pub films: Vec<Film>,
    /// What was counted in each window.
    pub counts: Vec<Counts>,
    /// Milliseconds of the trace.
    pub milliseconds: f64,
}

impl<'a> Lab<'a> {
    /// Prepares a World for both precisions.
    pub fn new(world: &'a mut World, workers: &Workers) -> Self {
        prepare::<f32>(world, workers.clone());
        prepare::<f64>(world, workers.clone());
        Self { world, double: Schedules::new::<f64>(), single: Schedules::new::<f32>() }
    }

    /// The World.
    pub fn world(&mut self) -> &mut World {
        self.world
    }

    /// The picture with a setting; `clock` tells milliseconds.
    pub fn shoot(&mut self, setting: Setting, clock: &mut dyn FnMut() -> f64) -> Result<Shot, FrameError> {
        self.set(setting);
        let (world, schedules) = self.schedules(setting.precision);
        let start = clock();
        schedules.trace.run(world);
        let milliseconds = clock() - start;
        let frame = self.world.resource::<Frame>();
        let (film, counts) = frame.traced()?;
        let refinement = frame.refinement().cloned();
        Ok(Shot { film: film.clone(), counts: *counts, milliseconds, refinement })
    }

    /// Parts of the picture with a setting.
    pub fn glimpse(
        &mut self,
        setting: Setting,
        windows: &Windows,
        clock: &mut dyn FnMut() -> f64,
    ) -> Result<Glimpse, FrameError> {
        self.set(setting);
        match setting.precision {
            Precision::F64 => glimpse::<f64>(self.world, setting, windows, clock),
            Precision::F32 => glimpse::<f32>(self.world, setting, windows, clock),
        }
    }

    /// Rays of the first sample of each pixel with a setting.
    pub fn rays(&mut self, setting: Setting) -> Result<Vec<u32>, FrameError> {
        self.set(setting);
        match setting.precision {
            Precision::F64 => rays::<f64>(self.world, setting),
            Precision::F32 => rays::<f32>(self.world, setting),
        }
    }

    fn set(&mut self, setting: Setting) {
        setting.apply(self.world);
        let (world, schedules) = self.schedules(setting.precision);
        schedules.extract.run(world);
    }

    fn schedules(&mut self, precision: Precision) -> (&mut World, &mut Schedules) {
        match precision {
            Precision::F64 => (self.world, &mut self.double),
            Precision::F32 => (self.world, &mut self.single),
        }
    }
}

impl Schedules {
    fn new<T: Real>() -> Self {
        Self { extract: extract_schedule::<T>(), trace: trace_schedule::<T>() }
    }
}

/// Does something with what a setting's pictures are traced from.
fn exposed<T: Real, R>(
    world: &World,
    setting: Setting,
    work: impl FnOnce(&Exposure<'_, T>, &Workers) -> R,
) -> Result<R, FrameError> {
    let tables = world.resource::<Tables<T>>();
    let workers = world.resource::<Workers>();
    let problems = tables.problems();
    let camera = tables.camera.as_ref().filter(|_| problems.is_empty());
    let camera = camera.ok_or(FrameError::World(problems))?;
    let depth = Depth { level: setting.level, cutoff: T::from_f64(setting.cutoff) };
    let kernel = workers.kernel_for(tables.effects());
    let grid = SampleGrid::new(setting.side);
    let exposure = Exposure { depth, grid, kernel, ..Exposure::new(&tables.scene, camera, setting.level) };
    Ok(work(&exposure, workers))
}

fn glimpse<T: Real>(
    world: &World,
    setting: Setting,
    windows: &Windows,
    clock: &mut dyn FnMut() -> f64,
) -> Result<Glimpse, FrameError> {
    exposed::<T, _>(world, setting, |exposure, workers| {
        let start = clock();
        let traced = trace_windows(exposure, setting.threshold, (&windows.corners, windows.side), workers);
        let milliseconds = clock() - start;
        let (films, counts) = traced.ok_or(FrameError::Memory(windows.side))?;
        Ok(Glimpse { films, counts, milliseconds })
    })?
}

fn rays<T: Real>(world: &World, setting: Setting) -> Result<Vec<u32>, FrameError> {
    exposed::<T, _>(world, setting, count_rays)
}

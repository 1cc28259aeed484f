//! What runs, and when: this page is the one place that orders systems.
//!
//! ```text
//! Stage::Control   control_camera   the moves that were asked for, if any
//! Stage::Survey    survey_effects   always: one step an archetype
//! Stage::Extract   measure_objects  single precision: per shape kind, as extract_objects
//!                  choose_unit      single precision: always, but it looks at lights and camera only
//!                  extract_objects  per shape kind, only if entities of that kind changed, came or went, or the unit did
//!                                   row by row where values changed in few of them
//!                  extract_lights   only if lights changed, came or went, or the unit did
//!                  extract_air      only if background or fog changed, came or went, or the unit did
//!                  extract_camera   always: two tangents
//!                  extract_motion   after the others, only while something has a velocity
//! Stage::Build     build_trees      only if a large table has no tree, or has changed
//! Stage::Trace     trace            tables and camera to film, tiles in parallel
//!                  trace_levels     or to bytes, where nobody wants a film
//! Stage::List      list_objects     what the preview draws, per shape kind, only if that kind changed
//!                  list_lights      only if lights changed
//! (last)           end_frame        lets the World forget reports of removals
//! ```
//!
//! The camera moves before extraction, so that a frame shows what was asked for before it. Extraction comes before
//! tracing because a frame is traced from tables alone: nothing can change under its threads. A user's own systems go
//! `.before(Stage::Extract)`, those that ask for moves `.before(Stage::Control)`. The preview's list
//! is a schedule of its own and reads neither tables nor film. Systems touch no file and hold no arithmetic.

mod build_trees;
mod carried;
mod changes;
mod choose_unit;
mod control_camera;
mod extract_air;
mod extract_camera;
mod extract_lights;
mod extract_motion;
mod extract_objects;
mod frame;
#[cfg(feature = "viewer")]
mod list_draws;
mod muted;
mod object_rows;
mod problem;
mod runs;
mod shape_tables;
mod survey_effects;
mod trace;
mod trace_adaptive;
mod trace_levels;
mod trace_windows;
mod workers;

use bevy_ecs::prelude::*;
use bevy_ecs::schedule::{IntoScheduleConfigs, Schedule};

use crate::components::{CameraInput, Checkerboard, Cube, Pyramid, Sampling, Snapshot, Sphere};
use crate::geometry::Real;

use build_trees::{build_trees, trees_are_lacking};
use changes::{air_changed, in_old_unit, is_outdated, lights_changed, objects_changed};
use choose_unit::{choose_unit, measure_objects};
use control_camera::control_camera;
use extract_air::extract_air;
use extract_camera::extract_camera;
use extract_lights::extract_lights;
use extract_motion::{extract_motion, something_moves};
use extract_objects::extract_objects;
#[cfg(feature = "viewer")]
use list_draws::{list_lights, list_objects};
use shape_tables::ExtractShape;
use survey_effects::survey_effects;
use trace::trace;
use trace_levels::trace_levels;

pub use frame::{Frame, FrameError, Tables};
#[cfg(feature = "viewer")]
pub use list_draws::Drawn;
pub use muted::Muted;
pub use problem::{Measure, WorldProblem};
pub use survey_effects::{Survey, carriers_of, take_away};
pub use trace::{trace_pass, trace_picture};
pub use trace_adaptive::trace_adaptive;
pub use trace_windows::{count_rays, trace_windows};
pub use workers::{Monitor, Workers, WorkersError};

/// Parts of a frame, in the order in which they run.
#[derive(SystemSet, Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Stage {
    /// What was asked of the camera to its pose.
    Control,
    /// Which effects entities ask for.
    Survey,
    /// World to tables.
    Extract,
    /// Tables to what makes them fast to search.
    Build,
    /// Tables to film.
    Trace,
    /// World to what the preview draws.
    List,
}

/// Gives a World what the schedules need besides entities: empty tables, a frame, settings where it has none.
pub fn prepare<T: Real>(world: &mut World, workers: Workers) {
    world.init_resource::<CameraInput>();
    world.init_resource::<Snapshot>();
    world.init_resource::<Sampling>();
    world.init_resource::<Monitor>();
    world.init_resource::<Survey>();
    world.init_resource::<Muted>();
    world.init_resource::<Frame>();
    world.init_resource::<Tables<T>>();
    #[cfg(feature = "viewer")]
    world.init_resource::<Drawn>();
    world.insert_resource(workers);
}

/// The whole frame: every stage in its order. The World must be [`prepare`]d for the same precision.
pub fn frame_schedule<T: Real>() -> Schedule {
    let mut schedule = Schedule::default();
    schedule
        .configure_sets((Stage::Control, Stage::Survey, Stage::Extract, Stage::Build, Stage::Trace).chain());
    add_control(&mut schedule);
    add_extract::<T>(&mut schedule);
    add_build::<T>(&mut schedule);
    add_trace::<T>(&mut schedule);
    schedule.add_systems(end_frame.after(Stage::Trace));
    schedule
}

/// [`Stage::Control`] alone. It needs a [`CameraInput`], which [`prepare`] gives a World.
pub fn control_schedule() -> Schedule {
    let mut schedule = Schedule::default();
    add_control(&mut schedule);
    schedule
}

/// All up to tables that can be traced: [`Stage::Survey`], [`Stage::Extract`] and [`Stage::Build`].
pub fn extract_schedule<T: Real>() -> Schedule {
    let mut schedule = Schedule::default();
    schedule.configure_sets((Stage::Survey, Stage::Extract, Stage::Build).chain());
    add_extract::<T>(&mut schedule);
    add_build::<T>(&mut schedule);
    schedule.add_systems(end_frame.after(Stage::Build));
    schedule
}

/// [`Stage::Survey`] and [`Stage::Extract`] alone, for who measures the stages: what was extracted is to be built before
/// it is traced.
pub fn tables_schedule<T: Real>() -> Schedule {
    let mut schedule = Schedule::default();
    schedule.configure_sets((Stage::Survey, Stage::Extract).chain());
    add_extract::<T>(&mut schedule);
    schedule.add_systems(end_frame.after(Stage::Extract));
    schedule
}

/// [`Stage::Build`] alone.
pub fn build_schedule<T: Real>() -> Schedule {
    let mut schedule = Schedule::default();
    add_build::<T>(&mut schedule);
    schedule
}

/// [`Stage::Trace`] alone.
pub fn trace_schedule<T: Real>() -> Schedule {
    let mut schedule = Schedule::default();
    add_trace::<T>(&mut schedule);
    schedule
}

/// [`Stage::Trace`] for who wants bytes and no film: see [`Frame::take_levels`].
pub fn levels_schedule<T: Real>() -> Schedule {
    let mut schedule = Schedule::default();
    schedule.add_systems(trace_levels::<T>.in_set(Stage::Trace));
    schedule
}

/// [`Stage::List`] alone. It needs a [`Drawn`], which [`prepare`] gives a World.
#[cfg(feature = "viewer")]
pub fn list_schedule() -> Schedule {
    let mut schedule = Schedule::default();
    schedule.add_systems(
        (
            list_objects::<Sphere>.run_if(objects_changed::<Sphere>),
            list_objects::<Cube>.run_if(objects_changed::<Cube>),
            list_objects::<Pyramid>.run_if(objects_changed::<Pyramid>),
            list_objects::<Checkerboard>.run_if(objects_changed::<Checkerboard>),
            list_lights.run_if(lights_changed),
        )
            .in_set(Stage::List),
    );
    schedule
}

fn add_control(schedule: &mut Schedule) {
    schedule.add_systems(control_camera.in_set(Stage::Control));
}

fn add_extract<T: Real>(schedule: &mut Schedule) {
    schedule.add_systems(survey_effects.in_set(Stage::Survey));
    if has_unit::<T>() {
        schedule.add_systems(choose_unit::<T>.in_set(Stage::Extract));
    }
    add_objects::<T, Sphere>(schedule);
    add_objects::<T, Cube>(schedule);
    add_objects::<T, Pyramid>(schedule);
    add_objects::<T, Checkerboard>(schedule);
    schedule.add_systems(
        (
            extract_lights::<T>.run_if(lights_changed.or_eager(in_old_unit::<T>("Light"))),
            extract_air::<T>.run_if(air_changed::<T>.or_eager(in_old_unit::<T>("Air"))),
            extract_camera::<T>,
        )
            .in_set(Stage::Extract)
            .after(choose_unit::<T>),
    );
    // It names rows and asks for the shutter, so it waits until they are there.
    let motion = extract_motion::<T>.run_if(something_moves::<T>).in_set(Stage::Extract);
    schedule.add_systems(
        motion
            .after(extract_camera::<T>)
            .after(extract_objects::<T, Sphere>)
            .after(extract_objects::<T, Cube>)
            .after(extract_objects::<T, Pyramid>)
            .after(extract_objects::<T, Checkerboard>),
    );
}

/// Whether tables keep lengths in a unit of the scene's own: in double precision the world unit holds all that are allowed.
fn has_unit<T: Real>() -> bool {
    T::LENGTH_LIMIT < f64::LENGTH_LIMIT
}

/// The extraction of one kind of objects. What asks whether they changed is asked once: it looks at every one of them.
fn add_objects<T: Real, S: ExtractShape<T>>(schedule: &mut Schedule) {
    let extract = extract_objects::<T, S>.in_set(Stage::Extract).after(choose_unit::<T>);
    if has_unit::<T>() {
        let measure = measure_objects::<T, S>.in_set(Stage::Extract).before(choose_unit::<T>);
        schedule.add_systems(measure.run_if(objects_changed::<S>));
        schedule.add_systems(extract.run_if(is_outdated::<T>(S::NAME)));
    } else {
        schedule.add_systems(extract.run_if(objects_changed::<S>));
    }
}

fn add_build<T: Real>(schedule: &mut Schedule) {
    schedule.add_systems(build_trees::<T>.run_if(trees_are_lacking::<T>).in_set(Stage::Build));
}

fn add_trace<T: Real>(schedule: &mut Schedule) {
    schedule.add_systems(trace::<T>.in_set(Stage::Trace));
}

/// Lets the World forget what its entities lost; without it the reports, which no system here reads, would pile up.
fn end_frame(world: &mut World) {
    world.clear_trackers();
}

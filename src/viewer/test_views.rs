//! Views for tests, and what `render` makes of them.

use std::num::NonZeroUsize;
use std::path::Path;

use bevy_ecs::prelude::*;
use glam::DVec3;

use crate::components::{CameraPose, Cutoff, Lens, Position, Precision, Sampling, Snapshot, Sphere};
use crate::film::Film;
use crate::geometry::{Real, is_camera_basis};
use crate::scene::{Source, spawn};
use crate::systems::{Frame, Tables, Workers, extract_schedule, frame_schedule, prepare};
use crate::trace::Counts;

use super::traced_view::{SharedTables, TracedView};

/// Two threads.
pub(super) fn workers() -> Workers {
    Workers::new(NonZeroUsize::new(2)).unwrap()
}

/// The official scene from the start, by a camera whose `r` has gone astray as far as a basis may. In this view whole
/// rows of pixel centres lie on edges of cells, so that it shows which `r` is traced.
pub(super) fn official() -> World {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/official.txt");
    let loaded = Source::read(&file).unwrap().load().unwrap();
    let mut world = World::new();
    spawn(&mut world, &loaded.description);
    for mut pose in world.query::<&mut CameraPose>().iter_mut(&mut world) {
        pose.r += DVec3::new(0.0, 3e-7, 3e-7);
        assert!(is_camera_basis([pose.l, pose.r, pose.u]));
    }
    world
}

/// Five thousand spheres that every ray has to be tested against: minutes of work at 1024 x 1024 pixels.
pub(super) fn heavy() -> World {
    let mut world = official();
    for number in 0..5000 {
        let place = Position::new(f64::from(number % 70) - 35.0, 60.0, f64::from(number / 70));
        world.spawn((Sphere { radius: 1.0 }, place));
    }
    world
}

/// The view of the World's camera.
pub(super) fn view(world: &mut World, precision: Precision) -> TracedView {
    let tables = match precision {
        Precision::F64 => SharedTables::F64(extracted::<f64>(world).scene.clone()),
        Precision::F32 => SharedTables::F32(extracted::<f32>(world).scene.clone()),
    };
    let (&pose, &lens) = world.query::<(&CameraPose, &Lens)>().single(world).unwrap();
    let effects = match precision {
        Precision::F64 => world.resource::<Tables<f64>>().camera_effects(),
        Precision::F32 => world.resource::<Tables<f32>>().camera_effects(),
    };
    TracedView {
        tables,
        pose,
        lens,
        effects,
        level: world.resource::<Snapshot>().level,
        cutoff: world.get_resource::<Cutoff>().map_or(0.0, |cutoff| cutoff.0),
    }
}

fn extracted<T: Real>(world: &mut World) -> &Tables<T> {
    prepare::<T>(world, workers());
    extract_schedule::<T>().run(world);
    world.resource::<Tables<T>>()
}

/// What `render` makes of the World with the numbers of its camera.
pub(super) fn rendered(mut world: World, precision: Precision, pixels: u32, side: u32) -> (Film, Counts) {
    world.resource_mut::<Snapshot>().pixels = pixels;
    world.insert_resource(Sampling { side });
    for mut pose in world.query::<&mut CameraPose>().iter_mut(&mut world) {
        let CameraPose { position, l, u, .. } = *pose;
        *pose = CameraPose::looking(position, l, u).unwrap();
    }
    match precision {
        Precision::F64 => framed::<f64>(world),
        Precision::F32 => framed::<f32>(world),
    }
}

fn framed<T: Real>(mut world: World) -> (Film, Counts) {
    prepare::<T>(&mut world, workers());
    frame_schedule::<T>().run(&mut world);
    let (film, counts) = world.resource::<Frame>().traced().unwrap();
    (film.clone(), *counts)
}

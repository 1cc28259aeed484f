//! Pictures as bytes without a film: the bytes that the film has, whatever the scene and however it is cut.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use archetrace::components::{
    Adaptive, CameraPose, ExposureStops, Sampling, Shutter, Snapshot, Sphere, SrgbTransfer, Velocity,
};
use archetrace::geometry::Real;
use archetrace::systems::{
    Frame, FrameError, Monitor, Workers, extract_schedule, frame_schedule, levels_schedule, prepare,
};
use archetrace::trace::Counts;
use bevy_ecs::prelude::*;
use glam::DVec3;

use crate::support::scenes::textured_case;
use crate::support::tracing::workers;

type Change = (&'static str, fn(&mut World));

/// What a picture can be beyond one sample a pixel of what does not move.
const CHANGES: [Change; 7] = [
    ("plain", |_| ()),
    ("samples", |world| world.insert_resource(Sampling { side: 2 })),
    ("adaptive", |world| {
        world.insert_resource(Sampling { side: 3 });
        world.insert_resource(Adaptive { threshold: 0.02 });
    }),
    ("srgb", |world| give_camera(world, SrgbTransfer)),
    ("exposure", |world| give_camera(world, ExposureStops(0.7))),
    ("motion", |world| {
        give_camera(world, Shutter { open: 1.0, close: 2.0 });
        let sphere = world.query_filtered::<Entity, With<Sphere>>().iter(world).next().unwrap();
        world.entity_mut(sphere).insert(Velocity(DVec3::new(9.0, 0.0, 4.0)));
    }),
    ("level 0", |world| world.resource_mut::<Snapshot>().level = 0),
];

fn give_camera(world: &mut World, effect: impl Bundle) {
    let camera = world.query_filtered::<Entity, With<CameraPose>>().single(world).unwrap();
    world.entity_mut(camera).insert(effect);
}

fn scene(pixels: u32, change: Change) -> World {
    let mut case = textured_case();
    case.description.pixels = pixels;
    let mut world = case.world();
    change.1(&mut world);
    world
}

/// The bytes of a film, and what was counted.
fn by_film<T: Real>(mut world: World) -> (Vec<u8>, Counts) {
    prepare::<T>(&mut world, workers(2));
    frame_schedule::<T>().run(&mut world);
    let (film, counts) = world.resource::<Frame>().traced().unwrap();
    (film.to_rgb8(), *counts)
}

fn by_levels<T: Real>(mut world: World, workers: Workers) -> Result<(Vec<u8>, Counts), FrameError> {
    prepare::<T>(&mut world, workers);
    extract_schedule::<T>().run(&mut world);
    levels_schedule::<T>().run(&mut world);
    world.resource_mut::<Frame>().take_levels()
}

fn assert_alike<T: Real>() {
    for change in CHANGES {
        // Bands of a whole number of rows and a lower one; more rows in a band than there are.
        for pixels in [1, 37, 64] {
            let (bytes, counts) = by_film::<T>(scene(pixels, change));
            assert_eq!(bytes.len(), 3 * (pixels * pixels) as usize);
            for workers in [workers(1), workers(3), workers(2).with_tile_size(5)] {
                let (levels, counted) = by_levels::<T>(scene(pixels, change), workers).unwrap();
                assert!(levels == bytes, "{}, {pixels} pixels, {}", change.0, T::NAME);
                assert_eq!(counted, counts, "{}, {pixels} pixels, {}", change.0, T::NAME);
            }
        }
    }
}

#[test]
fn levels_are_those_of_the_film() {
    assert_alike::<f64>();
    assert_alike::<f32>();
}

/// What was refined for the picture before says nothing of the next one.
#[test]
fn a_picture_without_refinement_has_none() {
    let mut world = scene(16, CHANGES[2]);
    prepare::<f64>(&mut world, workers(1));
    extract_schedule::<f64>().run(&mut world);
    let mut schedule = levels_schedule::<f64>();
    schedule.run(&mut world);
    assert!(world.resource::<Frame>().refinement().is_some());
    world.remove_resource::<Adaptive>();
    world.insert_resource(Sampling { side: 1 });
    schedule.run(&mut world);
    assert!(world.resource::<Frame>().refinement().is_none());
}

#[test]
fn a_world_that_cannot_be_traced_has_no_levels() {
    let mut world = scene(16, CHANGES[0]);
    world.spawn(Sphere { radius: -1.0 });
    let error = by_levels::<f64>(world, workers(1)).unwrap_err();
    assert!(matches!(error, FrameError::World(_)), "{error}");
}

#[test]
fn the_monitor_hears_of_every_pixel_and_may_stop() {
    for change in &CHANGES[..2] {
        let seen = Arc::new(AtomicU64::new(0));
        let mut world = scene(40, *change);
        let samples = world.get_resource::<Sampling>().map_or(1, |sampling| sampling.side.pow(2));
        let count = seen.clone();
        let on_tile = move |pixels| {
            count.fetch_add(pixels, Ordering::Relaxed);
        };
        world.insert_resource(Monitor::new(on_tile, Arc::default()));
        by_levels::<f64>(world, workers(2)).unwrap();
        assert_eq!(seen.load(Ordering::Relaxed), u64::from(40 * 40 * samples));

        let mut world = scene(40, *change);
        let cancel = Arc::new(AtomicBool::new(true));
        world.insert_resource(Monitor::new(|_| panic!("a tile was traced"), cancel));
        assert_eq!(by_levels::<f64>(world, workers(2)).unwrap_err(), FrameError::Cancelled);
    }
}

//! The unit that single precision keeps lengths in: chosen from what is there now, whatever was there before.

use archetrace::components::{
    Ambient, CameraPose, CheckerFilter, Color, Diffuse, Fog, Lens, Position, Pyramid, Sampling, Snapshot,
    Sphere,
};
use archetrace::geometry::{Real, Unit};
use archetrace::systems::{Stage, Tables, extract_schedule, frame_schedule, prepare};
use bevy_ecs::prelude::*;
use bevy_ecs::schedule::Schedule;

use crate::support::case::only;
use crate::support::picture::assert_same;
use crate::support::tracing::{Traced, run, trace, workers};

#[path = "../../scenes/gallery/exhibits.rs"]
#[allow(dead_code, reason = "shared with the gallery itself")]
mod exhibits;

/// Every effect at once, so that all tables have rows, in fog that lets the sky through and without a ceiling.
fn everything() -> World {
    let mut world = exhibits::Exhibit::named("all").unwrap().world();
    world.resource_mut::<Snapshot>().pixels = 32;
    world.insert_resource(Sampling { side: 2 });
    only::<Fog>(&mut world).density = 1e-13;
    let ceiling = world.query_filtered::<Entity, With<CheckerFilter>>().single(&world).unwrap();
    world.despawn(ceiling);
    world
}

fn unit<T: Real>(world: &World) -> Unit {
    world.resource::<Tables<T>>().scene.unit
}

/// What makes the scene too large for the world unit: a wall of a ball, far behind everything.
#[derive(Component)]
struct Moon;

fn rise(world: &mut World) {
    let place = Position::new(1e11, 6e11, 1e11);
    world.spawn((
        Moon,
        Sphere { radius: 3e11 },
        place,
        Ambient(0.7),
        Diffuse(0.2),
        Color::new(0.9, 0.8, 0.7),
    ));
    only::<Lens>(world).far = 1e13;
}

fn set(world: &mut World) {
    let moon = world.query_filtered::<Entity, With<Moon>>().single(world).unwrap();
    world.despawn(moon);
    only::<Lens>(world).far = 2000.0;
}

fn assert_traced_same(name: &str, left: &Traced, right: &Traced) {
    assert_same(name, &left.picture, &right.picture);
    assert_eq!(left.counts, right.counts, "{name}");
}

fn frame(world: &mut World, schedule: &mut Schedule) -> Traced {
    run(world, schedule).unwrap()
}

#[test]
fn after_an_edit_that_changes_the_unit_the_picture_is_that_of_a_new_world() {
    fn check<T: Real>() {
        let before = trace::<T>(&mut everything());
        let fresh = {
            let mut world = everything();
            rise(&mut world);
            trace::<T>(&mut world)
        };
        assert!(before.picture != fresh.picture, "the moon shows");
        let mut world = everything();
        prepare::<T>(&mut world, workers(2));
        let mut schedule = frame_schedule::<T>();
        for _ in 0..2 {
            assert_traced_same("before", &before, &frame(&mut world, &mut schedule));
            assert_eq!(unit::<T>(&world), Unit::WORLD);
            rise(&mut world);
            assert_traced_same("after", &fresh, &frame(&mut world, &mut schedule));
            assert_eq!(unit::<T>(&world) == Unit::WORLD, T::NAME == "f64");
            set(&mut world);
        }
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn schedules_that_share_tables_see_each_others_units() {
    let before = trace::<f32>(&mut everything());
    let mut world = everything();
    prepare::<f32>(&mut world, workers(2));
    let (mut frames, mut extraction) = (frame_schedule::<f32>(), extract_schedule::<f32>());
    rise(&mut world);
    let after = frame(&mut world, &mut frames);
    set(&mut world);
    extraction.run(&mut world);
    assert_eq!(unit::<f32>(&world), Unit::WORLD);
    rise(&mut world);
    assert_traced_same("risen again", &after, &frame(&mut world, &mut frames));
    extraction.run(&mut world);
    set(&mut world);
    extraction.run(&mut world);
    assert_traced_same("set again", &before, &frame(&mut world, &mut frames));
}

#[test]
fn while_the_unit_stays_no_row_is_extracted_for_it() {
    let mut world = everything();
    rise(&mut world);
    prepare::<f32>(&mut world, workers(2));
    let mut schedule = frame_schedule::<f32>();
    frame(&mut world, &mut schedule);
    let (chosen, revision) = (unit::<f32>(&world), world.resource::<Tables<f32>>().revision());
    frame(&mut world, &mut schedule);
    assert_eq!(world.resource::<Tables<f32>>().revision(), revision);
    // A small edit, twice as large a moon, and a camera that moves: one table each at most.
    only::<CameraPose>(&mut world).position.y += 1.0;
    only::<Pyramid>(&mut world).height += 1.0;
    frame(&mut world, &mut schedule);
    for (mut sphere, _) in world.query::<(&mut Sphere, &Moon)>().iter_mut(&mut world) {
        sphere.radius *= 1.5;
    }
    frame(&mut world, &mut schedule);
    assert_eq!(unit::<f32>(&world), chosen);
    assert_eq!(world.resource::<Tables<f32>>().revision(), revision + 2);
}

#[test]
fn a_world_that_no_unit_holds_is_told_until_it_is_mended() {
    let mut world = everything();
    prepare::<f32>(&mut world, workers(2));
    let mut schedule = frame_schedule::<f32>();
    let before = frame(&mut world, &mut schedule);
    let far = Position::new(0.0, 1e30, 0.0);
    let star = world.spawn((Moon, Sphere { radius: 1e25 }, far)).id();
    let least = world.query_filtered::<Entity, With<Lens>>().single(&world).unwrap();
    let message = format!(
        "1e0 (entity {least}: Lens.near) and 1e30 (entity {star}: Position) are too far apart for f32: it traces \
         lengths up to 5e17 times the least"
    );
    for _ in 0..2 {
        assert_eq!(run(&mut world, &mut schedule).unwrap_err().to_string(), message);
    }
    world.despawn(star);
    assert_traced_same("mended", &before, &frame(&mut world, &mut schedule));
}

#[test]
fn a_system_before_the_extraction_may_change_the_unit() {
    fn grow(mut frames: Local<u32>, mut spheres: Query<&mut Sphere, With<Moon>>) {
        *frames += 1;
        for mut sphere in &mut spheres {
            sphere.radius = if *frames == 1 { 3e11 } else { 20.0 };
        }
    }
    let mut fresh = everything();
    rise(&mut fresh);
    let fresh = trace::<f32>(&mut fresh);
    let mut world = everything();
    rise(&mut world);
    for mut sphere in world.query_filtered::<&mut Sphere, With<Moon>>().iter_mut(&mut world) {
        sphere.radius = 1e-16;
    }
    prepare::<f32>(&mut world, workers(2));
    let mut schedule = frame_schedule::<f32>();
    schedule.add_systems(grow.before(Stage::Extract));
    assert_traced_same("grown in its frame", &fresh, &frame(&mut world, &mut schedule));
    for mut position in world.query_filtered::<&mut Position, With<Moon>>().iter_mut(&mut world) {
        position.0 = -position.0 * 1e-9;
    }
    frame(&mut world, &mut schedule);
    assert_eq!(unit::<f32>(&world), Unit::WORLD);
}

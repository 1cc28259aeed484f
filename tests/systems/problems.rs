//! Worlds that cannot be traced: what is said, and that nothing else happens.

use core::f64::consts::FRAC_1_SQRT_2;
use std::sync::Arc;

use archetrace::components::{
    Ambient, Aperture, CameraPose, Checkerboard, Color, Cube, Diffuse, ExposureStops, Falloff, Gloss, Lens,
    Light, Mirror, Position, Pyramid, Sampling, Shutter, Snapshot, Sphere, SpotCone,
};
use archetrace::geometry::Real;
use archetrace::systems::{FrameError, Monitor, frame_schedule, prepare};
use bevy_ecs::prelude::*;
use glam::DVec3;

use crate::support::case::{Case, only};
use crate::support::picture::assert_same;
use crate::support::scenes::full_case;
use crate::support::tracing::{run, trace, workers};

pub(crate) fn small_case() -> Case {
    let mut case = full_case();
    case.description.pixels = 24;
    case
}

/// A World that panics when a tile of it is traced.
fn untraceable(world: &mut World) {
    let on_tile = |_| panic!("a tile was traced");
    world.insert_resource(Monitor::new(on_tile, Arc::default()));
}

/// What is said about a World.
pub(crate) fn error_of<T: Real>(world: &mut World) -> FrameError {
    untraceable(world);
    prepare::<T>(world, workers(1));
    run(world, &mut frame_schedule::<T>()).unwrap_err()
}

/// Spoils a World that could be traced, hears the message, mends it, and compares with the picture before.
fn assert_refused<T: Real>(
    spoil: impl Fn(&mut World) -> Entity,
    message: &str,
    mend: impl Fn(&mut World, Entity),
) {
    let mut world = small_case().world();
    prepare::<T>(&mut world, workers(1));
    let mut schedule = frame_schedule::<T>();
    let before = run(&mut world, &mut schedule).unwrap();
    let entity = spoil(&mut world);
    let expected = message.replace("{entity}", &entity.to_string());
    untraceable(&mut world);
    for _ in 0..2 {
        let error = run(&mut world, &mut schedule).unwrap_err();
        assert_eq!(error.to_string(), expected);
    }
    mend(&mut world, entity);
    world.insert_resource(Monitor::default());
    let after = run(&mut world, &mut schedule).unwrap();
    assert_same("mended", &before.picture, &after.picture);
    assert_eq!(before.counts, after.counts);
}

fn despawn(world: &mut World, entity: Entity) {
    world.despawn(entity);
}

/// An entity that cannot be traced, and what is said about it.
pub(crate) fn assert_bundle_refused<T: Real, B: Bundle>(bundle: impl Fn() -> B, message: &str) {
    assert_refused::<T>(|world| world.spawn(bundle()).id(), message, despawn);
}

#[test]
fn lengths_must_be_lengths() {
    let check = |radius: f64, found: &str| {
        let message =
            format!("entity {{entity}}: Sphere.radius is {found}, but must be a length from 1e-70 to 1e70");
        assert_bundle_refused::<f64, _>(|| Sphere { radius }, &message);
    };
    check(f64::NAN, "NaN");
    check(0.0, "0");
    check(-1.5, "-1.5");
    check(f64::INFINITY, "inf");
    assert_bundle_refused::<f64, _>(
        || Cube { side: -1.0 },
        "entity {entity}: Cube.side is -1, but must be a length from 1e-70 to 1e70",
    );
    assert_bundle_refused::<f64, _>(
        || Checkerboard { cell: f64::NAN },
        "entity {entity}: Checkerboard.cell is NaN, but must be a length from 1e-70 to 1e70",
    );
    assert_bundle_refused::<f64, _>(
        || Pyramid { width: 0.0, height: -2.0 },
        "entity {entity}: Pyramid.width is 0, but must be a length from 1e-70 to 1e70\n\
         entity {entity}: Pyramid.height is -2, but must be a length from 1e-70 to 1e70",
    );
}

#[test]
fn a_wrong_length_is_told_once() {
    // A sphere has one length; saying the same twice would look like two problems.
    let mut world = small_case().world();
    let entity = world.spawn(Sphere { radius: -1.0 }).id();
    let message = format!("entity {entity}: Sphere.radius is -1, but must be a length from 1e-70 to 1e70");
    assert_eq!(error_of::<f64>(&mut world).to_string(), message);
}

#[test]
fn values_must_be_in_their_ranges() {
    fn check<B: Bundle>(bundle: impl Fn() -> B, message: &str) {
        assert_bundle_refused::<f64, _>(bundle, &format!("entity {{entity}}: {message}"));
    }
    let sphere = || Sphere { radius: 1.0 };
    check(
        || (sphere(), Position::new(0.0, f64::NAN, 0.0)),
        "Position is NaN, but must be a number from -1e70 to 1e70",
    );
    check(|| (sphere(), Color::new(0.5, 1.5, 0.5)), "Color is 1.5, but must be a number from 0 to 1");
    check(|| (sphere(), Ambient(-0.1)), "Ambient is -0.1, but must be a number from 0 to 1");
    check(|| (sphere(), Diffuse(f64::NAN)), "Diffuse is NaN, but must be a number from 0 to 1");
    check(|| (sphere(), Mirror(1.01)), "Mirror is 1.01, but must be a number from 0 to 1");
    let gloss = |specular, shininess| Gloss { specular, shininess };
    check(|| (sphere(), gloss(2.0, 1.0)), "Gloss.specular is 2, but must be a number from 0 to 1");
    check(|| (sphere(), gloss(0.2, -1.0)), "Gloss.shininess is -1, but must be a number from 0 to 1e9");
    check(|| (Light, Falloff(-1.0)), "Falloff is -1, but must be a number from 0 to 1e150");
    let cone = SpotCone { target: DVec3::X, cutoff: 180.5 };
    check(|| (Light, cone), "SpotCone.cutoff is 180.5, but must be an angle from 0 to 180 degrees");
}

#[test]
fn a_spotlight_must_look_somewhere() {
    let target = DVec3::new(1.0, 2.0, 3.0);
    assert_bundle_refused::<f64, _>(
        || (Light, Position(target), SpotCone { target, cutoff: 20.0 }),
        "entity {entity}: SpotCone.target is, in f64, the light's own position: the cone has no direction",
    );
}

#[test]
fn an_object_needs_its_components() {
    fn check<C: Component + Clone>() {
        let kept = small_case();
        assert_refused::<f64>(
            |world| {
                let entity = first_sphere(world);
                world.entity_mut(entity).remove::<C>().id()
            },
            "entity {entity}: a Sphere needs Position, Color, Ambient and Diffuse, and not all of that is there",
            |world, entity| {
                let mut other = kept.world();
                let whole = first_sphere(&mut other);
                let component = other.entity(whole).get::<C>().unwrap().clone();
                world.entity_mut(entity).insert(component);
            },
        );
    }
    check::<Color>();
    check::<Position>();
    check::<Ambient>();
    check::<Diffuse>();
}

fn first_sphere(world: &mut World) -> Entity {
    world.query_filtered::<Entity, With<Sphere>>().iter(world).min().unwrap()
}

#[test]
fn there_must_be_one_camera() {
    let message = |found| {
        format!("the World must have one camera (an entity with CameraPose and Lens), but has {found}")
    };
    let mut world = World::new();
    assert_eq!(error_of::<f64>(&mut world).to_string(), message(0));
    let mut world = World::new();
    world.spawn(CameraPose::default());
    assert_eq!(error_of::<f64>(&mut world).to_string(), message(0));
    let lens = small_lens();
    assert_bundle_refused::<f64, _>(|| (CameraPose::default(), lens), &message(2));
}

fn small_lens() -> Lens {
    Lens { near: 1.0, far: 10.0, fovy: 60.0, aspect: 1.0 }
}

/// The message for a World whose camera was changed.
fn camera_message(change: impl Fn(&mut World)) -> (Entity, String) {
    let mut world = small_case().world();
    change(&mut world);
    let camera = world.query_filtered::<Entity, With<Lens>>().single(&world).unwrap();
    (camera, error_of::<f64>(&mut world).to_string())
}

#[test]
fn a_lens_has_its_ranges() {
    let check = |change: fn(&mut Lens), message: &str| {
        let (camera, found) = camera_message(|world| change(&mut only::<Lens>(world)));
        let message = message.replace("{camera}", &camera.to_string());
        assert_eq!(found, format!("entity {camera}: {message}"));
    };
    check(|lens| lens.near = 0.0, "Lens.near is 0, but must be a length from 1e-70 to 1e70");
    check(|lens| lens.far = f64::INFINITY, "Lens.far is inf, but must be a length from 1e-70 to 1e70");
    check(
        |lens| lens.fovy = 160.0,
        "Lens.fovy * aspect is 192, but must be an angle above 0 and below 180 degrees",
    );
    check(
        |lens| lens.fovy = -60.0,
        "Lens.fovy is -60, but must be an angle above 0 and below 180 degrees\n\
         entity {camera}: Lens.fovy * aspect is -72, but must be an angle above 0 and below 180 degrees",
    );
}

#[test]
fn effects_of_the_camera_must_be_in_their_ranges() {
    fn check<B: Bundle + Copy>(bundle: B, message: &str) {
        let (camera, found) = camera_message(|world| {
            let camera = world.query_filtered::<Entity, With<Lens>>().single(world).unwrap();
            world.entity_mut(camera).insert(bundle);
        });
        assert_eq!(found, format!("entity {camera}: {message}"));
    }
    let ratio = "but must be a number from 0 to 1";
    check(Aperture { radius: -1.0, focus: 4.0 }, &format!("Aperture.radius / focus is -0.25, {ratio}"));
    check(Aperture { radius: 5.0, focus: 4.0 }, &format!("Aperture.radius / focus is 1.25, {ratio}"));
    check(Aperture { radius: f64::NAN, focus: 4.0 }, &format!("Aperture.radius / focus is NaN, {ratio}"));
    check(
        Aperture { radius: -0.0, focus: -4.0 },
        "Aperture.focus is -4, but must be a length from 1e-70 to 1e70",
    );
    check(Shutter { open: 1.0, close: 0.5 }, "Shutter.close is 0.5, but must not be before Shutter.open, 1");
    check(
        Shutter { open: 0.0, close: f64::INFINITY },
        "Shutter.close is inf, but must be a number from -1e9 to 1e9",
    );
    check(ExposureStops(101.0), "ExposureStops is 101, but must be a number from -100 to 100");
    check(ExposureStops(f64::NAN), "ExposureStops is NaN, but must be a number from -100 to 100");
}

#[test]
fn a_camera_has_unit_axes() {
    let (camera, message) = camera_message(|world| only::<CameraPose>(world).l *= 1.5);
    assert_eq!(
        message,
        format!(
            "entity {camera}: CameraPose l, r and u must be unit vectors at right angles, with u = r x l"
        )
    );
    let (camera, message) = camera_message(|world| only::<CameraPose>(world).r.x = f64::NAN);
    assert_eq!(
        message,
        format!(
            "entity {camera}: CameraPose l, r and u must be unit vectors at right angles, with u = r x l"
        )
    );
}

#[test]
fn the_axes_of_a_camera_are_perpendicular() {
    let (camera, message) = camera_message(|world| {
        let mut pose = only::<CameraPose>(world);
        pose.r = (pose.r + pose.l) * FRAC_1_SQRT_2;
    });
    assert_eq!(
        message,
        format!(
            "entity {camera}: CameraPose l, r and u must be unit vectors at right angles, with u = r x l"
        )
    );
}

#[test]
fn a_snapshot_has_its_ranges() {
    let check = |pixels: u32, level: u32, message: &str| {
        assert_refused::<f64>(
            |world| {
                world.insert_resource(Snapshot { pixels, level });
                first_sphere(world)
            },
            message,
            |world, _| world.insert_resource(Snapshot { pixels: 24, level: 4 }),
        );
    };
    check(0, 3, "Snapshot.pixels is 0, but must be from 1 to 8192");
    check(8193, 3, "Snapshot.pixels is 8193, but must be from 1 to 8192");
    check(24, 1001, "Snapshot.level is 1001, but must be from 0 to 1000");
    check(
        u32::MAX,
        u32::MAX,
        "Snapshot.pixels is 4294967295, but must be from 1 to 8192\n\
         Snapshot.level is 4294967295, but must be from 0 to 1000",
    );
}

#[test]
fn the_grid_of_samples_has_its_range() {
    for (side, message) in [
        (0, "Sampling.side is 0, but must be from 1 to 64"),
        (65, "Sampling.side is 65, but must be from 1 to 64"),
        (u32::MAX, "Sampling.side is 4294967295, but must be from 1 to 64"),
    ] {
        assert_refused::<f64>(
            |world| {
                world.insert_resource(Sampling { side });
                first_sphere(world)
            },
            message,
            |world, _| world.insert_resource(Sampling { side: 1 }),
        );
    }
}

#[test]
fn single_precision_says_what_it_cannot_hold() {
    let between = |least: &str, greatest: &str| {
        format!(
            "{least} and {greatest} are too far apart for f32: it traces lengths up to 5e17 times the least"
        )
    };
    // The camera's near plane and its place are the other lengths that count.
    let mut world = small_case().world();
    let camera = world.query_filtered::<Entity, With<Lens>>().single(&world).unwrap();
    let near = format!("2e0 (entity {camera}: Lens.near)");
    let place = format!("1.4177e2 (entity {camera}: CameraPose.position)");
    assert_bundle_refused::<f32, _>(
        || (Sphere { radius: 3.0 }, Position::new(0.0, -3e18, 0.0)),
        &between(&near, "3e18 (entity {entity}: Position)"),
    );
    assert_bundle_refused::<f32, _>(
        || Cube { side: 3e18 },
        &between(&near, "3e18 (entity {entity}: Cube.side)"),
    );
    assert_bundle_refused::<f32, _>(
        || Sphere { radius: 1e-16 },
        &between("1e-16 (entity {entity}: Sphere.radius)", &place),
    );
    // The same in double precision is no problem.
    world.spawn((Sphere { radius: 1e-16 }, Position::new(0.0, -2e20, 0.0)));
    trace::<f64>(&mut world);
}

#[test]
fn a_cone_whose_direction_single_precision_loses_is_told() {
    // Both points are the same f32: the cone would have no direction and light nothing, without a word.
    let position = DVec3::new(1000.0, 0.0, 10.0);
    let target = position - DVec3::X * 1e-6;
    let mut world = small_case().world();
    let light = world.spawn((Light, Position(position), SpotCone { target, cutoff: 60.0 })).id();
    let message = format!(
        "entity {light}: SpotCone.target is, in f32, the light's own position: the cone has no direction"
    );
    assert_eq!(error_of::<f32>(&mut world).to_string(), message);
}

#[test]
fn many_problems_are_told_in_part() {
    let mut world = small_case().world();
    let entities: Vec<Entity> =
        (0..12).map(|_| world.spawn((Cube { side: 1.0 }, Mirror(7.0))).id()).collect();
    let FrameError::World(problems) = error_of::<f64>(&mut world) else { panic!("not refused") };
    assert_eq!(problems.len(), entities.len());
    let message = FrameError::World(problems).to_string();
    let lines: Vec<&str> = message.lines().collect();
    assert_eq!(lines.len(), 11);
    assert_eq!(lines[10], "and 2 more");
}

#[test]
fn problems_of_every_kind_are_told_together() {
    let mut world = World::new();
    let pyramid = world.spawn(Pyramid { width: 1.0, height: 0.0 }).id();
    let cube = world.spawn((Cube { side: 1.0 }, Mirror(7.0))).id();
    let light = world.spawn((Light, Falloff(f64::NAN))).id();
    world.insert_resource(Snapshot { pixels: 0, level: 3 });
    let expected = format!(
        "Snapshot.pixels is 0, but must be from 1 to 8192\n\
         the World must have one camera (an entity with CameraPose and Lens), but has 0\n\
         entity {cube}: Mirror is 7, but must be a number from 0 to 1\n\
         entity {light}: Falloff is NaN, but must be a number from 0 to 1e150\n\
         entity {pyramid}: Pyramid.height is 0, but must be a length from 1e-70 to 1e70"
    );
    assert_eq!(error_of::<f64>(&mut world).to_string(), expected);
}

#[test]
fn a_problem_goes_with_its_entity() {
    // Taking the shape away mends as well as despawning.
    assert_refused::<f64>(
        |world| world.spawn(Pyramid { width: f64::NAN, height: 1.0 }).id(),
        "entity {entity}: Pyramid.width is NaN, but must be a length from 1e-70 to 1e70",
        |world, entity| {
            world.entity_mut(entity).remove::<Pyramid>();
        },
    );
}

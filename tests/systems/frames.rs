//! Frame after frame: each is the picture of the World as it is, bit for bit.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use archetrace::components::{
    Ambient, CameraPose, Checkerboard, Color, Cube, Diffuse, Falloff, Gloss, Lens, Light, Mirror, Order,
    Position, Pyramid, Sampling, Snapshot, Sphere, SpotCone, Textured,
};
use archetrace::geometry::Real;
use archetrace::systems::{FrameError, Monitor, Stage, frame_schedule, prepare};
use bevy_ecs::prelude::*;
use bevy_ecs::schedule::{IntoScheduleConfigs, Schedule};

use crate::support::case::{Case, only};
use crate::support::parts::rebuilt;
use crate::support::picture::{Picture, assert_same};
use crate::support::scenes::{full_case, textured_case};
use crate::support::tracing::{Traced, run, trace, workers};

/// The full scene, smaller: these tests trace many frames.
fn small_case() -> Case {
    let mut case = textured_case();
    case.description.pixels = 64;
    case
}

fn prepared<T: Real>(mut world: World) -> (World, Schedule) {
    prepare::<T>(&mut world, workers(2));
    (world, frame_schedule::<T>())
}

/// An entity with a component of this kind: the first in scene order.
fn first<C: Component>(world: &mut World) -> Entity {
    let mut entities = world.query_filtered::<(Entity, &Order), With<C>>();
    entities.iter(world).min_by_key(|(_, order)| order.0).unwrap().0
}

fn entity<C: Component>(world: &mut World) -> EntityWorldMut<'_> {
    let entity = first::<C>(world);
    world.entity_mut(entity)
}

fn insert<C: Component>(world: &mut World, bundle: impl Bundle) {
    entity::<C>(world).insert(bundle);
}

fn remove<C: Component, R: Component>(world: &mut World) {
    entity::<C>(world).remove::<R>();
}

#[derive(Component)]
struct Marker;

type Change = (&'static str, fn(&mut World));

/// Changes that show.
const CHANGES: [Change; 22] = [
    ("sphere moved", |world| entity::<Sphere>(world).get_mut::<Position>().unwrap().0.x += 3.0),
    ("sphere grown", |world| entity::<Sphere>(world).get_mut::<Sphere>().unwrap().radius *= 1.25),
    ("cube colored", |world| insert::<Cube>(world, Color::new(0.2, 0.9, 0.4))),
    ("ambient part", |world| insert::<Pyramid>(world, Ambient(0.9))),
    ("diffuse part", |world| insert::<Cube>(world, Diffuse(0.1))),
    ("mirror inserted", |world| {
        let mut matte = world.query_filtered::<Entity, (With<Cube>, Without<Mirror>)>();
        let cube = matte.single(world).unwrap();
        world.entity_mut(cube).insert(Mirror(0.7));
    }),
    ("mirror removed", |world| remove::<Mirror, Mirror>(world)),
    ("gloss removed", |world| remove::<Gloss, Gloss>(world)),
    ("gloss changed", |world| entity::<Gloss>(world).get_mut::<Gloss>().unwrap().shininess = 2.0),
    ("images removed", |world| remove::<Checkerboard, Textured>(world)),
    ("board moved", |world| insert::<Checkerboard>(world, Position::new(5.0, 7.0, -2.0))),
    ("light moved", |world| entity::<Light>(world).get_mut::<Position>().unwrap().0.z += 20.0),
    ("light faded", |world| insert::<Light>(world, Falloff(1e-3))),
    ("falloff removed", |world| remove::<Falloff, Falloff>(world)),
    ("cone removed", |world| remove::<SpotCone, SpotCone>(world)),
    ("light put out", |world| remove::<Light, Light>(world)),
    ("cube is now a sphere", |world| {
        entity::<Cube>(world).remove::<Cube>().insert(Sphere { radius: 15.0 });
    }),
    ("sphere despawned", |world| {
        let sphere = first::<Sphere>(world);
        world.despawn(sphere);
    }),
    ("cube spawned", |world| {
        world.spawn((Cube { side: 20.0 }, Position::new(-10.0, -60.0, 30.0), Ambient(0.7)));
    }),
    ("sphere replaced by another", |world| {
        let sphere = first::<Sphere>(world);
        world.despawn(sphere);
        world.spawn((Sphere { radius: 11.0 }, Position::new(0.0, -50.0, 30.0), Ambient(0.6)));
    }),
    ("camera moved", |world| only::<CameraPose>(world).position.x += 1.0),
    ("lens changed", |world| only::<Lens>(world).fovy = 40.0),
];

fn assert_follows<T: Real>() {
    let case = small_case();
    for (name, change) in CHANGES {
        let (mut world, mut schedule) = prepared::<T>(case.world());
        let before = run(&mut world, &mut schedule).unwrap();
        run(&mut world, &mut schedule).unwrap();
        change(&mut world);
        let mut fresh = case.world();
        change(&mut fresh);
        let fresh = trace::<T>(&mut fresh);
        assert_ne!(before.picture, fresh.picture, "{name}: shows nowhere");
        // The frame after the change, and those after it.
        for _ in 0..3 {
            let after = run(&mut world, &mut schedule).unwrap();
            assert_same(&format!("{} {name}", T::NAME), &fresh.picture, &after.picture);
            assert_eq!(fresh.counts, after.counts, "{name}");
        }
    }
}

#[test]
fn the_next_frame_shows_a_change() {
    assert_follows::<f64>();
    assert_follows::<f32>();
}

#[test]
fn all_changes_together_show_as_well() {
    let case = small_case();
    let (mut world, mut schedule) = prepared::<f64>(case.world());
    let mut fresh = case.world();
    for (name, change) in CHANGES {
        change(&mut world);
        change(&mut fresh);
        let after = run(&mut world, &mut schedule).unwrap();
        let rebuilt = trace::<f64>(&mut rebuilt(&mut fresh, |_| ()));
        assert_same(&format!("up to {name}"), &rebuilt.picture, &after.picture);
    }
}

#[test]
fn frames_without_change_are_the_same() {
    let (mut world, mut schedule) = prepared::<f64>(small_case().world());
    let first = run(&mut world, &mut schedule).unwrap();
    for _ in 0..3 {
        let next = run(&mut world, &mut schedule).unwrap();
        assert_same("another frame", &first.picture, &next.picture);
        assert_eq!(first.counts, next.counts);
    }
}

#[test]
fn a_marker_shows_in_no_frame() {
    let (mut world, mut schedule) = prepared::<f64>(small_case().world());
    let before = run(&mut world, &mut schedule).unwrap().picture;
    for change in [
        (|world| insert::<Sphere>(world, Marker)) as fn(&mut World),
        |world| insert::<Light>(world, Marker),
        |world| remove::<Sphere, Marker>(world),
        |world| {
            world.spawn(Marker);
        },
    ] {
        change(&mut world);
        let after = run(&mut world, &mut schedule).unwrap().picture;
        assert_same("marked", &before, &after);
    }
}

#[test]
fn a_picture_may_change_its_size_and_level() {
    let (mut world, mut schedule) = prepared::<f64>(small_case().world());
    for (pixels, level) in [(64, 4), (17, 4), (80, 1), (80, 0), (1, 2), (64, 4)] {
        *world.resource_mut::<Snapshot>() = Snapshot { pixels, level };
        let after = run(&mut world, &mut schedule).unwrap();
        let mut case = small_case();
        case.description.pixels = pixels;
        case.description.level = level;
        let fresh = trace::<f64>(&mut case.world());
        assert_same(&format!("{pixels} pixels, level {level}"), &fresh.picture, &after.picture);
        assert_eq!(fresh.counts, after.counts);
    }
}

#[test]
fn a_precision_that_paused_catches_up() {
    // Both precisions live in one World, as when a viewer switches between them. While one is traced, the other
    // must not miss a change.
    let missed = CHANGES.into_iter().filter(|(_, change)| {
        let (mut world, mut single) = prepared::<f32>(small_case().world());
        prepare::<f64>(&mut world, workers(2));
        let mut double = frame_schedule::<f64>();
        run(&mut world, &mut single).unwrap();
        change(&mut world);
        for _ in 0..3 {
            run(&mut world, &mut double).unwrap();
        }
        let mut fresh = small_case().world();
        change(&mut fresh);
        run(&mut world, &mut single).unwrap().picture != trace::<f32>(&mut fresh).picture
    });
    let missed: Vec<&str> = missed.map(|(name, _)| name).collect();
    assert!(missed.is_empty(), "missed: {missed:?}");
}

#[test]
fn an_entity_may_have_two_shapes() {
    fn check<T: Real>() {
        let mut world = full_case().world();
        let place = Position::new(10.0, -60.0, 20.0);
        let look = (Color::new(0.9, 0.7, 0.3), Ambient(0.5), Diffuse(0.4), Mirror(0.2));
        world.spawn((Sphere { radius: 12.0 }, Cube { side: 16.0 }, place, look));
        let both = trace::<T>(&mut world).picture;

        let mut world = full_case().world();
        world.spawn((Sphere { radius: 12.0 }, place, look));
        let sphere = trace::<T>(&mut world).picture;
        world.spawn((Cube { side: 16.0 }, place, look));
        assert_same("sphere and cube", &trace::<T>(&mut world).picture, &both);
        assert_ne!(sphere, both);
        assert_ne!(trace::<T>(&mut full_case().world()).picture, sphere);
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn a_world_with_a_camera_only_is_black() {
    fn check<T: Real>() {
        let mut world = World::new();
        let lens = Lens { near: 1.0, far: 1000.0, fovy: 60.0, aspect: 1.0 };
        world.spawn((CameraPose::default(), lens));
        world.insert_resource(Snapshot { pixels: 33, level: 3 });
        let Traced { picture, counts } = trace::<T>(&mut world);
        assert!(picture.pixels.iter().all(|&pixel| pixel == [0.0; 3]));
        assert_eq!((counts.rays.primary, counts.rays.shadow, counts.rays.mirror), (33 * 33, 0, 0));
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn a_system_of_the_user_runs_before_the_extraction() {
    fn rise(mut spheres: Query<&mut Position, With<Sphere>>, mut commands: Commands) {
        for mut position in &mut spheres {
            position.0.z += 5.0;
        }
        commands.spawn((Cube { side: 9.0 }, Position::new(0.0, -70.0, 40.0), Ambient(0.8)));
    }
    let (mut world, mut schedule) = prepared::<f64>(small_case().world());
    schedule.add_systems(rise.before(Stage::Extract));
    let mut fresh = small_case().world();
    for frame in 1..=3 {
        let found = run(&mut world, &mut schedule).unwrap().picture;
        let mut positions = fresh.query_filtered::<&mut Position, With<Sphere>>();
        positions.iter_mut(&mut fresh).for_each(|mut position| position.0.z += 5.0);
        fresh.spawn((Cube { side: 9.0 }, Position::new(0.0, -70.0, 40.0), Ambient(0.8)));
        let expected: Picture = trace::<f64>(&mut fresh).picture;
        assert_same(&format!("frame {frame}"), &expected, &found);
    }
}

#[test]
fn a_picture_may_change_its_samples() {
    let (mut world, mut schedule) = prepared::<f64>(small_case().world());
    for side in [1, 3, 2, 1] {
        *world.resource_mut::<Sampling>() = Sampling { side };
        let after = run(&mut world, &mut schedule).unwrap();
        let mut fresh = small_case().world();
        fresh.insert_resource(Sampling { side });
        let fresh = trace::<f64>(&mut fresh);
        assert_same(&format!("{side} by {side} samples"), &fresh.picture, &after.picture);
        assert_eq!(fresh.counts, after.counts);
        assert_eq!(after.counts.rays.primary, u64::from(64 * 64 * side * side));
    }
}

#[test]
fn a_picture_cancelled_between_two_passes_says_so_and_the_next_is_whole() {
    let mut world = small_case().world();
    world.insert_resource(Sampling { side: 2 });
    let cancel = Arc::new(AtomicBool::new(false));
    let (seen, stop) = (AtomicU64::new(0), cancel.clone());
    let on_tile = move |pixels| {
        if seen.fetch_add(pixels, Ordering::Relaxed) + pixels >= 64 * 64 {
            stop.store(true, Ordering::Relaxed);
        }
    };
    world.insert_resource(Monitor::new(on_tile, cancel));
    let (mut world, mut schedule) = prepared::<f64>(world);
    assert_eq!(run(&mut world, &mut schedule).unwrap_err(), FrameError::Cancelled);
    world.insert_resource(Monitor::default());
    let whole = run(&mut world, &mut schedule).unwrap().picture;
    let mut fresh = small_case().world();
    fresh.insert_resource(Sampling { side: 2 });
    assert_same("after a cancelled one", &trace::<f64>(&mut fresh).picture, &whole);
}

#[test]
fn the_monitor_hears_of_every_sample_of_every_pixel() {
    let mut world = small_case().world();
    world.insert_resource(Sampling { side: 3 });
    let seen = Arc::new(AtomicU64::new(0));
    let counter = seen.clone();
    let on_tile = move |pixels| {
        counter.fetch_add(pixels, Ordering::Relaxed);
    };
    world.insert_resource(Monitor::new(on_tile, Arc::default()));
    trace::<f64>(&mut world);
    assert_eq!(seen.load(Ordering::Relaxed), 9 * 64 * 64);
}

#[test]
fn a_cancelled_frame_says_so_and_the_next_is_whole() {
    let mut world = small_case().world();
    let cancel = Arc::new(AtomicBool::new(true));
    world.insert_resource(Monitor::new(|_| panic!("a tile was traced"), cancel));
    let (mut world, mut schedule) = prepared::<f64>(world);
    let error = run(&mut world, &mut schedule).unwrap_err();
    assert_eq!(error, FrameError::Cancelled);
    assert_eq!(error.to_string(), "interrupted");
    world.insert_resource(Monitor::default());
    let whole = run(&mut world, &mut schedule).unwrap().picture;
    assert_same("after a cancelled one", &trace::<f64>(&mut small_case().world()).picture, &whole);
}

#[test]
fn a_light_far_away_in_the_order_is_summed_in_its_place() {
    // Sums round, so the order of lights shows in the last bits: it must be that of Order.
    let picture = |orders: [u32; 5]| {
        let mut world = full_case().world();
        let mut lights = world.query_filtered::<&mut Order, With<Light>>();
        for mut order in lights.iter_mut(&mut world) {
            order.0 = orders[order.0 as usize];
        }
        trace::<f64>(&mut world).picture
    };
    let usual = picture([0, 1, 2, 3, 4]);
    assert_same("orders with gaps", &usual, &picture([3, 30, 31, 400, u32::MAX - 1]));
    assert_ne!(usual, picture([4, 3, 2, 1, 0]), "the order of lights shows nowhere");
}

//! Objects that move while the shutter is open.

use archetrace::components::{CameraPose, Lens, Position, Sampling, Shutter, Snapshot, Sphere, Velocity};
use archetrace::effects::Effect;
use archetrace::geometry::Real;
use archetrace::systems::{Tables, frame_schedule, prepare};
use bevy_ecs::prelude::*;
use glam::DVec3;

use super::{View, lamp, wall_ahead, white};
use crate::support::picture::assert_same;
use crate::support::random::Random;
use crate::support::scenes::full_case;
use crate::support::tracing::{run, trace, workers};

fn camera(world: &mut World) -> Entity {
    world.query_filtered::<Entity, With<CameraPose>>().single(world).unwrap()
}

fn open(world: &mut World, open: f64, close: f64) {
    let camera = camera(world);
    world.entity_mut(camera).insert(Shutter { open, close });
}

/// One pixel next to nothing wide: all its samples look at one point.
fn narrow_view() -> View {
    View { lens: Lens { fovy: 1e-9, ..View::one_ray().lens }, ..View::one_ray() }
}

#[test]
fn an_edge_shows_for_as_long_as_it_is_there() {
    fn check<T: Real>() {
        // A wall comes from the right and reaches the only ray 0.3 s after the start.
        for (start, end) in [(0.0, 1.0), (0.0, 0.3), (0.25, 0.35), (-1.0, 3.0), (0.4, 0.5), (0.0, 0.2)] {
            let mut world = narrow_view().world();
            let (cube, mut corner) = wall_ahead(5.0);
            corner.0.x = 3.0;
            world.spawn((cube, corner, white(1.0, 0.0), Velocity(DVec3::new(-10.0, 0.0, 0.0))));
            world.insert_resource(Sampling { side: 32 });
            open(&mut world, start, end);
            let found = trace::<T>(&mut world).picture.middle()[0];
            let expected = ((end - 0.3) / (end - start)).clamp(0.0, 1.0);
            // Of 1024 moments in the middles of equal parts, the edge divides one part.
            let off = (found - expected).abs();
            assert!(off <= 0.5 / 1024.0 + 1e-6, "from {start} to {end}: {found}, on paper {expected}");
        }
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn shadows_and_mirrors_move_along() {
    // A ball hangs between lamp and wall for the second half of the time, and is out of sight itself.
    let mut world = narrow_view().world();
    world.spawn((wall_ahead(10.0), white(0.25, 0.5)));
    world.spawn(lamp(0.0, -1000.0, 0.0));
    let at = Position::new(-1.5, -500.0, 0.0);
    world.spawn((Sphere { radius: 1.0 }, at, Velocity(DVec3::new(1.0, 0.0, 0.0))));
    world.insert_resource(Sampling { side: 16 });
    open(&mut world, 0.0, 1.0);
    assert_eq!(trace::<f64>(&mut world).picture.middle(), [0.25 + 0.5 * 0.5; 3]);
}

/// Forty balls, so that their table has a tree, of which every third has a velocity, in eighths.
fn swarm(moved_by: f64) -> World {
    let mut world = full_case().world();
    world.resource_mut::<Snapshot>().pixels = 64;
    let random = &mut Random::new(77);
    for number in 0..40 {
        let mut eighths = |size: f64| (random.between(-size, size) * 8.0).round() / 8.0;
        let position = DVec3::new(eighths(80.0), eighths(80.0), 40.0 + eighths(40.0));
        let velocity = DVec3::new(eighths(60.0), eighths(60.0), eighths(30.0));
        let mut ball = world.spawn((Sphere { radius: 4.0 }, white(0.3, 0.5)));
        if number % 3 == 0 {
            ball.insert((Position(position + velocity * moved_by), Velocity(velocity)));
        } else {
            ball.insert(Position(position));
        }
    }
    world
}

#[test]
fn a_moment_shows_everything_where_it_is_then() {
    fn check<T: Real>() {
        for moment in [0.5, -0.25, 4.0] {
            let mut moving = swarm(0.0);
            open(&mut moving, moment, moment);
            assert_same(
                "a moment",
                &trace::<T>(&mut swarm(moment)).picture,
                &trace::<T>(&mut moving).picture,
            );
        }
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn without_shutter_velocity_or_time_nothing_moves() {
    fn check<T: Real>() {
        let still = trace::<T>(&mut swarm(0.0)).picture;
        let check = |change: fn(&mut World)| {
            let mut world = swarm(0.0);
            change(&mut world);
            assert_same("nothing moves", &still, &trace::<T>(&mut world).picture);
            let tables = world.resource::<Tables<T>>();
            let count = tables.effect_counts().into_iter().find(|c| c.effect == Effect::MotionBlur).unwrap();
            assert_eq!((count.rows, count.bytes), (0, 0));
        };
        check(|_| ());
        check(|world| open(world, 0.0, 0.0));
        check(|world| {
            open(world, 0.0, 1.0);
            world.query::<&mut Velocity>().iter_mut(world).for_each(|mut velocity| velocity.0 = DVec3::ZERO);
        });
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn edits_of_velocity_and_shutter_show_in_the_next_frame() {
    let mut world = swarm(0.0);
    prepare::<f64>(&mut world, workers(2));
    let mut schedule = frame_schedule::<f64>();
    let mut next = |change: &dyn Fn(&mut World)| {
        change(&mut world);
        let picture = run(&mut world, &mut schedule).unwrap().picture;
        let counts = world.resource::<Tables<f64>>().effect_counts();
        (picture, counts.into_iter().find(|count| count.effect == Effect::MotionBlur).unwrap().rows)
    };
    let (still, rows) = next(&|_| ());
    assert_eq!(rows, 0);
    let (blurred, rows) = next(&|world| open(world, 0.5, 0.5));
    assert_eq!(rows, 14);
    assert_ne!(still, blurred);
    let (_, rows) = next(&|world| {
        let movers: Vec<Entity> = world.query_filtered::<Entity, With<Velocity>>().iter(world).collect();
        world.despawn(movers[3]);
    });
    assert_eq!(rows, 13);
    let (unmoved, rows) = next(&|world| {
        let movers: Vec<Entity> = world.query_filtered::<Entity, With<Velocity>>().iter(world).collect();
        for mover in movers {
            world.entity_mut(mover).remove::<Velocity>();
        }
    });
    assert_eq!(rows, 0);
    let (shut, _) = next(&|world| {
        let camera = camera(world);
        world.entity_mut(camera).remove::<Shutter>();
    });
    assert_same("nothing moves", &unmoved, &shut);
}

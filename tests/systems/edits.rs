//! Small edits of large scenes: only the rows that changed are touched, and the tables and pictures are those of a World
//! that was extracted from nothing.

use archetrace::components::{
    Ambient, CameraPose, Checkerboard, Color, Cube, Diffuse, Gloss, Lens, Light, Mirror, Order, Position,
    Pyramid, Snapshot, Sphere,
};
use archetrace::systems::{Tables, extract_schedule, frame_schedule, prepare};
use bevy_ecs::prelude::*;
use bevy_ecs::schedule::Schedule;
use glam::DVec3;

use crate::support::parts::rebuilt;
use crate::support::picture::assert_same;
use crate::support::random::Random;
use crate::support::tracing::{run, trace, workers};

const COUNT: u32 = 900;

/// Objects of all kinds in a cube, seen from outside.
fn crowd() -> World {
    let random = &mut Random::new(4711);
    let mut world = World::new();
    world.insert_resource(Snapshot { pixels: 48, level: 3 });
    let eye = DVec3::new(90.0, -120.0, 60.0);
    let pose = CameraPose::looking(eye, -eye, DVec3::Z).unwrap();
    world.spawn((pose, Lens { near: 1.0, far: 1000.0, fovy: 50.0, aspect: 1.0 }));
    world.spawn((Light, Position::new(50.0, -90.0, 140.0), Order(0)));
    world.spawn((Checkerboard { cell: 9.0 }, Position::new(0.0, 0.0, -60.0), Diffuse(0.6), Order(1)));
    for number in 0..COUNT {
        let place = (Position(random.point(50.0)), Order(number + 2));
        let surface = (Color::new(random.unit(), 0.5, 0.7), Ambient(0.2), Diffuse(0.5), Mirror(0.3));
        let size = random.between(1.0, 7.0);
        let mut entity = world.spawn((place, surface));
        match number % 3 {
            0 => entity.insert((Sphere { radius: 0.5 * size }, Gloss { specular: 0.2, shininess: 9.0 })),
            1 => entity.insert(Cube { side: size }),
            _ => entity.insert(Pyramid { width: size, height: 1.3 * size }),
        };
    }
    world
}

fn all<S: Component>(world: &mut World) -> Vec<Entity> {
    let mut entities: Vec<_> = world.query_filtered::<(Entity, &Order), With<S>>().iter(world).collect();
    entities.sort_by_key(|(_, order)| order.0);
    entities.into_iter().map(|(entity, _)| entity).collect()
}

fn move_some<S: Component>(world: &mut World, count: usize, by: DVec3) {
    for entity in all::<S>(world).into_iter().step_by(7).take(count) {
        world.get_mut::<Position>(entity).unwrap().0 += by;
    }
}

/// The first sphere's entity.
fn sphere(world: &mut World) -> EntityWorldMut<'_> {
    let entity = all::<Sphere>(world)[0];
    world.entity_mut(entity)
}

fn check_against_a_new_world(world: &mut World, schedule: &mut Schedule, name: &str) {
    let edited = run(world, schedule).unwrap();
    let fresh = trace::<f64>(&mut rebuilt(world, |_| ()));
    assert_same(name, &edited.picture, &fresh.picture);
    assert_eq!(edited.counts, fresh.counts, "{name}");
}

/// An edit, by name.
type Edit = (&'static str, fn(&mut World));

const EDITS: [Edit; 13] = [
    ("one sphere moved", |world| move_some::<Sphere>(world, 1, DVec3::new(30.0, -20.0, 10.0))),
    ("some cubes moved", |world| move_some::<Cube>(world, 20, DVec3::new(-9.0, 4.0, 22.0))),
    ("some pyramids far away", |world| move_some::<Pyramid>(world, 9, DVec3::new(0.0, 0.0, 70.0))),
    ("most spheres moved", |world| {
        all::<Sphere>(world).into_iter().skip(3).for_each(|entity| {
            world.get_mut::<Position>(entity).unwrap().0.x += 5.0;
        });
    }),
    ("radius", |world| sphere(world).get_mut::<Sphere>().unwrap().radius *= 4.0),
    ("colour", |world| *sphere(world).get_mut::<Color>().unwrap() = Color::new(1.0, 0.0, 0.0)),
    ("gloss replaced", |world| {
        sphere(world).insert(Gloss { specular: 0.8, shininess: 50.0 });
    }),
    ("gloss that shows nothing", |world| sphere(world).get_mut::<Gloss>().unwrap().specular = 0.0),
    ("order", |world| sphere(world).get_mut::<Order>().unwrap().0 = COUNT + 50),
    ("gloss of one to another", |world| {
        let spheres = all::<Sphere>(world);
        world.entity_mut(spheres[3]).remove::<Gloss>();
        let cubes = all::<Cube>(world);
        world.entity_mut(cubes[4]).insert(Gloss { specular: 0.5, shininess: 5.0 });
        world.entity_mut(spheres[9]).remove::<Mirror>();
    }),
    ("mirror of one to another of a kind", |world| {
        let pyramids = all::<Pyramid>(world);
        world.entity_mut(pyramids[2]).remove::<Mirror>();
        let bare = world.entity_mut(pyramids[5]).take::<Mirror>();
        world.entity_mut(pyramids[5]).insert(bare.unwrap());
    }),
    ("one for another in its place", |world| {
        let entity = all::<Cube>(world)[8];
        let order = *world.get::<Order>(entity).unwrap();
        world.despawn(entity);
        world.spawn((Cube { side: 20.0 }, Position::new(0.0, 0.0, 20.0), Ambient(1.0), order));
    }),
    ("order lost", |world| {
        sphere(world).remove::<Order>();
    }),
];

#[test]
fn after_any_edit_the_picture_is_that_of_a_new_world() {
    let mut world = crowd();
    prepare::<f64>(&mut world, workers(2));
    let mut schedule = frame_schedule::<f64>();
    run(&mut world, &mut schedule).unwrap();
    for round in 0..2 {
        for (name, edit) in EDITS {
            edit(&mut world);
            check_against_a_new_world(&mut world, &mut schedule, &format!("{name}, round {round}"));
        }
    }
}

/// A World, its tables extracted.
fn extracted() -> (World, Schedule) {
    let mut world = crowd();
    prepare::<f64>(&mut world, workers(1));
    let mut schedule = extract_schedule::<f64>();
    schedule.run(&mut world);
    (world, schedule)
}

#[test]
fn an_edit_keeps_the_tree_and_many_edits_wear_it() {
    let (mut world, mut schedule) = extracted();
    let moved = |world: &World| world.resource::<Tables<f64>>().scene.trees.spheres.as_ref().unwrap().moved();
    for edits in 1..=3 {
        move_some::<Sphere>(&mut world, 1, DVec3::X);
        schedule.run(&mut world);
        assert_eq!(moved(&world), edits, "not built again");
    }
    let mut rounds = 0;
    while moved(&world) > 0 {
        move_some::<Sphere>(&mut world, 30, DVec3::Y);
        schedule.run(&mut world);
        rounds += 1;
        assert!(rounds < 40, "a tree is for ever");
    }
}

#[test]
fn a_bad_value_in_an_edit_is_reported_and_mended() {
    let (mut world, mut schedule) = extracted();
    sphere(&mut world).get_mut::<Sphere>().unwrap().radius = -1.0;
    schedule.run(&mut world);
    assert_eq!(world.resource::<Tables<f64>>().problems().len(), 1);
    sphere(&mut world).get_mut::<Sphere>().unwrap().radius = 1.0;
    schedule.run(&mut world);
    assert!(world.resource::<Tables<f64>>().problems().is_empty());
    let scene = &world.resource::<Tables<f64>>().scene;
    assert!(!scene.lacks_trees());
}

//! World to scene file and back.

use archetrace::components::{
    CameraPose, Checkerboard, Color, Cube, Gloss, Lens, Position, Pyramid, Snapshot, Sphere,
};
use archetrace::scene::{
    BoardDescription, DescribeError, Description, LightDescription, ObjectDescription, ShapeDescription,
    SpotDescription, SurfaceDescription, describe, parse, spawn,
};
use archetrace::systems::{Tables, extract_schedule, prepare};
use bevy_ecs::prelude::*;
use glam::DVec3;

use crate::support::case::{Case, only};
use crate::support::random::Random;
use crate::support::scenes::{full_case, random_case};
use crate::support::tracing::workers;

fn world_of(description: &Description) -> World {
    Case::new(description.clone()).world()
}

/// All that a frame is traced from, as text.
fn tables(world: &mut World) -> String {
    prepare::<f64>(world, workers(1));
    extract_schedule::<f64>().run(world);
    let tables = world.resource::<Tables<f64>>();
    assert_eq!(tables.problems(), []);
    format!("{:?} {:?} {:?}", tables.scene, tables.camera, world.resource::<Snapshot>())
}

/// World, text, World again: the same tables.
fn assert_round_trip(name: &str, description: &Description) {
    let mut world = world_of(description);
    let described = describe(&mut world).unwrap();
    let text = described.to_string();
    let (parsed, _) = parse(&text).unwrap_or_else(|problems| panic!("{name}: {problems:?}\n{text}"));
    assert_eq!(parsed, described, "{name}: the text says something else");
    let mut again = world_of(&parsed);
    assert_eq!(describe(&mut again).unwrap(), described, "{name}: described again");
    assert!(tables(&mut again) == tables(&mut world), "{name}: other tables\n{text}");
}

/// The description without what shows nothing: gloss of a surface without a specular part.
fn visible(description: &Description) -> Description {
    let mut visible = description.clone();
    for object in &mut visible.objects {
        if object.surface.specular == 0.0 {
            object.surface.shininess = 0.0;
        }
    }
    visible
}

#[test]
fn random_scenes_come_back() {
    for seed in 1..=200 {
        let description = random_case(seed, 96).description;
        assert_round_trip(&format!("seed {seed}"), &description);
        let described = describe(&mut world_of(&description)).unwrap();
        assert_eq!(described, visible(&description), "seed {seed}");
    }
}

#[test]
fn scenes_of_any_magnitude_come_back() {
    for seed in 1..=300 {
        let description = wild_description(&mut Random::new(seed));
        assert_round_trip(&format!("wild seed {seed}"), &description);
        let described = describe(&mut world_of(&description)).unwrap();
        assert_eq!(described, visible(&description), "wild seed {seed}");
    }
}

/// A number between two powers of ten, with all its digits.
fn magnitude(random: &mut Random, low: i32, high: i32) -> f64 {
    let exponent = random.between(f64::from(low), f64::from(high)).floor();
    random.between(1.0, 9.9) * 10_f64.powf(exponent)
}

fn length(random: &mut Random) -> f64 {
    magnitude(random, -69, 69)
}

fn coordinate(random: &mut Random) -> f64 {
    let magnitude = magnitude(random, -300, 69);
    random.pick(&[0.0, -0.0, magnitude, -magnitude, 1e70, -1e70, 5e-324])
}

fn point(random: &mut Random) -> DVec3 {
    DVec3::from_array(core::array::from_fn(|_| coordinate(random)))
}

fn share(random: &mut Random) -> f64 {
    let (unit, tiny) = (random.unit(), magnitude(random, -300, 0).min(1.0));
    random.pick(&[0.0, 1.0, unit, tiny])
}

fn wild_description(random: &mut Random) -> Description {
    let near = length(random);
    Description {
        near,
        far: near * random.between(1.5, 9.0),
        fovy: random.between(1e-9, 100.0),
        aspect: random.between(1e-6, 1.7),
        level: random.below(1001) as u32,
        pixels: 1 + random.below(8192) as u32,
        board: BoardDescription {
            cell: length(random),
            ambient: share(random),
            diffuse: share(random),
            reflection: share(random),
        },
        objects: (0..random.below(6)).map(|_| wild_object(random)).collect(),
        lights: (0..random.below(4)).map(|_| wild_light(random)).collect(),
        spots: (0..random.below(4)).map(|_| wild_spot(random)).collect(),
    }
}

fn wild_object(random: &mut Random) -> ObjectDescription {
    let shape = match random.below(3) {
        0 => ShapeDescription::Sphere { radius: length(random) },
        1 => ShapeDescription::Cube { side: length(random) },
        _ => ShapeDescription::Pyramid { width: length(random), height: length(random) },
    };
    let surface = SurfaceDescription {
        color: DVec3::from_array(core::array::from_fn(|_| share(random))),
        ambient: share(random),
        diffuse: share(random),
        specular: share(random),
        reflection: share(random),
        shininess: 1e9 * share(random),
    };
    ObjectDescription { position: point(random), shape, surface }
}

fn wild_light(random: &mut Random) -> LightDescription {
    LightDescription { position: point(random), falloff: magnitude(random, -300, 149) * share(random) }
}

fn wild_spot(random: &mut Random) -> SpotDescription {
    let light = wild_light(random);
    let target = point(random);
    let elsewhere = DVec3::ONE - light.position;
    SpotDescription {
        target: if target == light.position { elsewhere } else { target },
        light,
        cutoff: 180.0 * share(random),
    }
}

#[test]
fn entities_without_order_are_described_too() {
    let mut world = World::new();
    world.spawn((CameraPose::default(), Lens { near: 1.0, far: 9.0, fovy: 60.0, aspect: 1.0 }));
    world.spawn(Checkerboard { cell: 2.0 });
    world.spawn((Sphere { radius: 1.0 }, Position::new(1.0, 2.0, 3.0)));
    world.spawn((Pyramid { width: 1.0, height: 4.0 }, Color::new(0.5, 0.25, 0.0)));
    let described = describe(&mut world).unwrap();
    assert_eq!((described.pixels, described.level), (768, 3));
    let shapes: Vec<ShapeDescription> = described.objects.iter().map(|object| object.shape).collect();
    let expected =
        [ShapeDescription::Sphere { radius: 1.0 }, ShapeDescription::Pyramid { width: 1.0, height: 4.0 }];
    assert_eq!(shapes, expected);
    assert_eq!(described.objects[0].position, DVec3::new(1.0, 2.0, 3.0));
    assert_eq!(described.objects[1].surface.color, DVec3::new(0.5, 0.25, 0.0));
}

fn refusal(change: impl Fn(&mut World)) -> String {
    let mut world = full_case().world();
    change(&mut world);
    describe(&mut world).unwrap_err().to_string()
}

#[test]
fn what_a_file_cannot_say_is_refused() {
    let none = describe(&mut World::new()).unwrap_err();
    assert_eq!(none, DescribeError::Cameras(0));
    assert_eq!(none.to_string(), "a scene file has one camera, but the World has 0");
    let second = refusal(|world| spawn(world, &full_case().description));
    assert_eq!(second, "a scene file has one camera, but the World has 2");
    let boards = refusal(|world| {
        world.spawn(Checkerboard { cell: 1.0 });
    });
    assert_eq!(boards, "a scene file has one checkerboard, but the World has 2");
}

#[test]
fn a_changed_board_or_a_double_shape_is_refused() {
    let board = |world: &mut World| {
        let mut boards = world.query_filtered::<Entity, With<Checkerboard>>();
        boards.single(world).unwrap()
    };
    let entity = board(&mut full_case().world());
    let message = format!("entity {entity}: a scene file cannot move, tint or polish its checkerboard");
    let found = |insert: fn(EntityWorldMut<'_>)| {
        refusal(|world| {
            let entity = board(world);
            insert(world.entity_mut(entity));
        })
    };
    let moved = |mut board: EntityWorldMut<'_>| {
        board.insert(Position::new(0.0, 0.0, 1.0));
    };
    let tinted = |mut board: EntityWorldMut<'_>| {
        board.insert(Color::new(0.5, 1.0, 1.0));
    };
    let polished = |mut board: EntityWorldMut<'_>| {
        board.insert(Gloss { specular: 0.1, shininess: 1.0 });
    };
    assert_eq!([found(moved), found(tinted), found(polished)], [message.as_str(); 3]);
    let mut world = full_case().world();
    let entity = world.spawn((Sphere { radius: 1.0 }, Cube { side: 1.0 })).id();
    let message = format!("entity {entity}: a scene file cannot give one object two shapes");
    assert_eq!(describe(&mut world).unwrap_err().to_string(), message);
}

#[test]
fn an_incomplete_object_is_not_left_out_silently() {
    let mut world = full_case().world();
    let sphere = world.query_filtered::<Entity, With<Sphere>>().iter(&world).min().unwrap();
    world.entity_mut(sphere).remove::<Color>();
    let described = describe(&mut world);
    assert!(described.is_err(), "{} of 8 objects described", described.unwrap().objects.len());
}

#[test]
fn the_camera_pose_is_not_part_of_a_file() {
    let mut world = full_case().world();
    let before = describe(&mut world).unwrap();
    only::<CameraPose>(&mut world).position = DVec3::splat(5.0);
    assert_eq!(describe(&mut world).unwrap(), before);
}

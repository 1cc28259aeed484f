//! Description to World and back: what a file says, the World holds.

use archetrace::components::{
    CameraPose, Checkerboard, Falloff, Gloss, Lens, Light, Mirror, Order, Position, Snapshot, Sphere,
    SpotCone,
};
use archetrace::scene::{Description, describe, parse, spawn};
use bevy_ecs::prelude::*;

use crate::round_trip::{bits, description};
use crate::sample::{SAMPLE, read};

fn world_of(scene: &Description) -> World {
    let mut world = World::new();
    spawn(&mut world, scene);
    world
}

/// What of a description a World keeps: an effect without strength is none.
fn kept(scene: &Description) -> Description {
    let without_sign = |value: f64| if value == 0.0 { 0.0 } else { value };
    let mut kept = scene.clone();
    kept.board.reflection = without_sign(kept.board.reflection);
    for object in &mut kept.objects {
        let surface = &mut object.surface;
        surface.reflection = without_sign(surface.reflection);
        if surface.specular == 0.0 {
            surface.specular = 0.0;
            surface.shininess = 0.0;
        }
    }
    for light in &mut kept.lights {
        light.falloff = without_sign(light.falloff);
    }
    for spot in &mut kept.spots {
        spot.light.falloff = without_sign(spot.light.falloff);
    }
    kept
}

#[test]
fn a_world_gives_back_what_it_was_spawned_from() {
    for seed in 0..500 {
        let scene = description(seed);
        let described = describe(&mut world_of(&scene)).unwrap();
        assert_eq!(bits(&described), bits(&kept(&scene)), "seed {seed}:\n{scene}");
    }
}

#[test]
fn a_world_written_and_read_is_the_same_world() {
    for seed in 0..500 {
        let mut world = world_of(&description(seed));
        let described = describe(&mut world).unwrap();
        let (read, _) = parse(&described.to_string()).unwrap();
        let mut again = world_of(&read);
        let described_again = describe(&mut again).unwrap();
        assert_eq!(bits(&described_again), bits(&described), "seed {seed}");
        assert_eq!(again.entities().len(), world.entities().len(), "seed {seed}: number of entities");
    }
}

#[test]
fn effects_without_strength_become_no_component() {
    let text = "1 2 60 1 0 1  1 1 0 0  2
        sphere 0 0 0 1  1 1 1  1 0 0 0  9
        sphere 0 0 0 1  1 1 1  0 0 0.5 0.5  9
        2  0 0 5 0  0 0 5 0.1  1  0 0 5 0  0 0 0 30";
    let mut world = world_of(&read(text));
    let mut objects = world.query_filtered::<(&Order, Has<Gloss>, Has<Mirror>), With<Sphere>>();
    let mut found: Vec<_> =
        objects.iter(&world).map(|(order, gloss, mirror)| (order.0, gloss, mirror)).collect();
    found.sort_unstable();
    assert_eq!(found, [(0, false, false), (1, true, true)]);
    let mut lights = world.query_filtered::<(&Order, Has<Falloff>, Has<SpotCone>), With<Light>>();
    let mut found: Vec<_> =
        lights.iter(&world).map(|(order, falloff, cone)| (order.0, falloff, cone)).collect();
    found.sort_unstable();
    assert_eq!(found, [(0, false, false), (1, true, false), (2, false, true)]);
    let mut boards = world.query_filtered::<Has<Mirror>, With<Checkerboard>>();
    assert!(!boards.single(&world).unwrap());
}

#[test]
fn the_camera_starts_where_the_assignment_says() {
    let mut world = world_of(&read(SAMPLE));
    let (pose, lens) = world.query::<(&CameraPose, &Lens)>().single(&world).unwrap();
    assert_eq!(pose.position.to_array(), [0.0, -150.0, 50.0]);
    assert_eq!(pose.l.to_array(), [0.0, 1.0, 0.0]);
    assert_eq!(pose.r.to_array(), [1.0, 0.0, 0.0]);
    assert_eq!(pose.u.to_array(), [0.0, 0.0, 1.0]);
    assert_eq!((lens.near, lens.far, lens.fovy, lens.aspect), (1.0, 1000.0, 60.0, 1.5));
    let snapshot = world.resource::<Snapshot>();
    assert_eq!((snapshot.pixels, snapshot.level), (64, 3));
}

#[test]
fn objects_come_back_in_file_order_however_the_world_moved_them() {
    let scene = read(SAMPLE);
    let mut world = world_of(&scene);
    // Taking a component away and giving it back moves an entity to the end of its table.
    let mut glossy = world.query_filtered::<(Entity, &Gloss), With<Sphere>>();
    let (entity, gloss) = glossy.single(&world).map(|(e, g)| (e, *g)).unwrap();
    world.entity_mut(entity).remove::<Gloss>();
    world.entity_mut(entity).insert(gloss);
    assert_eq!(describe(&mut world).unwrap(), scene);
}

#[test]
fn a_world_that_no_file_can_say_is_refused_with_the_reason() {
    let scene = read(SAMPLE);
    let refusal = |change: &dyn Fn(&mut World)| {
        let mut world = world_of(&scene);
        change(&mut world);
        describe(&mut world).unwrap_err().to_string()
    };
    let first = |world: &mut World, with: fn(&mut World) -> Entity| with(world);
    let board = |world: &mut World| {
        let mut boards = world.query_filtered::<Entity, With<Checkerboard>>();
        boards.single(world).unwrap()
    };
    let no_camera = refusal(&|world| {
        let mut cameras = world.query_filtered::<Entity, With<CameraPose>>();
        let camera = cameras.single(world).unwrap();
        world.despawn(camera);
    });
    assert_eq!(no_camera, "a scene file has one camera, but the World has 0");
    let no_board = refusal(&|world| {
        let board = first(world, board);
        world.despawn(board);
    });
    assert_eq!(no_board, "a scene file has one checkerboard, but the World has 0");
    let moved = refusal(&|world| {
        let board = first(world, board);
        world.entity_mut(board).insert(Position::new(0.0, 0.0, 1.0));
    });
    assert!(moved.ends_with("a scene file cannot move, tint or polish its checkerboard"), "{moved}");
    let two_shapes = refusal(&|world| {
        let mut spheres = world.query_filtered::<Entity, With<Sphere>>();
        let sphere = spheres.single(world).unwrap();
        world.entity_mut(sphere).insert(archetrace::components::Cube { side: 1.0 });
    });
    assert!(two_shapes.ends_with("a scene file cannot give one object two shapes"), "{two_shapes}");
}

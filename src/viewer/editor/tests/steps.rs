//! What single edits promise.

use bevy_ecs::prelude::*;
use glam::DVec3;

use std::sync::Arc;

use crate::components::{
    CameraPose, Checkerboard, Color, Cube, Gloss, Home, Lens, Light, Order, Position, Reference, Sampling,
    Snapshot, Sphere, Texture, Textured,
};
use crate::scene::{describe, spawn};
use crate::systems::Tables;

use super::super::history::{History, Limits};
use super::super::{Editor, New};
use super::{Followed, description};

fn camera(world: &mut World) -> Entity {
    world.query_filtered::<Entity, With<CameraPose>>().single(world).unwrap()
}

fn with_limits(steps: usize, hidden: usize) -> Editor {
    Editor { history: History::with_limits(Limits { steps, hidden }), ..Editor::default() }
}

fn entities(world: &World) -> u32 {
    world.entities().count_spawned()
}

#[test]
fn a_drag_is_one_step_and_one_that_comes_back_is_none() {
    let (mut world, mut editor) = (World::new(), Editor::default());
    let sphere = world.spawn(Sphere { radius: 1.0 }).id();
    for radius in [2.0, 3.0, 4.0] {
        editor.change(&mut world, sphere, Some(Sphere { radius }));
    }
    editor.end_gesture();
    for radius in [5.0, 4.0] {
        editor.change(&mut world, sphere, Some(Sphere { radius }));
    }
    editor.end_gesture();
    assert_eq!(editor.undo(&mut world), Some("Sphere"));
    assert_eq!(world.get(sphere), Some(&Sphere { radius: 1.0 }));
    assert_eq!(editor.undo(&mut world), None);
    assert_eq!(editor.redo(&mut world), Some("Sphere"));
    assert_eq!(world.get(sphere), Some(&Sphere { radius: 4.0 }));
    assert_eq!(editor.redo(&mut world), None);
}

#[test]
fn another_component_or_entity_within_a_gesture_is_another_step() {
    let (mut world, mut editor) = (World::new(), Editor::default());
    let [a, b] = [1.0, 2.0].map(|radius| world.spawn(Sphere { radius }).id());
    editor.change(&mut world, a, Some(Sphere { radius: 3.0 }));
    editor.change(&mut world, b, Some(Sphere { radius: 4.0 }));
    editor.change(&mut world, b, Some(Position::new(1.0, 0.0, 0.0)));
    assert_eq!(editor.undo(&mut world), Some("Position"));
    assert_eq!(editor.undo(&mut world), Some("Sphere"));
    assert_eq!(world.get(b), Some(&Sphere { radius: 2.0 }));
    assert_eq!(world.get(a), Some(&Sphere { radius: 3.0 }));
}

#[test]
fn an_effect_comes_and_goes() {
    let (mut world, mut editor) = (World::new(), Editor::default());
    let sphere = world.spawn(Sphere { radius: 1.0 }).id();
    let gloss = Gloss { specular: 0.5, shininess: 30.0 };
    editor.change(&mut world, sphere, Some(gloss));
    editor.end_gesture();
    editor.change::<Gloss>(&mut world, sphere, None);
    editor.end_gesture();
    assert_eq!(world.get::<Gloss>(sphere), None);
    editor.undo(&mut world);
    assert_eq!(world.get(sphere), Some(&gloss));
    editor.undo(&mut world);
    assert_eq!(world.get::<Gloss>(sphere), None);
}

#[test]
fn a_scene_is_unmodified_where_it_was_saved() {
    let (mut world, mut editor) = (World::new(), Editor::default());
    let sphere = world.spawn(Sphere { radius: 1.0 }).id();
    assert!(!editor.is_modified());
    editor.change(&mut world, sphere, Some(Sphere { radius: 2.0 }));
    assert!(editor.is_modified());
    editor.mark_saved();
    assert!(!editor.is_modified());
    editor.change(&mut world, sphere, Some(Sphere { radius: 3.0 }));
    assert!(editor.is_modified(), "a change after saving is a step of its own");
    editor.undo(&mut world);
    assert!(!editor.is_modified());
    editor.undo(&mut world);
    assert!(editor.is_modified());
    editor.redo(&mut world);
    assert!(!editor.is_modified());
    editor.change_setting(&mut world, Sampling { side: 3 });
    editor.end_gesture();
    assert!(!editor.is_modified(), "a file holds no sampling");
    editor.undo(&mut world);
    assert!(!editor.is_modified());
    editor.change(&mut world, sphere, Some(Sphere { radius: 9.0 }));
    editor.change(&mut world, sphere, Some(Sphere { radius: 2.0 }));
    editor.end_gesture();
    assert!(!editor.is_modified(), "a drag that came back");
}

#[test]
fn what_goes_while_another_comes_back_is_noticed() {
    let mut scene = Followed::new(World::new());
    let mut editor = Editor::default();
    let spheres = [1.0, 2.0].map(|radius| scene.world.spawn(Sphere { radius }).id());
    let lights = [1.0, 2.0].map(|x| scene.world.spawn((Light, Position::new(x, 0.0, 0.0))).id());
    for [a, b] in [spheres, lights] {
        editor.select(Some(b));
        assert!(editor.delete(&mut scene.world));
        let without_b = scene.tables();
        editor.undo(&mut scene.world);
        editor.select(Some(a));
        assert!(editor.delete(&mut scene.world));
        let without_a = scene.tables();
        assert_ne!(without_a, without_b);
        editor.undo(&mut scene.world);
        scene.tables();
    }
    let table = &scene.world.resource::<Tables<f64>>().scene;
    assert_eq!(table.table_counts().map(|count| count.rows), [2, 0, 0, 0, 2]);
}

#[test]
fn the_camera_stays_one() {
    let mut scene = Followed::of_file("official.txt");
    let mut editor = Editor::default();
    let camera = camera(&mut scene.world);
    let before = scene.tables();
    editor.select(Some(camera));
    assert!(!editor.delete(&mut scene.world));
    assert_eq!(editor.duplicate(&mut scene.world), None);
    assert_eq!(scene.tables(), before);
    assert_eq!(editor.undo(&mut scene.world), None);
}

#[derive(Component, Clone, Debug, PartialEq)]
struct Speed(f64);

#[derive(Component)]
struct Secret;

#[test]
fn components_of_a_scene_of_its_own_survive() {
    let (mut world, mut editor) = (World::new(), Editor::default());
    let moon = world.spawn((Sphere { radius: 1.0 }, Speed(3.0), Secret)).id();
    editor.select(Some(moon));
    assert!(editor.delete(&mut world));
    assert_eq!(world.query::<&Speed>().iter(&world).count(), 0);
    editor.undo(&mut world);
    assert_eq!(world.get(moon), Some(&Speed(3.0)));
    assert!(world.get::<Secret>(moon).is_some());
    editor.select(Some(moon));
    let copy = editor.duplicate(&mut world).unwrap();
    assert_eq!(world.get(copy), Some(&Speed(3.0)));
    assert_eq!(world.get(copy), Some(&Sphere { radius: 1.0 }));
    assert_eq!(world.get::<Position>(copy).unwrap().0, DVec3::new(2.0, 0.0, 0.0), "beside the original");
    assert_eq!(editor.selected(), Some(copy));
    editor.undo(&mut world);
    assert_eq!(editor.selected(), None);
    assert_eq!(world.query::<&Speed>().iter(&world).count(), 1);
}

#[test]
fn an_entity_that_was_despawned_by_others_is_left_alone() {
    let (mut world, mut editor) = (World::new(), Editor::default());
    let sphere = world.spawn(Sphere { radius: 1.0 }).id();
    editor.change(&mut world, sphere, Some(Sphere { radius: 2.0 }));
    editor.select(Some(sphere));
    world.despawn(sphere);
    editor.look(&world);
    assert_eq!(editor.selected(), None);
    editor.select(Some(sphere));
    assert!(!editor.delete(&mut world));
    assert_eq!(editor.duplicate(&mut world), None);
    assert_eq!(editor.undo(&mut world), Some("Sphere"));
    assert_eq!(editor.redo(&mut world), Some("Sphere"));
}

#[test]
fn what_no_step_can_bring_back_is_despawned() {
    let (mut world, mut editor) = (World::new(), with_limits(3, usize::MAX));
    editor.add(&mut world, New::Sphere);
    editor.delete(&mut world);
    let most = entities(&world);
    for _ in 0..100 {
        editor.add(&mut world, New::Sphere);
        assert!(editor.delete(&mut world));
    }
    assert!(entities(&world) <= most + 2, "{} instead of {most} entities", entities(&world));
    editor.undo(&mut world);
    assert_eq!(world.query::<&Sphere>().iter(&world).count(), 1);

    let mut editor = Editor::default();
    let before = entities(&world);
    for _ in 0..100 {
        editor.add(&mut world, New::Cube);
        editor.undo(&mut world);
    }
    assert!(entities(&world) <= before + 1, "a step that was undone and is gone keeps no entity");
}

#[test]
fn hidden_entities_are_bounded() {
    let (mut world, mut editor) = (World::new(), with_limits(usize::MAX, 10));
    let spheres: Vec<Entity> = (0..50).map(|_| world.spawn(Sphere { radius: 1.0 }).id()).collect();
    let before = entities(&world);
    for &sphere in &spheres {
        editor.select(Some(sphere));
        assert!(editor.delete(&mut world));
    }
    assert_eq!(entities(&world), before - 40);
    let undone = std::iter::from_fn(|| editor.undo(&mut world)).count();
    assert_eq!(undone, 10);
    assert_eq!(world.query::<&Sphere>().iter(&world).count(), 10);
    assert!(editor.is_modified(), "the forgotten steps cannot be undone");
}

#[test]
fn a_file_takes_the_place_of_the_scene_but_not_of_the_camera() {
    let mut scene = Followed::of_file("official.txt");
    let mut editor = Editor::default();
    let camera = camera(&mut scene.world);
    let pose = CameraPose::looking(DVec3::new(1.0, 2.0, 3.0), DVec3::X, DVec3::Z).unwrap();
    scene.world.entity_mut(camera).insert((pose, Reference { distance: 7.0 }, Home(pose)));
    let image = Arc::new(Texture::new(1, 1, vec![[1, 2, 3]]).unwrap());
    let board = scene.world.query_filtered::<Entity, With<Checkerboard>>().single(&scene.world).unwrap();
    scene.world.entity_mut(board).insert(Textured { white: image.clone(), black: image });
    let before = scene.tables();
    let file = description("highlights.txt");

    assert!(editor.replace_scene(&mut scene.world, &file));
    assert!(!editor.is_modified());
    assert_eq!(describe(&mut scene.world).as_ref(), Ok(&file));
    assert_eq!(scene.world.get(camera), Some(&pose));
    assert_eq!(scene.world.get(camera), Some(&Reference { distance: 7.0 }));
    assert_eq!(scene.world.get(camera), Some(&Home(pose)));
    assert_eq!(scene.world.get::<Lens>(camera).unwrap().fovy, file.fovy);
    assert_eq!(scene.world.resource::<Snapshot>().pixels, file.pixels);
    assert_eq!(scene.world.query::<&Textured>().iter(&scene.world).count(), 1);
    let after = scene.tables();

    assert!(!editor.replace_scene(&mut scene.world, &file), "the World says that already");
    assert_eq!(editor.undo(&mut scene.world), Some("reload"));
    assert!(editor.is_modified());
    assert_eq!(scene.tables(), before);
    editor.redo(&mut scene.world);
    assert_eq!(scene.tables(), after);
    assert!(!editor.is_modified());
    assert_eq!(editor.undoes(), Some("reload"));
    assert_eq!(editor.redoes(), None);
}

#[test]
fn a_new_object_stays_before_the_board_when_the_scene_is_saved_and_read() {
    let mut scene = Followed::of_file("official.txt");
    let mut editor = Editor::default();
    let cube = editor.add(&mut scene.world, New::Cube);
    let board = scene.world.query_filtered::<&Order, With<Checkerboard>>().single(&scene.world).unwrap();
    assert!(*board > *scene.world.get::<Order>(cube).unwrap());
    let edited = scene.tables();
    let written = describe(&mut scene.world).unwrap();
    let mut read = World::new();
    spawn(&mut read, &written);
    assert_eq!(Followed::new(read).tables(), edited);
    let before = describe(&mut Followed::of_file("official.txt").world);
    editor.undo(&mut scene.world);
    assert_eq!(describe(&mut scene.world), before);
}

#[test]
fn everything_new_is_allowed_and_in_front_of_the_camera() {
    let mut scene = Followed::of_file("official.txt");
    let mut editor = Editor::default();
    for (what, name) in New::ALL {
        let entity = editor.add(&mut scene.world, what);
        assert_eq!(editor.selected(), Some(entity));
        scene.tables();
        let problems = scene.world.resource::<Tables<f64>>().problems();
        assert!(problems.is_empty(), "{name}: {problems:?}");
        let position = scene.world.get::<Position>(entity).unwrap().0;
        let to = (position - CameraPose::default().position).normalize();
        let seen = to.dot(CameraPose::default().l) > 0.8;
        assert!(seen || what == New::Checkerboard, "{name} at {position}");
    }
    assert_eq!(scene.world.get::<Color>(editor.selected().unwrap()), None, "lights have no surface");
    assert_eq!(scene.world.query::<&Cube>().iter(&scene.world).count(), 2);
}

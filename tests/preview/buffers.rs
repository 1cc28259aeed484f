//! Work that is not done: lists and buffers stay as they are until something in them changes.

use archetrace::components::{
    CameraPose, Checkerboard, Color, Cube, Lens, Light, Position, Pyramid, Sphere, SpotCone, Texture,
    Textured,
};
use archetrace::preview::PreviewStyle;
use archetrace::systems::{Drawn, list_schedule};
use bevy_ecs::entity_disabling::Disabled;
use bevy_ecs::prelude::*;
use bevy_ecs::schedule::Schedule;
use glam::DVec3;

use super::canvas::Canvas;

const LENS: Lens = Lens { near: 1.0, far: 1000.0, fovy: 60.0, aspect: 1.0 };

/// A World that is drawn again and again by one schedule and one renderer.
struct Show {
    world: World,
    schedule: Schedule,
    canvas: Canvas,
    pose: CameraPose,
    style: PreviewStyle,
}

impl Show {
    /// One of everything; drawn once.
    fn new() -> Self {
        let mut world = World::new();
        world.spawn((Sphere { radius: 10.0 }, Position::new(0.0, 0.0, 50.0)));
        world.spawn((Sphere { radius: 10.0 }, Position::new(30.0, 0.0, 50.0)));
        world.spawn((Cube { side: 10.0 }, Position::new(-30.0, 0.0, 50.0)));
        world.spawn((Pyramid { width: 10.0, height: 20.0 }, Position::new(-30.0, 0.0, 20.0)));
        world.spawn(Checkerboard { cell: 20.0 });
        world.spawn((Light, Position::new(0.0, 0.0, 90.0)));
        world.spawn((Light, Position::new(9.0, 0.0, 90.0), SpotCone { target: DVec3::ZERO, cutoff: 20.0 }));
        world.init_resource::<Drawn>();
        let mut show = Self {
            world,
            schedule: list_schedule(),
            canvas: Canvas::new(),
            pose: CameraPose::default(),
            style: PreviewStyle::default(),
        };
        assert!(show.fills() >= 5);
        show
    }

    /// Buffers that the next frame fills.
    fn fills(&mut self) -> u64 {
        let before = self.canvas.fills();
        self.schedule.run(&mut self.world);
        let list = &self.world.resource::<Drawn>().0;
        self.canvas.draw_list(list, (&self.pose, &LENS), &self.style, 64);
        self.canvas.fills() - before
    }

    fn first<F: bevy_ecs::query::QueryFilter>(&mut self) -> Entity {
        self.world.query_filtered::<Entity, F>().iter(&self.world).next().unwrap()
    }
}

#[test]
fn a_frame_in_which_nothing_changed_fills_no_buffer() {
    let mut show = Show::new();
    for _ in 0..5 {
        assert_eq!(show.fills(), 0);
    }
}

#[test]
fn neither_the_camera_nor_the_style_nor_the_size_fills_a_buffer() {
    let mut show = Show::new();
    show.pose.position.x += 10.0;
    assert_eq!(show.fills(), 0);
    show.style = PreviewStyle { lights: false, axes: false, samples: 1, ..show.style };
    assert_eq!(show.fills(), 0);
    show.canvas.draw_list(&show.world.resource::<Drawn>().0, (&show.pose, &LENS), &show.style, 200);
    assert_eq!(show.fills(), 0);
}

#[test]
fn only_the_kind_that_changed_is_filled_again() {
    let mut show = Show::new();
    let sphere = show.first::<With<Sphere>>();
    show.world.entity_mut(sphere).insert(Color::new(1.0, 0.0, 0.0));
    assert_eq!((show.fills(), show.fills()), (1, 0));
    let pyramid = show.first::<With<Pyramid>>();
    show.world.get_mut::<Position>(pyramid).unwrap().0.x += 1.0;
    assert_eq!((show.fills(), show.fills()), (1, 0));
    let light = show.first::<With<SpotCone>>();
    show.world.get_mut::<SpotCone>(light).unwrap().cutoff = 30.0;
    // Markers and cones.
    assert_eq!((show.fills(), show.fills()), (2, 0));
    let board = show.first::<With<Checkerboard>>();
    show.world.get_mut::<Checkerboard>(board).unwrap().cell = 30.0;
    // A board is no buffer.
    assert_eq!((show.fills(), show.fills()), (0, 0));
}

#[test]
fn what_comes_and_goes_is_noticed() {
    let mut show = Show::new();
    let sphere = show.first::<With<Sphere>>();
    show.world.entity_mut(sphere).insert(Disabled);
    assert_eq!((show.fills(), show.fills()), (1, 0));
    show.world.entity_mut(sphere).remove::<Disabled>();
    assert_eq!((show.fills(), show.fills()), (1, 0));
    show.world.despawn(sphere);
    assert_eq!((show.fills(), show.fills()), (1, 0));
    show.world.spawn((Cube { side: 3.0 }, Position::new(1.0, 2.0, 3.0)));
    assert_eq!((show.fills(), show.fills()), (1, 0));
}

#[test]
fn an_image_is_loaded_once_for_all_boards_and_forgotten_with_the_last() {
    let mut show = Show::new();
    let image = || std::sync::Arc::new(Texture::new(1, 1, vec![[9, 9, 9]]).unwrap());
    let textured = Textured { white: image(), black: image() };
    let board = show.first::<With<Checkerboard>>();
    show.world.entity_mut(board).insert(textured.clone());
    assert_eq!((show.fills(), show.fills()), (2, 0));
    show.world.spawn((Checkerboard { cell: 5.0 }, Position::new(0.0, 0.0, -9.0), textured.clone()));
    assert_eq!((show.fills(), show.fills()), (0, 0));
    let boards: Vec<Entity> =
        show.world.query_filtered::<Entity, With<Checkerboard>>().iter(&show.world).collect();
    for &board in &boards {
        show.world.entity_mut(board).remove::<Textured>();
    }
    assert_eq!(show.fills(), 0);
    show.world.entity_mut(boards[0]).insert(textured);
    assert_eq!((show.fills(), show.fills()), (2, 0));
}

#[test]
fn an_outline_is_filled_when_it_is_another_one() {
    let mut show = Show::new();
    let corners = Some([DVec3::ZERO, DVec3::ONE]);
    for (corners, fills) in [(corners, 1), (corners, 0), (None, 1), (None, 0)] {
        show.world.resource_mut::<Drawn>().0.set_outline(corners);
        assert_eq!(show.fills(), fills, "{corners:?}");
    }
}

//! Surfaces in the same place: the lower scene order shows, without a speck, as in the trace.

use archetrace::components::{CameraPose, Checkerboard, Color, Cube, Lens, Order, Position, Pyramid, Sphere};
use bevy_ecs::prelude::*;
use glam::DVec3;

use super::canvas::Canvas;
use super::colors::assert_same_colors;
use super::maps::{Labelled, Tally, assert_agrees};
use super::support::random::Random;

const LENS: Lens = Lens { near: 0.7, far: 2000.0, fovy: 65.0, aspect: 1.0 };
const SIDE: usize = 120;

fn looking_at_origin(from: DVec3) -> CameraPose {
    CameraPose::looking(from, -from, DVec3::new(0.02, 0.01, 1.0)).unwrap()
}

/// Random directions, above and below.
fn poses(seed: u64, distance: f64) -> Vec<CameraPose> {
    let random = &mut Random::new(seed);
    (0..12).map(|_| looking_at_origin(random.direction() * random.between(0.6, 2.0) * distance)).collect()
}

/// A World of bodies that share planes, drawn from many sides.
#[track_caller]
fn assert_ties(name: &str, spawn: impl Fn(&mut World)) {
    let canvas = &mut Canvas::new();
    let mut all = Tally::default();
    for (number, pose) in poses(name.len() as u64, 60.0).iter().enumerate() {
        let mut world = World::new();
        spawn(&mut world);
        world.spawn((*pose, LENS));
        let labelled = &mut Labelled::new(world);
        all += assert_agrees(&format!("{name} {number}"), canvas, labelled, (pose, &LENS), SIDE);
    }
    assert!(all.outline < all.pixels / 5, "{name}: {all:?}");
}

#[test]
fn cubes_and_pyramids_that_share_a_floor_win_by_their_order() {
    for (cube_order, pyramid_order) in [(0, 1), (1, 0)] {
        assert_ties("floor", |world| {
            world.spawn((Cube { side: 20.0 }, Position::new(-14.3, -9.1, 0.0), Order(cube_order)));
            let pyramid = Pyramid { width: 27.0, height: 16.0 };
            world.spawn((pyramid, Position::new(-6.7, -13.9, 0.0), Order(pyramid_order)));
        });
    }
}

#[test]
fn cubes_side_by_side_leave_no_gap() {
    assert_ties("side by side", |world| {
        for (order, (x, y)) in (0..).zip([(-20.1, -10.3), (-0.1, -10.3), (-10.1, 9.7), (-3.0, -10.3)]) {
            world.spawn((Cube { side: 20.0 }, Position::new(x, y, -7.7), Order(order)));
        }
    });
}

#[test]
fn twins_show_the_lower_order_or_the_lower_values() {
    for orders in [Some((0, 1)), Some((1, 0)), None] {
        assert_ties("twins", |world| {
            let position = Position::new(3.1, -2.7, 1.9);
            let mut twin = |order: Option<u32>| {
                let sphere = world.spawn((Sphere { radius: 15.0 }, position)).id();
                let cube = world.spawn((Cube { side: 21.0 }, Position::new(5.0, 4.0, -17.0))).id();
                let pyramid = Pyramid { width: 30.0, height: 40.0 };
                let pyramid = world.spawn((pyramid, Position::new(-30.0, 4.0, -9.0))).id();
                if let Some(order) = order {
                    for entity in [sphere, cube, pyramid] {
                        world.entity_mut(entity).insert(Order(order));
                    }
                }
            };
            twin(orders.map(|(first, _)| first));
            twin(orders.map(|(_, second)| second));
        });
    }
}

#[test]
fn a_board_in_the_plane_of_a_face_wins_by_its_order() {
    for (cube_order, board_order) in [(0, 1), (1, 0), (1, 1)] {
        assert_ties("board", |world| {
            world.spawn((Cube { side: 30.0 }, Position::new(-14.3, -9.1, -27.5), Order(cube_order)));
            let pyramid = Pyramid { width: 27.0, height: 16.0 };
            world.spawn((pyramid, Position::new(6.7, -33.9, 2.5), Order(cube_order)));
            let board = Checkerboard { cell: 9.0 };
            world.spawn((board, Position::new(0.3, 0.2, 2.5), Order(board_order)));
        });
    }
}

#[test]
fn of_two_boards_in_one_plane_the_lower_order_shows() {
    for (first, second) in [(0, 1), (1, 0)] {
        let mut world = World::new();
        let red = Color::new(1.0, 0.0, 0.0);
        let blue = Color::new(0.0, 0.0, 1.0);
        world.spawn((Checkerboard { cell: 14.0 }, Position::new(1.3, 2.4, 5.0), red, Order(first)));
        world.spawn((Checkerboard { cell: 9.0 }, Position::new(0.3, 0.2, 5.0), blue, Order(second)));
        world.spawn((Checkerboard { cell: 11.0 }, Position::new(0.3, 0.2, -30.0), Color::new(0.0, 1.0, 0.0)));
        let pose = looking_at_origin(DVec3::new(10.0, -25.0, 60.0));
        let compared = assert_same_colors("boards", &mut world, (&pose, &LENS), 200);
        assert!(compared > 0.4, "{compared}");
    }
}

//! Surfaces in the same place: one shows everywhere, and it is said which.

use archetrace::components::{Checkerboard, Color, Cube, Mirror, Order, Position, Pyramid, Sphere};
use archetrace::geometry::Real;
use bevy_ecs::prelude::*;
use glam::DVec3;

use super::{View, lamp, white};
use crate::paths::check_world;
use crate::support::picture::{Picture, assert_same};
use crate::support::tracing::trace;

fn red() -> (Color, archetrace::components::Ambient) {
    (Color::new(1.0, 0.0, 0.0), archetrace::components::Ambient(1.0))
}

fn slanting_view(z: f64) -> View {
    let position = DVec3::new(1.37, -5.11, z);
    View { position, look: DVec3::new(0.13, 0.21, 0.0) - position, pixels: 96, ..View::one_ray() }
}

/// A cube of side 4 over or under the ground, in the plane of the board, and the board.
fn cube_and_board<T: Real>(view: &View, z: f64, orders: [Option<u32>; 2]) -> Picture {
    let mut world = view.world();
    let cube = (Cube { side: 4.0 }, Position::new(-2.0, -2.0, z), red());
    let board = (Checkerboard { cell: 0.7 }, white(1.0, 0.0));
    let entities = [world.spawn(cube).id(), world.spawn(board).id()];
    for (entity, order) in entities.into_iter().zip(orders) {
        if let Some(order) = order {
            world.entity_mut(entity).insert(Order(order));
        }
    }
    trace::<T>(&mut world).picture
}

/// Checks every pixel whose ground point is clearly within the cube's square, and returns their number.
fn assert_square<T: Real>(view: &View, z: f64, orders: [Option<u32>; 2], cube_shows: bool) -> usize {
    let picture = cube_and_board::<T>(view, z, orders);
    let mut within = 0;
    for row in 0..view.pixels {
        for column in 0..view.pixels {
            let Some(place) = view.on_ground(column, row) else {
                continue;
            };
            if place.abs().max_element() < 2.0 - 1e-4 {
                within += 1;
                let [r, g, b] = picture.at(column as usize, row as usize);
                let is_red = [r, g, b] == [1.0, 0.0, 0.0];
                assert_eq!(is_red, cube_shows, "column {column}, row {row}");
            }
        }
    }
    within
}

#[test]
fn a_cube_in_the_plane_of_the_board_shows_without_speckle() {
    fn check<T: Real>() {
        for (eye, bottom) in [(6.31, -4.0), (-6.31, 0.0)] {
            let view = slanting_view(eye);
            for orders in [[Some(0), Some(1)], [None, None], [Some(7), None], [Some(3), Some(3)]] {
                assert!(assert_square::<T>(&view, bottom, orders, true) > 1000);
            }
            for orders in [[Some(1), Some(0)], [None, Some(0)]] {
                assert!(assert_square::<T>(&view, bottom, orders, false) > 1000);
            }
        }
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn of_twins_the_one_of_lower_order_shows_everywhere() {
    fn check<T: Real, B: Bundle + Clone>(shape: &B) {
        let picture = |colors: &[(u32, Color)]| {
            let mut world = slanting_view(6.31).world();
            for (order, color) in colors {
                world.spawn((shape.clone(), white(1.0, 0.0), Order(*order))).insert(*color);
            }
            trace::<T>(&mut world).picture
        };
        let (red, green) = (Color::new(1.0, 0.0, 0.0), Color::new(0.0, 1.0, 0.0));
        let alone = picture(&[(0, green)]);
        assert!(alone.pixels.iter().filter(|pixel| pixel[1] == 1.0).count() > 500);
        assert_same("twins", &alone, &picture(&[(5, red), (3, green)]));
        assert_same("twins", &alone, &picture(&[(3, green), (5, red)]));
    }
    fn check_all<T: Real>() {
        check::<T, _>(&Sphere { radius: 2.0 });
        check::<T, _>(&(Cube { side: 2.3 }, Position::new(-1.0, -1.0, 0.0)));
        let pyramid = Pyramid { width: 3.1, height: 2.9 };
        check::<T, _>(&(pyramid, Position::new(-1.0, -1.0, 0.0)));
        check::<T, _>(&Checkerboard { cell: 0.7 });
    }
    check_all::<f64>();
    check_all::<f32>();
}

#[test]
fn of_touching_cubes_the_one_of_lower_order_shows_on_the_common_edge() {
    // The ray runs in the plane of the common face, x = 0, and meets the edge of both.
    for (left, right, expected) in [(0, 1, [1.0, 0.0, 0.0]), (1, 0, [0.0, 1.0, 0.0])] {
        let mut world = View::one_ray().world();
        let side = |x: f64| (Cube { side: 2.0 }, Position::new(x, 0.0, -1.0));
        world.spawn((side(-2.0), red(), Order(left)));
        world.spawn((side(0.0), red(), Order(right))).insert(Color::new(0.0, 1.0, 0.0));
        assert_eq!(trace::<f64>(&mut world).picture.middle(), expected);
    }
}

/// A square field of pyramids side by side, 16 units wide, seen from above or below so that many rays go through common
/// edges of their bases, but for rounding.
fn field_of_pyramids(a_side: u32, below: bool) -> World {
    let view = View::from_above(0.0, 0.25, 7.5, 15);
    let mirrored = DVec3::new(1.0, 1.0, -1.0);
    let view = if below { View { position: view.position * mirrored, look: DVec3::Z, ..view } } else { view };
    let mut world = view.world();
    let width = 16.0 / f64::from(a_side);
    for (row, column) in (0..a_side).flat_map(|row| (0..a_side).map(move |column| (row, column))) {
        let corner = |index: u32| f64::from(index) * width - 8.0;
        let shape = Pyramid { width, height: 0.5 * width };
        world.spawn((shape, Position::new(corner(column), corner(row), 0.0), white(0.5, 0.5)));
    }
    world.spawn(lamp(0.0, 0.25, 9.0));
    world.spawn(lamp(-3.0, 0.0, -8.0));
    world
}

#[test]
fn nothing_shows_between_touching_pyramids() {
    fn check<T: Real>() {
        // Sixteen are searched row by row, sixty-four through a tree.
        for (a_side, below) in [(4, false), (4, true), (8, false), (8, true)] {
            let picture = trace::<T>(&mut field_of_pyramids(a_side, below)).picture;
            assert!(picture.pixels.iter().all(|&[r, _, _]| r >= 0.5), "{a_side} a side");
            check_world::<T>("touching pyramids", field_of_pyramids(a_side, below));
        }
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn a_twin_casts_no_shadow_on_its_twin_and_is_not_mirrored_in_it() {
    fn check<T: Real, B: Bundle + Clone>(shape: &B) {
        let picture = |count: u32| {
            let mut world = slanting_view(6.31).world();
            for order in 0..count {
                world.spawn((shape.clone(), white(0.1, 0.6), Mirror(0.3), Order(order)));
            }
            world.spawn(lamp(-6.0, -9.0, 8.0));
            world.spawn(lamp(7.0, -5.0, 9.0));
            trace::<T>(&mut world).picture
        };
        let alone = picture(1);
        assert!(alone.pixels.iter().filter(|pixel| pixel[0] > 0.3).count() > 500);
        assert_same("lit twins", &alone, &picture(2));
    }
    fn check_all<T: Real>() {
        check::<T, _>(&(Sphere { radius: 2.03 }, Position::new(0.33, -0.17, 0.41)));
        check::<T, _>(&(Cube { side: 2.3 }, Position::new(-1.1, -0.9, 0.2)));
        check::<T, _>(&(Pyramid { width: 3.1, height: 2.9 }, Position::new(-1.03, -1.07, 0.13)));
        check::<T, _>(&Checkerboard { cell: 0.7 });
    }
    check_all::<f64>();
    check_all::<f32>();
}

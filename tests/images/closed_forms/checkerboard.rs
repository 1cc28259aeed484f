//! The board: its cells, its images, its two sides.

use std::sync::Arc;

use archetrace::components::{Checkerboard, Color, Cube, Mirror, Position, Texture, Textured};
use archetrace::geometry::Real;
use bevy_ecs::prelude::*;
use glam::DVec3;

use super::{View, assert_close, lamp, white};
use crate::support::picture::Picture;
use crate::support::tracing::trace;

#[test]
fn cells_alternate_through_the_origin() {
    fn check<T: Real>(cell: f64) {
        // Each of 8 x 8 pixels shows the middle of a cell, from (-4, 3) at the top left.
        let mut world = View::from_above(0.0, 0.0, 4.0 * cell, 8).world();
        world.spawn((Checkerboard { cell }, white(1.0, 0.0)));
        let picture = trace::<T>(&mut world).picture;
        for row in 0..8 {
            for column in 0..8 {
                // x = column - 4 and y = 3 - row.
                let white = (column + row) % 2 == 1;
                let expected = if white { 1.0 } else { 0.0 };
                assert_eq!(picture.at(column, row), [expected; 3], "column {column}, row {row}");
            }
        }
    }
    check::<f64>(1.0);
    check::<f64>(0.3);
    check::<f32>(50.0);
}

#[test]
fn the_color_tints_white_cells_and_the_position_moves_them() {
    let mut world = View::from_above(0.0, 0.0, 2.0, 4).world();
    let tint = Color::new(0.25, 0.5, 1.0);
    world.spawn((Checkerboard { cell: 1.0 }, white(1.0, 0.0))).insert((tint, Position::new(1.0, 0.0, 0.0)));
    let picture = trace::<f64>(&mut world).picture;
    // Columns and rows 0, 1, 2, 3 are x = -2, -1, 0, 1 and y = 1, 0, -1, -2.
    assert_eq!(picture.at(3, 1), [0.25, 0.5, 1.0]);
    assert_eq!(picture.at(2, 1), [0.0; 3]);
    assert_eq!(picture.at(2, 2), [0.25, 0.5, 1.0]);
}

#[test]
fn the_board_has_an_underside() {
    // From below, looking up with +y at the top, x grows to the left.
    let mut world =
        View { position: DVec3::new(0.5, 0.5, -1.0), look: DVec3::Z, ..View::from_above(0.5, 0.5, 1.0, 1) }
            .world();
    world.spawn((Checkerboard { cell: 1.0 }, white(0.25, 0.5)));
    let light = world.spawn(lamp(0.5, 0.5, -0.5)).id();
    assert_eq!(trace::<f64>(&mut world).picture.middle(), [0.75; 3]);
    world.entity_mut(light).insert(Position::new(0.5, 0.5, 0.5));
    assert_eq!(trace::<f64>(&mut world).picture.middle(), [0.25; 3]);
}

/// An image in which every texel is another colour.
fn image(width: u32, height: u32, blue: u8) -> Arc<Texture> {
    let texels = (0..height).flat_map(|row| (0..width).map(move |column| texel(column, row, blue)));
    Arc::new(Texture::new(width, height, texels.collect()).unwrap())
}

fn texel(column: u32, row: u32, blue: u8) -> [u8; 3] {
    [10 + 70 * column as u8, 20 + 60 * row as u8, blue]
}

fn textured() -> Textured {
    Textured { white: image(2, 3, 50), black: image(3, 2, 200) }
}

/// A single cell of width 6 from above, six pixels wide.
fn cell(x: f64, y: f64, change: impl Fn(&mut World)) -> Picture {
    let mut world = View { level: 2, ..View::from_above(x + 3.0, y + 3.0, 3.0, 6) }.world();
    world.spawn((Checkerboard { cell: 6.0 }, white(1.0, 0.0), textured()));
    change(&mut world);
    trace::<f64>(&mut world).picture
}

/// Compares with the image of this many texels.
fn assert_shows(picture: &Picture, (width, height, blue): (u32, u32, u8), change: impl Fn(f64) -> f64) {
    for row in 0..6 {
        for column in 0..6 {
            let texel = texel(column * width / 6, row * height / 6, blue);
            let expected = texel.map(|byte| change(f64::from(byte) / 255.0));
            assert_close(picture.at(column as usize, row as usize), expected);
        }
    }
}

const ON_WHITE: (u32, u32, u8) = (2, 3, 50);
const ON_BLACK: (u32, u32, u8) = (3, 2, 200);

#[test]
fn images_stand_upright_on_their_cells() {
    let plain = |share| share;
    for (x, y) in [(0.0, 0.0), (6.0, 6.0), (-6.0, -6.0), (-6.0, 6.0), (-12.0, 0.0)] {
        assert_shows(&cell(x, y, |_| ()), ON_WHITE, plain);
    }
    for (x, y) in [(6.0, 0.0), (-6.0, 0.0), (0.0, -6.0), (-12.0, 6.0)] {
        assert_shows(&cell(x, y, |_| ()), ON_BLACK, plain);
    }
}

#[test]
fn an_image_takes_part_in_ambient_and_diffuse_light() {
    // A light so high that its cosine is 1 all over the cell.
    let lit = cell(0.0, 0.0, |world| {
        world.spawn(lamp(3.0, 3.0, 1e12));
        *crate::support::case::only(world) = archetrace::components::Ambient(0.25);
        *crate::support::case::only(world) = archetrace::components::Diffuse(0.5);
    });
    assert_shows(&lit, ON_WHITE, |share| share * 0.75);
}

#[test]
fn an_image_leaves_the_reflected_part_alone() {
    let reflecting = cell(0.0, 0.0, |world| {
        let mut boards = world.query_filtered::<Entity, With<Checkerboard>>();
        let board = boards.single(world).unwrap();
        world.entity_mut(board).insert((Mirror(0.5), archetrace::components::Ambient(0.25)));
        // A ceiling.
        let corner = Position::new(-500.0, -500.0, 10.0);
        world.spawn((Cube { side: 1000.0 }, corner, white(0.5, 0.0)));
    });
    assert_shows(&reflecting, ON_WHITE, |share| 0.25 * share + 0.25);
}

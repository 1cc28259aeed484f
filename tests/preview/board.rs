//! The checkerboard: filtered as the area under a pixel is, its images the right way round.

use archetrace::components::{CameraPose, Checkerboard, Lens, Position, Texture, Textured};
use archetrace::preview::PreviewStyle;
use bevy_ecs::prelude::*;
use glam::DVec3;

use super::canvas::{PLAIN, Shot, draw_once};
use super::colors::assert_same_colors;
use super::support::random::Random;

const LENS: Lens = Lens { near: 0.1, far: 1e7, fovy: 60.0, aspect: 1.0 };
const SIDE: usize = 256;
const CELL: f64 = 20.0;
const HEIGHT: f64 = 50.0;

fn board_world() -> World {
    let mut world = World::new();
    world.spawn(Checkerboard { cell: CELL });
    world
}

/// Level, this far to the right of +y, in degrees.
fn level_pose(yaw: f64) -> CameraPose {
    let (sine, cosine) = yaw.to_radians().sin_cos();
    CameraPose::looking(DVec3::new(3.7, -150.3, HEIGHT), DVec3::new(sine, cosine, 0.0), DVec3::Z).unwrap()
}

/// The point of the board that is seen at a place of the picture, in pixels from the upper left corner.
fn place(pose: &CameraPose, column: f64, row: f64) -> DVec3 {
    let extent = (LENS.fovy / 2.0).to_radians().tan() * 2.0 / SIDE as f64;
    let (x, y) = ((column - SIDE as f64 / 2.0) * extent, (SIDE as f64 / 2.0 - row) * extent);
    let ray = pose.l + pose.r * x + pose.u * y;
    pose.position - ray * (pose.position.z / ray.z)
}

fn is_white(place: DVec3) -> bool {
    ((place.x / CELL).floor() + (place.y / CELL).floor()).rem_euclid(2.0) < 0.5
}

/// Share of white, over a square of the picture, from 64 samples a pixel.
fn white_share(pose: &CameraPose, (left, top): (usize, usize), size: usize) -> f64 {
    let steps = 8 * size;
    let at = |step: usize| (step as f64 + 0.5) / 8.0;
    let points = (0..steps).flat_map(|x| (0..steps).map(move |y| (x, y)));
    let white = points.filter(|&(x, y)| is_white(place(pose, left as f64 + at(x), top as f64 + at(y))));
    white.count() as f64 / (steps * steps) as f64
}

/// Mean level of a square of the picture.
fn mean(shot: &Shot, (left, top): (usize, usize), size: usize) -> f64 {
    let pixels = (left..left + size).flat_map(|x| (top..top + size).map(move |y| shot.at(x, y)));
    pixels.map(|[red, ..]| f64::from(red)).sum::<f64>() / (size * size) as f64
}

/// Cells of the board along one pixel upwards in the picture.
fn cells_upwards(pose: &CameraPose, row: usize) -> f64 {
    let middle = SIDE as f64 / 2.0;
    (place(pose, middle, row as f64) - place(pose, middle, row as f64 + 1.0)).length() / CELL
}

/// Levels between a picture and the means of the pattern, at worst, over squares of eight pixels: from the horizon down
/// to where a cell is two pixels high. A mean forgives every filter, and no moire.
fn worst_block(shot: &Shot, pose: &CameraPose) -> f64 {
    let tops = (SIDE / 2 + 1..SIDE - 8).step_by(8).filter(|&top| cells_upwards(pose, top + 8) > 0.5);
    let blocks: Vec<_> = tops.flat_map(|top| (0..SIDE).step_by(8).map(move |left| (left, top))).collect();
    assert!(blocks.len() >= 64, "{}", blocks.len());
    let apart = |&block: &_| (mean(shot, block, 8) - 255.0 * white_share(pose, block, 8)).abs();
    blocks.iter().map(apart).fold(0.0, f64::max)
}

/// What one ray through the middle of each pixel would show.
fn unfiltered(pose: &CameraPose) -> Shot {
    let below = |row: usize| row > SIDE / 2;
    let level = |at: usize| {
        let (column, row) = (at % SIDE, at / SIDE);
        below(row) && is_white(place(pose, column as f64 + 0.5, row as f64 + 0.5))
    };
    Shot { side: SIDE, pixels: (0..SIDE * SIDE).map(|at| [255 * u8::from(level(at)); 3]).collect() }
}

#[test]
fn a_far_board_has_the_grey_of_what_it_covers_and_no_moire() {
    const MOST: f64 = 12.0;
    for yaw in [0.0, 17.0, 30.0, 45.0, 61.0] {
        let pose = level_pose(yaw);
        let moire = worst_block(&unfiltered(&pose), &pose);
        assert!(moire > 2.0 * MOST, "the comparison would not see moire of {moire} levels");
        for samples in [1, 4] {
            let style = PreviewStyle { samples, ..PLAIN };
            let shot = draw_once(&mut board_world(), (&pose, &LENS), &style, SIDE);
            let worst = worst_block(&shot, &pose);
            println!("yaw {yaw}, {samples} samples: {worst:.1} levels, unfiltered {moire:.1}");
            assert!(worst < MOST, "yaw {yaw}, {samples} samples: {worst}");
        }
    }
}

/// A view without the directions along which a board shows stripes up to the horizon: 45 degrees and, fainter, 18.4.
const NARROW: Lens = Lens { fovy: 30.0, ..LENS };

#[test]
fn towards_the_horizon_the_pattern_fades_to_an_even_grey() {
    for samples in [1, 4] {
        let style = PreviewStyle { samples, ..PLAIN };
        let shot = draw_once(&mut board_world(), (&level_pose(0.0), &NARROW), &style, SIDE);
        for row in SIDE / 2 + 1..SIDE / 2 + 8 {
            let levels: Vec<f64> = (0..SIDE).map(|column| f64::from(shot.at(column, row)[0])).collect();
            let mean = levels.iter().sum::<f64>() / SIDE as f64;
            let variance = levels.iter().map(|level| (level - mean).powi(2)).sum::<f64>() / SIDE as f64;
            assert!((mean - 127.5).abs() < 1.0, "row {row}: mean {mean}");
            assert!(variance < 1.0, "row {row}: variance {variance}");
        }
    }
}

/// An image in which no two texels are alike.
fn noise(random: &mut Random, width: u32, height: u32) -> std::sync::Arc<Texture> {
    let texels =
        (0..width * height).map(|_| random.bits().to_le_bytes()).map(|[r, g, b, ..]| [r, g, b]).collect();
    Texture::new(width, height, texels).unwrap().into()
}

#[test]
fn images_lie_on_the_cells_as_in_the_trace() {
    let random = &mut Random::new(3);
    for (pixels_seed, look) in
        [(0, DVec3::new(0.02, 0.01, -1.0)), (1, DVec3::new(0.4, 0.7, -1.0)), (2, DVec3::new(-0.5, 0.1, 1.0))]
    {
        let mut world = World::new();
        let textured = Textured { white: noise(random, 7, 5), black: noise(random, 4, 9) };
        world.spawn((Checkerboard { cell: 20.0 }, Position::new(1.7, -3.2, 0.5), textured));
        let position = DVec3::new(20.0 * f64::from(pixels_seed), -9.0, -30.0 * look.z);
        let pose = CameraPose::looking(position, look, DVec3::Y).unwrap();
        let compared = assert_same_colors("images", &mut world, (&pose, &LENS), 400);
        println!("{look}: {compared:.2} compared");
        assert!(compared > 0.2, "{look}: {compared}");
    }
}

#[test]
fn an_image_far_away_has_its_mean_colour() {
    let pick = |levels: [u8; 3]| Texture::new(2, 2, vec![levels, [0; 3], [0; 3], levels]).unwrap().into();
    let mut world = World::new();
    let textured = Textured { white: pick([200, 100, 0]), black: pick([0, 40, 240]) };
    world.spawn((Checkerboard { cell: CELL }, textured));
    let shot = draw_once(&mut world, (&level_pose(0.0), &NARROW), &PLAIN, SIDE);
    for column in 0..SIDE {
        let seen = shot.at(column, SIDE / 2 + 2);
        let expected = [50, 35, 60];
        for channel in 0..3 {
            assert!(seen[channel].abs_diff(expected[channel]) <= 2, "column {column}: {seen:?}");
        }
    }
}

#[test]
fn texture_comes_and_goes_with_its_component() {
    let mut world = board_world();
    let pose = level_pose(10.0);
    let plain = draw_once(&mut world, (&pose, &LENS), &PLAIN, 64);
    let board = world.query_filtered::<Entity, With<Checkerboard>>().single(&world).unwrap();
    let image = noise(&mut Random::new(1), 8, 8);
    world.entity_mut(board).insert(Textured { white: image.clone(), black: image });
    assert_ne!(draw_once(&mut world, (&pose, &LENS), &PLAIN, 64), plain);
    world.entity_mut(board).remove::<Textured>();
    assert_eq!(draw_once(&mut world, (&pose, &LENS), &PLAIN, 64), plain);
}

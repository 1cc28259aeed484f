//! Filters of checkerboards and of their images.

use std::sync::Arc;

use archetrace::components::{
    CheckerFilter, Checkerboard, Color, Lens, Mirror, Position, Sampling, Texture, TextureFilter, Textured,
};
use archetrace::effects::{Effect, EffectSet};
use archetrace::geometry::Real;
use archetrace::systems::Tables;
use bevy_ecs::prelude::*;
use glam::DVec3;

use super::{View, white};
use crate::support::case::Case;
use crate::support::picture::{Picture, assert_same};
use crate::support::scenes::{full_case, textured_case};
use crate::support::tracing::trace;

fn board(world: &mut World) -> Entity {
    world.query_filtered::<Entity, With<Checkerboard>>().single(world).unwrap()
}

/// The full scene with something more on its board.
fn with<B: Bundle>(case: &Case, effect: B) -> World {
    let mut world = case.world();
    let board = board(&mut world);
    world.entity_mut(board).insert(effect);
    world
}

fn effects<T: Real>(world: &World) -> EffectSet {
    world.resource::<Tables<T>>().effects()
}

#[test]
fn filters_that_have_nothing_to_filter_are_not_there() {
    fn check<T: Real>() {
        let plain = trace::<T>(&mut full_case().world());
        let mut world = with(&full_case(), TextureFilter::Mip);
        let filtered = trace::<T>(&mut world);
        assert_same("no image", &plain.picture, &filtered.picture);
        assert_eq!(plain.counts, filtered.counts);
        assert!(!effects::<T>(&world).contains(Effect::TextureFilter));

        let images = trace::<T>(&mut textured_case().world());
        let mut world = with(&textured_case(), (CheckerFilter, TextureFilter::Nearest));
        assert_same("no plain cells", &images.picture, &trace::<T>(&mut world).picture);
        let found = effects::<T>(&world);
        assert!(!found.contains(Effect::CheckerFilter) && !found.contains(Effect::TextureFilter));
    }
    check::<f64>();
    check::<f32>();
}

/// The share of white in a square around a point of the board, cells of width 1, from a mean over a fine grid.
fn counted_share(x: f64, y: f64, side: f64) -> f64 {
    let steps = 512_i32;
    let at = |step: i32| side * ((f64::from(step) + 0.5) / f64::from(steps) - 0.5);
    let is_odd = |value: f64| value.floor().rem_euclid(2.0) == 1.0;
    let white = (0..steps).flat_map(|row| (0..steps).map(move |column| (row, column)));
    let white = white.filter(|&(row, column)| is_odd(x + at(column)) == is_odd(y + at(row))).count();
    white as f64 / f64::from(steps * steps)
}

#[test]
fn a_pixel_shows_the_share_of_white_that_it_covers() {
    fn check<T: Real>() {
        for (x, y, height) in
            [(0.3, 0.4, 0.2), (0.1, 0.6, 0.7), (2.9, -1.2, 1.3), (0.5, 0.5, 4.4), (7.1, 3.0, 2.0)]
        {
            // The only pixel is as wide on the ground as the view from above: twice the height.
            let mut world = View::from_above(x, y, height, 1).world();
            world.spawn((Checkerboard { cell: 1.0 }, white(1.0, 0.0), CheckerFilter));
            let found = trace::<T>(&mut world).picture.middle()[0];
            let counted = counted_share(x, y, 2.0 * height);
            // Along each side of the square a border runs through one of 512 points.
            assert!(
                (found - counted).abs() < 4.0 / 512.0,
                "{x}, {y} from {height}: {found}, counted {counted}"
            );
        }
    }
    check::<f64>();
    check::<f32>();
}

/// A board with tinted cells seen at a flat angle, up to the horizon.
fn horizon<B: Bundle>(side: u32, effect: B) -> Picture {
    let view = View {
        position: DVec3::new(0.37, 0.21, 2.0),
        look: DVec3::new(0.2, 1.0, -0.2),
        pixels: 48,
        lens: Lens { near: 0.01, far: 1e9, fovy: 40.0, aspect: 1.0 },
        ..View::one_ray()
    };
    let mut world = view.world();
    world.insert_resource(Sampling { side });
    world.spawn((Checkerboard { cell: 1.0 }, white(1.0, 0.0), effect)).insert(Color::new(1.0, 0.5, 0.25));
    trace::<f64>(&mut world).picture
}

fn mean_square(a: &Picture, b: &Picture) -> f64 {
    let pairs = a.pixels.iter().flatten().zip(b.pixels.iter().flatten());
    pairs.map(|(a, b)| (a - b) * (a - b)).sum::<f64>() / a.pixels.len() as f64
}

#[test]
fn one_filtered_sample_is_closer_to_the_truth_than_nine_without() {
    let truth = horizon(31, ());
    let [one, nine] = [1, 3].map(|side| mean_square(&horizon(side, ()), &truth));
    let filtered = mean_square(&horizon(1, CheckerFilter), &truth);
    assert!(filtered < nine && nine < one, "{filtered}, nine samples {nine}, one {one}");
}

#[test]
fn below_the_horizon_all_cells_run_together() {
    let picture = horizon(1, CheckerFilter);
    // The horizon is where the ray is level: z of `look` less the row's share of the picture's half height.
    let level = (1..48).find(|&row| picture.at(24, row)[0] > 0.0).unwrap();
    let [red, green, blue] = picture.at(24, level);
    assert!((red - 0.5).abs() < 0.01 && green == red * 0.5 && blue == red * 0.25, "{red} {green} {blue}");
}

#[test]
fn a_mirror_shows_cells_as_far_away_as_the_whole_way_is() {
    // The eye is as high above a mirroring floor as below a ceiling: the way to that is three times as long.
    let shown = |height: f64, mirrored: bool| {
        let view = View { level: 3, ..View::from_above(0.3, 0.4, height, 1) };
        let mut world = view.world();
        if mirrored {
            let floor = Checkerboard { cell: 1e6 };
            world.spawn((floor, white(0.0, 0.0), Mirror(1.0))).insert(Position::new(-5.0, -5.0, 0.0));
            let ceiling = Position::new(0.0, 0.0, 2.0 * height);
            world.spawn((Checkerboard { cell: 1.0 }, white(1.0, 0.0), CheckerFilter, ceiling));
        } else {
            world.spawn((Checkerboard { cell: 1.0 }, white(1.0, 0.0), CheckerFilter));
        }
        trace::<f64>(&mut world).picture.middle()[0]
    };
    assert!((shown(0.9, false) - shown(0.3, true)).abs() < 1e-14);
    assert!((shown(0.3, false) - shown(0.3, true)).abs() > 0.01);
}

fn noise(width: u32, height: u32) -> Arc<Texture> {
    let texels =
        (0..width * height).map(|index| [index, index * 7, index * 31].map(|n| (n * 97 % 251) as u8));
    Arc::new(Texture::new(width, height, texels.collect()).unwrap())
}

/// A cell of width 8 from above, as many pixels as its image has texels.
fn cell(pixels: u32, filter: Option<TextureFilter>) -> Picture {
    let mut world = View::from_above(4.0, 4.0, 4.0, pixels).world();
    let images = Textured { white: noise(8, 8), black: noise(4, 4) };
    world.spawn((Checkerboard { cell: 8.0 }, white(1.0, 0.0), images));
    let board = board(&mut world);
    if let Some(filter) = filter {
        world.entity_mut(board).insert(filter);
    }
    trace::<f64>(&mut world).picture
}

#[test]
fn where_pixels_are_texels_filters_change_nothing() {
    let nearest = cell(8, None);
    assert!(nearest.variety() > 60);
    let bilinear = cell(8, Some(TextureFilter::Bilinear));
    for (found, expected) in bilinear.pixels.iter().flatten().zip(nearest.pixels.iter().flatten()) {
        assert!((found - expected).abs() < 1e-13, "{found}, not {expected}");
    }
}

#[test]
fn a_pixel_that_covers_the_cell_shows_the_mean_of_its_image() {
    let mean = [0, 1, 2].map(|channel| {
        let texels = (0..8).flat_map(|row| (0..8).map(move |column| (column, row)));
        texels.map(|(column, row)| f64::from(noise(8, 8).texel(column, row)[channel])).sum::<f64>()
            / 64.0
            / 255.0
    });
    let found = cell(1, Some(TextureFilter::Mip)).middle();
    for (found, expected) in found.into_iter().zip(mean) {
        assert!((found - expected).abs() < 1e-6, "{found}, not {expected}");
    }
}

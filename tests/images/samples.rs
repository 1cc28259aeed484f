//! Several samples a pixel: against finer pictures, and against an area known on paper.

use archetrace::components::{
    Ambient, CameraPose, Color, Cube, Diffuse, Lens, Light, Position, Sampling, Snapshot, Sphere,
};
use archetrace::geometry::Real;
use archetrace::systems::Workers;
use archetrace::trace::{CameraRay, CameraRays, SampleGrid, SamplePoint};
use bevy_ecs::prelude::*;
use core::f64::consts::PI;
use glam::DVec3;

use crate::support::picture::{Picture, assert_same};
use crate::support::random::Random;
use crate::support::scenes::{full_case, random_case, textured_case};
use crate::support::tracing::{Traced, trace, trace_with, workers};

const PIXELS: u32 = 24;

/// The World at `pixels` by `pixels`, with `side` by `side` samples in each.
fn with_samples(mut world: World, pixels: u32, side: u32) -> World {
    world.resource_mut::<Snapshot>().pixels = pixels;
    world.insert_resource(Sampling { side });
    world
}

/// Means of the blocks of `side` by `side` pixels of a finer picture, summed in the order of `points`.
fn blocks(fine: &Picture, side: u32, points: &[SamplePoint]) -> Picture {
    let coarse = fine.side / side as usize;
    let mean = |index: usize| {
        let (column, row) = (index % coarse * side as usize, index / coarse * side as usize);
        let samples = points.iter().map(|at| fine.at(column + at.column as usize, row + at.row as usize));
        let sum = samples.reduce(|a, b| core::array::from_fn(|i| a[i] + b[i])).unwrap();
        sum.map(|channel| channel / f64::from(side * side))
    };
    Picture { side: coarse, pixels: (0..coarse * coarse).map(mean).collect() }
}

/// The points of a grid row by row.
fn row_by_row(side: u32) -> Vec<SamplePoint> {
    (0..side * side).map(|index| SamplePoint { column: index % side, row: index / side }).collect()
}

fn assert_blocks_of_a_finer_picture<T: Real>(name: &str, world: impl Fn() -> World, side: u32) {
    let name = format!("{name}, {side} by {side} samples in {}", T::NAME);
    let Traced { picture: sampled, counts } = trace::<T>(&mut with_samples(world(), PIXELS, side));
    let fine = trace::<T>(&mut with_samples(world(), PIXELS * side, 1));
    let grid = SampleGrid::new(side);
    let points: Vec<SamplePoint> = (0..grid.count()).map(|pass| grid.point(pass)).collect();
    assert_same(&name, &sampled, &blocks(&fine.picture, side, &points));
    assert_eq!(counts, fine.counts, "{name}");
    // The order of the sum shows in the last digits only: each of its n^2 steps rounds once.
    let allowed = f64::from(side * side) * f64::EPSILON;
    let other = blocks(&fine.picture, side, &row_by_row(side));
    for (a, b) in sampled.pixels.iter().flatten().zip(other.pixels.iter().flatten()) {
        assert!((a - b).abs() <= allowed * b.abs(), "{name}: {a} and {b}");
    }
}

#[test]
fn samples_are_the_pixels_of_a_finer_picture() {
    for side in [1, 2, 3, 4, 5, 8] {
        assert_blocks_of_a_finer_picture::<f64>("all effects", || full_case().world(), side);
        assert_blocks_of_a_finer_picture::<f32>("all effects", || full_case().world(), side);
    }
    assert_blocks_of_a_finer_picture::<f64>("textures", || textured_case().world(), 3);
    for seed in 1..=20 {
        let name = format!("random scene of seed {seed}");
        assert_blocks_of_a_finer_picture::<f64>(&name, || random_case(seed, PIXELS).world(), 3);
    }
}

#[test]
fn the_finest_grid_is_right_in_single_precision_too() {
    let sampled = trace::<f32>(&mut with_samples(full_case().world(), 4, 64)).picture;
    let fine = trace::<f32>(&mut with_samples(full_case().world(), 4 * 64, 1)).picture;
    let means = blocks(&fine, 64, &row_by_row(64));
    for (a, b) in sampled.pixels.iter().flatten().zip(means.pixels.iter().flatten()) {
        assert!((a - b).abs() <= 4096.0 * f64::EPSILON * b.abs(), "{a} and {b}");
    }
}

fn assert_centers_stay<T: Real>() {
    let pose = CameraPose::looking(DVec3::new(3.0, 4.0, 5.0), DVec3::new(1.0, 2.0, -0.7), DVec3::Z).unwrap();
    let mut random = Random::new(1);
    for pixels in [1, 2, 7, 768, 1000, 8191, 8192] {
        let camera = CameraRays::<T>::new(&pose, &LENS, pixels);
        for side in (1..=63).step_by(2) {
            let at: [u32; 2] = core::array::from_fn(|_| random.below(pixels as usize) as u32);
            let [column, row] = at.map(|index| index * side + side / 2);
            let (usual, middle) = (camera.ray(at[0], at[1]), camera.refined(side).ray(column, row));
            let bits = |start: CameraRay<T>| format!("{:?}", (start.ray, start.reach));
            assert_eq!(bits(usual), bits(middle), "{pixels} pixels, side {side}, {at:?}");
        }
    }
}

#[test]
fn the_middle_of_an_odd_grid_is_the_ray_through_the_centre_to_the_bit() {
    assert_centers_stay::<f64>();
    assert_centers_stay::<f32>();
}

#[test]
fn threads_and_tiles_show_in_no_sampled_picture() {
    let world = || with_samples(full_case().world(), 37, 3);
    let usual = trace::<f64>(&mut world());
    for (threads, tile_size) in [(1, 32), (1, 1), (3, 5), (2, 37), (4, 1000)] {
        let name = format!("{threads} threads, tiles of {tile_size}");
        let other = trace_with::<f64>(&mut world(), workers(threads).with_tile_size(tile_size));
        assert_same(&name, &usual.picture, &other.picture);
        assert_eq!(usual.counts, other.counts, "{name}");
    }
}

const LENS: Lens = Lens { near: 1.0, far: 1e6, fovy: 90.0, aspect: 1.0 };

/// A camera in the origin that looks along +y: at distance 1 the picture reaches from -1 to 1 in both directions.
fn ahead(pixels: u32) -> World {
    let mut world = World::new();
    let pose = CameraPose::looking(DVec3::ZERO, DVec3::Y, DVec3::Z).unwrap();
    world.spawn((pose, LENS));
    world.insert_resource(Snapshot { pixels, level: 1 });
    world
}

const DISC_PIXELS: u32 = 8;

/// The share of the picture that a white sphere ahead covers: the mean of all pixels, and the area on paper. The
/// picture shows a circle whose radius is the tangent of the angle at which the view just touches the sphere.
fn covered(workers: Workers, side: u32, tangent: f64) -> (f64, f64) {
    let mut world = with_samples(ahead(DISC_PIXELS), DISC_PIXELS, side);
    let distance = 100.0;
    let radius = distance * tangent / tangent.hypot(1.0);
    let white = (Color::new(1.0, 1.0, 1.0), Ambient(1.0), Diffuse(0.0));
    world.spawn((Sphere { radius }, Position::new(0.0, distance, 0.0), white));
    let pixels = trace_with::<f64>(&mut world, workers).picture.pixels;
    let sum: f64 = pixels.iter().map(|pixel| pixel[0]).sum();
    (sum / pixels.len() as f64, PI * tangent * tangent / 4.0)
}

/// How far they can be apart: the cells around the sample points in a disc cover nothing further out than half a
/// diagonal, and everything that lies as deep in the disc.
fn bound(side: u32, tangent: f64) -> f64 {
    let half_diagonal = 2.0_f64.sqrt() / f64::from(DISC_PIXELS * side);
    PI * ((tangent + half_diagonal).powi(2) - tangent.powi(2)) / 4.0
}

/// The root of the mean square of the error over many discs.
fn error(workers: &Workers, side: u32) -> f64 {
    const DISCS: u32 = 200;
    let mut random = Random::new(u64::from(side));
    let squares = (0..DISCS).map(|_| {
        let tangent = random.between(0.3, 0.95);
        let (found, area) = covered(workers.clone(), side, tangent);
        assert!((found - area).abs() <= bound(side, tangent), "side {side}, tangent {tangent}");
        (found - area).powi(2)
    });
    (squares.sum::<f64>() / f64::from(DISCS)).sqrt()
}

#[test]
fn the_mean_converges_to_the_area_of_a_disc() {
    // How far the number of grid points in a circle is from its area is Gauss's circle problem: over many radii the
    // root of the mean square grows like the root of the radius (H. Cramer, Math. Zeitschrift 15, 1922), so the error
    // of the share falls like n^-1.5.
    let workers = workers(2);
    let sides = [1, 2, 4, 8, 16];
    let errors = sides.map(|side| error(&workers, side));
    let rate = (errors[4] / errors[0]).log2() / 4.0;
    println!("samples along a side {sides:?}: errors {errors:?}, like n^{rate:.3}");
    assert!((-1.6..-1.4).contains(&rate), "{errors:?}");
}

/// Its right half is twice as bright as white can be, its left half black.
fn half_a_pixel() -> World {
    let mut world = ahead(1);
    let bright = (Color::new(1.0, 1.0, 1.0), Ambient(1.0), Diffuse(1.0));
    world.spawn((Cube { side: 1000.0 }, Position::new(0.0, 100.0, -500.0), bright));
    world.spawn((Light, Position::new(500.0, -1e6, 0.0)));
    world
}

#[test]
fn a_sample_is_cut_before_the_mean_not_after() {
    for side in [2, 4, 64] {
        let mut world = with_samples(half_a_pixel(), 1, side);
        assert_eq!(trace::<f64>(&mut world).picture.at(0, 0), [0.5; 3], "{side} by {side} samples");
        assert_eq!(trace::<f32>(&mut world).picture.at(0, 0), [0.5; 3], "f32, {side} by {side} samples");
    }
}

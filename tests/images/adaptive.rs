//! Adaptive samples, the cutoff and windows: what must be equal to the bit, and what an error may be.

use archetrace::components::{Adaptive, Cutoff, Sampling, Snapshot};
use archetrace::film::Film;
use archetrace::geometry::Real;
use archetrace::systems::{
    Frame, Monitor, Tables, extract_schedule, frame_schedule, prepare, trace_adaptive, trace_picture,
    trace_windows,
};
use archetrace::trace::{Counts, Exposure, Kernel, SampleGrid, Simd};
use bevy_ecs::prelude::*;

use crate::support::scenes::{full_case, random_case, textured_case};
use crate::support::tracing::workers;

/// The picture, its counts and the samples of each pixel with so many points along each side of a pixel.
fn traced<T: Real>(world: World, side: u32, threshold: Option<f64>) -> (Film, Counts, Option<Vec<u16>>) {
    let mut world = world;
    world.insert_resource(Sampling { side });
    if let Some(threshold) = threshold {
        world.insert_resource(Adaptive { threshold });
    }
    prepare::<T>(&mut world, workers(2));
    frame_schedule::<T>().run(&mut world);
    let frame = world.resource::<Frame>();
    let (film, counts) = frame.traced().unwrap();
    (film.clone(), *counts, frame.refinement().map(|refinement| refinement.samples().to_vec()))
}

fn check_ends<T: Real>(world: impl Fn() -> World) {
    for side in [1, 3, 4] {
        let (uniform, rays, none) = traced::<T>(world(), side, None);
        assert_eq!(none, None);
        // Not even equal samples are enough for an error of less than nothing.
        let (all, all_rays, samples) = traced::<T>(world(), side, Some(-1.0));
        assert!(all == uniform && all_rays == rays, "{} {side}", T::NAME);
        assert!(samples.unwrap().iter().all(|&count| u32::from(count) == side * side));
    }
    // Anything is enough for an error of 1; an odd grid begins in the middle.
    let (single, rays, _) = traced::<T>(world(), 1, None);
    let (first, first_rays, samples) = traced::<T>(world(), 3, Some(1.0));
    assert!(first == single && first_rays == rays, "{}", T::NAME);
    assert!(samples.unwrap().iter().all(|&count| count == 1));
}

#[test]
fn no_threshold_gives_all_samples_and_a_great_one_the_first_to_the_bit() {
    for case in [full_case(), textured_case(), random_case(0xADA, 37)] {
        check_ends::<f64>(|| case.world());
        check_ends::<f32>(|| case.world());
    }
}

/// What depends on nothing but the scene: pixels, samples and rays.
fn by_path<T: Real>(world: &World, kernel: Kernel, simd: Simd, threads: usize) -> (Film, Counts, Vec<u16>) {
    let tables = world.resource::<Tables<T>>();
    let camera = tables.camera.as_ref().unwrap();
    let level = world.resource::<Snapshot>().level;
    let grid = SampleGrid::new(3);
    let exposure = Exposure { grid, kernel, ..Exposure::new(&tables.scene, camera, level) };
    let mut film = Film::new(camera.pixels()).unwrap();
    let workers = workers(threads).with_simd(simd);
    let (counts, refinement) = trace_adaptive(&exposure, 0.01, &mut film, &workers, &Monitor::default());
    (film, counts, refinement.samples().to_vec())
}

fn check_paths<T: Real>(mut world: World) {
    prepare::<T>(&mut world, workers(1));
    extract_schedule::<T>().run(&mut world);
    let effects = world.resource::<Tables<T>>().effects();
    let truth = by_path::<T>(&world, Kernel::EVERYTHING, Simd::detect(), 1);
    let (fewest, most) = (truth.2.iter().min().unwrap(), truth.2.iter().max().unwrap());
    assert!((*fewest, *most) == (1, 9), "some pixels want one sample, some all: {fewest} to {most}");
    for kernel in Kernel::all_for(effects) {
        for simd in Simd::available() {
            for threads in [1, 2] {
                let found = by_path::<T>(&world, kernel, simd, threads);
                assert!(found == truth, "{}, {kernel:?}, {simd:?}, {threads} threads", T::NAME);
            }
        }
    }
}

#[test]
fn adaptive_pictures_are_the_same_to_the_bit_on_every_path() {
    for case in [full_case(), random_case(0xADB, 61)] {
        check_paths::<f64>(case.world());
        check_paths::<f32>(case.world());
    }
}

#[test]
fn a_lower_threshold_takes_more_samples_and_is_closer_to_all_of_them() {
    let world = || full_case().world();
    let (uniform, ..) = traced::<f64>(world(), 5, None);
    let mut before = (0, f64::INFINITY);
    for threshold in [1.0, 0.1, 0.03, 0.01, 0.001] {
        let (film, counts, _) = traced::<f64>(world(), 5, Some(threshold));
        let squares = film.pixels().iter().flatten().zip(uniform.pixels().iter().flatten());
        let error: f64 = squares.map(|(a, b)| (a - b) * (a - b)).sum();
        assert!(counts.rays.primary > before.0, "threshold {threshold}: no more rays");
        assert!(error < before.1, "threshold {threshold}: {error} is no less than {}", before.1);
        before = (counts.rays.primary, error);
    }
}

/// A path that is cut carries no more than the cutoff, and no light is more than 1.
#[test]
fn a_cutoff_darkens_by_no_more_than_itself() {
    let with = |cutoff: Option<f64>| {
        let mut world = full_case().world();
        world.resource_mut::<Snapshot>().level = 30;
        if let Some(cutoff) = cutoff {
            world.insert_resource(Cutoff(cutoff));
        }
        traced::<f64>(world, 1, None)
    };
    let (whole, whole_rays, _) = with(None);
    let (zero, zero_rays, _) = with(Some(0.0));
    assert!(zero == whole && zero_rays == whole_rays);
    let mut rays = whole_rays.rays.mirror;
    for cutoff in [1e-3, 0.01, 0.1, 1.0] {
        let (film, counts, _) = with(Some(cutoff));
        // Light that arrives is at most the sum over three lights, each of at most 1.
        let most = whole.pixels().iter().flatten().zip(film.pixels().iter().flatten()).map(|(a, b)| a - b);
        let most = most.fold(0.0, f64::max);
        assert!((0.0..=4.0 * cutoff).contains(&most), "cutoff {cutoff}: off by {most}");
        assert!(counts.rays.mirror < rays, "cutoff {cutoff}: no fewer rays");
        rays = counts.rays.mirror;
    }
    assert_eq!(rays, 0);
}

#[test]
fn windows_are_parts_of_the_picture() {
    fn check<T: Real>() {
        let mut world = full_case().world();
        prepare::<T>(&mut world, workers(2));
        extract_schedule::<T>().run(&mut world);
        let tables = world.resource::<Tables<T>>();
        let camera = tables.camera.as_ref().unwrap();
        let grid = SampleGrid::new(2);
        let exposure = Exposure { grid, ..Exposure::new(&tables.scene, camera, 4) };
        let mut whole = Film::new(camera.pixels()).unwrap();
        trace_picture(&exposure, &mut whole, &workers(2), &Monitor::default());
        let corners = [[0, 0], [5, 9], [camera.pixels() - 11, 3]];
        let (films, counts) = trace_windows(&exposure, None, (&corners, 11), &workers(2)).unwrap();
        assert!(counts.iter().all(|counts| counts.rays.primary == 11 * 11 * 4));
        for (film, [left, top]) in films.iter().zip(corners) {
            for (row, pixels) in film.pixels().chunks(11).enumerate() {
                let start = (top as usize + row) * camera.pixels() as usize + left as usize;
                assert_eq!(pixels, &whole.pixels()[start..start + 11]);
            }
        }
    }
    check::<f64>();
    check::<f32>();
}

//! Time of everything that a picture is made of, each by itself: `cargo bench --bench kernels [-- FILTER]`.

#[path = "support/crowd.rs"]
mod crowd;
#[path = "../tests/support/random.rs"]
#[allow(
    dead_code,
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    reason = "shared with the tests: small whole numbers, and not all of it is used here"
)]
mod random;

use core::hint::black_box;
use core::num::NonZeroUsize;

use archetrace::components::{CameraPose, Position, Sphere};
use archetrace::geometry::{CubeShape, PlaneShape, PyramidShape, Ray, Real, SphereShape, Straight, Vector};
use archetrace::scene::{Description, parse, spawn};
use archetrace::systems::{
    Workers, build_schedule, extract_schedule, frame_schedule, prepare, tables_schedule,
};
use bevy_ecs::prelude::*;
use criterion::{BatchSize, BenchmarkId, Criterion, criterion_group, criterion_main};
use glam::DVec3;

use crowd::{camera, crowd};
use random::Random;

criterion_group!(all, kernels, loading, tables, edits, pictures);
criterion_main!(all);

/// Rays a kernel is run on.
const RAYS: usize = 1024;

fn kernels(criterion: &mut Criterion) {
    kernels_of::<f64>(criterion);
    kernels_of::<f32>(criterion);
}

fn kernels_of<T: Real>(criterion: &mut Criterion) {
    let rays = rays::<T>();
    let corner = DVec3::new(-1.0, -1.0, -1.0);
    let sphere = SphereShape { center: Vector::new(T::ZERO, T::ZERO, T::ZERO), radius: T::ONE };
    bounded_kernels(criterion, "sphere", sphere, &rays);
    bounded_kernels(criterion, "cube", CubeShape::<T>::new(corner, 2.0), &rays);
    bounded_kernels(criterion, "pyramid", PyramidShape::<T>::new(corner, 2.0, 2.0), &rays);
    bounded_kernels(criterion, "plane", PlaneShape { height: T::ZERO }, &rays);
}

/// With branches and without.
fn bounded_kernels<T: Real, S: Straight<T>>(
    criterion: &mut Criterion,
    name: &str,
    shape: S,
    rays: &[Ray<T>],
) {
    let mut group = criterion.benchmark_group(format!("{name} {}, {RAYS} rays", T::NAME));
    group.bench_function("intersect", |bencher| {
        bencher.iter(|| {
            let shape = black_box(shape);
            rays.iter().filter(|ray| shape.intersect(ray).is_some()).count()
        });
    });
    group.bench_function("meet", |bencher| {
        bencher.iter(|| {
            let shape = black_box(shape);
            rays.iter().filter(|ray| shape.meet(ray).t > T::ZERO).count()
        });
    });
}

/// From a sphere of radius 3 towards points near its middle: about half of them meet a body of radius 1 there.
fn rays<T: Real>() -> Vec<Ray<T>> {
    let random = &mut Random::new(1);
    let ray = |_| {
        let origin = random.direction() * 3.0;
        let direction = (random.point(1.2) - origin).normalize();
        Ray { origin: Vector::from_dvec3(origin), direction: Vector::from_dvec3(direction) }
    };
    (0..RAYS).map(ray).collect()
}

fn loading(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("loading");
    group.sample_size(10);
    for count in [1_000, 100_000] {
        let description = crowd(count, 64);
        let text = description.to_string();
        group.bench_function(BenchmarkId::new("parse", count), |bencher| bencher.iter(|| parse(&text)));
        group.bench_function(BenchmarkId::new("spawn", count), |bencher| {
            bencher.iter_with_large_drop(|| spawned(&description));
        });
    }
}

fn tables(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("tables f32");
    group.sample_size(10);
    for count in [1_000, 10_000, 100_000, 1_000_000] {
        let description = crowd(count, 64);
        group.bench_function(BenchmarkId::new("extract", count), |bencher| {
            bencher.iter_batched_ref(
                || prepared::<f32>(&description),
                |world| tables_schedule::<f32>().run(world),
                BatchSize::PerIteration,
            );
        });
        let extracted = || {
            let mut world = prepared::<f32>(&description);
            tables_schedule::<f32>().run(&mut world);
            world
        };
        group.bench_function(BenchmarkId::new("build", count), |bencher| {
            let run = |world: &mut World| build_schedule::<f32>().run(world);
            bencher.iter_batched_ref(extracted, run, BatchSize::PerIteration);
        });
    }
}

fn edits(criterion: &mut Criterion) {
    let mut world = prepared::<f32>(&crowd(100_000, 64));
    let mut schedule = extract_schedule::<f32>();
    schedule.run(&mut world);
    let spheres: Vec<Entity> = world.query_filtered::<Entity, With<Sphere>>().iter(&world).collect();
    let mut places = spheres.iter().cycle();
    criterion.bench_function("edit one of 100000", |bencher| {
        bencher.iter(|| {
            let place = places.next().and_then(|&sphere| world.get_mut::<Position>(sphere));
            if let Some(mut place) = place {
                place.0.x += 0.01;
            }
            schedule.run(&mut world);
        });
    });
}

fn pictures(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("picture of 128 x 128, f32");
    for count in [10, 1_000, 100_000] {
        let mut world = prepared::<f32>(&crowd(count, 128));
        let mut schedule = frame_schedule::<f32>();
        schedule.run(&mut world);
        group.bench_function(BenchmarkId::new("spheres", count), |bencher| {
            bencher.iter(|| schedule.run(&mut world));
        });
    }
}

fn spawned(description: &Description) -> World {
    let mut world = World::new();
    spawn(&mut world, description);
    world.query::<&mut CameraPose>().iter_mut(&mut world).for_each(|mut pose| *pose = camera());
    world
}

/// A World that can be extracted. On one thread: what more of them bring is another question.
fn prepared<T: Real>(description: &Description) -> World {
    let mut world = spawned(description);
    if let Ok(workers) = Workers::new(Some(NonZeroUsize::MIN)) {
        prepare::<T>(&mut world, workers);
    }
    world
}

//! Every path to a picture is the same path: packets with any vector instructions, and ray by ray.

use archetrace::components::Snapshot;
use archetrace::effects::EffectSet;
use archetrace::film::Film;
use archetrace::geometry::Real;
use archetrace::systems::{Monitor, Tables, Workers, extract_schedule, prepare, trace_picture};
use archetrace::trace::{Counts, Exposure, Kernel, SampleId, SceneTables, Simd, Trees, radiance};
use bevy_ecs::prelude::World;

use crate::support::case::Case;
use crate::support::scenes::{full_case, random_case, textured_case};
use crate::support::tracing::workers;

/// With tables and camera.
fn extracted<T: Real>(mut world: World) -> World {
    prepare::<T>(&mut world, workers(1));
    extract_schedule::<T>().run(&mut world);
    world
}

fn by_kernel<T: Real>(exposure: &Exposure<'_, T>, workers: &Workers) -> (Film, Counts) {
    let mut film = Film::new(exposure.camera.pixels()).unwrap();
    let counts = trace_picture(exposure, &mut film, workers, &Monitor::default());
    (film, counts)
}

/// One ray after the other, by the scalar kernels, every object tested.
fn ray_by_ray<T: Real>(exposure: &Exposure<'_, T>) -> (Vec<[f64; 3]>, Counts) {
    let mut counts = Counts::default();
    let pixels = exposure.camera.pixels();
    let picture = (0..pixels * pixels).map(|index| {
        if exposure.depth.level == 0 {
            return [0.0; 3];
        }
        counts.rays.primary += 1;
        let (column, row) = (index % pixels, index / pixels);
        let sample = SampleId { column, row, index: 0 };
        let start = exposure.camera.sample(column, row, sample);
        let color = radiance(exposure.tables, start, exposure.depth, sample, &mut counts).color;
        color.to_f64().map(|channel| channel.clamp(0.0, 1.0))
    });
    (picture.collect(), counts)
}

pub(crate) fn check<T: Real>(name: &str, case: &Case) {
    check_world::<T>(name, case.world());
}

/// Checks that every path gives the same picture, and returns it.
pub(crate) fn check_world<T: Real>(name: &str, world: World) -> Vec<[f64; 3]> {
    let world = extracted::<T>(world);
    let tables = world.resource::<Tables<T>>();
    let camera = tables.camera.as_ref().unwrap();
    let level = world.resource::<Snapshot>().level;
    let smallest = Kernel::smallest_for(tables.effects());
    let with = |kernel| Exposure { kernel, ..Exposure::new(&tables.scene, camera, level) };
    let treeless = SceneTables { trees: Trees::default(), ..(*tables.scene).clone() };
    let (truth, rays) = ray_by_ray(&Exposure { tables: &treeless, ..with(smallest) });
    for (simd, kernel) in paths(tables.effects()) {
        for (threads, tile) in [(1, 32), (2, 7)] {
            let workers = workers(threads).with_simd(simd).with_tile_size(tile);
            let (film, counts) = by_kernel(&with(kernel), &workers);
            let unequal = film.pixels().iter().zip(&truth).filter(|(a, b)| bits(**a) != bits(**b)).count();
            let path = format!("{name}, {}, {simd:?}, {kernel:?}, tiles of {tile}", T::NAME);
            assert_eq!(unequal, 0, "{path}: pixels differ");
            assert_eq!(counts, rays, "{path}");
        }
    }
    truth
}

/// All vector instructions with all kernels that have some effects; rays one by one use none.
fn paths(effects: EffectSet) -> impl Iterator<Item = (Simd, Kernel)> {
    let all = move |simd| Kernel::all_for(effects).map(move |kernel| (simd, kernel));
    let distinct =
        |&(simd, kernel): &(Simd, Kernel)| !matches!(kernel, Kernel::Stages(_)) || simd == Simd::detect();
    Simd::available().into_iter().flat_map(all).filter(distinct)
}

fn bits(pixel: [f64; 3]) -> [u64; 3] {
    pixel.map(f64::to_bits)
}

#[test]
fn random_scenes_are_the_same_to_the_bit_on_every_path() {
    for seed in 1..=120 {
        // Odd sizes leave blocks at the edges that are not full.
        let case = random_case(0x5_0000 + seed, 61);
        check::<f64>(&format!("random scene {seed}"), &case);
        check::<f32>(&format!("random scene {seed}"), &case);
    }
}

#[test]
fn the_full_scene_is_the_same_to_the_bit_on_every_path() {
    for case in [full_case(), textured_case()] {
        check::<f64>("full scene", &case);
        check::<f32>("full scene", &case);
    }
}

//! Hard cases that only whole pictures show, by their id in `tests/hard_cases.md`.

use std::sync::Arc;

use archetrace::components::{
    Ambient, CameraPose, Checkerboard, Color, Cube, Lens, Position, Sampling, Snapshot,
};
use archetrace::film::Film;
use archetrace::geometry::Real;
use archetrace::scene::{LightDescription, ObjectDescription, ShapeDescription};
use archetrace::systems::{Monitor, Tables, extract_schedule, prepare, trace_picture};
use archetrace::trace::{Exposure, Simd, SurfaceRow};
use bevy_ecs::prelude::World;
use glam::DVec3;

use crate::support::case::Case;
use crate::support::parts::{Parts, rebuilt, scene_entities};
use crate::support::picture::{Picture, assert_same, differing};
use crate::support::random::Random;
use crate::support::scenes::{full_case, textured_case};
use crate::support::tracing::{trace, trace_with, workers};
use crate::transforms::{mirrored_x, moved, quarter_turned, scaled};

#[test]
fn c11_cells_too_far_to_be_told_apart_average_to_grey() {
    // A unit above the ground, cells of 0.37 units. The rows next to the horizon meet the ground hundreds to
    // thousands of cells away.
    fn check<T: Real>() {
        let mut world = World::new();
        world.insert_resource(Snapshot { pixels: 64, level: 1 });
        world.insert_resource(Sampling { side: 32 });
        let look = CameraPose::looking(DVec3::Z, DVec3::new(0.31, 1.0, 0.0), DVec3::Z);
        world.spawn((look.unwrap(), Lens { near: 0.1, far: 1e6, fovy: 2.0, aspect: 1.0 }));
        let white = (Color::new(1.0, 1.0, 1.0), Ambient(1.0));
        world.spawn((Checkerboard { cell: 0.37 }, Position::default(), white));
        let picture = trace::<T>(&mut world).picture;
        for row in 32..40 {
            let mean = (0..64).map(|column| picture.at(column, row)[0]).sum::<f64>() / 64.0;
            assert!((mean - 0.5).abs() < 0.02, "{}: row {row}: {mean}", T::NAME);
        }
        assert_eq!(picture.at(32, 31), [0.0; 3], "above the horizon");
    }
    check::<f64>();
    check::<f32>();
}

/// The full scene with a mirror image of everything, seen from the plane between.
fn symmetric_case() -> Case {
    let mut case = full_case();
    let scene = &mut case.description;
    let width = |object: &ObjectDescription| match object.shape {
        ShapeDescription::Sphere { .. } => 0.0,
        ShapeDescription::Cube { side } => side,
        ShapeDescription::Pyramid { width, .. } => width,
    };
    let flip = |v: DVec3| DVec3::new(-v.x, v.y, v.z);
    for object in scene.objects.clone() {
        let position = flip(object.position) - DVec3::X * width(&object);
        scene.objects.push(ObjectDescription { position, ..object });
    }
    // On the plane itself: the sum over two lights would depend on their order.
    for light in &mut scene.lights {
        light.position.x = 0.0;
    }
    for spot in &mut scene.spots {
        spot.light.position.x = 0.0;
        spot.target.x = 0.0;
    }
    // The middle of a cell.
    case.board_origin = DVec3::new(-0.5 * scene.board.cell, 0.0, 0.0);
    let position = DVec3::new(0.0, -170.0, 60.0);
    let look = DVec3::new(0.0, 17.0, -4.3);
    case.pose = CameraPose::looking(position, look, DVec3::Z).unwrap();
    case
}

#[test]
fn k08_a_symmetric_scene_has_a_symmetric_picture_to_the_bit() {
    fn check<T: Real>() {
        for pixels in [160, 161] {
            let mut case = symmetric_case();
            case.description.pixels = pixels;
            let picture = trace::<T>(&mut case.world()).picture;
            assert!(picture.variety() > 1000);
            assert_same(&format!("{} symmetric, {pixels}", T::NAME), &picture, &picture.flipped());
        }
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn l17_a_thousand_lights_light_the_same_in_any_order_of_spawning() {
    let mut case = full_case();
    case.description.pixels = 40;
    let random = &mut Random::new(0x1_7000);
    case.description.lights = (0..1000)
        .map(|_| LightDescription { position: random.point(200.0), falloff: 1e-3 * random.unit() })
        .collect();
    let mut other = rebuilt(&mut case.world(), |parts| random.shuffle(parts));
    let usual = trace::<f64>(&mut case.world());
    assert!(usual.counts.rays.shadow > 100_000);
    assert_same("a thousand lights", &usual.picture, &trace::<f64>(&mut other).picture);
    let usual = trace::<f32>(&mut case.world()).picture;
    assert_same("a thousand lights, f32", &usual, &trace::<f32>(&mut other).picture);
}

/// Traces the full scene after its tables were spoilt behind the back of every check.
fn spoilt<T: Real>(ambient: T) -> (Film, u64) {
    let mut world = full_case().world();
    prepare::<T>(&mut world, workers(1));
    extract_schedule::<T>().run(&mut world);
    let mut tables = world.resource_mut::<Tables<T>>();
    let surfaces = &mut Arc::make_mut(&mut tables.scene).boards.surfaces;
    let row = SurfaceRow { ambient, ..surfaces.row(0) };
    assert!(surfaces.replace(0, row));
    let tables = world.resource::<Tables<T>>();
    let camera = tables.camera.as_ref().unwrap();
    let exposure = Exposure::new(&tables.scene, camera, 4);
    let mut film = Film::new(camera.pixels()).unwrap();
    let counts = trace_picture(&exposure, &mut film, &workers(2), &Monitor::default());
    (film, counts.non_finite)
}

#[test]
fn q01_q02_a_radiance_that_is_not_finite_is_counted_and_black() {
    fn check<T: Real>() {
        let (usual, none) = spoilt::<T>(T::ONE);
        assert_eq!(none, 0);
        for value in [T::NAN, T::INFINITY] {
            let (film, count) = spoilt::<T>(value);
            let changed = film.pixels().iter().zip(usual.pixels()).filter(|(a, b)| a != b);
            assert!(changed.clone().all(|(a, _)| *a == [0.0; 3]));
            // Black cells, too, are NaN then, and were black before.
            assert!((1000..=count).contains(&(changed.count() as u64)), "{count}");
        }
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn q03_a_channel_times_255_is_cut_not_rounded() {
    for (ambient, level) in [(0.0, 0), (0.5, 127), (0.999, 254), (254.999 / 255.0, 254), (1.0, 255)] {
        let mut world = World::new();
        world.insert_resource(Snapshot { pixels: 1, level: 1 });
        let pose = CameraPose::looking(DVec3::NEG_Y, DVec3::Y, DVec3::Z).unwrap();
        world.spawn((pose, Lens { near: 0.1, far: 10.0, fovy: 60.0, aspect: 1.0 }));
        let cube = (Cube { side: 2.0 }, Position::new(-1.0, 0.0, -1.0));
        world.spawn((cube, Color::new(1.0, 1.0, 1.0), Ambient(ambient)));
        assert_eq!(trace::<f64>(&mut world).picture.levels(), [[level; 3]], "{ambient}");
        // An ambient part between two single numbers may be rounded up to the next level.
        if [0.0, 0.5, 0.999, 1.0].contains(&ambient) {
            assert_eq!(trace::<f32>(&mut world).picture.levels(), [[level; 3]], "f32, {ambient}");
        }
    }
}

/// Pixels that differ by a level or more.
fn count_differing(usual: &Picture, other: &Picture) -> usize {
    differing(&usual.levels(), &other.levels(), 0).len()
}

#[test]
fn r07_scaled_by_powers_of_ten_single_precision_changes_few_pixels() {
    for case in [full_case(), textured_case()] {
        let usual = trace::<f32>(&mut case.world()).picture;
        for factor in [1e-6, 1e-3, 1e3, 1e6] {
            let other = trace::<f32>(&mut scaled(&case, factor).world()).picture;
            let count = count_differing(&usual, &other);
            println!("f32 scaled by {factor:e}: {count} of {} pixels differ", usual.pixels.len());
            assert!(count <= 10, "{count}");
        }
    }
}

#[test]
fn r08_moved_by_a_million_units_no_pixel_changes_in_8_bits() {
    let case = full_case();
    let usual = trace::<f64>(&mut case.world()).picture;
    for by in [DVec3::new(1e6, 0.0, 0.0), DVec3::new(-1e6, 1e6, 0.0), DVec3::splat(1e6)] {
        let count = count_differing(&usual, &trace::<f64>(&mut moved(&case, by).world()).picture);
        assert_eq!(count, 0, "f64 moved by {by}");
    }
    let usual = trace::<f32>(&mut case.world()).picture;
    let other = trace::<f32>(&mut moved(&case, DVec3::new(1024.0, 2048.0, 0.0)).world()).picture;
    let count = count_differing(&usual, &other);
    println!("f32 moved by (1024, 2048, 0): {count} of {} pixels differ", usual.pixels.len());
    assert!(count * 100 <= usual.pixels.len(), "{count}");
    // A million units away single numbers place everything to a sixteenth: what is shown is another scene, but whole.
    let far = trace::<f32>(&mut moved(&case, DVec3::splat(1e6)).world());
    assert_eq!(far.counts.non_finite, 0);
    let count = count_differing(&usual, &far.picture);
    println!("f32 moved by a million: {count} of {} pixels differ", usual.pixels.len());
    assert!(count * 20 <= usual.pixels.len(), "{count}");
}

/// Every third entity despawned and spawned again, which moves rows of the World's tables.
fn respawned(mut world: World) -> World {
    for entity in scene_entities(&mut world).into_iter().step_by(3) {
        let parts = Parts::of(world.entity(entity));
        world.despawn(entity);
        parts.spawn(&mut world);
    }
    world
}

#[test]
fn r06_r09_transforms_do_not_show_on_any_simd_path() {
    fn check<T: Real>() {
        let case = full_case();
        let usual = trace::<T>(&mut case.world()).picture;
        for simd in Simd::available() {
            let by = |case: &Case| trace_with::<T>(&mut case.world(), workers(2).with_simd(simd)).picture;
            let name = |what: &str| format!("{} {simd:?} {what}", T::NAME);
            for exponent in [-60, -20, 20, 60] {
                assert_same(&name("scaled"), &usual, &by(&scaled(&case, 2_f64.powi(exponent))));
            }
            assert_same(&name("mirrored"), &usual, &by(&mirrored_x(&case)).flipped());
            assert_same(&name("turned"), &usual, &by(&quarter_turned(&case)));
            let of_world =
                |mut world: World| trace_with::<T>(&mut world, workers(3).with_tile_size(13).with_simd(simd));
            let permuted = rebuilt(&mut case.world(), |parts| Random::new(9).shuffle(parts));
            assert_same(&name("permuted"), &usual, &of_world(permuted).picture);
            assert_same(&name("respawned"), &usual, &of_world(respawned(case.world())).picture);
        }
    }
    check::<f64>();
    check::<f32>();
}

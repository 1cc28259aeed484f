//! Far from the world's origin, at every scale, and with planes that lie far apart.

use archetrace::components::{CameraPose, Checkerboard, Cube, Lens, Position, Pyramid, Sphere};
use archetrace::systems::{Drawn, list_schedule};
use bevy_ecs::prelude::*;
use glam::DVec3;

use super::canvas::{Canvas, PLAIN};
use super::maps::{Labelled, Tally, assert_agrees};
use super::support::random::Random;
use super::support::scenes::full_case;

const SIDE: usize = 150;
const LENS: Lens = Lens { near: 2.0, far: 900.0, fovy: 55.0, aspect: 1.2 };

/// The scene with everything, seen from around it, moved by an offset and then scaled.
fn changed(seed: u64, offset: DVec3, scale: f64) -> (World, CameraPose, Lens) {
    let case = full_case();
    let mut world = case.world();
    for mut position in world.query::<&mut Position>().iter_mut(&mut world) {
        position.0 = (position.0 + offset) * scale;
    }
    for mut sphere in world.query::<&mut Sphere>().iter_mut(&mut world) {
        sphere.radius *= scale;
    }
    for mut cube in world.query::<&mut Cube>().iter_mut(&mut world) {
        cube.side *= scale;
    }
    for mut pyramid in world.query::<&mut Pyramid>().iter_mut(&mut world) {
        pyramid.width *= scale;
        pyramid.height *= scale;
    }
    for mut board in world.query::<&mut Checkerboard>().iter_mut(&mut world) {
        board.cell *= scale;
    }
    let random = &mut Random::new(seed);
    let from = random.direction() * random.between(50.0, 250.0);
    let pose = CameraPose::looking((from + offset) * scale, random.point(30.0) - from, random.direction());
    (world, pose.unwrap(), Lens { near: LENS.near * scale, far: LENS.far * scale, ..LENS })
}

/// The changed scene agrees with the trace, and with the picture of the unchanged one but for some pixels on outlines.
#[track_caller]
fn assert_unchanged(offset: DVec3, scale: f64, most_differing: f64) {
    let canvas = &mut Canvas::new();
    let (mut pixels, mut differing) = (0, 0);
    for seed in 0..12 {
        let (world, pose, lens) = changed(seed, DVec3::ZERO, 1.0);
        let before = Labelled::new(world).draw(canvas, &pose, &lens, SIDE);
        let (world, pose, lens) = changed(seed, offset, scale);
        let mut labelled = Labelled::new(world);
        let name = format!("{offset} x {scale:e}, seed {seed}");
        assert_agrees(&name, canvas, &mut labelled, (&pose, &lens), SIDE);
        let after = labelled.draw(canvas, &pose, &lens, SIDE);
        let apart = |(a, b): &(&[u8; 3], &[u8; 3])| (0..3).any(|i| a[i].abs_diff(b[i]) > 2);
        differing += before.pixels.iter().zip(&after.pixels).filter(apart).count();
        pixels += SIDE * SIDE;
    }
    let share = differing as f64 / pixels as f64;
    println!("{offset} x {scale:e}: {differing} of {pixels} pixels differ");
    assert!(share <= most_differing, "{offset} x {scale:e}: {share}");
}

#[test]
fn far_from_the_origin_the_picture_is_the_same() {
    assert_unchanged(DVec3::new(1e6, 2e6, 0.0), 1.0, 1e-4);
    assert_unchanged(DVec3::new(-3e8, 5e7, 1e7), 1.0, 1e-3);
}

#[test]
fn at_every_scale_the_picture_is_the_same() {
    for scale in [1e-25, 1e-9, 1e-6, 1e-3, 1e3, 1e6, 1e9, 1e25] {
        assert_unchanged(DVec3::ZERO, scale, 1e-4);
    }
}

/// Bodies that overlap, hide and pierce each other at a distance, some of them by a hundred-thousandth of it.
fn crowd(random: &mut Random, center: DVec3, size: f64) -> World {
    let mut world = World::new();
    for _ in 0..12 {
        let position = Position(center + random.point(size));
        let length = size * random.between(0.1, 1.0);
        match random.below(3) {
            0 => world.spawn((Sphere { radius: length }, position)),
            1 => world.spawn((Cube { side: length }, position)),
            _ => world.spawn((Pyramid { width: length, height: length }, position)),
        };
    }
    world.spawn((Checkerboard { cell: size }, Position(center - DVec3::new(0.0, 0.0, 0.3 * size))));
    world
}

#[test]
fn depth_tells_near_from_far_over_nine_decades() {
    let canvas = &mut Canvas::new();
    let mut all = Tally::default();
    for seed in 0..24 {
        let random = &mut Random::new(seed);
        let distance = random.pick(&[1.0, 1e3, 1e5, 9e5]);
        let size = distance * random.pick(&[1e-2, 0.3]);
        let eye = random.point(100.0);
        let look = DVec3::new(random.between(-1.0, 1.0), 1.0, random.between(-0.3, 0.3));
        let world = crowd(random, eye + distance * look.normalize(), size);
        let pose = CameraPose::looking(eye, look, DVec3::Z).unwrap();
        let fovy = (3.0 * size / distance).atan().to_degrees();
        let lens = Lens { near: 1e-3, far: 1e6, fovy, aspect: 1.0 };
        let labelled = &mut Labelled::new(world);
        all += assert_agrees(&format!("depth {seed}"), canvas, labelled, (&pose, &lens), SIDE);
    }
    println!("nine decades: {all:?}");
}

#[test]
fn the_near_and_the_far_plane_cut_everything_where_the_trace_does() {
    let canvas = &mut Canvas::new();
    for seed in 100..130 {
        let random = &mut Random::new(seed);
        let world = crowd(random, DVec3::ZERO, 40.0);
        let from = random.direction() * random.between(20.0, 100.0);
        let pose = CameraPose::looking(from, random.point(20.0) - from, random.direction()).unwrap();
        let near = from.length() * random.between(0.2, 0.9);
        let far = near + random.between(5.0, 60.0);
        let lens = Lens { near, far, fovy: random.pick(&[30.0, 80.0, 140.0]), aspect: 1.1 };
        let labelled = &mut Labelled::new(world);
        assert_agrees(&format!("planes {seed}"), canvas, labelled, (&pose, &lens), SIDE);
    }
}

#[test]
fn a_planet_under_the_feet_is_round_to_its_horizon() {
    let canvas = &mut Canvas::new();
    for (seed, height) in (0..).zip([1e-3, 0.1, 1.0, 100.0, -0.1, -1e4]) {
        let radius = 1e6;
        let mut world = World::new();
        world.spawn((Sphere { radius }, Position::new(0.0, 0.0, -radius)));
        world.spawn((Cube { side: 0.2 }, Position::new(0.3, 2.0, -0.1)));
        world.spawn((Sphere { radius: 30.0 }, Position::new(100.0, 900.0, 0.0)));
        let random = &mut Random::new(seed);
        for number in 0..6 {
            let look = DVec3::new(random.between(-0.3, 0.3), 1.0, random.between(-0.2, 0.2));
            let pose = CameraPose::looking(DVec3::new(0.0, 0.0, height), look, random.direction()).unwrap();
            let lens = Lens { near: 1e-4, far: 1e7, fovy: 60.0, aspect: 1.0 };
            let mut copy = World::new();
            core::mem::swap(&mut copy, &mut world);
            let mut labelled = Labelled::new(copy);
            let name = format!("planet {height} {number}");
            assert_agrees(&name, canvas, &mut labelled, (&pose, &lens), SIDE);
            world = labelled.world;
        }
    }
}

#[test]
fn from_a_keyhole_to_nearly_all_of_the_half_space() {
    let canvas = &mut Canvas::new();
    for fovy in [0.1, 1.0, 20.0, 120.0, 170.0, 179.0] {
        for seed in 0..4 {
            let (world, pose, _) = changed(seed, DVec3::ZERO, 1.0);
            let lens = Lens { fovy, aspect: 1.0, ..LENS };
            let labelled = &mut Labelled::new(world);
            assert_agrees(&format!("fovy {fovy} {seed}"), canvas, labelled, (&pose, &lens), SIDE);
        }
    }
}

#[test]
fn what_has_no_finite_place_or_size_is_left_out_and_counted() {
    let mut world = World::new();
    world.spawn((Sphere { radius: f64::NAN }, Position::default()));
    world.spawn((Sphere { radius: 0.0 }, Position::default()));
    world.spawn((Sphere { radius: -3.0 }, Position::default()));
    world.spawn((Sphere { radius: 5.0 }, Position::new(0.0, f64::INFINITY, 0.0)));
    world.spawn((Cube { side: 1e60 }, Position::default()));
    world.spawn((Pyramid { width: 1.0, height: f64::INFINITY }, Position::default()));
    world.spawn((Checkerboard { cell: 0.0 }, Position::default()));
    world.spawn((Sphere { radius: 20.0 }, Position::new(0.0, 0.0, 50.0)));
    world.init_resource::<Drawn>();
    list_schedule().run(&mut world);
    assert_eq!(world.resource::<Drawn>().0.left_out(), 7);
    let camera = (&CameraPose::default(), &LENS);
    let shot = Canvas::new().draw(&mut world, camera, &PLAIN, 101);
    assert_eq!(shot.at(50, 50), [255, 255, 255]);
    assert_eq!(shot.at(1, 1), [0, 255, 0]);
    assert_eq!(shot.count(|pixel| pixel != [255; 3] && pixel != [0, 255, 0]), 0);
}

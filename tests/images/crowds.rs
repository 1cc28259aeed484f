//! Scenes of many objects: with trees, a picture is what it is without, to the bit.

use archetrace::components::CameraPose;
use archetrace::scene::{Description, ObjectDescription, ShapeDescription};
use archetrace::systems::{Tables, extract_schedule, prepare};
use bevy_ecs::prelude::World;
use glam::DVec3;

use crate::paths::check;
use crate::support::case::Case;
use crate::support::random::Random;
use crate::support::scenes::random_case;
use crate::support::tracing::workers;

/// How the objects of a crowd lie.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Crowd {
    /// Anywhere, of many sizes.
    Scattered,
    /// On a grid, side by side: faces and poles touch.
    Touching,
    /// Each one there several times.
    Repeated,
    /// Needles, flakes and pebbles far from the origin.
    Extreme,
    /// All in one place.
    Nested,
}

pub(crate) const CROWDS: [Crowd; 5] =
    [Crowd::Scattered, Crowd::Touching, Crowd::Repeated, Crowd::Extreme, Crowd::Nested];

/// Objects of all kinds with the surfaces of a random scene.
pub(crate) fn crowd(kind: Crowd, count: usize, seed: u64, pixels: u32) -> Case {
    let random = &mut Random::new(seed);
    let mut case = (seed..).map(|seed| random_case(seed * 977, pixels)).find(is_lively).unwrap();
    let surfaces: Vec<_> = case.description.objects.iter().map(|object| object.surface).collect();
    let mut objects: Vec<ObjectDescription> = Vec::with_capacity(count);
    for number in 0..count {
        let (position, shape) = place(kind, number, count, random);
        objects.push(ObjectDescription { position, shape, surface: random.pick(&surfaces) });
        if let Crowd::Repeated = kind
            && number % 3 == 2
        {
            objects[number].position = objects[number - 1].position;
            objects[number].shape = objects[number - 1].shape;
        }
    }
    case.description.objects = objects;
    case
}

/// Whether a scene has something to put objects' surfaces from, mirrors and light.
fn is_lively(case: &Case) -> bool {
    let Description { objects, lights, level, .. } = &case.description;
    objects.len() > 3 && !lights.is_empty() && *level > 2
}

fn place(kind: Crowd, number: usize, count: usize, random: &mut Random) -> (DVec3, ShapeDescription) {
    let spacing = 120.0 / (count as f64).cbrt();
    let size = spacing * random.between(0.1, 1.4);
    match kind {
        Crowd::Scattered | Crowd::Repeated => (random.point(60.0), shape(random.below(3), size, size, 0.5)),
        Crowd::Touching => {
            let side = (count as f64).cbrt().ceil() as usize;
            let cell = [number % side, number / side % side, number / side / side];
            let at =
                DVec3::from_array(cell.map(|index| index as f64)) * 4.0 - DVec3::splat(2.0 * side as f64);
            let which = number % 3;
            let middle = if which == 0 { DVec3::splat(2.0) } else { DVec3::ZERO };
            (at + middle, shape(which, 4.0, 4.0, 0.5))
        }
        Crowd::Extreme => {
            let far = DVec3::new(random.pick(&[0.0, 1e5, -3e6]), random.pick(&[0.0, 2e4]), 0.0);
            let height = size * random.pick(&[1e-4, 1.0, 300.0]);
            (
                random.point(60.0) + far * random.pick(&[0.0, 0.0, 1.0]),
                shape(random.below(3), size, height, 0.5),
            )
        }
        Crowd::Nested => (DVec3::ZERO, shape(number % 3, 1.0 + number as f64 * 0.01, 20.0, 1.0)),
    }
}

fn shape(which: usize, size: f64, height: f64, radii: f64) -> ShapeDescription {
    match which {
        0 => ShapeDescription::Sphere { radius: size * radii },
        1 => ShapeDescription::Cube { side: size },
        _ => ShapeDescription::Pyramid { width: size, height },
    }
}

fn check_both(name: &str, case: &Case) {
    check::<f64>(name, case);
    check::<f32>(name, case);
}

#[test]
fn crowds_of_some_hundreds() {
    for kind in CROWDS {
        for seed in 1..=6 {
            let count = 100 + 90 * seed as usize;
            check_both(&format!("{kind:?} {seed}"), &crowd(kind, count, seed, 37));
        }
    }
}

#[test]
fn crowds_about_as_small_as_trees_are() {
    for seed in 1..=12 {
        let count = 50 + 5 * seed as usize;
        check_both(&format!("small {seed}"), &crowd(Crowd::Scattered, count, 100 + seed, 37));
    }
}

#[test]
fn crowds_of_thousands() {
    for kind in CROWDS {
        check_both(&format!("{kind:?} thousands"), &crowd(kind, 6000, 31, 23));
    }
}

#[test]
fn a_crowd_of_a_hundred_thousand() {
    let mut case = crowd(Crowd::Scattered, 100_000, 77, 17);
    let eye = DVec3::new(90.0, -100.0, 70.0);
    case.pose = CameraPose::looking(eye, -eye, DVec3::Z).unwrap();
    check_both("a hundred thousand", &case);
}

#[test]
fn crowds_do_have_trees() {
    let mut world: World = crowd(Crowd::Scattered, 600, 1, 8).world();
    prepare::<f64>(&mut world, workers(1));
    extract_schedule::<f64>().run(&mut world);
    let trees = &world.resource::<Tables<f64>>().scene.trees;
    assert!(trees.spheres.is_some() && trees.cubes.is_some() && trees.pyramids.is_some());
}

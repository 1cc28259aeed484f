//! Rays almost within the plane of a face and almost through an edge, from afar and from close by: hit or miss, side and
//! face are those of exact arithmetic, with no tolerance, and every way of searching a scene says the same.

use archetrace::geometry::{CubeShape, Ray, Vector};
use archetrace::selfcheck::Random;
use glam::DVec3;

use crate::cube::check_aimed;
use crate::oracle::ExactVector;
use crate::precision::{Precision, ray};
use crate::pyramid::{Figures, Pyramid, check_random};
use crate::shown::check_shown;
use crate::worst::Worst;

/// Whether a ray is asked of whole scenes, too: one in twenty, unless its step is shorter than any length of a scene.
fn is_shown<T: Precision>(number: u64, ray: &Ray<T>) -> bool {
    number.is_multiple_of(20) && ray.direction.length().to_f64() * T::LENGTH_LIMIT >= 1.0
}

/// A point of an edge, a way along it, and a way up or down a side that ends there.
fn edge_and_side<T: Precision>(pyramid: &Pyramid<T>, random: &mut Random) -> [DVec3; 3] {
    let corners = pyramid.corners();
    let number = random.below(4) as usize;
    let (from, next) = (corners[number], corners[(number + 1) % 4]);
    let up = pyramid.apex() - 0.5 * (from + next);
    let to = if random.coin() { next } else { pyramid.apex() };
    [from + random.between(-0.2, 1.2) * (to - from), to - from, up]
}

/// A ray almost within the plane of a side and almost through one of its edges.
fn almost_along<T: Precision>(pyramid: &Pyramid<T>, random: &mut Random) -> Ray<T> {
    let size = pyramid.width.max(pyramid.height);
    let [edge, along, up] = edge_and_side(pyramid, random);
    let within = along + up * if random.coin() { 0.0 } else { random.between(-1.0, 1.0) };
    slipped(random, edge, within, size)
}

/// A ray almost through a point and almost along a way, often level.
fn slipped<T: Precision>(random: &mut Random, target: DVec3, way: DVec3, size: f64) -> Ray<T> {
    let tilt = random.direction() * size * random.magnitude(-20.0, -1.0);
    let mut way = (way + tilt) * if random.coin() { 1.0 } else { -1.0 };
    if random.coin() {
        way.z = 0.0;
    }
    let slip = if random.coin() { 0.0 } else { size * random.magnitude(-20.0, -1.0) };
    let target = target + random.direction() * slip;
    ray(target - way * random.magnitude(-5.0, 2.0), way * random.magnitude(-2.0, 2.0))
}

fn check_pyramids<T: Precision>(seed: u64) {
    println!("seeds from {seed:#x}");
    let mut figures = Figures::new::<T>("almost along sides");
    for number in 0..60_000 {
        let random = &mut Random::new(seed + number);
        let width = random.magnitude(-2.0, 2.0);
        let corner = random.direction() * random.magnitude(-2.0, 2.0);
        let pyramid = Pyramid::<T>::new(corner, width, width * random.magnitude(-1.0, 1.0));
        let ray = almost_along(&pyramid, random);
        // From within, a ray that starts on a face is not met by it: see the tests of exits.
        if !pyramid.body.contains(&ExactVector::of(ray.origin)) {
            check_random(&pyramid, &ray, &mut figures);
            if is_shown(number, &ray) {
                check_shown(&pyramid.shape, &ray);
            }
        }
    }
    assert!(figures.hits > 10_000 && figures.rays - figures.hits > 10_000);
}

#[test]
fn p10_rays_almost_along_a_side_are_met_as_exact_arithmetic_has_it_f64() {
    check_pyramids::<f64>(0x9_1005_0000);
}

#[test]
fn p10_rays_almost_along_a_side_are_met_as_exact_arithmetic_has_it_f32() {
    check_pyramids::<f32>(0x9_1006_0000);
}

/// A ray almost within a face of a cube and almost through one of its edges.
fn almost_within<T: Precision>(cube: &CubeShape<T>, random: &mut Random) -> Ray<T> {
    let (min, max) = (cube.min.to_dvec3(), cube.max.to_dvec3());
    let [first, second, third] = [0, 1, 2].map(|step| (random.below(3) as usize + step) % 3);
    let size = (max - min).max_element();
    let mut edge = min + (max - min) * random.between(-0.2, 1.2);
    edge[first] = if random.coin() { min[first] } else { max[first] };
    edge[second] = if random.coin() { min[second] } else { max[second] };
    let mut way = DVec3::ZERO;
    way[second] = size * if random.coin() { 0.0 } else { random.between(-1.0, 1.0) };
    way[third] = size * random.between(-1.0, 1.0);
    slipped(random, edge, way, size)
}

fn check_cubes<T: Precision>(seed: u64) {
    println!("seeds from {seed:#x}");
    let mut worst = Worst::new(&format!("cube, almost within faces, t, {}", T::NAME));
    let mut hits = 0;
    for number in 0..60_000 {
        let random = &mut Random::new(seed + number);
        let cube = CubeShape::<T>::new(
            random.direction() * random.magnitude(-2.0, 2.0),
            random.magnitude(-2.0, 2.0),
        );
        let ray = almost_within(&cube, random);
        hits += u32::from(ray.direction != Vector::default() && check_aimed(&cube, &ray, &mut worst));
        if is_shown(number, &ray) {
            check_shown(&cube, &ray);
        }
    }
    println!("cube, almost within faces, {}: {hits} of 60000 rays hit, all as exact", T::NAME);
    assert!((10_000..50_000).contains(&hits));
}

#[test]
fn b01_rays_almost_within_a_face_are_met_as_exact_arithmetic_has_it_f64() {
    check_cubes::<f64>(0xB_0100_0000);
}

#[test]
fn b01_rays_almost_within_a_face_are_met_as_exact_arithmetic_has_it_f32() {
    check_cubes::<f32>(0xB_0101_0000);
}

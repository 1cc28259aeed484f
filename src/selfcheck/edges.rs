//! Rays at edges, corners and planes.

use glam::DVec3;

use crate::geometry::{CubeShape, PlaneShape, PyramidShape, Ray, Real, Vector};

use super::random::Random;
use super::solid::{Solid, check, check_plane};
use super::tally::Tally;

/// A ray from somewhere around at a point, of any length.
fn aimed<T: Real>(random: &mut Random, target: DVec3, size: f64) -> Ray<T> {
    let origin = target + random.direction() * (size * random.magnitude(-1.0, 2.0));
    // As near to the point as a float can say, or beside it by a share of the size.
    let slip = if random.coin() { 0.0 } else { size * random.magnitude(-17.0, -1.0) };
    let direction = target + random.direction() * slip - origin;
    Ray {
        origin: Vector::from_dvec3(origin),
        direction: Vector::from_dvec3(direction * random.magnitude(-3.0, 3.0)),
    }
}

/// Powers of ten between which sizes are drawn.
fn sizes<T: Real>() -> f64 {
    if T::LENGTH_LIMIT < 1e60 { 2.0 } else { 8.0 }
}

/// Rays at the edges and corners of cubes.
pub fn check_cubes<T: Real>(rays: u64, seed: u64) -> Tally {
    let mut tally = Tally::new("cube, edges and corners", T::NAME);
    for number in 0..rays {
        let random = &mut Random::new(seed.wrapping_add(number));
        let size = random.magnitude(-sizes::<T>(), sizes::<T>());
        let side = size * random.magnitude(-2.0, 1.0);
        let cube = CubeShape::<T>::new(random.point() * size, side);
        let (min, max) = (cube.min.to_dvec3(), cube.max.to_dvec3());
        let free = random.below(4);
        let along = |random: &mut Random, axis: u64, low: f64, high: f64| match random.coin() {
            _ if axis == free => random.between(low, high),
            true => low,
            false => high,
        };
        let x = along(random, 0, min.x, max.x);
        let y = along(random, 1, min.y, max.y);
        let target = DVec3::new(x, y, along(random, 2, min.z, max.z));
        check(&mut tally, &cube, &aimed(random, target, cube.corner_to_corner()));
    }
    tally
}

/// Rays at the edges and corners of pyramids, from slivers to towers.
pub fn check_pyramids<T: Real>(rays: u64, seed: u64) -> Tally {
    let mut tally = Tally::new("pyramid, edges and corners", T::NAME);
    for number in 0..rays {
        let random = &mut Random::new(seed.wrapping_add(number));
        let width = random.magnitude(-sizes::<T>(), sizes::<T>());
        let height = width * random.magnitude(-3.0, 3.0);
        let corner = random.point() * width;
        let pyramid = PyramidShape::<T>::new(corner, width, height);
        let at_corner = |number: u64| {
            let [x, y] = match number % 4 {
                0 => [0.0, 0.0],
                1 => [1.0, 0.0],
                2 => [1.0, 1.0],
                _ => [0.0, 1.0],
            };
            corner + DVec3::new(x, y, 0.0) * width
        };
        let number = random.below(4);
        let from = at_corner(number);
        let to = if random.coin() { at_corner(number + 1) } else { pyramid.apex.to_dvec3() };
        let share = if random.below(8) == 0 { 1.0 } else { random.share() };
        let target = from + (to - from) * share;
        check(&mut tally, &pyramid, &aimed(random, target, pyramid.corner_to_corner()));
    }
    tally
}

/// Rays at planes, steep and grazing.
pub fn check_planes<T: Real>(rays: u64, seed: u64) -> Tally {
    let mut tally = Tally::new("plane", T::NAME);
    for number in 0..rays {
        let random = &mut Random::new(seed.wrapping_add(number));
        let size = random.magnitude(-sizes::<T>(), sizes::<T>());
        let plane = PlaneShape { height: T::from_f64(random.between(-1.0, 1.0) * size) };
        let mut direction = random.direction();
        direction.z *= random.magnitude(-8.0, 0.0);
        let ray = Ray {
            origin: Vector::from_dvec3(random.point() * size),
            direction: Vector::from_dvec3(direction * random.magnitude(-3.0, 3.0)),
        };
        check_plane(&mut tally, &plane, &ray);
    }
    tally
}

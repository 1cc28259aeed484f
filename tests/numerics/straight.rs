//! The kernels without branches against those with: the same bits, wherever the ray starts and ends.

use archetrace::geometry::{
    CubeShape, Meeting, PlaneShape, PyramidShape, Ray, SphereShape, Straight, Vector,
};
use glam::DVec3;

use crate::precision::{Precision, bits};
use archetrace::selfcheck::Random;

/// A ray from far, near, inside or on the surface, at times along an axis or through a point of it.
fn random_ray<T: Precision>(random: &mut Random, size: f64) -> Ray<T> {
    let far = random.magnitude(-3.0, 3.0);
    let mut origin = random.point() * size * far;
    if random.below(4) == 0 {
        origin = DVec3::from_array(core::array::from_fn(|_| size * random.whole(-2, 2) * 0.5));
    }
    let mut direction = random.direction();
    match random.below(4) {
        0 => direction = DVec3::from_array(core::array::from_fn(|_| random.whole(-1, 1))),
        1 => direction = random.point() * size - origin,
        _ => {}
    }
    if direction == DVec3::ZERO {
        direction = DVec3::X;
    }
    Ray { origin: Vector::from_dvec3(origin), direction: Vector::from_dvec3(direction) }
}

fn check<T: Precision>(shape: &impl Straight<T>, ray: &Ray<T>) -> bool {
    let truth = shape.intersect(ray);
    let met = shape.meet(ray);
    assert_eq!(shape.meet_surely(ray).crossing(), truth, "{ray:?}: {met:?}");
    assert!(shape.may_meet(ray) || truth.is_none(), "{ray:?}");
    if met.unsure || truth.is_none() {
        assert!(met.t.to_f64().is_nan());
    }
    let Some(truth) = truth else { return false };
    if !met.unsure {
        assert_eq!(met.t.bits(), truth.t.bits(), "{ray:?}");
    }
    let met = Meeting::from(truth);
    let (point, expected) = (shape.surface(ray, &met), shape.locate(ray, &truth));
    assert_eq!(bits(point.point), bits(expected.point), "{ray:?}");
    assert_eq!(bits(point.normal), bits(expected.normal), "{ray:?}");
    check_exit(shape, ray, truth.face);
    true
}

/// A ray that was found to leave on some face has its point there.
fn check_exit<T: Precision>(shape: &impl Straight<T>, ray: &Ray<T>, from: u8) {
    let exit = shape.exit(ray, from);
    if exit.t.is_finite() {
        let (point, expected) = (shape.surface(ray, &Meeting::from(exit)), shape.locate(ray, &exit));
        assert_eq!(bits(point.point), bits(expected.point), "{ray:?}");
        assert_eq!(bits(point.normal), bits(expected.normal), "{ray:?}");
    }
}

fn check_shapes<T: Precision>(seed: u64) {
    let mut hits = [0; 4];
    for number in 0..200_000 {
        let random = &mut Random::new(seed + number);
        let size = random.magnitude(-2.0, 2.0);
        let ray = &random_ray::<T>(random, size);
        let place = if random.coin() { DVec3::ZERO } else { random.point() * size };
        let second = if random.coin() { size } else { size * random.magnitude(-3.0, 3.0) };
        let sphere = SphereShape { center: Vector::from_dvec3(place), radius: T::from_f64(size) };
        hits[0] += usize::from(check(&sphere, ray));
        hits[1] += usize::from(check(&CubeShape::<T>::new(place, size), ray));
        hits[2] += usize::from(check(&PyramidShape::<T>::new(place, size, second), ray));
        hits[3] += usize::from(check(&PlaneShape { height: T::from_f64(place.z) }, ray));
    }
    println!("{}: hits {hits:?}", T::NAME);
    assert!(hits.iter().all(|&hits| hits > 20_000), "{hits:?}");
}

/// Lines that all but touch a sphere, from near and far: what is not worth a look is met by none.
fn check_grazing<T: Precision>(seed: u64) {
    let mut counts = [0; 2];
    for number in 0..200_000 {
        let random = &mut Random::new(seed + number);
        let size = random.magnitude(-6.0, 6.0);
        let center = random.point() * size * random.magnitude(-2.0, 2.0);
        let sphere = SphereShape::<T> { center: Vector::from_dvec3(center), radius: T::from_f64(size) };
        let normal = random.direction();
        let along = normal.cross(random.direction()).normalize();
        let rim = center + normal * size * (1.0 + random.between(-20.0, 20.0) * T::ULP.to_f64());
        let direction = along * random.magnitude(-3.0, 3.0);
        let origin = rim - along * size * random.magnitude(-2.0, 3.0);
        let ray = Ray { origin: Vector::from_dvec3(origin), direction: Vector::from_dvec3(direction) };
        counts[usize::from(check(&sphere, &ray))] += 1;
    }
    assert!(counts.iter().all(|&count| count > 20_000), "{counts:?}");
}

#[test]
fn lines_that_graze_a_sphere_are_looked_at() {
    check_grazing::<f64>(0x7_0300_0000);
    check_grazing::<f32>(0x7_0400_0000);
}

#[test]
fn every_shape_is_the_same_without_branches_f64() {
    check_shapes::<f64>(0x7_0100_0000);
}

#[test]
fn every_shape_is_the_same_without_branches_f32() {
    check_shapes::<f32>(0x7_0200_0000);
}

//! Mirror reflection: length, plane and angle against exact arithmetic.

use archetrace::effects::reflect;
use archetrace::geometry::Vector;
use glam::DVec3;

use crate::oracle::{ExactVector, exact, nearest, small_angle};
use crate::precision::{Precision, bits};
use crate::worst::Worst;
use archetrace::selfcheck::Random;

#[test]
fn straight_and_slanted_reflections_are_exact() {
    let to = |direction: DVec3, normal: DVec3| {
        reflect::<f64>(Vector::from_dvec3(direction), Vector::from_dvec3(normal)).to_dvec3()
    };
    assert_eq!(to(DVec3::NEG_Z, DVec3::Z), DVec3::Z);
    assert_eq!(to(DVec3::new(0.6, 0.0, -0.8), DVec3::Z), DVec3::new(0.6, 0.0, 0.8));
    assert_eq!(to(DVec3::X, DVec3::Z), DVec3::X);
}

#[test]
fn both_sides_of_a_mirror_give_the_same_bits() {
    for number in 0..10_000 {
        let random = &mut Random::new(0x3_0100_0000 + number);
        let direction = Vector::<f64>::from_dvec3(random.direction());
        let normal = Vector::from_dvec3(random.direction());
        assert_eq!(bits(reflect(direction, normal)), bits(reflect(direction, -normal)));
    }
}

/// A mirror half way between being level and steep, and one that is grazed.
fn check<T: Precision>(seed: u64) {
    let mut length = Worst::new(&format!("mirror, length, {}", T::NAME));
    let mut angle = Worst::new(&format!("mirror, angle, {}", T::NAME));
    for number in 0..20_000 {
        let random = &mut Random::new(seed + number);
        let normal = Vector::<T>::from_dvec3(random.direction()).unit();
        let free = if random.coin() {
            random.direction()
        } else {
            let axis = normal.to_dvec3();
            random.across(axis) - axis * random.magnitude(-12.0, -1.0)
        };
        let direction = Vector::<T>::from_dvec3(free).unit();
        let found = reflect(direction, normal);
        let describe = || format!("{direction:?} {normal:?}");

        let unit = ExactVector::of(found);
        let stretch = nearest(&(unit.dot(&unit) - exact(1.0))).abs() / 2.0;
        // Squares, sums, root and quotient: at most two epsilons together.
        length.measure(stretch / T::EPSILON, 2.0, describe);

        let (d, n) = (ExactVector::of(direction), ExactVector::of(normal));
        let twice = exact(2.0) * d.dot(&n) / n.dot(&n);
        let truth = d.minus(&n.times(&twice));
        // The normal's own length counts twice, its product with the ray and the difference once each.
        angle.measure(small_angle(&unit, &truth) / T::EPSILON, 4.0, describe);
    }
}

#[test]
fn random_reflections_keep_length_and_angle_f64() {
    check::<f64>(0x3_0001_0000);
}

#[test]
fn random_reflections_keep_length_and_angle_f32() {
    check::<f32>(0x3_0002_0000);
}

#[test]
fn a_thousand_reflections_do_not_change_the_length() {
    let random = &mut Random::new(0x3_0200_0000);
    let mut direction = Vector::<f64>::from_dvec3(random.direction());
    for _ in 0..1_000 {
        direction = reflect(direction, Vector::from_dvec3(random.direction()));
    }
    assert!((direction.length() - 1.0).abs() <= 2.0 * f64::EPSILON);
}

//! Spot cones: the cutoff itself, narrow and wide, against exact sine and cosine.

use archetrace::components::range;
use archetrace::effects::Cone;
use archetrace::geometry::Vector;
use glam::DVec3;

use crate::oracle::{Exact, ExactVector, exact, nearest, sine_cosine};
use crate::precision::Precision;
use archetrace::selfcheck::Random;

fn cone<T: Precision>(axis: DVec3, cutoff: f64) -> Cone<T> {
    Cone::new(Vector::from_dvec3(axis), cutoff)
}

/// A vector at an angle in radians from an axis.
fn aside(axis: DVec3, across: DVec3, angle: f64) -> DVec3 {
    axis * angle.cos() + across * angle.sin()
}

/// Just inside and outside of the cutoff at each whole degree, around random axes.
fn check_whole_degrees<T: Precision>(slip: f64, power: f64) {
    for degrees in 1..180_u8 {
        let random = &mut Random::new(0x1_0700 + u64::from(degrees));
        let cutoff = f64::from(degrees);
        for _ in 0..20 {
            let axis = random.direction();
            let across = random.across(axis);
            let cone = cone::<T>(axis * random.extreme(power), cutoff);
            let length = random.extreme(power);
            let inside = |angle: f64| cone.contains(Vector::from_dvec3(aside(axis, across, angle) * length));
            let angle = cutoff.to_radians();
            assert!(inside(angle - slip), "{cutoff} around {axis}");
            assert!(!inside(angle + slip), "{cutoff} around {axis}");
        }
    }
}

#[test]
fn l07_whole_degrees_are_kept_to_a_billionth_of_a_radian_f64() {
    check_whole_degrees::<f64>(1e-9, 6.0);
}

#[test]
fn l07_whole_degrees_are_kept_to_a_millionth_of_a_radian_f32() {
    check_whole_degrees::<f32>(1e-6, 6.0);
}

#[test]
fn l07_whole_degrees_are_kept_at_all_allowed_lengths_f64() {
    check_whole_degrees::<f64>(1e-9, 70.0);
}

#[test]
fn l07_whole_degrees_are_kept_at_all_allowed_lengths_f32() {
    check_whole_degrees::<f32>(1e-6, 9.0);
}

#[test]
fn l07_the_cutoff_itself_is_inside_where_floats_can_say_it() {
    fn check<T: Precision>(below: f64) {
        let lit = |x: f64, z: f64, cutoff| {
            cone::<T>(DVec3::Z, cutoff).contains(Vector::from_dvec3(DVec3::new(x, 0.0, z)))
        };
        assert!(lit(1.0, 0.0, 90.0) && !lit(1.0, below, 90.0));
        assert!(lit(0.0, -1.0, 180.0));
        assert!(lit(0.0, 1.0, 0.0));
    }
    check::<f64>(-1e-15);
    check::<f32>(-1e-6);
}

#[test]
fn l07_the_cutoff_itself_is_inside_at_45_and_135_degrees() {
    fn check<T: Precision>() {
        let lit = |x: f64, z: f64, cutoff| {
            cone::<T>(DVec3::Z, cutoff).contains(Vector::from_dvec3(DVec3::new(x, 0.0, z)))
        };
        for length in [1.0, 3.0, 0.1, 1e6] {
            let places = [lit(length, length, 45.0), lit(length, -length, 135.0)];
            assert_eq!(places, [true, true], "at {length}");
        }
    }
    check::<f64>();
    check::<f32>();
}

/// Sine of the angle between axis and vector beyond the cutoff, and whether exact arithmetic has it inside.
fn beyond<T: Precision>(axis: Vector<T>, v: Vector<T>, cutoff: f64) -> (f64, bool) {
    let (axis, v) = (ExactVector::of(axis), ExactVector::of(v));
    let (sine, cosine) = sine_cosine(&exact(cutoff));
    let along = axis.dot(&v);
    let excess = axis.cross(&v).length() * &cosine - &along * sine;
    let ahead = cosine <= Exact::ZERO || along > Exact::ZERO;
    let inside = excess <= Exact::ZERO && ahead;
    (nearest(&(excess / (axis.length() * v.length()))), inside)
}

/// Random cones from a thousandth of a degree up, and vectors at their cutoff to within a few roundings.
fn check_near_cutoff<T: Precision>(finest: f64, power: f64, seed: u64) {
    let (mut near, mut wrong) = (0, 0);
    let mut farthest = 0.0_f64;
    for number in 0..4_000 {
        let random = &mut Random::new(seed + number);
        let cutoff = if random.coin() { random.magnitude(-3.0, 1.0) } else { random.between(0.0, 180.0) };
        let axis = random.direction();
        let angle = cutoff.to_radians() + random.between(-1.0, 1.0) * random.magnitude(finest, finest + 5.0);
        let v = aside(axis, random.across(axis), angle) * random.extreme(power);
        let axis = axis * random.extreme(power);
        let (axis, v) = (Vector::<T>::from_dvec3(axis), Vector::<T>::from_dvec3(v));
        let (excess, truth) = beyond(axis, v, cutoff);
        near += u32::from(excess.abs() <= 4.0 * T::EPSILON);
        if Cone::new(axis, cutoff).contains(v) != truth {
            wrong += 1;
            farthest = farthest.max(excess.abs() / T::EPSILON);
            assert!(excess.abs() <= 4.0 * T::EPSILON, "{axis:?} {v:?} {cutoff}: {excess:e}");
        }
    }
    println!(
        "spot, at the cutoff, {}: 4000 vectors, {near} within 4 epsilon, {wrong} told otherwise, up to {farthest:.2}",
        T::NAME
    );
    assert!(near > 500 && near < 3_500);
}

#[test]
fn l08_l09_the_cutoff_is_kept_to_4_epsilon_f64() {
    check_near_cutoff::<f64>(-17.0, 70.0, 0x1_0901_0000);
}

#[test]
fn l08_l09_the_cutoff_is_kept_to_4_epsilon_f32() {
    check_near_cutoff::<f32>(-8.5, 9.0, 0x1_0902_0000);
}

#[test]
fn l08_vectors_along_the_axis_are_inside_however_their_product_rounds() {
    fn check<T: Precision>(cutoff: f64) {
        for number in 0..20_000 {
            let random = &mut Random::new(0x1_0800_0000 + number);
            let axis = random.direction();
            let v = aside(axis, random.across(axis), random.magnitude(-18.0, -8.0));
            assert!(cone::<T>(axis, cutoff).contains(Vector::from_dvec3(v)), "{axis} {v}");
        }
    }
    // Wider than what rounding the two directions may turn them by.
    check::<f64>(1e-5);
    check::<f32>(1e-3);
}

#[test]
fn l09_a_hundredth_of_a_degree_is_kept_to_a_billionth_of_itself() {
    fn check<T: Precision>(slip: f64) {
        let random = &mut Random::new(0x1_0900);
        let angle = 0.01_f64.to_radians();
        for _ in 0..1_000 {
            let axis = random.direction();
            let across = random.across(axis);
            let cone = cone::<T>(axis, 0.01);
            let inside = |angle| cone.contains(Vector::from_dvec3(aside(axis, across, angle)));
            assert!(inside(angle - slip) && !inside(angle + slip), "{}", T::NAME);
        }
    }
    check::<f64>(1e-9 * 0.01_f64.to_radians());
    // Rounding two directions to single numbers moves each by up to an epsilon.
    check::<f32>(2.0 * f64::from(f32::EPSILON));
}

#[test]
fn l10_cutoff_0_lights_the_axis_and_nothing_else() {
    fn check<T: Precision>(slip: f64) {
        for axis in [DVec3::X, DVec3::Y, DVec3::NEG_Z] {
            let cone = cone::<T>(axis, 0.0);
            for length in [1e-6, 1.0, 3.0, 1e6] {
                assert!(cone.contains(Vector::from_dvec3(axis * length)));
                assert!(!cone.contains(Vector::from_dvec3(-axis * length)));
            }
            let beside = axis + DVec3::new(axis.y, axis.z, axis.x) * slip;
            assert!(!cone.contains(Vector::from_dvec3(beside)));
        }
    }
    check::<f64>(1e-12);
    check::<f32>(1e-5);
}

#[test]
fn l10_cutoff_0_lights_its_own_target() {
    // The target lies on the axis exactly: the vector to it is the axis.
    let mut dark = 0;
    for number in 0..1_000 {
        let random = &mut Random::new(0x1_1000_0000 + number);
        let axis = DVec3::new(random.whole(-9, 9), random.whole(-9, 9), random.whole(1, 9));
        dark += u32::from(!cone::<f64>(axis, 0.0).contains(Vector::from_dvec3(axis)));
        dark += u32::from(!cone::<f32>(axis, 0.0).contains(Vector::from_dvec3(axis)));
    }
    assert_eq!(dark, 0, "of 1000 targets in two precisions");
}

#[test]
fn l10_cutoff_180_lights_everything() {
    for number in 0..20_000 {
        let random = &mut Random::new(0x1_1001_0000 + number);
        let axis = random.direction();
        let v = if random.coin() { -axis } else { random.direction() };
        assert!(cone::<f64>(axis, 180.0).contains(Vector::from_dvec3(v)), "{axis} {v}");
        assert!(cone::<f32>(axis, 180.0).contains(Vector::from_dvec3(v)), "{axis} {v}");
    }
}

#[test]
fn l10_a_narrow_cone_lights_nothing_behind() {
    for number in 0..20_000 {
        let random = &mut Random::new(0x1_1002_0000 + number);
        let axis = random.direction();
        let cutoff = random.between(0.0, 89.9);
        let behind = aside(-axis, random.across(axis), random.magnitude(-18.0, -3.0));
        assert!(!cone::<f64>(axis, cutoff).contains(Vector::from_dvec3(behind)), "{axis} {cutoff}");
        assert!(!cone::<f32>(axis, cutoff).contains(Vector::from_dvec3(behind)), "{axis} {cutoff}");
    }
}

#[test]
fn l10_a_cutoff_beyond_180_degrees_is_refused() {
    for cutoff in [-1e-300, 180.0_f64.up(), f64::NAN] {
        assert!(!range::CUTOFF.contains(cutoff));
    }
    assert!(range::CUTOFF.contains(0.0) && range::CUTOFF.contains(180.0));
}

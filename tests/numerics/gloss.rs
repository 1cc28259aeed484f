//! Highlights: gates at the dark side, and digits at the highest shininess.

use archetrace::components::range;
use archetrace::effects::phong;
use archetrace::geometry::Vector;
use glam::DVec3;

use crate::oracle::{ExactVector, exact, from_long, long, nearest};
use crate::precision::Precision;
use crate::worst::Worst;
use archetrace::selfcheck::Random;

/// The highlight for vectors at this cosine from each other.
fn at<T: Precision>(cosine: f64, shininess: f64) -> T {
    let light = Vector::from_dvec3(DVec3::new(cosine, (1.0 - cosine * cosine).sqrt(), 0.0));
    phong(Vector::from_dvec3(DVec3::X), light, T::from_f64(shininess))
}

#[test]
fn l12_away_from_the_mirror_there_is_no_highlight() {
    for shininess in [0.0, 0.3, 1.0, 10.0, 11.0, 1e9] {
        for cosine in [-1.0, -0.5, -1e-300, -0.0, 0.0] {
            assert_eq!(at::<f64>(cosine, shininess).bits(), 0.0_f64.bits(), "{cosine} {shininess}");
            assert_eq!(at::<f32>(cosine, shininess).bits(), 0.0_f32.bits(), "{cosine} {shininess}");
        }
    }
}

#[test]
fn l13_shininess_0_lights_all_before_the_mirror_and_nothing_behind() {
    fn check<T: Precision>(least: f64) {
        for cosine in [1.0, 0.5, least] {
            assert_eq!(at::<T>(cosine, 0.0), T::ONE);
        }
        assert_eq!(at::<T>(0.0, 0.0), T::ZERO);
        assert_eq!(at::<T>(-0.5, 0.0), T::ZERO);
    }
    check::<f64>(1e-300);
    check::<f32>(1e-37);
}

#[test]
fn l13_in_the_mirror_direction_the_highlight_is_full() {
    for shininess in [0.0, 0.5, 7.0, 1e6, 1e9] {
        assert_eq!(at::<f64>(1.0, shininess), 1.0);
        assert_eq!(at::<f32>(1.0, shininess), 1.0);
    }
    assert_eq!((at::<f64>(0.5, 3.0), at::<f32>(0.5, 3.0)), (0.125, 0.125));
}

#[test]
fn l15_a_shininess_below_zero_is_refused() {
    for shininess in [-1.0, -1e-300, f64::NAN, f64::INFINITY] {
        assert!(!range::SHININESS.contains(shininess));
    }
    assert!(range::SHININESS.contains(0.0));
}

/// A rounding of the cosine counts `shininess` times: up to three halves of an epsilon by products and sums, of which
/// the cosine itself is the smaller the more they cancel. The power adds one epsilon.
fn check_digits<T: Precision>(seed: u64) {
    let mut worst = Worst::new(&format!("gloss / bound, {}", T::NAME));
    for number in 0..3_000 {
        let random = &mut Random::new(seed + number);
        let shininess = T::from_f64(random.magnitude(-1.0, 6.0));
        let mirrored = random.direction();
        let spread = random.magnitude(-1.0, 0.5) / shininess.to_f64().sqrt().max(1.0);
        let light = Vector::<T>::from_dvec3((mirrored + random.across(mirrored) * spread).normalize());
        let mirrored = Vector::<T>::from_dvec3(mirrored);
        let cosine = ExactVector::of(mirrored).dot(&ExactVector::of(light));
        let power = long(&cosine).ln() * long(&exact(shininess));
        let truth = from_long(power.exp());
        let found = phong(mirrored, light, shininess);
        let error = nearest(&(exact(found) - &truth)).abs() / (nearest(&truth) * T::EPSILON);
        let bound = 1.0 + 1.5 * shininess.to_f64() / nearest(&cosine);
        worst.measure(error / bound, 1.0, || format!("{mirrored:?} {light:?} {shininess}"));
    }
}

#[test]
fn l14_random_highlights_keep_their_digits_up_to_shininess_1e6_f64() {
    check_digits::<f64>(0x1_1401_0000);
}

#[test]
fn l14_random_highlights_keep_their_digits_up_to_shininess_1e6_f32() {
    check_digits::<f32>(0x1_1402_0000);
}

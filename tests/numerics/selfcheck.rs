//! The self-check: its arithmetic against fractions, that it finds what is wrong, and a million rays of each kind.

use archetrace::geometry::{Convex, Crossing, Side};
use archetrace::selfcheck::{
    Aim, Double, SEED, Tally, check_cubes, check_leaving, check_pyramids, check_spheres,
};

use crate::oracle::{Exact, exact, magnitude, nearest, square_root};
use crate::precision::Precision;
use crate::textbook;
use archetrace::selfcheck::Random;

/// Of every result, at most so much is lost.
const LOSS: f64 = 1e-31;

fn exactly(value: Double) -> Exact {
    let (high, low) = value.parts();
    exact(high) + exact(low)
}

fn check_error(what: &str, found: Double, truth: &Exact) {
    let error = magnitude(exactly(found) - truth);
    let allowed = magnitude(truth.clone()) * exact(LOSS);
    assert!(error <= allowed, "{what}: {found:?} is off by {:e}", nearest(&error));
}

/// A number of all its digits.
fn any(random: &mut Random) -> Double {
    let (high, low) = (random.between(-1.0, 1.0) * random.magnitude(-9.0, 9.0), random.between(-1.0, 1.0));
    Double::of(high) + Double::of(low * high * f64::EPSILON * 0.3)
}

#[test]
fn sums_products_quotients_and_roots_have_31_digits() {
    for number in 0..20_000 {
        let random = &mut Random::new(0xDD_0000 + number);
        let (a, b) = (any(random), any(random));
        let (x, y) = (exactly(a), exactly(b));
        check_error("product", a * b, &(&x * &y));
        check_error("quotient", a / b, &(&x / &y));
        check_error("root", a.abs().sqrt(), &square_root(&magnitude(x.clone())));
        // Of a sum that cancels only what its parts could hold is kept.
        let sum = magnitude(exactly(a + b) - (&x + &y));
        assert!(sum <= (magnitude(x.clone()) + magnitude(y.clone())) * exact(LOSS));
        let difference = magnitude(exactly(a - b) - (&x - &y));
        assert!(difference <= (magnitude(x.clone()) + magnitude(y.clone())) * exact(LOSS));
        assert_eq!(a < b, x < y);
    }
}

#[test]
fn one_digit_beside_another_is_told_apart() {
    let one = Double::of(1.0_f64);
    let tiny = Double::of(f64::EPSILON * f64::EPSILON);
    assert!(one + tiny > one && one - tiny < one);
    assert_eq!(((one + tiny) - one).nearest(), f64::EPSILON * f64::EPSILON);
}

#[test]
fn a_textbook_sphere_is_found_to_be_wrong() {
    let textbook = |aim| {
        check_spheres::<f64>(aim, 2_000, SEED, |sphere, ray| {
            let t = textbook::near_root(sphere, ray).filter(|&t| t > 0.0)?;
            Some(Crossing { t, face: 0, side: Side::Outside })
        })
    };
    for aim in [Aim::Far, Aim::Planet] {
        let tally = textbook(aim);
        assert!(!tally.is_good());
        assert!(tally.worst > 1e6, "{tally}");
    }
    assert!(textbook(Aim::Rim).false_hits > 10);
}

fn assert_good(tally: &Tally) {
    println!("selfcheck, seed {SEED:#x}: {tally}");
    assert!(tally.is_good(), "{tally}");
    assert_eq!((tally.leaks, tally.false_hits), (0, 0), "{tally}");
}

fn check_a_million<T: Precision>() {
    println!("selfcheck, seed {SEED:#x}: {}", Tally::header());
    for aim in Aim::ALL {
        let tally = check_spheres::<T>(aim, 1_000_000, SEED, |sphere, ray| sphere.intersect(ray));
        assert_good(&tally);
        // `wrong` counts what is beyond the bound that can be proved, which is 6.3 for rays 0.95 radii off the centre.
        assert!(tally.errors[4] == 0 && tally.worst <= 4.0, "{tally}");
    }
    assert_good(&check_cubes::<T>(1_000_000, SEED));
    assert_good(&check_pyramids::<T>(1_000_000, SEED));
    assert_good(&check_leaving::<T>(1_000_000, SEED));
}

#[test]
fn a_million_rays_of_each_kind_f64() {
    check_a_million::<f64>();
}

#[test]
fn a_million_rays_of_each_kind_f32() {
    check_a_million::<f32>();
}

//! Turns of a camera against exact rotations, and the basis after a million moves.

use archetrace::geometry::{Vector, basis_looking, head_left, raise, tilt, turn_left, turn_up};
use glam::DVec3;

use crate::camera::skew;
use crate::oracle::{Exact, ExactVector, exact, nearest, sine_cosine};
use crate::worst::Worst;
use archetrace::selfcheck::Random;

type Basis = [DVec3; 3];
type Turn = fn(Basis, f64) -> Option<Basis>;

/// How a camera is turned at the start.
pub(crate) const AXES: Basis = [DVec3::Y, DVec3::X, DVec3::Z];
/// Turns about an axis of the camera, each with the places of what moves (the first towards the second) and stays.
const TURNS: [(Turn, [usize; 3]); 3] = [(turn_left, [1, 0, 2]), (turn_up, [0, 2, 1]), (tilt, [2, 1, 0])];
const ALL: [Turn; 4] = [turn_left, turn_up, tilt, head_left];

pub(crate) fn random_basis(random: &mut Random) -> Basis {
    basis_looking(random.direction(), random.direction()).unwrap()
}

/// Of any size, from far below a rounding error to many turns.
fn random_angle(random: &mut Random) -> f64 {
    let size = match random.below(4) {
        0 => random.magnitude(-12.0, 0.0),
        1 => random.magnitude(2.5, 15.0),
        _ => random.between(0.0, 360.0),
    };
    if random.coin() { size } else { -size }
}

pub(crate) fn of(v: DVec3) -> ExactVector {
    ExactVector::of(Vector::<f64>::from_dvec3(v))
}

/// How far a vector is from the truth, in epsilons.
pub(crate) fn error(found: DVec3, truth: &ExactVector) -> f64 {
    nearest(&of(found).minus(truth).length()) / f64::EPSILON
}

fn bits(basis: Basis) -> [[u64; 3]; 3] {
    basis.map(|v| v.to_array().map(f64::to_bits))
}

/// Skew in plain floating point, for where the exact one would take too long; good to about an epsilon.
fn rough_skew([l, r, u]: Basis) -> f64 {
    let lengths = [l, r, u].map(|v| (v.length_squared() - 1.0).abs() / 2.0);
    let angles = [l.dot(r), l.dot(u), r.dot(u)].map(f64::abs);
    lengths.into_iter().chain(angles).chain([r.cross(l).distance(u)]).fold(0.0, f64::max) / f64::EPSILON
}

/// `v` turned about z, exactly.
fn about_z(v: DVec3, sine: &Exact, cosine: &Exact) -> ExactVector {
    let [x, y, z] = of(v).0;
    ExactVector([&x * cosine - &y * sine, &y * cosine + &x * sine, z])
}

#[test]
fn signs_left_is_away_from_r_up_is_towards_u_and_the_picture_tilts_counter_clockwise() {
    let [l, r, u] = AXES;
    assert_eq!(turn_left(AXES, 90.0), Some([-r, l, u]));
    assert_eq!(turn_up(AXES, 90.0), Some([u, r, -l]));
    // What was on the right of the picture is at its top: u has tipped towards r.
    assert_eq!(tilt(AXES, 90.0), Some([l, -u, r]));
    assert_eq!(head_left(AXES, 90.0), turn_left(AXES, 90.0));
    let on_its_head = [l, -r, -u];
    assert_eq!(head_left(on_its_head, 90.0), Some([r, l, -u]), "left is where the picture has it");
}

#[test]
fn random_turns_about_the_cameras_own_axes_are_the_exact_rotation() {
    let mut worst = Worst::new("turn, against the exact rotation");
    for number in 0..6_000 {
        let random = &mut Random::new(0xCB_0100_0000 + number);
        let basis = random_basis(random);
        let degrees = random_angle(random);
        let (sine, cosine) = sine_cosine(&exact(degrees));
        for (turn, [a, b, axis]) in TURNS {
            let turned = turn(basis, degrees).unwrap();
            let [from, towards] = [of(basis[a]), of(basis[b])];
            let first = from.times(&cosine).plus(&towards.times(&sine));
            let second = towards.times(&cosine).minus(&from.times(&sine));
            let describe = || format!("{basis:?} by {degrees}: {turned:?}");
            worst.measure(error(turned[a], &first), 4.0, describe);
            worst.measure(error(turned[b], &second), 4.0, describe);
            assert_eq!(turned[axis], basis[axis], "the axis keeps its bits: {}", describe());
        }
    }
}

#[test]
fn random_headings_are_the_exact_rotation_about_z() {
    let mut worst = Worst::new("heading, against the exact rotation");
    for number in 0..6_000 {
        let random = &mut Random::new(0xCB_0200_0000 + number);
        let basis = random_basis(random);
        let degrees = random_angle(random);
        let turned = head_left(basis, degrees).unwrap();
        let upright = if basis[2].z < 0.0 { -degrees } else { degrees };
        let (sine, cosine) = sine_cosine(&exact(upright));
        for (before, after) in basis.into_iter().zip(turned) {
            let truth = about_z(before, &sine, &cosine);
            worst.measure(error(after, &truth), 5.0, || format!("{basis:?} by {degrees}: {turned:?}"));
        }
    }
}

#[test]
fn huge_angles_lose_no_digit() {
    // Whole degrees: the remainder by 360 is taken in whole numbers, which round nothing.
    for power in 0..=100_u32 {
        let degrees = 2.0_f64.powi(20 + i32::try_from(power).unwrap());
        let remainder = (0..20 + power).fold(1_u32, |rest, _| rest * 2 % 360);
        for turn in ALL {
            assert_eq!(turn(AXES, degrees), turn(AXES, f64::from(remainder)), "2^{}", 20 + power);
            assert_eq!(turn(AXES, -degrees), turn(AXES, -f64::from(remainder)));
        }
    }
    for turn in ALL {
        let basis = turn(AXES, f64::MAX).unwrap();
        assert!(skew(basis) <= 4.0);
    }
}

#[test]
fn four_right_angles_return_to_the_bit_from_anywhere() {
    for number in 0..2_000 {
        let random = &mut Random::new(0xCB_0300_0000 + number);
        let basis = if number == 0 { AXES } else { random_basis(random) };
        for turn in ALL {
            for degrees in [90.0, -90.0, 270.0, 36_000_000_090.0] {
                let turned = (0..4).fold(basis, |basis, _| turn(basis, degrees).unwrap());
                assert_eq!(turned, basis, "four times {degrees}");
            }
            for degrees in [0.0, 360.0, -720.0, 3.6e17] {
                assert_eq!(turn(basis, degrees), Some(basis), "{degrees}");
            }
        }
    }
}

#[test]
fn right_angles_lead_from_axes_to_axes_without_a_minus_zero() {
    let mut basis = AXES;
    let random = &mut Random::new(0xCB_0400_0000);
    for _ in 0..10_000 {
        let turn = ALL[random.below(4) as usize];
        basis = turn(basis, random.whole(-9, 9) * 90.0).unwrap();
        for coordinate in basis.iter().flat_map(|v| v.to_array()) {
            assert!([0.0_f64, 1.0, -1.0].map(f64::to_bits).contains(&coordinate.to_bits()), "{basis:?}");
        }
        assert_eq!(basis[2], basis[1].cross(basis[0]));
    }
}

#[test]
fn there_and_back_is_where_it_was_to_a_few_digits_of_the_last_place() {
    let mut worst = Worst::new("turn there and back");
    for number in 0..20_000 {
        let random = &mut Random::new(0xCB_0500_0000 + number);
        let basis = random_basis(random);
        let degrees = random_angle(random);
        for turn in ALL {
            let back = turn(turn(basis, degrees).unwrap(), -degrees).unwrap();
            let away = (0..3).map(|axis| back[axis].distance(basis[axis])).fold(0.0, f64::max);
            worst.measure(away / f64::EPSILON, 8.0, || format!("{basis:?} by {degrees}"));
        }
    }
}

#[test]
fn a_million_turns_of_every_kind_leave_the_basis_orthonormal() {
    let mut rough = Worst::new("basis after each of a million turns, roughly");
    let mut sharp = Worst::new("basis after a million turns, exactly");
    let random = &mut Random::new(0xCB_0600_0000);
    let (mut position, mut basis, mut distance) = (DVec3::new(0.0, -150.0, 50.0), AXES, 150.0);
    for number in 0..1_000_000 {
        let turn = ALL[random.below(4) as usize];
        if random.below(8) != 0 {
            let degrees = if random.coin() { random_angle(random) } else { random.whole(-1, 1) * 5.0 };
            basis = turn(basis, degrees).unwrap();
        } else if let Some(raised) = raise(position, basis, distance, random.between(-50.0, 50.0)) {
            (position, basis, distance) = (raised.position, raised.basis, 150.0);
        }
        rough.measure(rough_skew(basis), 4.5, || format!("after {number}: {basis:?}"));
        if number % 1_000 == 999 {
            sharp.measure(skew(basis), 4.0, || format!("after {number}: {basis:?}"));
        }
    }
}

#[test]
fn the_same_small_turn_a_million_times_stays_orthonormal_and_arrives() {
    for (turn, [a, b, _]) in TURNS {
        let start = basis_looking(DVec3::new(0.3, 0.8, -0.2), DVec3::Z).unwrap();
        for degrees in [1e-9, -3e-7, 1e-4] {
            let turned = (0..1_000_000).fold(start, |basis, _| turn(basis, degrees).unwrap());
            assert!(skew(turned) <= 4.0, "{degrees}: {turned:?}");
            let whole = turn(start, degrees * 1e6).unwrap();
            // Half an epsilon a turn at most, were every rounding to go the same way, for each of two vectors.
            for axis in [a, b] {
                let away = turned[axis].distance(whole[axis]);
                assert!(away <= 1e6 * f64::EPSILON, "{degrees}: {away:e}");
            }
        }
    }
}

#[test]
fn looking_around_keeps_a_level_horizon_to_the_bit() {
    let random = &mut Random::new(0xCB_0700_0000);
    let (mut position, mut basis, mut distance) = (DVec3::ZERO, AXES, 150.0);
    for _ in 0..1_000_000 {
        match random.below(3) {
            0 => basis = head_left(basis, random_angle(random)).unwrap(),
            1 => basis = turn_up(basis, random_angle(random)).unwrap(),
            _ => {
                if let Some(raised) = raise(position, basis, distance, random.between(-9.0, 9.0)) {
                    (position, basis, distance) = (raised.position, raised.basis, raised.distance);
                }
            }
        }
        assert_eq!(basis[1].z, 0.0, "{basis:?}");
    }
}

#[test]
fn the_pointer_drags_the_same_way_upright_and_on_the_head() {
    for degrees in [-20.0, 3.0] {
        let [l, r, u] = turn_up(AXES, 20.0).unwrap();
        for basis in [[l, r, u], [l, -r, -u]] {
            let turned = head_left(basis, degrees).unwrap();
            assert!(turned[0].dot(basis[1]) * degrees < 0.0, "left is away from r: {turned:?}");
        }
    }
}

#[test]
fn no_turn_without_a_finite_angle_or_a_basis() {
    for turn in ALL {
        for degrees in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(turn(AXES, degrees), None);
        }
        assert_eq!(turn([DVec3::NAN; 3], 5.0), None);
        assert_eq!(turn([DVec3::ZERO; 3], 5.0), None);
    }
}

#[test]
fn no_turn_leaves_a_minus_zero() {
    for turn in ALL {
        for degrees in [5.0, -5.0, 90.0, 180.0, 1e-9, 12_345.0] {
            let basis = turn(AXES, degrees).unwrap();
            let minus_zero = (-0.0_f64).to_bits();
            assert!(!bits(basis).as_flattened().contains(&minus_zero), "{degrees}: {basis:?}");
        }
    }
}

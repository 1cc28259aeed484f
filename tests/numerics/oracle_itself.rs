//! The oracle against cases worked out by hand.

use archetrace::geometry::{Side, Vector};

use crate::oracle::{
    Ball, Body, Exact, ExactRay, ExactVector, Meeting, decimal, exact, floor_is_odd, from_long, long,
    nearest, relative_error, sine_cosine, small_angle, square_root,
};
use crate::precision::{Precision, ray};

fn line(origin: [f64; 3], direction: [f64; 3]) -> ExactRay {
    ExactRay::of::<f64>(&ray(origin.into(), direction.into()))
}

fn unit_cube() -> Body {
    Body::cube(Vector::new(0.0, 0.0, 0.0), Vector::new(1.0, 1.0, 1.0))
}

/// Base from -1/2 to 1/2 at height 0, apex at height 1.
fn unit_pyramid() -> Body {
    Body::pyramid(Vector::new(0.0, 0.0, 1.0), 0.0, 0.5, 1.0)
}

fn meeting(t: &str, face: u8, side: Side) -> Option<Meeting> {
    Some(Meeting { t: decimal(t), face, side })
}

#[test]
fn decimals_are_read_exactly() {
    assert_eq!(decimal("-1.25e1"), exact(-12.5));
    assert_eq!(decimal("0.5"), exact(0.5));
    assert_eq!(decimal("0.1") * exact(10.0), Exact::ONE);
    assert_ne!(decimal("0.1"), exact(0.1));
    assert_eq!(decimal("3e-2") * exact(100.0), exact(3.0));
}

#[test]
fn floats_are_taken_as_they_are_and_given_back_rounded_to_even() {
    let tiny = exact(2.0_f64.powi(-60));
    assert_eq!(nearest(&(Exact::ONE + &tiny)), 1.0);
    let tie = Exact::ONE + exact(f64::EPSILON / 2.0);
    assert_eq!(f64::rounded(&tie), 1.0);
    assert_eq!(f64::rounded(&(tie + tiny)), 1.0_f64.up());
    assert_eq!(f32::rounded(&decimal("0.1")), 0.1_f32);
    assert_eq!(exact(-0.0), Exact::ZERO);
    assert_eq!(relative_error(1.5, &exact(2.0)), 0.25);
}

#[test]
fn square_roots_are_good_to_200_bits() {
    assert_eq!(square_root(&exact(2.25)), exact(1.5));
    assert_eq!(square_root(&Exact::ZERO), Exact::ZERO);
    for number in [decimal("2"), decimal("3e-40"), decimal("7e40") / decimal("3")] {
        let root = square_root(&number);
        let error = (root.sqr() - &number) / number;
        assert!(nearest(&error).abs() < 1e-60);
    }
}

#[test]
fn long_functions_agree_with_known_digits() {
    let (sine, cosine) = sine_cosine(&exact(60.0));
    assert!(nearest(&(cosine - exact(0.5))).abs() < 1e-70);
    assert!(nearest(&(sine.sqr() - exact(0.75))).abs() < 1e-70);
    let (sine, cosine) = sine_cosine(&exact(179.0));
    assert_eq!((nearest(&sine), nearest(&cosine)), (0.017_452_406_437_283_51, -0.999_847_695_156_391_3));
    let e = from_long(long(&Exact::ONE).exp());
    let digits = decimal("2.71828182845904523536028747135266249775724709369995");
    assert!(nearest(&(e - digits)).abs() < 1e-49);
    let third = from_long(long(&(Exact::ONE / decimal("3")).clone()));
    assert!(nearest(&(third * decimal("3") - Exact::ONE)).abs() < 1e-80);
}

#[test]
fn angles_are_measured_by_their_sine() {
    let x = ExactVector::of(Vector::new(1.0, 0.0, 0.0));
    let near = ExactVector::of(Vector::new(3.0, 4.0, 0.0));
    assert!((small_angle(&x, &near) - 0.8).abs() < 1e-15);
    assert_eq!(small_angle(&near, &near.times(&exact(7.0))), 0.0);
}

#[test]
fn a_cube_is_met_where_a_ray_enters_or_from_within_leaves() {
    let cube = unit_cube();
    assert_eq!(cube.meet(&line([-1.0, 0.5, 0.5], [2.0, 0.0, 0.0])), meeting("0.5", 0, Side::Outside));
    assert_eq!(cube.meet(&line([0.5, 0.5, 0.5], [0.0, 0.0, 4.0])), meeting("0.125", 5, Side::Inside));
    assert_eq!(cube.meet(&line([2.0, 0.5, 0.5], [1.0, 0.0, 0.0])), None);
    assert_eq!(cube.meet(&line([-1.0, 1.5, 0.5], [1.0, 0.0, 0.0])), None);
}

#[test]
fn a_cube_is_closed_and_the_lowest_face_wins_a_tie() {
    let cube = unit_cube();
    assert_eq!(cube.meet(&line([-1.0, 1.0, 0.5], [1.0, 0.0, 0.0])), meeting("1", 0, Side::Outside));
    assert_eq!(cube.meet(&line([-1.0, -1.0, -1.0], [1.0, 1.0, 1.0])), meeting("1", 0, Side::Outside));
    // Over the edge x = 0, y = 1 in one point.
    assert_eq!(cube.meet(&line([-1.0, 0.0, 0.5], [1.0, 1.0, 0.0])), meeting("1", 0, Side::Outside));
    // On the boundary, inwards: the start itself does not count.
    assert_eq!(cube.meet(&line([0.0, 0.5, 0.5], [1.0, 0.0, 0.0])), meeting("1", 1, Side::Inside));
    assert_eq!(cube.meet(&line([1.0, 0.5, 0.5], [1.0, 0.0, 0.0])), None);
}

#[test]
fn a_pyramid_is_met_on_sides_base_and_apex() {
    let pyramid = unit_pyramid();
    assert_eq!(pyramid.meet(&line([-1.0, 0.0, 0.5], [1.0, 0.0, 0.0])), meeting("0.75", 0, Side::Outside));
    assert_eq!(pyramid.meet(&line([0.0, 1.0, 0.5], [0.0, -1.0, 0.0])), meeting("0.75", 3, Side::Outside));
    assert_eq!(pyramid.meet(&line([0.1, 0.1, -1.0], [0.0, 0.0, 1.0])), meeting("1", 4, Side::Outside));
    assert_eq!(pyramid.meet(&line([0.0, 0.0, 5.0], [0.0, 0.0, -1.0])), meeting("4", 0, Side::Outside));
    assert_eq!(pyramid.meet(&line([-1.0, 0.0, 1.1], [1.0, 0.0, 0.0])), None);
}

#[test]
fn the_exit_of_a_cube_is_the_nearest_of_the_faces_a_ray_heads_for() {
    let exit = |origin, direction| unit_cube().exit(&line(origin, direction));
    assert_eq!(exit([0.5, 0.5, 0.5], [1.0, 0.5, -0.25]), Some((exact(0.5), 1)));
    assert_eq!(exit([0.5, 0.5, 0.5], [-0.5, 1.0, -2.0]), Some((exact(0.25), 4)));
    assert_eq!(exit([2.0, 0.5, 0.5], [1.0, 0.0, 0.0]), Some((exact(-1.0), 1)));
}

#[test]
fn a_grown_body_reaches_farther_by_that_length() {
    let grown = unit_cube().grown(&[0.25; 6]);
    assert_eq!(grown.meet(&line([-1.0, 1.25, 0.5], [1.0, 0.0, 0.0])), meeting("0.75", 0, Side::Outside));
    assert_eq!(grown.meet(&line([-1.0, 1.26, 0.5], [1.0, 0.0, 0.0])), None);
    let corner = ExactVector::of(Vector::new(1.25, 1.25, 1.25));
    assert!(grown.contains(&corner) && !unit_cube().contains(&corner));
}

#[test]
fn a_ball_is_met_at_the_root_ahead() {
    let ball = Ball::of(Vector::new(0.0, 0.0, 0.0), 1.0);
    let at = |origin, direction| ball.meet(&line(origin, direction));
    assert_eq!(at([-5.0, 0.0, 0.0], [2.0, 0.0, 0.0]), meeting("2", 0, Side::Outside));
    assert_eq!(at([-5.0, 1.0, 0.0], [1.0, 0.0, 0.0]), meeting("5", 0, Side::Outside));
    assert_eq!(at([0.0, 0.0, 0.5], [0.0, 0.0, 1.0]), meeting("0.5", 0, Side::Inside));
    assert_eq!(at([0.0, 0.0, 1.0], [0.0, 0.0, -1.0]), meeting("2", 0, Side::Inside));
    assert_eq!(at([0.0, 0.0, 1.0], [0.0, 0.0, 1.0]), None);
    assert_eq!(at([-5.0, 1.0_f64.up(), 0.0], [1.0, 0.0, 0.0]), None);
    assert_eq!(at([5.0, 0.0, 0.0], [1.0, 0.0, 0.0]), None);
}

#[test]
fn parity_is_that_of_the_floor() {
    let odd = |x: &str| floor_is_odd(&decimal(x), &Exact::ONE);
    assert!(odd("-0.5") && odd("-1") && odd("-1e-17") && odd("1.5") && odd("9007199254740993"));
    assert!(!odd("0") && !odd("0.5") && !odd("-1.5") && !odd("-2") && !odd("9007199254740992.5"));
    assert!(floor_is_odd(&decimal("0.3"), &decimal("0.3")));
}

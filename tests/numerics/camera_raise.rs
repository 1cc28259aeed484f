//! An eye that is raised while it looks at one point: against the exact rotation, closed forms, and where it must stay.

use archetrace::components::CameraPose;
use archetrace::geometry::{Raised, raise, tilt, turn_up};
use glam::DVec3;

use crate::camera::skew;
use crate::camera_moves::{AXES, error, of, random_basis};
use crate::oracle::{Exact, ExactVector, exact, magnitude, nearest};
use crate::worst::Worst;
use archetrace::selfcheck::Random;

/// The rotation that takes one unit vector to another along the shortest way, exactly (Rodrigues).
fn shortest(from: &ExactVector, to: &ExactVector, v: &ExactVector) -> ExactVector {
    let axis = from.cross(to);
    let cosine = from.dot(to);
    let along = axis.dot(v) / (Exact::ONE + &cosine);
    v.times(&cosine).plus(&axis.cross(v)).plus(&axis.times(&along))
}

#[test]
fn raised_the_camera_looks_at_the_same_point_by_the_smallest_rotation() {
    let mut look = Worst::new("raise, look");
    let mut rest = Worst::new("raise, smallest rotation");
    let mut far = Worst::new("raise, distance");
    let mut square = Worst::new("raise, basis");
    for number in 0..6_000 {
        let random = &mut Random::new(0xCB_0800_0000 + number);
        let basis = random_basis(random);
        let position = random.point() * random.magnitude(-3.0, 9.0);
        let distance = random.magnitude(-1.0, 4.0);
        let height = random.between(-3.0, 3.0) * distance;
        let raised = raise(position, basis, distance, height).unwrap();
        let describe = || format!("{position:?} {basis:?} {distance} by {height}: {raised:?}");
        assert_eq!(raised.position, position + DVec3::Z * height);

        let point = of(position).plus(&of(basis[0]).times(&exact(distance)));
        let sight = point.minus(&of(raised.position));
        let length = sight.length();
        let truth = sight.times(&(Exact::ONE / &length));
        // Where the eye comes close to the point, the roundings of `distance * l` and of the climb count for more.
        let near = (distance + height.abs()) / raised.distance;
        look.measure(error(raised.basis[0], &truth) / near, 4.0, describe);
        let off = nearest(&magnitude(exact(raised.distance) / &length - Exact::ONE)) / f64::EPSILON;
        far.measure(off / near, 4.0, describe);

        // The closer to half a turn, the less is known of the way.
        let halfway = (basis[0] + raised.basis[0]).length();
        for axis in [1, 2] {
            let truth = shortest(&of(basis[0]), &truth, &of(basis[axis]));
            rest.measure(error(raised.basis[axis], &truth) * halfway / near, 8.0, describe);
        }
        square.measure(skew(raised.basis), 4.0, describe);
    }
}

#[test]
fn raised_from_the_start_closed_forms() {
    let start = CameraPose::default();
    let basis = [start.l, start.r, start.u];
    let half = 0.5_f64.sqrt();
    // 45 degrees, and the triangle of 3, 4 and 5.
    for (height, look, up, distance) in [
        (150.0, [half, -half], [half, half], 150.0 * 2.0_f64.sqrt()),
        (112.5, [0.8, -0.6], [0.6, 0.8], 187.5),
        (-112.5, [0.8, 0.6], [-0.6, 0.8], 187.5),
    ] {
        let raised = raise(start.position, basis, 150.0, height).unwrap();
        let [l, r, u] = raised.basis;
        assert_eq!(raised.position, DVec3::new(0.0, -150.0, 50.0 + height));
        assert_eq!(r, DVec3::X);
        assert!(l.distance(DVec3::new(0.0, look[0], look[1])) <= 2.0 * f64::EPSILON, "{l:?}");
        assert!(u.distance(DVec3::new(0.0, up[0], up[1])) <= 2.0 * f64::EPSILON, "{u:?}");
        assert!((raised.distance / distance - 1.0).abs() <= f64::EPSILON);
    }
}

#[test]
fn up_and_down_ten_thousand_times_the_point_stays() {
    for tilted in [0.0, 40.0] {
        let start = CameraPose::default();
        let basis = tilt([start.l, start.r, start.u], tilted).unwrap();
        let (mut position, mut now, mut distance) = (start.position, basis, 150.0);
        let point = position + distance * now[0];
        let mut worst = Worst::new(&format!("w and s, angle to the point in epsilons, tilted by {tilted}"));
        for number in 0..20_000 {
            // Up to 5000 above and 5000 below.
            let height = if (number / 1000) % 4 == 1 || (number / 1000) % 4 == 2 { -5.0 } else { 5.0 };
            let raised = raise(position, now, distance, height).unwrap();
            (position, now, distance) = (raised.position, raised.basis, raised.distance);
            let angle = now[0].cross(point - position).length() / (point - position).length();
            worst.measure(angle / f64::EPSILON, 2_000.0, || format!("after {number}"));
        }
        assert_eq!(position, start.position);
        let away = (0..3).map(|axis| now[axis].distance(basis[axis])).fold(0.0, f64::max);
        assert!(away <= 2_000.0 * f64::EPSILON, "{away:e}");
        assert!((distance / 150.0 - 1.0).abs() <= 2_000.0 * f64::EPSILON);
    }
}

#[test]
fn an_eye_that_would_land_on_the_point_or_turn_half_way_round_stays() {
    let up = [DVec3::Z, DVec3::X, DVec3::NEG_Y];
    let down = [DVec3::NEG_Z, DVec3::X, DVec3::Y];
    for position in [DVec3::ZERO, DVec3::new(3.0, -7.0, 11.0)] {
        for (basis, away) in [(up, 1.0), (down, -1.0)] {
            // Straight up, on the point, past it; back is a way without a turn.
            assert_eq!(raise(position, basis, 150.0, away * 150.0), None);
            for height in [151.0, 300.0, 1e9] {
                assert_eq!(raise(position, basis, 150.0, away * height), None, "{height}");
            }
            for height in [145.0, 5.0, -5.0, -1e9] {
                let raised = raise(position, basis, 150.0, away * height).unwrap();
                assert_eq!((raised.basis, raised.distance), (basis, 150.0 - height));
            }
        }
    }
    // By rounding alone beside the point, the direction would be rounding alone.
    let nearly_up = turn_up(AXES, 90.0 - 1e-8).unwrap();
    assert_eq!(raise(DVec3::ZERO, nearly_up, 150.0, 150.0), None);
    assert_eq!(raise(DVec3::ZERO, nearly_up, 150.0, 155.0), None);
}

#[test]
fn past_the_point_with_room_to_turn_a_level_horizon_stays_level() {
    // 4.7 degrees beside the vertical: the look swings from up to down between two steps.
    let mut basis = turn_up(AXES, 85.3).unwrap();
    let (mut position, mut distance) = (DVec3::ZERO, 150.0);
    for _ in 0..60 {
        let raised = raise(position, basis, distance, 5.0).unwrap();
        (position, basis, distance) = (raised.position, raised.basis, raised.distance);
        assert_eq!(basis[1], DVec3::X);
        assert!(basis[2].z > 0.0);
    }
    assert!(basis[0].z < -0.99);
}

#[test]
fn no_raise_where_numbers_end() {
    let origin = DVec3::ZERO;
    for height in [0.0, f64::NAN, f64::INFINITY, f64::MAX] {
        assert_eq!(raise(origin, AXES, 150.0, height), None, "{height}");
    }
    for distance in [0.0, -150.0, f64::NAN, f64::INFINITY, 1e200] {
        assert_eq!(raise(origin, AXES, distance, 5.0), None, "{distance}");
    }
    // So far up that five units are less than a rounding error: the eye does not move, so it must not turn.
    assert_eq!(raise(DVec3::Z * 1e20, AXES, 150.0, 5.0), None);
    // Far up, what counts is where the eye is, not where it should be: 5 units are rounded to 4 there.
    let high = DVec3::Z * 2.0_f64.powi(54);
    let raised = raise(high, AXES, 150.0, 5.0).unwrap();
    assert_eq!(raised.position.z - high.z, 4.0);
    assert_eq!(
        raised,
        raise(origin, AXES, 150.0, 4.0).map(|low| Raised { position: raised.position, ..low }).unwrap()
    );
}

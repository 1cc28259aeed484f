//! Glass: Snell's and Fresnel's laws, in forms other than the kernel's.

use archetrace::effects::{Split, split, split_at_sheet};
use archetrace::geometry::{Real, Vector};
use glam::DVec3;

use crate::precision::bits;
use archetrace::selfcheck::Random;

/// A ray that meets the plane z = 0 from above at an angle in radians.
fn ray(angle: f64, turn: f64) -> DVec3 {
    DVec3::new(angle.sin() * turn.cos(), angle.sin() * turn.sin(), -angle.cos())
}

fn at_plane<T: Real>(direction: DVec3, ratio: f64) -> Split<T> {
    let up = Vector::from_dvec3(DVec3::Z);
    split(Vector::from_dvec3(direction), up, T::from_f64(ratio))
}

/// An angle, a turn, and a ratio of indices at which not everything is reflected.
fn random_refraction(number: u64) -> (f64, f64, f64) {
    let random = &mut Random::new(0x6_0000 + number);
    let ratio = 0.2 + 2.0 * random.share();
    let steepest = f64::min(1.0 / ratio, 1.0).asin();
    (steepest * (0.01 + 0.98 * random.share()), 6.0 * random.share(), ratio)
}

#[test]
fn sines_are_in_the_ratio_of_the_indices() {
    fn check<T: Real>() {
        for number in 0..50_000 {
            let (angle, turn, ratio) = random_refraction(number);
            let direction = Vector::<T>::from_dvec3(ray(angle, turn));
            let ratio = T::from_f64(ratio);
            let refracted =
                split(direction, Vector::from_dvec3(DVec3::Z), ratio).refracted.unwrap().to_dvec3();
            let wanted = direction.to_dvec3() * ratio.to_f64();
            let eps = T::ULP.to_f64();
            for (found, wanted) in [(refracted.x, wanted.x), (refracted.y, wanted.y)] {
                assert!((found - wanted).abs() <= 4.0 * eps, "{number}: {found}, not {wanted}");
            }
            assert!((refracted.length() - 1.0).abs() <= 2.0 * eps && refracted.z < 0.0, "{number}");
        }
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn any_plane_refracts_within_that_of_ray_and_normal() {
    for number in 0..50_000 {
        let random = &mut Random::new(0x6_1000_0000 + number);
        let (normal, free) = (random.direction(), random.direction());
        let direction = if free.dot(normal) > 0.0 { -free } else { free };
        let ratio = 0.2 + 0.8 * random.share();
        let found = split::<f64>(Vector::from_dvec3(direction), Vector::from_dvec3(normal), ratio);
        let refracted = found.refracted.unwrap().to_dvec3();
        let residual = (refracted - direction * ratio).cross(normal).length();
        assert!(residual <= 8.0 * f64::EPSILON, "{number}: {residual:e}");
        assert!(refracted.dot(normal) < 0.0);
    }
}

#[test]
fn reflection_is_total_from_exactly_the_critical_angle_on() {
    for (index, sine) in [(2.0, 0.5), (4.0, 0.25), (1.25, 0.8), (1.6, 0.625)] {
        let at = |sine: f64| DVec3::new(sine, 0.0, -(1.0 - sine * sine).sqrt());
        for beyond in [sine, f64::next_up(sine), 0.99] {
            let Split { reflected, refracted } = at_plane::<f64>(at(beyond), index);
            assert!(reflected == 1.0 && refracted.is_none(), "index {index}, sine {beyond}");
        }
        let Split { reflected, refracted } = at_plane::<f64>(at(sine.next_down()), index);
        assert!(reflected < 1.0 && refracted.is_some(), "index {index}");
    }
}

#[test]
fn what_is_not_reflected_is_transmitted() {
    for number in 0..50_000 {
        let (angle, turn, ratio) = random_refraction(number);
        let reflected = at_plane::<f64>(ray(angle, turn), ratio).reflected;
        // Fresnel's own form, in angles.
        let refracted = (ratio * angle.sin()).asin();
        let both = (2.0 * angle).sin() * (2.0 * refracted).sin();
        let perpendicular = both / (angle + refracted).sin().powi(2);
        let parallel = perpendicular / (angle - refracted).cos().powi(2);
        let sum = reflected + (perpendicular + parallel) / 2.0;
        // Close to the critical angle the arc sine above loses more than the kernel does.
        let condition = 1.0 / refracted.cos();
        assert!((sum - 1.0).abs() <= 16.0 * f64::EPSILON * condition * condition, "{number}: {sum}");
    }
}

#[test]
fn fresnel_s_shares_are_those_of_the_textbooks() {
    for index in [1.1, 1.33, 1.5, 2.4] {
        let head_on = ((index - 1.0) / (index + 1.0_f64)).powi(2);
        // At Brewster's angle, whose tangent is the index, one polarisation is not reflected at all.
        let brewster = 0.5 * ((index * index - 1.0) / (index * index + 1.0)).powi(2);
        for (angle, share) in [(0.0, head_on), (index.atan(), brewster)] {
            let found = at_plane::<f64>(ray(angle, 0.3), 1.0 / index).reflected;
            assert!((found - share).abs() <= 1e-15, "index {index}: {found}, not {share}");
        }
        let grazing = at_plane::<f64>(DVec3::X, 1.0 / index).reflected;
        assert_eq!(grazing, 1.0);
    }
}

#[test]
fn a_ray_can_be_turned_back() {
    for number in 0..50_000 {
        let (angle, turn, ratio) = random_refraction(number);
        let direction = ray(angle, turn);
        let there = at_plane::<f64>(direction, ratio);
        let down = Vector::from_dvec3(DVec3::NEG_Z);
        let back = split(-there.refracted.unwrap(), down, 1.0 / ratio);
        // What a rounded sine does to a cosine, and that to the share.
        let condition = f64::min(direction.z.abs(), there.refracted.unwrap().z.abs()).powi(-2);
        assert!((back.reflected - there.reflected).abs() <= 8.0 * f64::EPSILON * condition, "{number}");
    }
}

#[test]
fn a_ratio_of_1_is_no_boundary() {
    for number in 0..1000 {
        let random = &mut Random::new(0x6_2000_0000 + number);
        let direction = Vector::from_dvec3(random.direction());
        let found = split::<f64>(direction, Vector::from_dvec3(random.direction()), 1.0);
        assert_eq!(found.reflected, 0.0);
        assert_eq!(bits(found.refracted.unwrap()), bits(direction));
    }
}

#[test]
fn a_sheet_reflects_the_sum_of_all_turns_within_it() {
    for number in 0..1000 {
        let (angle, turn, index) = (1.5 * f64::from(number) / 1000.0, 0.7, 1.5);
        let direction = ray(angle, turn);
        let face = at_plane::<f64>(direction, 1.0 / index).reflected;
        let up = Vector::from_dvec3(DVec3::Z);
        let sheet = split_at_sheet(Vector::from_dvec3(direction), up, 1.0 / index);
        let turns: f64 = (0..2000).map(|turn| face.powi(2 * turn)).sum();
        let sum = face + (1.0 - face).powi(2) * face * turns;
        assert!((sheet.reflected - sum).abs() < 1e-14, "{number}: {} and {sum}", sheet.reflected);
        assert_eq!(bits(sheet.refracted.unwrap()), bits(Vector::<f64>::from_dvec3(direction)));
    }
}

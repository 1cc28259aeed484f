//! Rays through and along edges of pyramids: each is met exactly where it is, so nothing passes between two that touch.

use archetrace::geometry::{Convex, Ray};
use archetrace::selfcheck::Random;
use glam::DVec3;

use crate::oracle::ExactRay;
use crate::precision::{Precision, ray};
use crate::pyramid::{Figures, Pyramid, check_random, unit};
use crate::shown::check_shown;

/// A ray down through a point of the edge x = 1/2 on the ground, in sixteenths: exactly so, or past it by a few roundings.
fn towards_common_edge<T: Precision>(random: &mut Random, slipped: bool) -> Ray<T> {
    let sixteenths = |random: &mut Random, low: i32, high: i32| random.whole(low, high) / 16.0;
    let edge = DVec3::new(0.5, sixteenths(random, -8, 8), 0.0);
    let step =
        DVec3::new(sixteenths(random, -64, 64), sixteenths(random, -64, 64), sixteenths(random, -64, -1));
    if !slipped {
        return ray(edge - step, step);
    }
    let slip = DVec3::X * random.between(-4.0, 4.0).round() * random.share() * T::EPSILON;
    let origin = edge - step * (1.0 + random.share());
    ray(origin, edge + slip - origin)
}

/// Unit pyramids side by side.
fn neighbours<T: Precision>() -> [Pyramid<T>; 2] {
    [unit(), Pyramid::new(DVec3::new(0.5, -0.5, 0.0), 1.0, 1.0)]
}

#[test]
fn p10_rays_exactly_through_a_common_base_edge_hit_both_pyramids() {
    fn check<T: Precision>() {
        let pair = neighbours::<T>();
        for number in 0..50_000 {
            let random = &mut Random::new(0x9_1000_0000 + number);
            let ray = towards_common_edge(random, false);
            for pyramid in &pair {
                let truth = pyramid.body.meet(&ExactRay::of(&ray)).unwrap();
                let hit = pyramid.shape.intersect(&ray).unwrap();
                let found = (hit.t, hit.face, hit.side);
                assert_eq!(found, (T::rounded(&truth.t), truth.face, truth.side), "{ray:?}");
                if number < 100 {
                    pyramid.check_surface(&ray, truth.face);
                    check_shown(&pyramid.shape, &ray);
                }
            }
        }
    }
    check::<f64>();
    check::<f32>();
}

/// Each of two pyramids is met where it truly is, and so no ray passes between them but beside the ends of their edge.
fn check_common_edge<T: Precision>(seed: u64) {
    let pair = neighbours::<T>();
    let mut counts = [0; 3];
    for number in 0..50_000 {
        let ray = towards_common_edge::<T>(&mut Random::new(seed + number), true);
        let exact_ray = ExactRay::of(&ray);
        let mut hits = 0;
        for pyramid in &pair {
            let is_met = pyramid.shape.intersect(&ray).is_some();
            assert_eq!(is_met, pyramid.body.meet(&exact_ray).is_some(), "{ray:?}");
            hits += usize::from(is_met);
        }
        counts[hits] += 1;
    }
    println!("pyramid, common edge, {}: of 50000 rays {counts:?} hit none, one and both", T::NAME);
}

/// A level ray along a face of a pyramid, a few roundings to either side of its plane; mostly along its edge at the base.
fn along_side<T: Precision>(pyramid: &Pyramid<T>, random: &mut Random) -> Ray<T> {
    let apex = pyramid.apex();
    let down = if random.below(4) == 0 { random.share() } else { 1.0 };
    let foot = if down == 1.0 { pyramid.corner.z } else { apex.z - down * pyramid.height };
    let aside = 0.5 * pyramid.width * down * if random.coin() { 1.0 } else { -1.0 };
    let mut slipped = |value: f64| value + random.whole(-2, 2) * 0.5 * T::EPSILON * value.abs();
    let (x, z) = (slipped(apex.x + aside), slipped(foot));
    let y = apex.y + pyramid.width * random.between(-3.0, 3.0);
    let way = random.magnitude(-2.0, 2.0) * if random.coin() { 1.0 } else { -1.0 };
    if random.coin() {
        ray(DVec3::new(x, y, z), DVec3::Y * way)
    } else {
        ray(DVec3::new(apex.x + (y - apex.y), apex.y + (x - apex.x), z), DVec3::X * way)
    }
}

fn check_along_sides<T: Precision>(seed: u64) {
    let mut figures = Figures::new::<T>("along sides");
    for number in 0..40_000 {
        let random = &mut Random::new(seed + number);
        let width = random.magnitude(-2.0, 2.0);
        let corner = random.direction() * random.magnitude(-2.0, 2.0);
        let pyramid = Pyramid::<T>::new(corner, width, width * random.magnitude(-1.0, 1.0));
        check_random(&pyramid, &along_side(&pyramid, random), &mut figures);
    }
    assert!(figures.hits > 5_000 && figures.rays - figures.hits > 5_000);
}

#[test]
fn p10_rays_along_a_base_edge_are_met_as_exact_arithmetic_has_it_f64() {
    check_along_sides::<f64>(0x9_1003_0000);
}

#[test]
fn p10_rays_along_a_base_edge_are_met_as_exact_arithmetic_has_it_f32() {
    check_along_sides::<f32>(0x9_1004_0000);
}

#[test]
fn p10_between_pyramids_with_a_common_base_edge_there_is_no_gap_f64() {
    check_common_edge::<f64>(0x9_1001_0000);
}

#[test]
fn p10_between_pyramids_with_a_common_base_edge_there_is_no_gap_f32() {
    check_common_edge::<f32>(0x9_1002_0000);
}

//! The plane of the checkerboard: parallel, grazing, from above and below, and level with a cube.

use archetrace::geometry::{Convex, CubeShape, PlaneShape, Side, Vector};
use glam::DVec3;

use crate::oracle::{Exact, ExactRay, ExactVector, HalfSpace, exact, magnitude, nearest, relative_error};
use crate::precision::{Precision, bits, ray};
use crate::shown::check_shown;
use crate::worst::Worst;
use archetrace::selfcheck::Random;

const GROUND: PlaneShape<f64> = PlaneShape { height: 0.0 };

fn ground<T: Precision>() -> PlaneShape<T> {
    PlaneShape { height: T::ZERO }
}

/// One difference and one quotient, half an epsilon each.
const T_BOUND: f64 = 1.0 + 1e-6;

/// A ray from above or below must meet the ground at `t`, with the normal towards where it comes from, and a scene must
/// show it there.
fn check_hit_in<T: Precision>(origin: DVec3, direction: DVec3, t: f64) {
    let ray = ray::<T>(origin, direction);
    let hit = ground().intersect(&ray).unwrap();
    assert_eq!((hit.t.to_f64(), hit.face, hit.side), (t, 0, Side::Outside));
    let found = ground().locate(&ray, &hit);
    let there = origin + direction * t;
    assert_eq!(found.point.to_dvec3(), there.with_z(0.0));
    assert_eq!(found.point.z.bits(), T::ZERO.bits());
    let side = if direction.z < 0.0 { DVec3::Z } else { DVec3::NEG_Z };
    assert_eq!(found.normal.to_dvec3(), side);
    check_shown(&ground(), &ray);
}

fn check_hit(origin: DVec3, direction: DVec3, t: f64) {
    check_hit_in::<f64>(origin, direction, t);
    check_hit_in::<f32>(origin, direction, t);
}

fn check_miss_in<T: Precision>(origin: DVec3, direction: DVec3) {
    let ray = ray::<T>(origin, direction);
    assert_eq!(ground().intersect(&ray), None);
    check_shown(&ground(), &ray);
}

fn check_miss(origin: DVec3, direction: DVec3) {
    check_miss_in::<f64>(origin, direction);
    check_miss_in::<f32>(origin, direction);
}

#[test]
fn c01_parallel_to_the_plane_is_a_miss() {
    for zero in [0.0, -0.0] {
        check_miss(DVec3::Z, DVec3::new(1.0, 0.0, zero));
        check_miss(DVec3::NEG_Z, DVec3::new(0.3, -1.0, zero));
    }
}

#[test]
fn c02_within_the_plane_is_a_miss() {
    for zero in [0.0, -0.0] {
        for level in [0.0, -0.0] {
            check_miss(DVec3::new(1.0, 2.0, level), DVec3::new(1.0, 0.0, zero));
        }
    }
}

#[test]
fn c03_a_grazing_ray_is_met_far_away_to_the_last_digit() {
    fn check<T: Precision>() {
        let ray = ray::<T>(DVec3::Z, DVec3::new(1.0, 0.0, -1e-9).normalize());
        let hit = ground().intersect(&ray).unwrap();
        assert_eq!((hit.face, hit.side), (0, Side::Outside));
        let truth = Exact::ONE / exact(-ray.direction.z);
        assert!(relative_error(hit.t, &truth) <= T_BOUND * T::EPSILON);
        assert!((hit.t.to_f64() - 1e9).abs() <= 1e9 * T::EPSILON);
        let found = ground().locate(&ray, &hit);
        assert!(relative_error(found.point.x, &(exact(ray.direction.x) * truth)) <= 2.0 * T::EPSILON);
        assert_eq!([found.point.y, found.point.z].map(T::bits), [T::ZERO.bits(); 2]);
        assert_eq!(found.normal.to_dvec3(), DVec3::Z);
        check_shown(&ground(), &ray);
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn c04_beyond_every_number_is_a_miss() {
    check_miss(DVec3::Z, DVec3::new(1.0, 0.0, -5e-324));
    check_miss_in::<f32>(DVec3::Z, DVec3::new(1.0, 0.0, f64::from(-f32::from_bits(1))));
    check_miss_in::<f64>(DVec3::Z * 1e70, DVec3::new(1.0, 0.0, -1e-300));
    check_miss_in::<f32>(DVec3::Z * 1e9, DVec3::new(1.0, 0.0, -1e-32));
    // The last one ahead of infinity.
    let far = |power: i32| (DVec3::new(1.0, 0.0, -2.0_f64.powi(-power)), 2.0_f64.powi(power));
    check_far::<f64>(far(1000));
    check_far::<f32>(far(126));
}

/// A hit farther away than any scene may be.
fn check_far<T: Precision>((direction, t): (DVec3, f64)) {
    let ray = ray::<T>(DVec3::Z, direction);
    let hit = ground().intersect(&ray).unwrap();
    assert_eq!((hit.t.to_f64(), hit.face, hit.side), (t, 0, Side::Outside));
    let found = ground().locate(&ray, &hit);
    assert_eq!((found.point.to_dvec3(), found.normal.to_dvec3()), (DVec3::X * t, DVec3::Z));
}

#[test]
fn c14_from_below_the_normal_points_down() {
    check_hit(DVec3::new(3.0, -4.0, -2.0), DVec3::new(1.0, 1.0, 1.0), 2.0);
    check_hit(DVec3::new(3.0, -4.0, 2.0), DVec3::new(1.0, 1.0, -1.0), 2.0);
    check_miss(DVec3::NEG_Z, DVec3::NEG_Z);
    check_miss(DVec3::Z, DVec3::Z);
}

#[test]
fn c15_on_the_plane_it_is_met_in_no_direction() {
    for level in [0.0, -0.0] {
        for direction in [DVec3::Z, DVec3::NEG_Z, DVec3::new(1.0, 0.0, -1e-30)] {
            check_miss(DVec3::new(5.0, 7.0, level), direction);
        }
    }
}

fn check_random<T: Precision>(seed: u64) {
    let mut worst = Worst::new(&format!("plane, t, {}", T::NAME));
    let mut hits = 0;
    for number in 0..50_000 {
        let random = &mut Random::new(seed + number);
        let scale = random.magnitude(-8.0, 8.0);
        let height = T::from_f64(random.between(-1.0, 1.0) * scale);
        let plane = PlaneShape { height };
        let ray = ray::<T>(random.point() * scale, random.point() * random.magnitude(-3.0, 3.0));
        let truth =
            HalfSpace { normal: ExactVector::of(Vector::<f64>::from_dvec3(DVec3::Z)), offset: exact(height) }
                .crossing(&ExactRay::of(&ray))
                .filter(|t| *t > Exact::ZERO);
        let found = plane.intersect(&ray);
        assert_eq!(found.is_some(), truth.is_some(), "{height} {ray:?}");
        let (Some(found), Some(truth)) = (found, truth) else {
            continue;
        };
        hits += 1;
        let error = relative_error(found.t, &truth) / T::EPSILON;
        worst.measure(error, T_BOUND, || format!("{height} {ray:?}"));
        let point = plane.locate(&ray, &found).point;
        assert_eq!(point.z.bits(), height.bits());
        let there = ExactRay::of(&ray).at(&truth);
        for axis in 0..2 {
            let way = ray.direction[axis].to_f64().abs() * nearest(&truth);
            let bound = 2.0 * T::EPSILON * (way + ray.origin[axis].to_f64().abs());
            assert!(nearest(&magnitude(exact(point[axis]) - &there.0[axis])) <= bound);
        }
    }
    assert!(hits > 20_000);
}

#[test]
fn c03_random_rays_keep_all_digits_f64() {
    check_random::<f64>(0xC_0001_0000);
}

#[test]
fn c03_random_rays_keep_all_digits_f32() {
    check_random::<f32>(0xC_0002_0000);
}

fn check_level<T: Precision>(seed: u64) {
    let mut ties = 0;
    for number in 0..100_000 {
        let random = &mut Random::new(seed + number);
        let scale = random.magnitude(-6.0, 6.0);
        let cube = CubeShape::<T>::new(random.point() * scale, scale);
        let top = random.coin();
        let height = if top { cube.max.z } else { cube.min.z };
        let target = cube.min.to_dvec3() + DVec3::new(random.share(), random.share(), 0.0) * scale;
        let away = random.direction();
        let away = away.with_z(if top { away.z.abs() } else { -away.z.abs() });
        let origin = target.with_z(height.to_f64()) + away * scale * random.magnitude(-1.0, 2.0);
        let ray = ray::<T>(origin, target.with_z(height.to_f64()) - origin);
        let face = if top { 5 } else { 4 };
        if let Some(hit) = cube.intersect(&ray).filter(|hit| hit.face == face) {
            let ground = PlaneShape { height };
            let on_ground = ground.intersect(&ray).unwrap();
            assert_eq!(on_ground.t.bits(), hit.t.bits(), "{cube:?} {ray:?}");
            let points = (cube.locate(&ray, &hit).point.z, ground.locate(&ray, &on_ground).point.z);
            assert_eq!(points.0.bits(), points.1.bits());
            ties += 1;
        }
    }
    println!("plane, level with a cube, {}: {ties} ties of 100000", T::NAME);
    assert!(ties > 90_000);
}

#[test]
fn c13_a_cube_face_and_a_level_plane_are_met_at_the_same_bits_f64() {
    check_level::<f64>(0xC_1301_0000);
}

#[test]
fn c13_a_cube_face_and_a_level_plane_are_met_at_the_same_bits_f32() {
    check_level::<f32>(0xC_1302_0000);
}

#[test]
fn c13_the_plane_has_one_normal_and_no_inside() {
    let ray = ray::<f64>(DVec3::ZERO, DVec3::NEG_Z);
    let exit = GROUND.exit(&ray, 0);
    assert_eq!((exit.t, exit.side), (0.0, Side::Outside));
    let normal = GROUND.locate(&ray, &exit).normal;
    assert_eq!(bits(normal), [0.0_f64, 0.0, 1.0].map(Precision::bits));
}

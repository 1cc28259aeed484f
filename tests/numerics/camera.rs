//! Camera rays and bases: symmetry to the bit, depth of the near plane, reach, and extreme lenses.

use archetrace::components::{CameraPose, Lens, range};
use archetrace::geometry::{Vector, basis_looking};
use archetrace::trace::CameraRays;
use glam::DVec3;

use crate::oracle::{Exact, ExactVector, exact, magnitude, nearest, relative_error};
use crate::precision::{Precision, bits};
use crate::worst::Worst;
use archetrace::selfcheck::Random;

const LENS: Lens = Lens { near: 1.0, far: 1000.0, fovy: 60.0, aspect: 1.0 };

/// Views along the axes: look, right and up have one component each, so that mirroring is changing a sign.
fn axis_views() -> [CameraPose; 3] {
    let looking = |l: DVec3, u: DVec3| CameraPose { position: DVec3::ZERO, l, r: l.cross(u), u };
    [looking(DVec3::Y, DVec3::Z), looking(DVec3::NEG_X, DVec3::Z), looking(DVec3::NEG_Z, DVec3::Y)]
}

fn flipped<T: Precision>(v: Vector<T>, axis: DVec3) -> Vector<T> {
    let sign = |part: f64, value: T| if part == 0.0 { value } else { -value };
    Vector::new(sign(axis.x, v.x), sign(axis.y, v.y), sign(axis.z, v.z))
}

/// Equal but for the sign of a zero.
fn same<T: Precision>(a: Vector<T>, b: Vector<T>) -> bool {
    a == b && (a.x.is_finite() && a.y.is_finite() && a.z.is_finite())
}

fn check_symmetry<T: Precision>() {
    for pose in axis_views() {
        for pixels in [1, 2, 3, 7, 16, 33] {
            let rays = CameraRays::<T>::new(&pose, &LENS, pixels);
            for row in 0..pixels {
                for column in 0..pixels {
                    let here = rays.ray(column, row);
                    let mirrored = rays.ray(pixels - 1 - column, row);
                    let upside = rays.ray(column, pixels - 1 - row);
                    for (there, axis) in [(mirrored, pose.r), (upside, pose.u)] {
                        assert!(same(here.ray.direction, flipped(there.ray.direction, axis)));
                        assert!(same(here.ray.origin, flipped(there.ray.origin, axis)));
                        assert_eq!(here.reach.bits(), there.reach.bits());
                    }
                }
            }
        }
    }
}

#[test]
fn k08_opposite_pixels_are_mirror_images_to_the_bit_f64() {
    check_symmetry::<f64>();
}

#[test]
fn k08_opposite_pixels_are_mirror_images_to_the_bit_f32() {
    check_symmetry::<f32>();
}

fn check_orientation<T: Precision>() {
    let rays = CameraRays::<T>::new(&CameraPose::default(), &LENS, 8);
    let corner = rays.ray(0, 0).ray.direction;
    assert!(corner.x < T::ZERO && corner.y > T::ZERO && corner.z > T::ZERO, "top left: {corner:?}");
    let corner = rays.ray(7, 7).ray.direction;
    assert!(corner.x > T::ZERO && corner.y > T::ZERO && corner.z < T::ZERO, "bottom right: {corner:?}");
}

#[test]
fn row_0_is_the_top_and_column_0_the_left() {
    check_orientation::<f64>();
    check_orientation::<f32>();
}

#[test]
fn k06_k07_the_middle_ray_of_an_odd_picture_looks_along_l_exactly() {
    for pose in axis_views() {
        for pixels in [1, 3, 5, 101, 767] {
            let ray = CameraRays::<f64>::new(&pose, &LENS, pixels).ray(pixels / 2, pixels / 2);
            assert_eq!(ray.ray.direction.to_dvec3(), pose.l);
            assert_eq!(ray.ray.origin.to_dvec3(), pose.l * LENS.near);
            assert_eq!(ray.reach, LENS.far);
        }
    }
}

#[test]
fn k07_in_a_turned_view_the_middle_ray_is_l_to_the_last_digit() {
    let mut worst = Worst::new("camera, middle ray against l");
    for number in 0..5_000 {
        let random = &mut Random::new(0xCA_0700_0000 + number);
        let pose = CameraPose::looking(DVec3::ZERO, random.direction(), random.direction()).unwrap();
        let ray = CameraRays::<f64>::new(&pose, &LENS, 3).ray(1, 1).ray;
        let error = (ray.direction.to_dvec3() - pose.l).length() / f64::EPSILON;
        // The length of l is off by up to three halves of an epsilon, and the quotient rounds once more.
        worst.measure(error, 2.0, || format!("{pose:?}"));
    }
}

/// A lens of any angle whose two fields of view are below 180 degrees.
fn random_lens(random: &mut Random) -> Lens {
    let fovy = random.between(1.0, 170.0);
    let near = random.magnitude(-4.0, 2.0);
    let aspect = random.magnitude(-2.0, 0.0) * 170.0 / fovy;
    Lens { near, far: near * random.magnitude(0.1, 6.0), fovy, aspect }
}

/// Unit length, depth of the near plane, and reach, of random pixels of random cameras at the world's origin.
fn check_rays<T: Precision>(seed: u64) {
    let worst = |name: &str| Worst::new(&format!("camera, {name}, {}", T::NAME));
    let (mut length, mut depth, mut reach) = (worst("length"), worst("depth"), worst("reach"));
    for number in 0..20_000 {
        let random = &mut Random::new(seed + number);
        let pose = CameraPose::looking(DVec3::ZERO, random.direction(), random.direction()).unwrap();
        let lens = random_lens(random);
        let pixels = 1 + random.below(4000) as u32;
        let pixel = [random.below(u64::from(pixels)) as u32, random.below(u64::from(pixels)) as u32];
        let found = CameraRays::<T>::new(&pose, &lens, pixels).ray(pixel[0], pixel[1]);
        let describe = || format!("{pose:?} {lens:?} {pixel:?} of {pixels}");

        let direction = ExactVector::of(found.ray.direction);
        let stretch = nearest(&(direction.dot(&direction) - Exact::ONE)).abs() / 2.0;
        length.measure(stretch / T::EPSILON, 2.0, describe);

        // l is itself a unit vector to an epsilon or so, and the rounding of wide offsets counts by their size.
        let look = ExactVector::of(Vector::<T>::from_dvec3(pose.l));
        let near = exact(T::from_f64(lens.near));
        let deep = ExactVector::of(found.ray.origin).dot(&look);
        let wide = nearest(&ExactVector::of(found.ray.origin).length()) / lens.near;
        let error = nearest(&magnitude(deep / near - Exact::ONE));
        depth.measure(error / (T::EPSILON * wide), 4.0, describe);

        let far = exact(T::from_f64(lens.far));
        let error = nearest(&magnitude(exact(found.reach) * direction.dot(&look) / far - Exact::ONE));
        reach.measure(error / (T::EPSILON * wide), 4.0, describe);
    }
}

#[test]
fn k05_random_rays_have_unit_length_start_on_the_near_plane_and_end_on_the_far_f64() {
    check_rays::<f64>(0xCA_0501_0000);
}

#[test]
fn k05_random_rays_have_unit_length_start_on_the_near_plane_and_end_on_the_far_f32() {
    check_rays::<f32>(0xCA_0502_0000);
}

#[test]
fn the_near_plane_is_met_exactly_by_every_ray_of_a_straight_view() {
    let pose = CameraPose::default();
    let rays = CameraRays::<f64>::new(&pose, &LENS, 64);
    for row in 0..64 {
        for column in 0..64 {
            let found = rays.ray(column, row);
            assert_eq!(found.ray.origin.y, -149.0);
            let cosine = exact(found.ray.direction.y);
            let end = Exact::from(1000) / cosine;
            assert!(relative_error(found.reach, &end) <= 1.5 * f64::EPSILON);
        }
    }
}

#[test]
fn the_edges_of_the_picture_are_half_the_field_of_view_away() {
    // 90 degrees: the outermost edge is at 45, a pixel centre half a pixel before.
    let lens = Lens { fovy: 90.0, aspect: 0.5, ..LENS };
    let rays = CameraRays::<f64>::new(&CameraPose::default(), &lens, 10);
    let corner = rays.ray(9, 0).ray.direction;
    assert!((corner.z / corner.y - 0.9).abs() < 1e-15);
    // The aspect is one of angles: 45 degrees across.
    assert!((corner.x / corner.y - 0.9 * (22.5_f64).to_radians().tan()).abs() < 1e-15);
}

#[test]
fn k04_a_camera_far_away_looks_the_same_way_to_the_bit() {
    for number in 0..2_000 {
        let random = &mut Random::new(0xCA_0400_0000 + number);
        let here = CameraPose::looking(DVec3::ZERO, random.direction(), DVec3::Z).unwrap();
        let there = CameraPose { position: random.direction() * 1e9, ..here };
        let [near, far] = [here, there].map(|pose| CameraRays::<f64>::new(&pose, &LENS, 99).ray(3, 70));
        assert_eq!(bits(near.ray.direction), bits(far.ray.direction));
        assert_eq!(near.reach.bits(), far.reach.bits());
    }
}

fn check_finite<T: Precision>(fovy: f64, aspect: f64) {
    let lens = Lens { fovy, aspect, ..LENS };
    let rays = CameraRays::<T>::new(&CameraPose::default(), &lens, 9);
    for pixel in 0..81 {
        let found = rays.ray(pixel % 9, pixel / 9);
        let length = found.ray.direction.to_dvec3().length();
        assert!((length - 1.0).abs() <= 2.0 * T::EPSILON, "{fovy} {aspect}: {length}");
        assert!(found.reach.is_finite() && found.reach >= T::from_f64(LENS.far));
    }
}

#[test]
fn k05_k10_narrow_and_wide_lenses_give_finite_rays() {
    for fovy in [1e-300, 1e-6, 1.0, 90.0, 179.0, 179.9999, 180.0_f64.down()] {
        check_finite::<f64>(fovy, 1.0);
    }
    for fovy in [1e-6, 1.0, 90.0, 179.0, 179.9999] {
        check_finite::<f32>(fovy, 1.0);
    }
    for (fovy, aspect) in [(1e-3, 1e3), (170.0, 1e-3), (1.0, 1e-6), (1e-6, 1e6)] {
        check_finite::<f64>(fovy, aspect);
        check_finite::<f32>(fovy, aspect);
    }
}

#[test]
fn k05_fields_of_view_without_a_picture_are_refused() {
    for degrees in [0.0, -1.0, 180.0, 360.0, f64::NAN] {
        assert!(!range::FIELD_OF_VIEW.contains(degrees));
    }
    assert!(range::FIELD_OF_VIEW.contains(180.0_f64.down()));
    // Angles multiply: 90 degrees at aspect 2 are none.
    assert!(!range::FIELD_OF_VIEW.contains(Lens { fovy: 90.0, aspect: 2.0, ..LENS }.fovx()));
}

/// How far from orthonormal and right-handed a basis is, exactly, in epsilons.
pub(crate) fn skew([l, r, u]: [DVec3; 3]) -> f64 {
    let [l, r, u] = [l, r, u].map(|v| ExactVector::of(Vector::<f64>::from_dvec3(v)));
    let unit = |v: &ExactVector| magnitude(v.dot(v) - Exact::ONE) / Exact::from(2);
    let handed = r.cross(&l).minus(&u);
    [
        unit(&l),
        unit(&r),
        unit(&u),
        magnitude(l.dot(&r)),
        magnitude(l.dot(&u)),
        magnitude(r.dot(&u)),
        handed.length(),
    ]
    .iter()
    .map(nearest)
    .fold(0.0, f64::max)
        / f64::EPSILON
}

fn check_basis(look: DVec3, up: DVec3, worst: &mut Worst) -> [DVec3; 3] {
    let basis = basis_looking(look, up).unwrap();
    worst.measure(skew(basis), 4.0, || format!("look {look:?} up {up:?}: {basis:?}"));
    basis
}

#[test]
fn k02_random_bases_are_orthonormal() {
    let mut worst = Worst::new("basis, random");
    for number in 0..20_000 {
        let random = &mut Random::new(0xCA_0201_0000 + number);
        let look = random.direction() * random.magnitude(-9.0, 9.0);
        let up = random.across(look.normalize()) + look.normalize() * random.between(-2.0, 2.0);
        let [l, _, u] = check_basis(look, up, &mut worst);
        assert!((l - look.normalize()).length() <= 4.0 * f64::EPSILON);
        assert!(u.dot(up) > 0.0);
    }
}

#[test]
fn k02_look_along_up_takes_the_part_of_up_from_y_and_then_from_minus_x() {
    let mut worst = Worst::new("basis, parallel");
    for (look, up, picture_up) in [
        (DVec3::Z, DVec3::Z, DVec3::Y),
        (DVec3::NEG_Z, DVec3::Z, DVec3::Y),
        (DVec3::Z * 1e-30, DVec3::NEG_Z * 1e30, DVec3::Y),
        (DVec3::Y, DVec3::Y, DVec3::NEG_X),
        (DVec3::NEG_Y, DVec3::Y, DVec3::NEG_X),
    ] {
        let [l, r, u] = check_basis(look, up, &mut worst);
        assert_eq!((l, u), (look.normalize(), picture_up));
        assert_eq!(r, l.cross(u));
    }
}

#[test]
fn k02_parallel_in_any_direction_there_is_a_basis() {
    let mut worst = Worst::new("basis, parallel in any direction");
    for number in 0..5_000 {
        let random = &mut Random::new(0xCA_0202_0000 + number);
        let look = random.direction();
        let up = look * random.magnitude(-9.0, 9.0) * if random.coin() { 1.0 } else { -1.0 };
        check_basis(look, up, &mut worst);
    }
}

#[test]
fn k02_nearly_parallel_the_basis_is_still_orthonormal() {
    let mut worst = Worst::new("basis, nearly parallel");
    for number in 0..20_000 {
        let random = &mut Random::new(0xCA_0203_0000 + number);
        let look = random.direction();
        let up = look + random.across(look) * random.magnitude(-15.5, -1.0);
        check_basis(look, up, &mut worst);
    }
}

#[test]
fn s17_s18_the_length_of_look_and_up_does_not_matter() {
    for number in 0..1_000 {
        let random = &mut Random::new(0xCA_1700_0000 + number);
        let (look, up) = (random.direction(), random.direction());
        let plain = basis_looking(look, up).unwrap();
        for power in [-560, -565, 500, 531] {
            let scale = 2.0_f64.powi(power);
            assert_eq!(basis_looking(look * scale, up / scale), Some(plain), "2^{power}");
        }
        for scale in [1e-170, 1e160, 1e-300, 1e300] {
            let scaled = basis_looking(look * scale, up).unwrap();
            let away = (0..3).map(|axis| (scaled[axis] - plain[axis]).length()).fold(0.0, f64::max);
            assert!(away <= 8.0 * f64::EPSILON / look.cross(up).length(), "{scale:e}: {away:e}");
        }
    }
}

#[test]
fn s17_denormal_and_largest_vectors_have_a_basis() {
    let mut worst = Worst::new("basis, extreme lengths");
    check_basis(DVec3::new(5e-324, 0.0, 0.0), DVec3::Z, &mut worst);
    check_basis(DVec3::new(5e-324, -5e-324, 5e-324), DVec3::Z * 1e308, &mut worst);
    check_basis(DVec3::splat(f64::MAX), DVec3::Z, &mut worst);
}

#[test]
fn s25_zero_or_not_finite_there_is_no_basis() {
    for bad in [DVec3::ZERO, -DVec3::ZERO, DVec3::NAN, DVec3::new(1.0, f64::INFINITY, 0.0)] {
        assert_eq!(basis_looking(bad, DVec3::Z), None);
        assert_eq!(basis_looking(DVec3::Y, bad), None);
    }
}

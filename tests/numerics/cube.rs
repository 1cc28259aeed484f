//! The cube: a whole lattice of hard rays with no tolerance at all, the cases by id, and rays aimed at edges.

use archetrace::geometry::{Convex, CubeShape, Ray, Side, Vector};
use glam::DVec3;

use crate::oracle::{Body, Exact, ExactRay, Meeting, exact, magnitude, nearest, relative_error};
use crate::precision::{Precision, bits, ray};
use crate::shown::{Tabled, check_shown, shown};
use crate::worst::Worst;
use archetrace::selfcheck::Random;
use archetrace::trace::{Kind, ObjectId, SceneTables};

/// One difference and one quotient, half an epsilon each.
const T_BOUND: f64 = 1.0 + 1e-6;

const NORMALS: [[f64; 3]; 6] =
    [[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0], [0.0, 0.0, 1.0]];

fn unit_cube<T: Precision>() -> CubeShape<T> {
    CubeShape::new(DVec3::ZERO, 1.0)
}

fn body<T: Precision>(cube: &CubeShape<T>) -> Body {
    Body::cube(cube.min, cube.max)
}

/// The plane of a face.
fn plane<T: Precision>(cube: &CubeShape<T>, face: u8) -> (usize, T) {
    let axis = usize::from(face / 2);
    let corner = if face.is_multiple_of(2) { cube.min } else { cube.max };
    (axis, corner[axis])
}

/// What every hit owes: the point on its face exactly and within the others, the face's own normal, and a point
/// off the ray by no more than the roundings of `t`, product and sum.
fn check_surface<T: Precision>(cube: &CubeShape<T>, ray: &Ray<T>, truth: &Meeting) {
    let crossing = cube.intersect(ray).unwrap();
    let found = cube.locate(ray, &crossing);
    let (axis, level) = plane(cube, crossing.face);
    assert_eq!(found.point[axis].bits(), level.bits(), "{cube:?} {ray:?}");
    let normal = Vector::from_dvec3(NORMALS[usize::from(crossing.face)].into());
    assert_eq!(bits(found.normal), bits::<T>(normal), "{cube:?} {ray:?}");
    let there = ExactRay::of(ray).at(&truth.t);
    for axis in 0..3 {
        let at = found.point[axis];
        assert!(cube.min[axis] <= at && at <= cube.max[axis], "{cube:?} {ray:?}");
        let error = nearest(&magnitude(exact(at) - &there.0[axis]));
        let way = ray.direction[axis].to_f64().abs() * nearest(&truth.t);
        let bound = 2.0 * T::EPSILON * (way + ray.origin[axis].to_f64().abs());
        assert!(error <= bound, "{error} above {bound}: {cube:?} {ray:?}");
    }
}

const ORIGINS: [f64; 9] = [-1.0, -0.5, -0.0, 0.0, 0.25, 0.5, 1.0, 1.5, 2.0];
const DIRECTIONS: [f64; 8] = [-3.0, -1.0, -0.5, -0.0, 0.0, 0.5, 1.0, 3.0];

/// All triples of a list.
fn lattice(values: &[f64]) -> impl Iterator<Item = DVec3> + '_ {
    let triples =
        move |&x: &f64| values.iter().flat_map(move |&y| values.iter().map(move |&z| DVec3::new(x, y, z)));
    values.iter().flat_map(triples)
}

/// Hit or miss, `t`, face, side, point and normal of a ray, with no tolerance for the first four.
fn check_exactly<T: Precision>(cube: &CubeShape<T>, body: &Body, ray: &Ray<T>) -> bool {
    let truth = body.meet(&ExactRay::of(ray));
    let found = cube.intersect(ray);
    let Some(truth) = truth else {
        assert_eq!(found, None, "{ray:?}");
        return false;
    };
    let found = found.unwrap_or_else(|| panic!("missed, t = {}: {ray:?}", nearest(&truth.t)));
    assert_eq!(found.t.bits(), T::rounded(&truth.t).bits(), "{ray:?}");
    assert_eq!((found.face, found.side), (truth.face, truth.side), "{ray:?}");
    check_surface(cube, ray, &truth);
    true
}

fn check_lattice<T: Precision>() {
    let cube = unit_cube::<T>();
    let body = body(&cube);
    let mut hits = 0;
    let mut rays = 0;
    for direction in lattice(&DIRECTIONS).filter(|direction| *direction != DVec3::ZERO) {
        for origin in lattice(&ORIGINS) {
            rays += 1;
            hits += u32::from(check_exactly(&cube, &body, &ray(origin, direction)));
        }
    }
    println!("cube, lattice, {}: {rays} rays, {hits} hits, all as exact", T::NAME);
    assert_eq!(rays, 729 * 504);
}

#[test]
fn a2_the_lattice_of_367416_rays_is_met_exactly_f64() {
    check_lattice::<f64>();
}

#[test]
fn a2_the_lattice_of_367416_rays_is_met_exactly_f32() {
    check_lattice::<f32>();
}

/// A ray with the unit cube in both precisions: `t`, face, side, point and normal with no tolerance for the first three,
/// all as exact arithmetic has them, too, and that a scene shows the cube there by every way of searching it.
fn check_case(origin: [f64; 3], direction: [f64; 3], expected: Option<(f64, u8, Side)>) {
    check_case_in::<f64>(origin, direction, expected);
    check_case_in::<f32>(origin, direction, expected);
}

fn check_case_in<T: Precision>(origin: [f64; 3], direction: [f64; 3], expected: Option<(f64, u8, Side)>) {
    let cube = unit_cube::<T>();
    let ray = ray::<T>(origin.into(), direction.into());
    check_kernel(&cube, &ray, expected);
    check_shown(&cube, &ray);
}

fn check_kernel<T: Precision>(cube: &CubeShape<T>, ray: &Ray<T>, expected: Option<(f64, u8, Side)>) {
    let found = cube.intersect(ray);
    assert_eq!(found.map(|hit| (hit.t.to_f64(), hit.face, hit.side)), expected, "{ray:?}");
    if let Some((t, face, side)) = expected {
        let truth = Meeting { t: exact(t), face, side };
        assert_eq!(body(cube).meet(&ExactRay::of(ray)), Some(truth.clone()), "{ray:?}");
        check_surface(cube, ray, &truth);
        let normal = cube.locate(ray, &found.unwrap()).normal;
        assert_eq!(normal.dot(ray.direction) > T::ZERO, side == Side::Inside, "{ray:?}");
    }
}

#[test]
fn b01_a_ray_within_a_face_is_met_whatever_the_sign_of_its_zeros() {
    fn check<T: Precision>() {
        for direction in [[1.0, 0.0, 0.0], [1.0, 0.0, -0.0], [1.0, -0.0, 0.0], [1.0, -0.0, -0.0]] {
            let check = check_case_in::<T>;
            check([-1.0, 0.5, 1.0], direction, Some((1.0, 0, Side::Outside)));
            check([-1.0, 0.5, 0.0], direction, Some((1.0, 0, Side::Outside)));
            check([-1.0, 1.0, 1.0], direction, Some((1.0, 0, Side::Outside)));
            check([-1.0, 0.5, T::ONE.up().to_f64()], direction, None);
            check([-1.0, 0.5, T::ZERO.down().to_f64()], direction, None);
        }
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn b02_corner_to_corner_leaves_by_the_first_face() {
    check_case([0.0; 3], [1.0; 3], Some((1.0, 1, Side::Inside)));
}

#[test]
fn b03_through_a_corner_the_first_axis_wins() {
    check_case([-1.0; 3], [1.0; 3], Some((1.0, 0, Side::Outside)));
    check_case([2.0; 3], [-1.0; 3], Some((1.0, 1, Side::Outside)));
    // Touches the corner (0, 0, 1) in one point.
    check_case([-1.0, 1.0, 0.0], [1.0, -1.0, 1.0], Some((1.0, 0, Side::Outside)));
}

#[test]
fn b04_through_an_edge_the_first_axis_wins() {
    check_case([-1.0, -1.0, 0.5], [1.0, 1.0, 0.0], Some((1.0, 0, Side::Outside)));
    check_case([0.5, -1.0, -1.0], [0.0, 1.0, 1.0], Some((1.0, 2, Side::Outside)));
}

#[test]
fn b05_from_the_inside_the_wall_ahead_is_met() {
    check_case([0.5; 3], [0.0, 0.0, 1.0], Some((0.5, 5, Side::Inside)));
    check_case([0.5; 3], [0.0, -2.0, 0.0], Some((0.25, 2, Side::Inside)));
}

#[test]
fn b06_a_slope_without_a_reciprocal_is_divided_by() {
    fn check<T: Precision>() {
        let slope = T::of(1e-310, 1e-40);
        check_case_in::<T>([0.0, 0.5, -1.0], [slope, 0.0, 1.0], Some((1.0, 4, Side::Outside)));
        check_case_in::<T>([0.0, 0.5, -1.0], [-slope, 0.0, 1.0], None);
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn b07_a_far_hit_is_finite_or_none() {
    // Farther away than any scene may be.
    fn check<T: Precision>() {
        let cube = unit_cube::<T>();
        let check = |z: f64, rise: f64, expected| {
            check_kernel(&cube, &ray(DVec3::new(0.5, 0.5, z), DVec3::new(0.0, 0.0, rise)), expected);
        };
        let far = T::from_f64(T::of(1e308, 1e38)).to_f64();
        let least = T::of(1e-320, 1e-44);
        check(-far, 1.0, Some((far, 4, Side::Outside)));
        check(-1.0, least, None);
        check(0.5, least, None);
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn b08_two_cubes_side_by_side_are_met_at_the_same_bits() {
    fn check<T: Precision>() {
        let neighbour = CubeShape::<T>::new(DVec3::X, 1.0);
        let between = ray::<T>(DVec3::new(1.0, -1.0, 0.5), DVec3::Y);
        check_kernel(&unit_cube(), &between, Some((1.0, 2, Side::Outside)));
        check_kernel(&neighbour, &between, Some((1.0, 2, Side::Outside)));
        // The one of lower order shows, whichever it is.
        for pair in [[unit_cube(), neighbour], [neighbour, unit_cube()]] {
            let mut tables = SceneTables::default();
            (1..).zip(pair).for_each(|(order, cube)| cube.push(&mut tables, order));
            assert_eq!(shown(&mut tables, &between).unwrap().0, ObjectId { kind: Kind::Cube, row: 0 });
        }
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn b09_from_one_cube_into_the_next_there_is_no_gap() {
    fn check<T: Precision>(scales: f64) {
        let mut random = Random::new(0xB09);
        let mut crossed = 0;
        for _ in 0..20_000 {
            let side = random.magnitude(-scales, scales);
            let first = CubeShape::<T>::new(random.point() * side, side);
            let end = first.max.x + T::from_f64(side);
            let second = CubeShape { min: first.min.with(0, first.max.x), max: first.max.with(0, end) };
            let (min, max) = (first.min.to_dvec3(), first.max.to_dvec3());
            let share = DVec3::new(random.share(), random.share(), random.share());
            let way = DVec3::new(random.share(), 0.0, 0.0) + 0.3 * random.point();
            let ray = ray::<T>(min + share * (max - min), way);
            let exit = first.intersect(&ray).unwrap();
            if (exit.face, exit.side) == (1, Side::Inside) {
                let entry = second.intersect(&ray).unwrap();
                assert_eq!((entry.t, entry.face, entry.side), (exit.t, 0, Side::Outside), "{ray:?}");
                let [out, into] =
                    [(&first, &exit), (&second, &entry)].map(|(cube, hit)| cube.locate(&ray, hit));
                assert_eq!((out.point, out.normal), (into.point, -into.normal), "{ray:?}");
                crossed += 1;
            }
        }
        assert!(crossed > 5_000, "{crossed}");
    }
    check::<f64>(6.0);
    check::<f32>(3.0);
}

#[test]
fn b10_equal_cubes_give_equal_bits_however_they_were_made() {
    fn check<T: Precision>() {
        let mut random = Random::new(0xB10);
        for _ in 0..2_000 {
            let (min, side) = (random.point(), random.share());
            let ray = ray::<T>(3.0 * random.point(), random.direction());
            let [first, second] = [0, 1].map(|_| CubeShape::<T>::new(min, side).intersect(&ray));
            assert_eq!(first, second);
        }
        // Of thirty twins the first shows.
        check_shown(&unit_cube::<T>(), &ray(DVec3::new(-2.0, 0.25, 0.75), DVec3::X));
    }
    check::<f64>();
    check::<f32>();
}

/// A hit without the scale: `t`, face, side, and the bits of point and normal.
type Unscaled<T> = Option<(T, u8, Side, [u64; 3], [u64; 3])>;

fn unscaled<T: Precision>(cube: &CubeShape<T>, ray: &Ray<T>, scale: f64) -> Unscaled<T> {
    let hit = cube.intersect(ray)?;
    let (found, scale) = (cube.locate(ray, &hit), T::from_f64(scale));
    Some((hit.t / scale, hit.face, hit.side, bits(found.point / scale), bits(found.normal)))
}

#[test]
fn b11_scaled_by_a_power_of_two_only_the_exponent_changes() {
    fn check<T: Precision>(powers: [i32; 4]) {
        let mut random = Random::new(0xB11);
        let mut hits = 0;
        for number in 0..20_000 {
            let (min, side) = (random.point(), random.magnitude(-2.0, 0.5));
            let origin = 3.0 * random.point();
            let direction = min + (random.point() + 0.5) * side - origin;
            let at = |scale: f64| {
                let cube = CubeShape::<T>::new(min * scale, side * scale);
                unscaled(&cube, &ray(origin * scale, direction), scale)
            };
            let plain = at(1.0);
            assert_eq!(at(2.0_f64.powi(powers[number % 4])), plain);
            hits += u32::from(plain.is_some());
        }
        assert!(hits > 1_000, "{hits}");
    }
    check::<f64>([-60, -20, 20, 60]);
    // A scene's own unit keeps lengths within these in single precision.
    check::<f32>([-20, -7, 7, 20]);
    // Sides of a millionth and a million, and a cube a million away: the face is met where it is.
    for (corner, side) in [(0.0, 1e-6), (0.0, 1e6), (1e6, 1.0)] {
        check_side::<f64>(corner, side);
        check_side::<f32>(corner, side);
    }
}

/// From one side ahead of the middle of a cube's face -x.
fn check_side<T: Precision>(corner: f64, side: f64) {
    let cube = CubeShape::<T>::new(DVec3::splat(corner), side);
    let middle = DVec3::splat(corner + 0.5 * side);
    let ray = ray::<T>(middle.with_x(corner - side), DVec3::X);
    assert!(check_exactly(&cube, &body(&cube), &ray));
    check_shown(&cube, &ray);
}

/// Hit or miss and side without tolerance; `t`, face, point and normal. Whether it is a hit.
pub(crate) fn check_aimed<T: Precision>(cube: &CubeShape<T>, ray: &Ray<T>, worst: &mut Worst) -> bool {
    let body = body(cube);
    let exact_ray = ExactRay::of(ray);
    let truth = body.meet(&exact_ray);
    let found = cube.intersect(ray);
    assert_eq!(found.map(|hit| hit.side), truth.as_ref().map(|hit| hit.side), "{cube:?} {ray:?}");
    let (Some(truth), Some(found)) = (truth, found) else { return false };
    let error = relative_error(found.t, &truth.t) / T::EPSILON;
    worst.measure(error, T_BOUND, || format!("{cube:?} {ray:?}"));
    let of_face = body.0[usize::from(found.face)].crossing(&exact_ray).unwrap();
    let off = relative_error(found.t, &of_face) / T::EPSILON;
    assert!(off <= T_BOUND, "face {}: {cube:?} {ray:?}", found.face);
    check_surface(cube, ray, &truth);
    true
}

/// A point on an edge, or one in eight times a corner, of a cube.
fn edge_point<T: Precision>(cube: &CubeShape<T>, random: &mut Random) -> DVec3 {
    let (min, max) = (cube.min.to_dvec3(), cube.max.to_dvec3());
    let mut point = min;
    for axis in 0..3 {
        point[axis] = if random.coin() { min[axis] } else { max[axis] };
    }
    if random.below(8) > 0 {
        let axis = random.below(3) as usize;
        point[axis] = random.between(min[axis], max[axis]);
    }
    point
}

fn check_edges<T: Precision>(scales: f64, seed: u64) {
    let mut hits = 0;
    let mut worst = Worst::new(&format!("cube, aimed at edges, t, {}", T::NAME));
    for number in 0..100_000 {
        let random = &mut Random::new(seed + number);
        let scale = random.magnitude(-scales, scales);
        let side = scale * random.magnitude(-2.0, 1.0);
        let cube = CubeShape::<T>::new(random.point() * scale, side);
        let target = edge_point(&cube, random);
        let origin = target + random.direction() * side * random.magnitude(-1.0, 2.0);
        let start = Vector::<T>::from_dvec3(origin);
        let length = random.magnitude(-3.0, 3.0);
        let ray =
            Ray { origin: start, direction: (Vector::from_dvec3(target) - start) * T::from_f64(length) };
        hits += u32::from(check_aimed(&cube, &ray, &mut worst));
    }
    println!("cube, aimed at edges, {}: {hits} of 100000 rays hit, all as exact", T::NAME);
    assert!((30_000..90_000).contains(&hits));
}

#[test]
fn b03_b04_rays_aimed_at_edges_and_corners_do_not_leak_f64() {
    check_edges::<f64>(8.0, 0xB_0001_0000);
}

#[test]
fn b03_b04_rays_aimed_at_edges_and_corners_do_not_leak_f32() {
    check_edges::<f32>(3.0, 0xB_0002_0000);
}

/// On whole numbers the rays run exactly through edges and corners: there is no band then.
fn check_whole<T: Precision>(seed: u64) {
    let mut touching = 0;
    for number in 0..50_000 {
        let random = &mut Random::new(seed + number);
        let scale = 2.0_f64.powi(random.whole(-30, 30) as i32);
        let min = DVec3::new(random.whole(-9, 9), random.whole(-9, 9), random.whole(-9, 9));
        let cube = CubeShape::<T>::new(min * scale, random.whole(1, 9) * scale);
        let target = edge_point(&cube, random) / scale;
        let start = DVec3::new(random.whole(-99, 99), random.whole(-99, 99), random.whole(-99, 99));
        let direction = target.floor() - start;
        if direction == DVec3::ZERO {
            continue;
        }
        let ray = ray::<T>(start * scale, direction * scale);
        let body = body(&cube);
        check_exactly(&cube, &body, &ray);
        let chord = body.chord(&ExactRay::of(&ray));
        touching += u32::from(chord.is_some_and(|chord| {
            matches!((chord.enter, chord.leave), (Some((enter, _)), Some((leave, _))) if enter == leave && enter > Exact::ZERO)
        }));
    }
    println!("cube, whole numbers, {}: {touching} rays touch in one point, all hits", T::NAME);
    assert!(touching > 5_000, "{touching}");
}

#[test]
fn b03_b04_rays_exactly_through_edges_and_corners_hit_f64() {
    check_whole::<f64>(0xB_0003_0000);
}

#[test]
fn b03_b04_rays_exactly_through_edges_and_corners_hit_f32() {
    check_whole::<f32>(0xB_0004_0000);
}

//! The pyramid: cases by id, and rays aimed at edges and corners of flat, tall, tiny, huge and far ones.

use archetrace::components::range;
use archetrace::geometry::{Convex, PyramidShape, Ray, Side, Vector};
use glam::DVec3;

use crate::oracle::{
    Body, ExactRay, ExactVector, Meeting, exact, magnitude, nearest, small_angle, square_root,
};
use crate::precision::{Precision, bits, ray};
use crate::shown::check_shown;
use crate::worst::Worst;
use archetrace::selfcheck::Random;

/// A pyramid, its parameters and its exact body.
pub(crate) struct Pyramid<T> {
    /// As the kernel has it.
    pub(crate) shape: PyramidShape<T>,
    /// The same half-spaces, exactly.
    pub(crate) body: Body,
    pub(crate) corner: DVec3,
    pub(crate) width: f64,
    pub(crate) height: f64,
}

impl<T: Precision> Pyramid<T> {
    /// The pyramid on a base with this least corner.
    pub(crate) fn new(corner: DVec3, width: f64, height: f64) -> Self {
        let shape = PyramidShape::new(corner, width, height);
        let rounded = T::from_f64;
        Self {
            shape,
            body: Body::pyramid(shape.apex, rounded(corner.z), rounded(0.5 * width), rounded(height)),
            corner,
            width,
            height,
        }
    }

    pub(crate) fn corners(&self) -> [DVec3; 4] {
        let w = self.width;
        [(0.0, 0.0), (w, 0.0), (w, w), (0.0, w)].map(|(x, y)| self.corner + DVec3::new(x, y, 0.0))
    }

    pub(crate) fn apex(&self) -> DVec3 {
        self.shape.apex.to_dvec3()
    }

    /// A point well inside.
    pub(crate) fn inner_point(&self, random: &mut Random) -> DVec3 {
        let mut sum = DVec3::ZERO;
        let mut total = 0.0;
        for point in self.corners().into_iter().chain([self.apex()]) {
            let weight = random.between(0.05, 1.0);
            sum += weight * (point - self.corner);
            total += weight;
        }
        self.corner + sum / total
    }

    /// A point on an edge, or one in eight times a corner or the apex.
    fn edge_point(&self, random: &mut Random) -> DVec3 {
        let corners = self.corners();
        let number = random.below(4) as usize;
        let from = corners[number];
        let to = if random.coin() { corners[(number + 1) % 4] } else { self.apex() };
        match random.below(16) {
            0 => from,
            1 => to,
            _ => from + random.share() * (to - from),
        }
    }

    /// How far rounding can move a face as a ray sees it on its way up to `t`, in epsilons at most 1.5 times what the
    /// products of `t * slope <= room` amount to: room takes three roundings of half an epsilon, slope two, `t` one.
    fn blur(&self, face: u8, ray: &Ray<T>, t: f64) -> f64 {
        let (origin, direction) = (ray.origin.to_dvec3(), ray.direction.to_dvec3());
        let to_apex = self.shape.apex.to_dvec3() - origin;
        let [room, slope] = [to_apex, direction].map(|v| match face {
            0 | 1 => self.height * v.x.abs() + 0.5 * self.width * v.z.abs(),
            2 | 3 => self.height * v.y.abs() + 0.5 * self.width * v.z.abs(),
            _ => v.z.abs(),
        });
        let base = (self.shape.base.to_f64() - origin.z).abs();
        let (room, length) = if face < 4 { (room, self.height.hypot(0.5 * self.width)) } else { (base, 1.0) };
        1.5 * T::EPSILON * (room + t * slope) / length
    }

    /// How far `t` can be off by the blur of a face.
    pub(crate) fn step(&self, face: u8, ray: &Ray<T>, exact_ray: &ExactRay, t: f64) -> f64 {
        let along = self.cosine(face, exact_ray) * ray.direction.to_dvec3().length();
        self.blur(face, ray, t) / along
    }

    /// Cosine between a ray and the normal of a face: how much of a step along the one is a step along the other.
    fn cosine(&self, face: u8, ray: &ExactRay) -> f64 {
        let normal = &self.body.0[usize::from(face)].normal;
        let square =
            normal.dot(&ray.direction).sqr() / (normal.dot(normal) * ray.direction.dot(&ray.direction));
        nearest(&square_root(&square))
    }

    /// The located point: on its face, within the body, with the unit normal of the face.
    pub(crate) fn check_surface(&self, ray: &Ray<T>, meeting_face: u8) {
        let crossing = self.shape.intersect(ray).unwrap();
        assert_eq!(crossing.face, meeting_face);
        let found = self.shape.locate(ray, &crossing);
        let point = ExactVector::of(found.point);
        let point_size = found.point.to_dvec3().length();
        let from_apex = (found.point - self.shape.apex).to_dvec3().length();
        let way = (found.point - ray.origin).to_dvec3().length();
        let place = 4.0 * T::EPSILON * (point_size + from_apex + way);
        let face = &self.body.0[usize::from(crossing.face)];
        let off = nearest(&magnitude(face.outside(&point) / face.normal.length()));
        assert!(off <= place, "{off:e} off its face: {:?} {ray:?}", self.shape);
        assert!(self.body.grown(&[place; 5]).contains(&point), "{:?} {ray:?}", self.shape);
        self.check_normal(crossing.face, found.normal);
    }

    /// A unit normal within half an epsilon of the exact angle.
    fn check_normal(&self, face: u8, normal: Vector<T>) {
        if face == 4 {
            assert_eq!(bits(normal), bits::<T>(Vector::from_dvec3(DVec3::NEG_Z)));
            return;
        }
        let truth = &self.body.0[usize::from(face)].normal;
        let found = ExactVector::of(normal);
        let angle = small_angle(&found, truth);
        assert!(angle <= 0.51 * T::EPSILON, "{angle:e}: {:?}", self.shape);
        assert!(found.dot(truth) > exact(0.0));
        let length = nearest(&(found.dot(&found) - exact(1.0))).abs() / 2.0;
        assert!(length <= 1.5 * T::EPSILON, "{length:e}: {:?}", self.shape);
    }
}

pub(crate) fn unit<T: Precision>() -> Pyramid<T> {
    Pyramid::new(DVec3::new(-0.5, -0.5, 0.0), 1.0, 1.0)
}

/// A ray with the unit pyramid in both precisions: `t`, face and side, no tolerance; then point and normal, and that a
/// scene shows the pyramid there by every way of searching it.
fn check_case(origin: [f64; 3], direction: [f64; 3], expected: Option<(f64, u8, Side)>) {
    check_case_in::<f64>(origin, direction, expected);
    check_case_in::<f32>(origin, direction, expected);
}

fn check_case_in<T: Precision>(origin: [f64; 3], direction: [f64; 3], expected: Option<(f64, u8, Side)>) {
    let pyramid = unit::<T>();
    let ray = ray::<T>(origin.into(), direction.into());
    let found = pyramid.shape.intersect(&ray);
    let truth = expected.map(|(t, face, side)| {
        let t = exact(t);
        Meeting { t, face, side }
    });
    assert_eq!(pyramid.body.meet(&ExactRay::of(&ray)), truth, "{ray:?}");
    let found = found.map(|hit| (hit.t.to_f64(), hit.face, hit.side));
    assert_eq!(found, expected, "{ray:?}");
    if let Some((_, face, side)) = expected {
        pyramid.check_surface(&ray, face);
        let normal = pyramid.shape.locate(&ray, &pyramid.shape.intersect(&ray).unwrap()).normal;
        assert_eq!(normal.dot(ray.direction) > T::ZERO, side == Side::Inside, "{ray:?}");
    }
    check_shown(&pyramid.shape, &ray);
}

#[test]
fn p01_the_apex_is_met_by_the_first_face() {
    check_case([0.0, 0.0, 5.0], [0.0, 0.0, -1.0], Some((4.0, 0, Side::Outside)));
    let pyramid = unit::<f64>();
    let down = ray(DVec3::new(0.0, 0.0, 5.0), DVec3::NEG_Z);
    let hit = pyramid.shape.intersect(&down).unwrap();
    assert_eq!(pyramid.shape.locate(&down, &hit).point, pyramid.shape.apex);
    // Level with the tip, it is touched in one point.
    check_case([-2.0, 0.0, 1.0], [1.0, 0.0, 0.0], Some((2.0, 0, Side::Outside)));
    check_case([-2.0, 0.0, f64::from(1.0_f32.next_up())], [1.0, 0.0, 0.0], None);
    check_case_in::<f64>([-2.0, 0.0, 1.0.up()], [1.0, 0.0, 0.0], None);
}

#[test]
fn p02_a_slanted_edge_is_met_by_the_first_of_its_faces() {
    check_case([2.0, 2.0, 1.5], [-1.75, -1.75, -1.0], Some((1.0, 1, Side::Outside)));
    check_case([-2.0, 2.0, 1.5], [1.75, -1.75, -1.0], Some((1.0, 0, Side::Outside)));
    check_case([2.0, -2.0, 1.5], [-1.75, 1.75, -1.0], Some((1.0, 1, Side::Outside)));
}

#[test]
fn p03_a_base_corner_touched_in_one_point_is_met() {
    check_case([2.0, 2.0, 0.125], [-1.5, -1.5, -0.125], Some((1.0, 1, Side::Outside)));
    check_case([-2.0, -2.0, 0.25], [1.5, 1.5, -0.25], Some((1.0, 0, Side::Outside)));
    check_case([2.0, -2.0, 0.25], [-1.5, 1.5, -0.25], Some((1.0, 1, Side::Outside)));
}

#[test]
fn p04_a_ray_within_the_base_is_met_like_one_within_a_cube_face() {
    for zero in [0.0, -0.0] {
        check_case([-5.0, 0.0, zero], [1.0, 0.0, zero], Some((4.5, 0, Side::Outside)));
        check_case([-5.0, 0.5, zero], [1.0, zero, zero], Some((4.5, 0, Side::Outside)));
    }
    check_case([-5.0, 0.0, -1e-30], [1.0, 0.0, 0.0], None);
    check_case_in::<f64>([-5.0, 0.0, 0.0.down()], [1.0, 0.0, 0.0], None);
    check_case_in::<f32>([-5.0, 0.0, f64::from(0.0_f32.down())], [1.0, 0.0, 0.0], None);
}

#[test]
fn p05_from_below_the_base_is_met() {
    check_case([0.125, 0.125, -1.0], [0.0, 0.0, 1.0], Some((1.0, 4, Side::Outside)));
    check_case([0.1, 0.1, -1.0], [0.0, 0.0, 1.0], Some((1.0, 4, Side::Outside)));
}

#[test]
fn p06_from_the_inside_the_exit_is_met() {
    check_case([0.0, 0.0, 0.25], [0.0, 0.0, -1.0], Some((0.25, 4, Side::Inside)));
    check_case([0.0, 0.0, 0.25], [0.0, 0.0, 1.0], Some((0.75, 0, Side::Inside)));
    check_case([0.0, 0.0, 0.5], [1.0, 0.0, 0.0], Some((0.25, 1, Side::Inside)));
    check_case([0.0, 0.0, 0.5], [0.0, -1.0, 0.0], Some((0.25, 2, Side::Inside)));
    check_case([0.0, 0.0, 0.5], [0.0, 1.0, 0.0], Some((0.25, 3, Side::Inside)));
}

#[test]
fn p06_random_rays_from_the_inside_always_leave() {
    fn check<T: Precision>() {
        let mut figures = Figures::new::<T>("from inside");
        let pyramid = unit::<T>();
        for number in 0..20_000 {
            let random = &mut Random::new(0x9_0600_0000 + number);
            let ray = ray(pyramid.inner_point(random), random.direction());
            check_random(&pyramid, &ray, &mut figures);
            assert_eq!(pyramid.shape.intersect(&ray).unwrap().side, Side::Inside);
        }
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn p07_side_normals_are_exact_to_half_an_epsilon_from_sliver_to_tower() {
    for number in 0..5_000 {
        let random = &mut Random::new(0x9_0700_0000 + number);
        let (width, height) = (random.magnitude(-6.0, 6.0), random.magnitude(-6.0, 6.0));
        check_normals::<f64>(width, height);
        check_normals::<f32>(width, height);
    }
    for height in [1e-6, 1e6] {
        check_normals::<f64>(1.0, height);
        check_normals::<f32>(1.0, height);
    }
}

/// Rays down onto the middle of each side.
fn check_normals<T: Precision>(width: f64, height: f64) {
    let pyramid = Pyramid::<T>::new(DVec3::new(-0.5 * width, -0.5 * width, 0.0), width, height);
    for (face, (x, y)) in (0..).zip([(-0.25, 0.0), (0.25, 0.0), (0.0, -0.25), (0.0, 0.25)]) {
        let over = DVec3::new(x * width, y * width, 2.0 * height);
        let ray = ray::<T>(over, DVec3::NEG_Z);
        let hit = pyramid.shape.intersect(&ray).unwrap();
        assert_eq!((hit.face, hit.side), (face, Side::Outside));
        pyramid.check_normal(face, pyramid.shape.locate(&ray, &hit).normal);
    }
}

#[test]
fn p09_a_flat_or_empty_pyramid_is_refused() {
    for length in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(!range::LENGTH.contains(length), "{length}");
    }
}

/// What a run of rays has shown.
pub(crate) struct Figures {
    name: String,
    t: Worst,
    pub(crate) rays: u32,
    pub(crate) hits: u32,
}

impl Figures {
    pub(crate) fn new<T: Precision>(name: &str) -> Self {
        let name = format!("pyramid, {name}, {}", T::NAME);
        Self { t: Worst::new(&format!("{name}, t / bound")), name, rays: 0, hits: 0 }
    }
}

impl Drop for Figures {
    fn drop(&mut self) {
        println!("{}: {} rays, {} hits", self.name, self.rays, self.hits);
    }
}

/// One ray: hit or miss, side, face, `t`, point and normal.
pub(crate) fn check_random<T: Precision>(pyramid: &Pyramid<T>, ray: &Ray<T>, figures: &mut Figures) {
    let exact_ray = ExactRay::of(ray);
    let truth = pyramid.body.meet(&exact_ray);
    let found = pyramid.shape.intersect(ray);
    let describe = || format!("{:?} {ray:?}", pyramid.shape);
    figures.rays += 1;
    assert_eq!(found.is_some(), truth.is_some(), "{}: {}", figures.name, describe());
    let (Some(truth), Some(found)) = (truth, found) else { return };
    figures.hits += 1;
    assert_eq!(found.side, truth.side, "{}", describe());
    // Near an edge the other face may be named: then the crossings of both are that near to each other.
    let t = nearest(&truth.t);
    let allowed = [truth.face, found.face].map(|face| pyramid.step(face, ray, &exact_ray, t));
    let error = nearest(&magnitude(exact(found.t) - &truth.t));
    figures.t.measure(error / allowed[0].max(allowed[1]), 1.0, describe);
    pyramid.check_surface(ray, found.face);
}

/// Rays through a point on an edge and a point inside: each must hit, and none on its far side. One in four is
/// compared with the exact answer.
fn check_edges<T: Precision>(name: &str, corner: DVec3, width: f64, height: f64, seed: u64) {
    let pyramid = Pyramid::<T>::new(corner, width, height);
    let mut figures = Figures::new::<T>(name);
    for number in 0..100_000 {
        let random = &mut Random::new(seed + number);
        let edge = pyramid.edge_point(random);
        let inner = pyramid.inner_point(random);
        let origin = edge + (edge - inner) * random.magnitude(-1.0, 2.0);
        let start = Vector::<T>::from_dvec3(origin);
        let towards = if random.coin() { edge } else { inner };
        let direction = Vector::<T>::from_dvec3(towards - origin);
        let ray = Ray { origin: start, direction: direction * T::from_f64(random.magnitude(-2.0, 2.0)) };
        let found = pyramid.shape.intersect(&ray).map(|hit| hit.side);
        assert_eq!(found, Some(Side::Outside), "{:?} {ray:?}", pyramid.shape);
        if number % 4 == 0 {
            check_random(&pyramid, &ray, &mut figures);
        }
    }
    assert_eq!((figures.hits, figures.rays), (25_000, 25_000));
}

fn centered(width: f64) -> DVec3 {
    DVec3::new(-0.5 * width, -0.5 * width, 0.0)
}

#[test]
fn p02_p03_no_leaks_unit_f64() {
    check_edges::<f64>("unit", centered(1.0), 1.0, 1.0, 0x9_0001_0000);
}

#[test]
fn p02_p03_no_leaks_unit_f32() {
    check_edges::<f32>("unit", centered(1.0), 1.0, 1.0, 0x9_0003_0000);
}

#[test]
fn p07_no_leaks_sliver_f64() {
    check_edges::<f64>("sliver", centered(1.0), 1.0, 1e-6, 0x9_0005_0000);
}

#[test]
fn p07_no_leaks_sliver_f32() {
    check_edges::<f32>("sliver", centered(1.0), 1.0, 1e-6, 0x9_0007_0000);
}

#[test]
fn p07_no_leaks_tower_f64() {
    check_edges::<f64>("tower", centered(1.0), 1.0, 1e6, 0x9_0009_0000);
}

#[test]
fn p07_no_leaks_tower_f32() {
    check_edges::<f32>("tower", centered(1.0), 1.0, 1e6, 0x9_000B_0000);
}

#[test]
fn p02_p03_no_leaks_far_from_the_origin_f64() {
    let corner = DVec3::new(999_999.5, 999_999.5, 1e6);
    check_edges::<f64>("at 1e6", corner, 1.0, 1.0, 0x9_000D_0000);
}

#[test]
fn p02_p03_no_leaks_far_from_the_origin_f32() {
    let corner = DVec3::new(9_999.5, 9_999.5, 1e4);
    check_edges::<f32>("at 1e4", corner, 1.0, 1.0, 0x9_000F_0000);
}

fn check_needle<T: Precision>(finest: f64, seed: u64) {
    let width = 1e-6;
    let pyramid = Pyramid::<T>::new(centered(width), width, 1.0);
    let mut figures = Figures::new::<T>("needle at 1e3");
    for number in 0..50_000 {
        let random = &mut Random::new(seed + number);
        let aside = random.between(999.0, 1001.0) * if random.coin() { 1.0 } else { -1.0 };
        let origin = DVec3::new(aside, 0.0, random.share());
        // At the outline to within a tenth of a step of the distance, up to the needle's own width.
        let height = random.share();
        let outline = 0.5 * width * (1.0 - height) * if random.coin() { 1.0 } else { -1.0 };
        let slip = random.between(-1.0, 1.0) * random.magnitude(finest, -6.0);
        let target = DVec3::new(0.0, outline + slip, height);
        check_random(&pyramid, &ray(origin, target - origin), &mut figures);
    }
    assert!(figures.hits > 10_000 && figures.rays - figures.hits > 10_000);
}

#[test]
fn p08_a_needle_afar_is_met_only_where_it_is_f64() {
    check_needle::<f64>(-14.0, 0x9_0800_0000);
}

#[test]
fn p08_a_needle_afar_is_met_only_where_it_is_f32() {
    check_needle::<f32>(-10.0, 0x9_0801_0000);
}

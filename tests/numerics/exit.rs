//! Rays that start on a body: into it they leave by another face, out of it they never come back.

use archetrace::effects::reflect;
use archetrace::geometry::{Convex, Crossing, CubeShape, Ray, Side, SphereShape, Vector};
use glam::DVec3;

use crate::oracle::{Ball, Body, Exact, ExactRay, ExactVector, exact, magnitude, nearest, relative_error};
use crate::precision::{Precision, ray};
use crate::pyramid::Pyramid;
use crate::worst::Worst;
use archetrace::selfcheck::Random;

/// A body that a test can start rays from.
trait Start<T: Precision> {
    type Shape: Convex<T>;
    /// The kernel's shape.
    fn shape(&self) -> &Self::Shape;
    /// A point inside.
    fn inside(&self, random: &mut Random) -> DVec3;
    /// Its extent.
    fn size(&self) -> f64;

    /// A ray from outside, the surface point it meets, and the face.
    fn land(&self, random: &mut Random) -> (Vector<T>, Vector<T>, u8) {
        loop {
            let target = self.inside(random);
            let origin = target + random.direction() * self.size() * random.magnitude(0.5, 2.0);
            let ray = ray::<T>(origin, target - origin);
            if let Some(hit) = self.shape().intersect(&ray).filter(|hit| hit.side == Side::Outside) {
                let place = self.shape().locate(&ray, &hit);
                return (place.point, place.normal, hit.face);
            }
        }
    }

    /// A ray from a surface point to the side of the normal that `outwards` says, by the kernels' own arithmetic.
    fn start(&self, random: &mut Random, outwards: bool) -> (Ray<T>, Vector<T>, u8) {
        let (origin, normal, face) = self.land(random);
        loop {
            let free = if random.below(4) == 0 {
                // Along the surface.
                random.across(normal.to_dvec3()) + normal.to_dvec3() * random.magnitude(-18.0, -2.0)
            } else {
                random.direction()
            };
            let direction = Vector::<T>::from_dvec3(free);
            let along = direction.dot(normal);
            if along != T::ZERO {
                let turned = if (along > T::ZERO) == outwards { direction } else { -direction };
                return (Ray { origin, direction: turned }, normal, face);
            }
        }
    }
}

impl<T: Precision> Start<T> for CubeShape<T> {
    type Shape = Self;
    fn shape(&self) -> &Self {
        self
    }
    fn inside(&self, random: &mut Random) -> DVec3 {
        let share = DVec3::new(random.share(), random.share(), random.share());
        self.min.to_dvec3() + share * (self.max - self.min).to_dvec3()
    }
    fn size(&self) -> f64 {
        (self.max - self.min).to_dvec3().length()
    }
}

impl<T: Precision> Start<T> for Pyramid<T> {
    type Shape = archetrace::geometry::PyramidShape<T>;
    fn shape(&self) -> &Self::Shape {
        &self.shape
    }
    fn inside(&self, random: &mut Random) -> DVec3 {
        self.inner_point(random)
    }
    fn size(&self) -> f64 {
        self.shape.height.to_f64() + 2.0 * self.shape.half_width.to_f64()
    }
}

impl<T: Precision> Start<T> for SphereShape<T> {
    type Shape = Self;
    fn shape(&self) -> &Self {
        self
    }
    fn inside(&self, random: &mut Random) -> DVec3 {
        self.center.to_dvec3() + random.direction() * (0.95 * random.share() * self.radius.to_f64())
    }
    fn size(&self) -> f64 {
        self.radius.to_f64()
    }
}

fn random_cube<T: Precision>(random: &mut Random) -> CubeShape<T> {
    let scale = random.magnitude(-3.0, 3.0);
    CubeShape::new(random.point() * scale, scale * random.magnitude(-1.5, 1.0))
}

fn random_pyramid<T: Precision>(random: &mut Random) -> Pyramid<T> {
    let scale = random.magnitude(-2.0, 2.0);
    let height = scale * random.magnitude(-1.5, 1.5);
    Pyramid::new(random.point() * scale, scale, height)
}

fn random_sphere<T: Precision>(random: &mut Random) -> SphereShape<T> {
    let radius = random.magnitude(-3.0, 3.0);
    let center = random.direction() * radius * random.magnitude(-2.0, 1.5);
    SphereShape { center: Vector::from_dvec3(center), radius: T::from_f64(radius) }
}

/// How far a place can be off by the rounding of its own coordinates and of the body's.
fn place_blur<T: Precision>(point: Vector<T>, size: f64) -> f64 {
    4.0 * T::EPSILON * (point.to_dvec3().length() + size)
}

/// What holds for every exit: it lies ahead or at the start, and not on the face the ray starts from.
fn check_ahead<T: Precision>(exit: &Crossing<T>, from: Option<u8>, input: &impl Fn() -> String) {
    assert!(exit.t >= T::ZERO && exit.t.is_finite(), "{exit:?}: {}", input());
    assert_ne!(Some(exit.face), from, "{}", input());
    assert_eq!(exit.side, Side::Inside);
}

/// The exact exit by any face but one; 0 where the start lies beyond it by rounding.
fn exact_exit(body: &Body, ray: &ExactRay, from: u8) -> (Exact, u8) {
    let mut others = body.0.clone();
    others.remove(usize::from(from));
    let (t, place) = Body(others).exit(ray).unwrap();
    (t.max(Exact::ZERO), if place < from { place } else { place + 1 })
}

fn check_cube<T: Precision>(seed: u64) {
    let mut worst = Worst::new(&format!("exit, cube, t, {}", T::NAME));
    for number in 0..20_000 {
        let random = &mut Random::new(seed + number);
        let cube = random_cube::<T>(random);
        let (ray, _, from) = cube.start(random, false);
        let describe = || format!("{cube:?} {ray:?} from {from}");
        let exit = cube.exit(&ray, from);
        check_ahead(&exit, Some(from), &describe);
        let body = Body::cube(cube.min, cube.max);
        let (truth, _) = exact_exit(&body, &ExactRay::of(&ray), from);
        // A start on an edge leaves at once, and then both are 0.
        worst.measure(relative_error(exit.t, &truth) / T::EPSILON, 1.0 + 1e-6, describe);
        let place = cube.locate(&ray, &exit);
        assert!(body.contains(&ExactVector::of(place.point)), "{}", describe());
        assert!(place.normal.dot(ray.direction) > T::ZERO, "{}", describe());
    }
}

#[test]
fn r10_a_ray_into_a_cube_leaves_by_another_face_f64() {
    check_cube::<f64>(0xE_0001_0000);
}

#[test]
fn r10_a_ray_into_a_cube_leaves_by_another_face_f32() {
    check_cube::<f32>(0xE_0002_0000);
}

fn check_pyramid<T: Precision>(seed: u64) {
    let mut worst = Worst::new(&format!("exit, pyramid, t / bound, {}", T::NAME));
    for number in 0..20_000 {
        let random = &mut Random::new(seed + number);
        let pyramid = random_pyramid::<T>(random);
        let (ray, _, from) = pyramid.start(random, false);
        let describe = || format!("{:?} {ray:?} from {from}", pyramid.shape);
        let exit = pyramid.shape.exit(&ray, from);
        check_ahead(&exit, Some(from), &describe);
        let exact_ray = ExactRay::of(&ray);
        let (truth, face) = exact_exit(&pyramid.body, &exact_ray, from);
        let t = nearest(&truth);
        let allowed = [face, exit.face].map(|face| pyramid.step(face, &ray, &exact_ray, t));
        let error = nearest(&magnitude(exact(exit.t) - &truth));
        worst.measure(error / allowed[0].max(allowed[1]), 1.0, describe);
        let place = pyramid.shape.locate(&ray, &exit);
        let blur = place_blur(place.point, pyramid.size()) + place_blur(ray.origin, pyramid.size());
        let grown = pyramid.body.grown(&[blur; 5]);
        assert!(grown.contains(&ExactVector::of(place.point)), "{}", describe());
        let off = pyramid.body.0[usize::from(exit.face)].outside(&ExactVector::of(place.point));
        let length = pyramid.body.0[usize::from(exit.face)].normal.length();
        assert!(nearest(&magnitude(off / length)) <= blur, "{}", describe());
        assert!(place.normal.dot(ray.direction) > T::ZERO, "{}", describe());
    }
}

#[test]
fn r10_a_ray_into_a_pyramid_leaves_by_another_face_f64() {
    check_pyramid::<f64>(0xE_0003_0000);
}

#[test]
fn r10_a_ray_into_a_pyramid_leaves_by_another_face_f32() {
    check_pyramid::<f32>(0xE_0004_0000);
}

/// The start is off the sphere by rounding, so that `c` is not quite 0 and the exact exit is not quite twice the way to
/// the chord's middle: it differs by at most `c / h`, and by the root of `c` where the ray grazes.
fn check_sphere<T: Precision>(seed: u64) {
    let mut worst = Worst::new(&format!("exit, sphere, t / bound, {}", T::NAME));
    for number in 0..20_000 {
        let random = &mut Random::new(seed + number);
        let sphere = random_sphere::<T>(random);
        let (ray, _, from) = sphere.start(random, false);
        let describe = || format!("{sphere:?} {ray:?}");
        let exit = sphere.exit(&ray, from);
        check_ahead(&exit, None, &describe);

        let exact_ray = ExactRay::of(&ray);
        let ball = Ball::of(sphere.center, sphere.radius);
        let quadratic = ball.quadratic(&exact_ray);
        let truth = quadratic.roots().map_or(Exact::ZERO, |(_, far)| far.max(Exact::ZERO));
        let length = nearest(&quadratic.a).sqrt();
        let middle = (nearest(&quadratic.h) / length).abs();
        let c = nearest(&quadratic.c).abs();
        let radius = sphere.radius.to_f64();
        let allowed = (2.0 * c / middle).min(2.0 * c.sqrt()) + 4.0 * T::EPSILON * radius;
        let error = nearest(&magnitude(exact(exit.t) - &truth)) * length;
        worst.measure(error / allowed, 1.0, describe);

        let place = sphere.locate(&ray, &exit);
        let from_center = ExactVector::of(place.point).minus(&ball.center).length();
        let off = nearest(&magnitude(from_center - &ball.radius));
        assert!(off <= place_blur(place.point, radius), "{off:e}: {}", describe());
    }
}

#[test]
fn r10_a_ray_into_a_sphere_leaves_at_the_far_root_f64() {
    check_sphere::<f64>(0xE_0005_0000);
}

#[test]
fn r10_a_ray_into_a_sphere_leaves_at_the_far_root_f32() {
    check_sphere::<f32>(0xE_0006_0000);
}

/// Light between mirrors inside a body: each leg must end within the body, a thousand times over.
fn check_trapped<T: Precision, S: Start<T>>(
    start: &S,
    random: &mut Random,
    holds: impl Fn(Vector<T>) -> bool,
) {
    let (mut ray, _, mut face) = start.start(random, false);
    for bounce in 0..1_000 {
        let exit = start.shape().exit(&ray, face);
        let place = start.shape().locate(&ray, &exit);
        assert!(holds(place.point), "bounce {bounce}: {ray:?} {exit:?} {place:?}");
        let direction = reflect(ray.direction.unit(), -place.normal);
        ray = Ray { origin: place.point, direction };
        face = exit.face;
    }
}

#[test]
fn r05_a_thousand_mirror_images_stay_within_a_cube() {
    fn check<T: Precision>() {
        for number in 0..50 {
            let random = &mut Random::new(0xE_0500_0000 + number);
            let cube = random_cube::<T>(random);
            let body = Body::cube(cube.min, cube.max);
            check_trapped(&cube, random, |point| body.contains(&ExactVector::of(point)));
        }
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn r05_a_thousand_mirror_images_stay_within_a_pyramid() {
    fn check<T: Precision>() {
        for number in 0..50 {
            let random = &mut Random::new(0xE_0501_0000 + number);
            let pyramid = random_pyramid::<T>(random);
            let blur = 2.0 * place_blur(pyramid.shape.apex, pyramid.size());
            let grown = pyramid.body.grown(&[blur; 5]);
            check_trapped(&pyramid, random, |point| grown.contains(&ExactVector::of(point)));
        }
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn r05_a_thousand_mirror_images_stay_within_a_sphere() {
    fn check<T: Precision>() {
        for number in 0..50 {
            let random = &mut Random::new(0xE_0502_0000 + number);
            let sphere = random_sphere::<T>(random);
            let ball = Ball::of(sphere.center, sphere.radius);
            check_trapped(&sphere, random, |point| {
                let from_center = ExactVector::of(point).minus(&ball.center).length();
                nearest(&magnitude(from_center - &ball.radius)) <= place_blur(point, sphere.size())
            });
        }
    }
    check::<f64>();
    check::<f32>();
}

/// Outward rays from a body: none meets it again, as exact geometry knows it.
fn count_returns<T: Precision, S: Start<T>>(
    seed: u64,
    make: impl Fn(&mut Random) -> S,
    returns: impl Fn(&S, &Ray<T>) -> bool,
) -> u32 {
    (0..100_000)
        .map(|number| {
            let random = &mut Random::new(seed + number);
            let start = make(random);
            let (ray, _, _) = start.start(random, true);
            u32::from(returns(&start, &ray))
        })
        .sum()
}

#[test]
fn r04_outward_rays_never_meet_their_cube_again() {
    // Points on a cube are exact, so this holds with no tolerance.
    fn check<T: Precision>() {
        let returns = count_returns::<T, _>(0xE_0601_0000, random_cube, |cube, ray| {
            Body::cube(cube.min, cube.max).meet(&ExactRay::of(ray)).is_some()
        });
        assert_eq!(returns, 0);
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn r04_outward_rays_never_meet_their_pyramid_again_below_its_skin() {
    fn check<T: Precision>() {
        let returns = count_returns::<T, _>(0xE_0602_0000, random_pyramid, |pyramid, ray| {
            let blur = place_blur(ray.origin, pyramid.size());
            pyramid.body.grown(&[-blur; 5]).meet(&ExactRay::of(ray)).is_some()
        });
        assert_eq!(returns, 0);
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn r04_outward_rays_never_meet_their_sphere_again_below_its_skin() {
    fn check<T: Precision>() {
        let returns = count_returns::<T, _>(0xE_0603_0000, random_sphere, |sphere, ray| {
            let blur = place_blur(ray.origin, sphere.radius.to_f64());
            let core =
                Ball { center: ExactVector::of(sphere.center), radius: exact(sphere.radius) - exact(blur) };
            core.meet(&ExactRay::of(ray)).is_some()
        });
        assert_eq!(returns, 0);
    }
    check::<f64>();
    check::<f32>();
}

/// Outward rays that meet a twin of the body that they leave: how many, and the largest sine of the angle between such
/// a ray and the surface, in epsilons. `places` is how far rounding moves the body, in epsilons of its size.
fn measure_twins<T: Precision, S: Start<T>>(
    seed: u64,
    make: impl Fn(&mut Random) -> S,
    places: impl Fn(&S) -> f64,
) -> (u32, f64) {
    let mut met = (0, 0.0);
    for number in 0..200_000 {
        let random = &mut Random::new(seed + number);
        let start = make(random);
        let (ray, normal, _) = start.start(random, true);
        if start.shape().intersect(&ray).is_some() {
            let direction = ray.direction.to_dvec3();
            let sine = normal.to_dvec3().dot(direction) / direction.length();
            met = (met.0 + 1, f64::max(met.1, sine / (T::EPSILON * places(&start))));
        }
    }
    met
}

/// The trace skips the body that a ray leaves. A twin of it, or one that touches it, is tested like any other, from a
/// point that rounding may have put below its skin. A twin is met only by rays whose angle to the surface is as small
/// as rounding itself: the light along them counts by the sine of that angle, which is nothing.
#[test]
fn b10_a_twin_of_the_body_that_a_ray_leaves_is_met_along_the_surface_only() {
    fn check<T: Precision>() {
        let place = |place: Vector<T>, size: f64| 1.0 + place.to_dvec3().length() / size;
        let sphere =
            measure_twins(0xE_0605_0000, random_sphere::<T>, |sphere| place(sphere.center, sphere.size()));
        let cube = measure_twins(0xE_0606_0000, random_cube::<T>, |cube| place(cube.min, cube.size()));
        let pyramid = measure_twins(0xE_0604_0000, random_pyramid::<T>, |pyramid| {
            // At an edge between two faces a place is as uncertain as the edge is sharp.
            let steep = (pyramid.shape.height / pyramid.shape.half_width).to_f64();
            place(pyramid.shape.apex, pyramid.size()) * (1.0 + steep.max(steep.recip()))
        });
        println!(
            "exit, outward rays of 200000 that meet a twin, and at which angle in epsilons, {}: sphere {sphere:?}, \
             cube {cube:?}, pyramid {pyramid:?}",
            T::NAME
        );
        assert!(sphere.1 < 2.0 && pyramid.1 < 64.0);
        assert_eq!(cube.0, 0);
    }
    check::<f64>();
    check::<f32>();
}

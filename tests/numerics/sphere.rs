//! The sphere: 22 truths to 25 digits, and random rays from a pebble at the horizon to a planet underfoot.

use archetrace::components::range;
use archetrace::geometry::{Convex, Ray, Side, SphereShape, SurfacePoint, Vector, basis_looking};
use glam::DVec3;

use crate::oracle::{Ball, Exact, ExactRay, ExactVector, decimal, nearest, relative_error};
use crate::precision::{Precision, bits, ray};
use crate::shown::check_shown;
use crate::textbook;
use crate::worst::Worst;
use archetrace::selfcheck::Random;

/// Asked of `t` and of the normal, in epsilons, where the ray does not graze.
const BOUND: f64 = 4.0;
/// Half chord by radius of a ray that passes the centre at 0.95 radii; `t` and normals are printed up to there.
const GRAZING: f64 = 0.312;

/// Origin, direction, centre, radius and the expected `t` (`""` for a miss) of a case.
#[derive(Clone)]
struct Case {
    id: &'static str,
    origin: [f64; 3],
    direction: [f64; 3],
    center: [f64; 3],
    radius: f64,
    t: &'static str,
    side: Side,
}

/// A case whose ray comes from outside.
fn case(
    id: &'static str,
    origin: [f64; 3],
    direction: [f64; 3],
    center: [f64; 3],
    radius: f64,
    t: &'static str,
) -> Case {
    Case { id, origin, direction, center, radius, t, side: Side::Outside }
}

const O: [f64; 3] = [0.0; 3];
const X: [f64; 3] = [1.0, 0.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];
const AWAY: [f64; 3] = [-5.0, 0.25, 0.0];

fn far_cases<T: Precision>() -> Vec<Case> {
    let slant = [0.6, 0.8, 0.0];
    // In `f32` the slanted direction itself is off by more than a radius at 1e8: there it is a thousand radii away.
    let oblique = T::of([60_000_000.25, 8e7, 0.25], [600.25, 800.0, 0.25]);
    vec![
        case("S01 small and far", O, X, [1e8, 0.5, 0.0], 1.0, "99999999.13397459621556135"),
        case("S02 tiny", O, X, [1e6, 5e-4, 0.0], 1e-3, "999999.9991339745962155613"),
        case("S03 oblique and far", O, slant, oblique, 1.0, "99999999.20263523264225842"),
        case("S15 direction of length 3", AWAY, [3.0, 0.0, 0.0], O, 1.0, "1.343918054482715259568395"),
        case("S16 direction of length 1e-6", AWAY, [1e-6, 0.0, 0.0], O, 1.0, "4031754.163448145961149672"),
        case(
            "S19 far from the origin",
            [999_995.0, 1_000_000.25, 1e6],
            X,
            [1e6; 3],
            1.0,
            "4.031754163448145778705184",
        ),
    ]
}

fn planet_cases() -> Vec<Case> {
    let down = [0.0, 0.6, -0.8];
    let slope = [core::f64::consts::FRAC_1_SQRT_2, 0.0, -core::f64::consts::FRAC_1_SQRT_2];
    vec![
        case("S04 planet", Z, slope, [0.0, 0.0, -1e6], 1e6, "1.41421426948058324651808"),
        case("S05 planet", Z, down, [0.0, 0.0, -1e8], 1e8, "1.250000003515624950386451"),
        case(
            "S06 skimming a planet",
            [0.0, 0.0, 1e-3],
            down,
            [0.0, 0.0, -1e6],
            1e6,
            "0.001250000000351562456829667",
        ),
    ]
}

fn tangent_cases<T: Precision>() -> Vec<Case> {
    let beside = |y: T| [-5.0, y.to_f64(), 0.0];
    let before_1 = T::of(0.999_999_999, 0.999_99);
    vec![
        case("S07 exact tangent is a hit", beside(T::ONE), X, O, 1.0, "5"),
        case(
            "S08 one step inside the tangent",
            beside(T::ONE.down()),
            X,
            O,
            1.0,
            "4.999999985098838806152344",
        ),
        case("S09 one step outside the tangent is a miss", beside(T::ONE.up()), X, O, 1.0, ""),
        case("S10 grazing from afar", [-1e4, before_1, 0.0], X, O, 1.0, "9999.999955278641093587763"),
        case("S21 behind is a miss", [5.0, 0.0, 0.0], X, O, 1.0, ""),
    ]
}

fn inside_cases<T: Precision>() -> Vec<Case> {
    let before_1 = T::of(0.999_999_999, 0.999_99);
    let inside =
        |id, origin, direction, t| Case { side: Side::Inside, ..case(id, origin, direction, O, 1.0, t) };
    vec![
        inside("S11 from the centre", O, Z, "1"),
        inside("S12 just before the wall", [0.0, 0.0, before_1], Z, "9.999999717180685365747195e-10"),
        inside("S13 on the surface, outwards, is a miss", Z, Z, ""),
        inside("S14 on the surface, inwards", Z, [0.0, 0.0, -1.0], "2"),
    ]
}

fn sphere(center: DVec3, radius: f64) -> SphereShape<f64> {
    SphereShape { center: Vector::from_dvec3(center), radius }
}

/// Hit or miss, side, `t`, point and normal as exact arithmetic has them for the rounded case, and that a scene shows the
/// sphere there by every way of searching it. Even at the tangent `t` keeps its digits, but for those that
/// [`Ends::bound`] explains.
fn check_case<T: Precision>(case: &Case, worst: &mut Worst, surface: &mut Surface) {
    let shape =
        SphereShape { center: Vector::from_dvec3(case.center.into()), radius: T::from_f64(case.radius) };
    let ray = ray::<T>(case.origin.into(), case.direction.into());
    let ends = Ends::of(&shape, &ray);
    let truth = ends.ball.meet(&ends.ray);
    let found = shape.intersect(&ray);
    let describe = || format!("{}, {}: {found:?}", case.id, T::NAME);
    check_shown(&shape, &ray);
    if case.t.is_empty() {
        // S13 starts on the surface: its other root is 0, or behind.
        assert_eq!((found, truth.map(|hit| nearest(&hit.t))), (None, None), "{}", describe());
        return;
    }
    let (truth, crossing) = (truth.unwrap(), found.unwrap_or_else(|| panic!("missed: {}", describe())));
    assert_eq!((crossing.side, crossing.face, truth.side), (case.side, 0, case.side), "{}", describe());
    worst.measure(relative_error(crossing.t, &truth.t) / T::EPSILON, BOUND, describe);
    ends.check_surface(&shape, &ray, surface);
    let found = shape.locate(&ray, &crossing);
    let off = ExactVector::of(found.point).minus(&ends.ray.at(&truth.t)).length();
    let world = shape.center.to_dvec3().length() + case.radius;
    // At the tangent the half chord is the root of a rounding, and so is what the point is off by.
    let normal = ends.normal_bound().min(2.0 / T::EPSILON.sqrt());
    let bound = T::EPSILON * (normal * ends.distance * case.radius + world);
    assert!(nearest(&off) <= bound, "{:e} off: {}", nearest(&off), describe());
    let way = found.normal.dot(ray.direction);
    assert!(if case.side == Side::Inside { way > T::ZERO } else { way <= T::ZERO }, "{}", describe());
}

fn check_cases<T: Precision>(name: &str, cases: &[Case]) {
    let mut worst = Worst::new(&format!("sphere, {name}, t, {}", T::NAME));
    let mut surface = Surface::new(&format!("{name}, {}", T::NAME));
    for case in cases {
        check_case::<T>(case, &mut worst, &mut surface);
    }
}

#[test]
fn the_truths_are_those_of_exact_fractions() {
    let cases = [far_cases::<f64>(), planet_cases(), tangent_cases::<f64>(), inside_cases::<f64>()].concat();
    for case in cases.iter().filter(|case| !case.t.is_empty()) {
        let ball = Ball::of::<f64>(Vector::from_dvec3(case.center.into()), case.radius);
        let truth = ball.meet(&ExactRay::of(&ray::<f64>(case.origin.into(), case.direction.into()))).unwrap();
        assert_eq!(truth.side, case.side, "{}", case.id);
        let off = nearest(&((decimal(case.t) - &truth.t) / &truth.t)).abs();
        assert!(off < 1e-23, "{}: {off:e}", case.id);
    }
}

#[test]
fn s01_to_s03_s15_s16_s19_far_spheres_keep_all_digits() {
    check_cases::<f64>("far cases", &far_cases::<f64>());
    check_cases::<f32>("far cases", &far_cases::<f32>());
}

#[test]
fn s04_to_s06_planets_underfoot_keep_all_digits() {
    check_cases::<f64>("planet cases", &planet_cases());
    check_cases::<f32>("planet cases", &planet_cases());
}

#[test]
fn s07_to_s10_s21_tangents_and_misses() {
    check_cases::<f64>("tangent cases", &tangent_cases::<f64>());
    check_cases::<f32>("tangent cases", &tangent_cases::<f32>());
}

#[test]
fn s11_to_s14_from_inside_and_from_the_surface() {
    check_cases::<f64>("inside cases", &inside_cases::<f64>());
    check_cases::<f32>("inside cases", &inside_cases::<f32>());
}

#[test]
fn s06b_a_millionth_above_a_planet() {
    let altitude = 1e-6;
    let truth = "1.25000000000035144e-6";
    let skim = case("S06b", [0.0, 0.0, altitude], [0.0, 0.6, -0.8], [0.0, 0.0, -1e6], 1e6, truth);
    // The truth is known to 18 digits only, which is enough for an epsilon of 2e-16.
    check_cases::<f64>("S06b", core::slice::from_ref(&skim));
    check_cases::<f32>("S06b", core::slice::from_ref(&skim));
}

#[test]
fn s17_s18_a_direction_of_any_length_shows_the_same() {
    fn check<T: Precision>() {
        let shape = SphereShape { center: Vector::default(), radius: T::ONE };
        // A camera's look becomes a unit vector before there is a ray.
        let hit = |length: f64| {
            let [look, _, _] = basis_looking(DVec3::new(5.0, 0.5, -0.25) * length, DVec3::Z).unwrap();
            let ray = ray::<T>(AWAY.into(), look);
            check_shown(&shape, &ray);
            let crossing = shape.intersect(&ray).unwrap();
            let SurfacePoint { point, normal } = shape.locate(&ray, &crossing);
            (crossing.t.bits(), crossing.side, bits(point), bits(normal))
        };
        for length in [1e-170, 2.0_f64.powi(-700), 2.0_f64.powi(500), 1e160] {
            let (t, side, point, normal) = hit(length);
            let plain = hit(1.0);
            if length.log2().fract() == 0.0 {
                assert_eq!((t, side, point, normal), plain, "{length:e}");
            } else {
                // The length itself is rounded: up to a step in each component.
                let off = t.abs_diff(plain.0);
                assert!(off <= 8 && side == plain.1, "{length:e}: {off}");
            }
        }
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn s20_scaled_by_a_power_of_two_only_the_exponent_changes() {
    /// The hit as it is without the scale: distance, point, normal.
    fn at<T: Precision>(scale: f64) -> (u64, [u64; 3], [u64; 3]) {
        let shape = SphereShape { center: Vector::default(), radius: T::from_f64(scale) };
        let ray = ray::<T>(DVec3::new(-5.0, 0.25, 0.0) * scale, DVec3::X);
        let crossing = shape.intersect(&ray).unwrap();
        assert_eq!((crossing.side, crossing.face), (Side::Outside, 0));
        let SurfacePoint { point, normal } = shape.locate(&ray, &crossing);
        let scale = T::from_f64(scale);
        ((crossing.t / scale).bits(), bits(point / scale), bits(normal))
    }
    for exponent in [-100, -60, 60, 100] {
        assert_eq!(at::<f64>(2.0_f64.powi(exponent)), at::<f64>(1.0), "2^{exponent}");
    }
    // Further off, single numbers end; tables are in a unit of their own.
    for exponent in [-20, 20] {
        assert_eq!(at::<f32>(2.0_f64.powi(exponent)), at::<f32>(1.0), "2^{exponent}");
    }
    let truth = decimal("3.180493239006287466201229e-30");
    let tiny = f64::from_bits(at::<f64>(2.0_f64.powi(-100)).0) * 2.0_f64.powi(-100);
    assert!(relative_error(tiny, &truth) <= BOUND * f64::EPSILON);
}

#[test]
fn s22_a_radius_whose_square_underflows_is_refused() {
    assert!(!range::LENGTH.contains(1e-200));
    assert!(range::LENGTH.contains(1e-70) && range::LENGTH.contains(1e70));
}

#[test]
fn s22_the_smallest_and_largest_allowed_sphere_keep_all_digits() {
    let mut random = Random::new(22);
    let mut figures = Figures::new::<f64>("range limits");
    for scale in [1e-70, 1e70] {
        for _ in 0..500 {
            let origin = random.direction() * scale * random.between(0.0, 1.0);
            let center = random.direction() * scale * random.between(0.0, 1.0);
            let aim = center + random.direction() * scale * 0.5 - origin;
            check_random(&sphere(center, scale), &ray(origin, aim / scale), &mut figures);
        }
    }
}

#[test]
fn s23_minus_zero_and_denormal_components_count_as_zero() {
    fn check<T: Precision>(least: f64) {
        let shape = SphereShape { center: Vector::default(), radius: T::ONE };
        let at = |direction: DVec3| {
            let ray = ray::<T>(DVec3::new(-5.0, 0.25, 0.0), direction);
            let crossing = shape.intersect(&ray).unwrap();
            let SurfacePoint { point, normal } = shape.locate(&ray, &crossing);
            (crossing.t.bits(), crossing.side, [point.x, point.y, normal.x, normal.y].map(T::bits))
        };
        for (y, z) in [(-0.0, least), (0.0, -0.0), (-least, 0.0)] {
            // The third coordinates are as small as that.
            assert!(at(DVec3::new(1.0, y, z)) == at(DVec3::X), "{}: {y:e} {z:e}", T::NAME);
        }
    }
    check::<f64>(5e-324);
    check::<f32>(f64::from(f32::from_bits(1)));
}

#[test]
fn the_textbook_formula_misses_the_bound_on_s01_and_s05() {
    for case in [&far_cases::<f64>()[0], &planet_cases()[1]] {
        let shape = sphere(case.center.into(), case.radius);
        let ray = ray::<f64>(case.origin.into(), case.direction.into());
        let t = textbook::near_root(&shape, &ray).unwrap();
        let error = relative_error(t, &decimal(case.t));
        assert!(error > 1e6 * BOUND * f64::EPSILON, "{}: {error:e}", case.id);
    }
}

#[test]
fn the_textbook_formula_hits_what_s09_says_is_missed() {
    let outside = ray::<f64>(DVec3::new(-5.0, 1.0_f64.up(), 0.0), DVec3::X);
    assert!(textbook::near_root(&sphere(DVec3::ZERO, 1.0), &outside).is_some());
}

/// Exact values of one ray and sphere.
struct Ends {
    ball: Ball,
    ray: ExactRay,
    /// Squared half chord by squared radius: 1 through the centre, 0 at a tangent, below it at a miss.
    depth: f64,
    /// Distance of the origin from the centre in radii, but at least 1.
    distance: f64,
    /// Distance along the ray from the origin to the chord's middle, in radii.
    middle: f64,
}

impl Ends {
    fn of<T: Precision>(shape: &SphereShape<T>, ray: &Ray<T>) -> Self {
        let ball = Ball::of(shape.center, shape.radius);
        let ray = ExactRay::of(ray);
        let quadratic = ball.quadratic(&ray);
        let depth = quadratic.discriminant() / (&quadratic.a * ball.radius.sqr());
        let distance = (&quadratic.c / ball.radius.sqr()) + Exact::ONE;
        let middle = quadratic.h.sqr() / (&quadratic.a * ball.radius.sqr());
        Self {
            depth: nearest(&depth),
            distance: nearest(&distance).sqrt().max(1.0),
            middle: nearest(&middle).sqrt(),
            ball,
            ray,
        }
    }

    /// Distance of the line from the sphere's rim, as a share of the radius: `b/r - 1`.
    fn rim(&self) -> f64 {
        -self.depth / (1.0 + (1.0 - self.depth).sqrt())
    }

    /// Half the chord, in radii.
    fn half(&self) -> f64 {
        self.depth.max(0.0).sqrt()
    }

    /// What `t` may be off by, in epsilons: 4, and more towards the rim.
    ///
    /// Both roots hang on `q`, the way `m` to the chord's middle plus half the chord. Three roundings, half an epsilon
    /// each, move the middle along the ray and across it by shares of the distance D from the centre. From afar, across
    /// counts `r / half` times: `q` is off by up to `1.5 D / q * (1 + r / half)` epsilons. Near the surface and inside,
    /// half the chord comes from `m` itself, whose error counts `m / half` times: `1.5 D / half`.
    fn bound(&self) -> f64 {
        let half = self.half();
        let is_near = 2.0 * self.middle * self.middle < 1.0 - half * half;
        let across = if is_near { self.middle } else { 1.0 };
        BOUND.max(1.5 * self.distance / (self.middle + half) * (1.0 + across / half))
    }

    /// What the normal may be off by, in epsilons of the distance: 4, and more towards the rim, as for `t`.
    fn normal_bound(&self) -> f64 {
        BOUND.max(1.5 * (1.0 + self.half().recip()))
    }

    /// The located point and normal against the exact ones.
    fn check_surface<T: Precision>(&self, shape: &SphereShape<T>, ray: &Ray<T>, surface: &mut Surface) {
        let crossing = shape.intersect(ray).unwrap();
        let meeting = self.ball.meet(&self.ray).unwrap();
        let found = shape.locate(ray, &crossing);
        let describe = || format!("{shape:?} {ray:?}");

        let radius = Exact::ONE / &self.ball.radius;
        let normal = self.ray.at(&meeting.t).minus(&self.ball.center).times(&radius);
        let error = nearest(&ExactVector::of(found.normal).minus(&normal).length());
        let error = error / (T::EPSILON * self.distance);
        if self.half() >= GRAZING {
            surface.normal.measure(error, f64::INFINITY, describe);
        }
        surface.normal_share.measure(error / self.normal_bound(), 1.0, describe);

        let from_center = ExactVector::of(found.point).minus(&self.ball.center).times(&radius);
        let off = nearest(&(from_center.length() - Exact::ONE)).abs() / T::EPSILON;
        // The point is a world position: its own rounding takes half an epsilon of it.
        let world = shape.center.to_dvec3().length() / shape.radius.to_f64() + 1.0;
        surface.off.measure(off / (BOUND + 0.5 * world), 1.0, describe);
    }
}

/// Errors of located points, as shares of their bounds.
struct Surface {
    normal: Worst,
    normal_share: Worst,
    off: Worst,
}

impl Surface {
    fn new(name: &str) -> Self {
        Self {
            normal: Worst::new(&format!("sphere, {name}, normal / distance")),
            normal_share: Worst::new(&format!("sphere, {name}, normal / bound")),
            off: Worst::new(&format!("sphere, {name}, distance from surface / bound")),
        }
    }
}

/// What a run of random rays has shown.
struct Figures {
    name: String,
    t: Worst,
    share: Worst,
    surface: Surface,
    rays: u32,
    hits: u32,
    in_band: u32,
    wrong_in_band: u32,
}

impl Figures {
    fn new<T: Precision>(name: &str) -> Self {
        let name = format!("{name}, {}", T::NAME);
        Self {
            t: Worst::new(&format!("sphere, {name}, t")),
            share: Worst::new(&format!("sphere, {name}, t / bound")),
            surface: Surface::new(&name),
            name,
            rays: 0,
            hits: 0,
            in_band: 0,
            wrong_in_band: 0,
        }
    }
}

impl Drop for Figures {
    fn drop(&mut self) {
        println!(
            "sphere, {}: {} rays, {} hits, {} in the band of 8 epsilon, {} of them told otherwise than exact",
            self.name, self.rays, self.hits, self.in_band, self.wrong_in_band
        );
    }
}

/// One ray: hit or miss, side, `t`, normal and point.
fn check_random<T: Precision>(shape: &SphereShape<T>, ray: &Ray<T>, figures: &mut Figures) {
    let ends = Ends::of(shape, ray);
    let truth = ends.ball.meet(&ends.ray);
    let found = shape.intersect(ray);
    let describe = || format!("{shape:?} {ray:?} truth {:?}", truth.as_ref().map(|hit| nearest(&hit.t)));
    figures.rays += 1;
    let in_band = ends.rim().abs() < 8.0 * T::EPSILON * ends.distance;
    figures.in_band += u32::from(in_band);
    if truth.is_some() != found.is_some() {
        assert!(in_band, "{}: {found:?}: {}", figures.name, describe());
        figures.wrong_in_band += 1;
        return;
    }
    let (Some(truth), Some(found)) = (&truth, found) else {
        return;
    };
    figures.hits += 1;
    assert_eq!(found.side, truth.side, "{}: {}", figures.name, describe());
    if in_band {
        return;
    }
    let error = relative_error(found.t, &truth.t) / T::EPSILON;
    if ends.half() >= GRAZING {
        figures.t.measure(error, BOUND, describe);
    }
    figures.share.measure(error / ends.bound(), 1.0, describe);
    ends.check_surface(shape, ray, &mut figures.surface);
}

/// A sphere and a ray that passes its centre at `impact` radii, from `distance` radii.
fn aimed<T: Precision>(
    random: &mut Random,
    radius: f64,
    distance: f64,
    impact: f64,
    world: f64,
) -> (SphereShape<T>, Ray<T>) {
    let origin = random.direction() * world;
    let towards = random.direction();
    let center = origin + towards * (distance * radius);
    let shape = SphereShape { center: Vector::from_dvec3(center), radius: T::from_f64(radius) };
    // Perpendicular to the ray, not to the line between the centres.
    let sine = impact / distance;
    let aim = towards * (1.0 - sine * sine).max(0.0).sqrt() + random.across(towards) * sine;
    (shape, ray(origin, aim * random.magnitude(-3.0, 3.0)))
}

fn check_far<T: Precision>(powers: f64, scales: f64, seed: u64) {
    let mut figures = Figures::new::<T>("far");
    for number in 0..20_000 {
        let random = &mut Random::new(seed + number);
        let radius = random.magnitude(-scales, scales);
        let distance = 1.001 * random.magnitude(0.0, powers);
        let impact = 0.95 * random.share().sqrt();
        let world = radius * distance * random.magnitude(-3.0, 1.0);
        let (shape, ray) = aimed::<T>(random, radius, distance, impact, world);
        check_random(&shape, &ray, &mut figures);
    }
}

#[test]
fn s01_random_far_spheres_f64() {
    check_far::<f64>(8.0, 8.0, 0x5_0001_0000);
}

#[test]
fn s01_random_far_spheres_f32() {
    check_far::<f32>(4.0, 2.0, 0x5_0002_0000);
}

/// Rays at the rim: within a millionth of it down to a few epsilons.
fn check_silhouette<T: Precision>(powers: f64, scales: f64, finest: f64, seed: u64) {
    let mut figures = Figures::new::<T>("silhouette");
    for number in 0..20_000 {
        let random = &mut Random::new(seed + number);
        let radius = random.magnitude(-scales, scales);
        let distance = 1.001 * random.magnitude(0.0, powers);
        let beside = distance * random.magnitude(finest, finest + 4.0);
        let impact = 1.0 + if random.coin() { beside } else { -beside };
        let world = radius * random.share();
        let (shape, ray) = aimed::<T>(random, radius, distance, impact.abs().min(distance), world);
        check_random(&shape, &ray, &mut figures);
    }
}

#[test]
fn s07_to_s10_random_silhouettes_f64() {
    check_silhouette::<f64>(8.0, 8.0, -16.5, 0x5_0003_0000);
}

#[test]
fn s07_to_s10_random_silhouettes_f32() {
    check_silhouette::<f32>(4.0, 2.0, -7.7, 0x5_0004_0000);
}

fn check_planet<T: Precision>(powers: f64, scales: f64, seed: u64) {
    let mut figures = Figures::new::<T>("planet");
    for number in 0..20_000 {
        let random = &mut Random::new(seed + number);
        let radius = random.magnitude(-scales, scales);
        let altitude = radius / random.magnitude(0.0, powers);
        let up = random.direction();
        let center = random.direction() * radius * random.share();
        let shape = SphereShape { center: Vector::from_dvec3(center), radius: T::from_f64(radius) };
        let origin = center + up * (radius + altitude);
        check_random(&shape, &ray(origin, random.direction() - up), &mut figures);
    }
}

#[test]
fn s04_to_s06_random_planets_f64() {
    check_planet::<f64>(8.0, 8.0, 0x5_0005_0000);
}

#[test]
fn s04_to_s06_random_planets_f32() {
    check_planet::<f32>(6.0, 2.0, 0x5_0006_0000);
}

#[test]
fn s05_random_rays_from_1_above_a_radius_of_1e8() {
    let mut figures = Figures::new::<f64>("radius 1e8, 1 above");
    for number in 0..20_000 {
        let random = &mut Random::new(0x5_0010_0000 + number);
        let up = random.direction();
        let center = random.direction() * 1e8 * random.share();
        let planet = sphere(center, 1e8);
        let steep = random.between(0.0, 3.0);
        let down = ray(center + up * (1e8 + 1.0), random.direction() - up * steep);
        check_random(&planet, &down, &mut figures);
    }
    assert!(figures.hits > 12_000);
}

fn check_inside<T: Precision>(powers: f64, scales: f64, seed: u64) {
    let mut figures = Figures::new::<T>("inside");
    for number in 0..20_000 {
        let random = &mut Random::new(seed + number);
        let radius = random.magnitude(-scales, scales);
        let center = random.direction() * radius * random.share();
        let shape = SphereShape { center: Vector::from_dvec3(center), radius: T::from_f64(radius) };
        let depth = random.magnitude(-powers, 0.0);
        let origin = center + random.direction() * (radius * (1.0 - depth));
        check_random(&shape, &ray(origin, random.direction()), &mut figures);
    }
}

#[test]
fn s11_to_s14_random_rays_from_inside_f64() {
    check_inside::<f64>(8.0, 8.0, 0x5_0007_0000);
}

#[test]
fn s11_to_s14_random_rays_from_inside_f32() {
    check_inside::<f32>(6.0, 2.0, 0x5_0008_0000);
}

#[test]
fn s19_moved_far_away_the_nearest_representable_sphere_is_met_as_exactly() {
    let mut figures = Figures::new::<f64>("moved by 1e6");
    for number in 0..5_000 {
        let random = &mut Random::new(0x5_0009_0000 + number);
        let distance = random.between(1.001, 10.0);
        let (shape, ray) = aimed::<f64>(random, 1.0, distance, 0.9, 1e6);
        check_random(&shape, &ray, &mut figures);
    }
}

//! What numerical care costs and buys: the sphere as textbooks have it beside the kernel of this program.

use crate::geometry::{Convex, Crossing, Ray, Real, Side, SphereShape, Vector};
use crate::selfcheck::{Aim, check_spheres};
use crate::trace::{Hit, Kind, ObjectId, SceneTables, closest_hit};

use super::cost::CareRow;

/// Rays of each group whose errors are measured.
const RAYS: u64 = 20_000;
/// Rays that are timed.
const TIMED: u32 = 200_000;
/// Textbooks begin a ray so far from where it starts, in world units, lest it meets the surface that it leaves.
const TEXTBOOK_OFFSET: f64 = 1e-3;
/// Seed of the rays.
const SEED: u64 = 1;

/// Both ways in both precisions, the textbook's first. `clock` tells milliseconds.
pub fn price_of_care(clock: &mut dyn FnMut() -> f64) -> Vec<CareRow> {
    vec![
        textbook::<f32>("f32, textbook", clock),
        careful::<f32>("f32, this program", clock),
        textbook::<f64>("f64, textbook", clock),
        careful::<f64>("f64, this program", clock),
    ]
}

fn textbook<T: Real>(way: &'static str, clock: &mut dyn FnMut() -> f64) -> CareRow {
    let is_met = |sphere: &SphereShape<T>, ray: &Ray<T>| textbook_sphere(sphere, ray, T::ZERO);
    let offset = T::from_f64(TEXTBOOK_OFFSET);
    let returns = |sphere: &SphereShape<T>, ray: &Ray<T>| textbook_sphere(sphere, ray, offset).is_some();
    row::<T>(way, is_met, returns, clock)
}

fn careful<T: Real>(way: &'static str, clock: &mut dyn FnMut() -> f64) -> CareRow {
    let returns = |sphere: &SphereShape<T>, ray: &Ray<T>| {
        let mut tables = SceneTables::default();
        tables.spheres.shapes.push(*sphere);
        tables.spheres.order.push(0);
        let crossing = Crossing { t: T::ONE, face: 0, side: Side::Outside };
        let left = Hit { object: ObjectId { kind: Kind::Sphere, row: 0 }, crossing };
        closest_hit(&tables, ray, &left.departure(), T::INFINITY).is_some()
    };
    row::<T>(way, |sphere, ray| sphere.intersect(ray), returns, clock)
}

fn row<T: Real>(
    way: &'static str,
    meet: impl Fn(&SphereShape<T>, &Ray<T>) -> Option<Crossing<T>>,
    returns: impl Fn(&SphereShape<T>, &Ray<T>) -> bool,
    clock: &mut dyn FnMut() -> f64,
) -> CareRow {
    let worst = |aim| check_spheres(aim, RAYS, SEED, &meet).worst * T::ULP.to_f64();
    CareRow {
        way,
        nanoseconds: time(&meet, clock),
        instructions: None,
        worst_far: worst(Aim::Far),
        worst_near: worst(Aim::Planet),
        self_hits: share_of_returns(returns),
    }
}

/// Nanoseconds a ray at a unit sphere, of which half meet it.
fn time<T: Real>(
    meet: impl Fn(&SphereShape<T>, &Ray<T>) -> Option<Crossing<T>>,
    clock: &mut dyn FnMut() -> f64,
) -> f64 {
    let sphere = SphereShape { center: Vector::new(T::ZERO, T::ZERO, T::ZERO), radius: T::ONE };
    let start = clock();
    let mut met = 0_u32;
    for number in 0..TIMED {
        let beside = T::from_u32(number % 1024) / T::from_u32(512);
        let origin = Vector::new(beside, T::ZERO, -T::TWO);
        let ray = Ray { origin, direction: Vector::new(T::ZERO, T::ZERO, T::ONE) };
        met += u32::from(core::hint::black_box(meet(&sphere, core::hint::black_box(&ray))).is_some());
    }
    core::hint::black_box(met);
    (clock() - start) * 1e6 / f64::from(TIMED)
}

/// Share of the rays that leave a sphere outwards and meet it again, over spheres from a hundredth to a million units.
fn share_of_returns<T: Real>(returns: impl Fn(&SphereShape<T>, &Ray<T>) -> bool) -> f64 {
    const DECADES: u32 = 8;
    const RAYS_A_DECADE: u32 = 1000;
    let mut count = 0_u32;
    for decade in 0..DECADES {
        let radius = T::from_f64(0.01 * 10.0_f64.powi(decade.cast_signed()));
        let center = Vector::new(radius, -radius, radius * T::TWO);
        let sphere = SphereShape { center, radius };
        for number in 0..RAYS_A_DECADE {
            // Evenly around and up, by the golden angle.
            let share = (f64::from(number) + 0.5) / f64::from(RAYS_A_DECADE);
            let (sine, cosine) = (2.399_963_229_728_653 * f64::from(number)).sin_cos();
            let up = 1.0 - 2.0 * share;
            let across = (1.0 - up * up).sqrt();
            let normal =
                Vector::new(T::from_f64(across * cosine), T::from_f64(across * sine), T::from_f64(up));
            let grazing = Vector::new(-normal.y, normal.x, T::ZERO) + normal * T::from_f64(0.05);
            let ray = Ray { origin: center + normal * radius, direction: grazing.unit() };
            count += u32::from(returns(&sphere, &ray));
        }
    }
    f64::from(count) / f64::from(DECADES * RAYS_A_DECADE)
}

/// The quadratic `a t^2 + 2 b t + c = 0` by its usual formula; the first root beyond an offset.
fn textbook_sphere<T: Real>(sphere: &SphereShape<T>, ray: &Ray<T>, offset: T) -> Option<Crossing<T>> {
    let from_center = ray.origin - sphere.center;
    let a = ray.direction.dot(ray.direction);
    let b = from_center.dot(ray.direction);
    let c = from_center.dot(from_center) - sphere.radius * sphere.radius;
    let discriminant = b * b - a * c;
    if discriminant < T::ZERO {
        return None;
    }
    let root = discriminant.sqrt();
    let roots = [((-b - root) / a, Side::Outside), ((-b + root) / a, Side::Inside)];
    let (t, side) = roots.into_iter().find(|(t, _)| *t > offset)?;
    Some(Crossing { t, face: 0, side })
}

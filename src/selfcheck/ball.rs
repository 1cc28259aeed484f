//! The sphere against its quadratic in numbers of twice the digits.

use crate::geometry::{Crossing, Ray, Real, Side, SphereShape, Straight, Vector};

use super::double::{Double, DoubleVector};
use super::random::Random;
use super::tally::Tally;

/// Half the chord by the radius of a ray that passes the centre at 0.95 radii. Errors are listed up to there.
const GRAZING: f64 = 0.312;
/// What `t` may be off by in any case, in epsilons.
const BOUND: f64 = 4.0;

/// A ray and a ball as they are.
struct Truth {
    near: Double,
    far: Double,
    /// Squared half chord by squared radius: below 0 at a miss.
    depth: f64,
    /// Distance of the origin from the centre in radii, at least 1.
    distance: f64,
    /// Distance from the origin to the chord's middle, in radii.
    middle: f64,
    /// How far the origin lies below the surface, in radii.
    below: f64,
}

impl Truth {
    fn of<T: Real>(sphere: &SphereShape<T>, ray: &Ray<T>) -> Self {
        let direction = DoubleVector::of(ray.direction);
        let offset = DoubleVector::of(ray.origin).minus(DoubleVector::of(sphere.center));
        let square = Double::of(sphere.radius) * Double::of(sphere.radius);
        let (a, h) = (direction.dot(direction), -offset.dot(direction));
        let from_center = offset.dot(offset);
        let c = from_center - square;
        let discriminant = h * h - a * c;
        let root = discriminant.sqrt();
        let (near, far) = if h > Double::ZERO {
            (c / (h + root), (h + root) / a)
        } else {
            ((h - root) / a, c / (h - root))
        };
        Self {
            near,
            far,
            depth: (discriminant / (a * square)).nearest(),
            distance: (from_center / square).nearest().sqrt().max(1.0),
            middle: (h * h / (a * square)).nearest().sqrt(),
            below: -0.5 * (c / square).nearest(),
        }
    }

    /// The first root ahead.
    fn hit(&self) -> Option<(Double, Side)> {
        let first =
            if self.near > Double::ZERO { (self.near, Side::Outside) } else { (self.far, Side::Inside) };
        (self.depth >= 0.0 && first.0 > Double::ZERO).then_some(first)
    }

    /// Whether the line passes the rim so closely that a float cannot tell on which side.
    fn is_uncertain<T: Real>(&self) -> bool {
        let rim = self.depth / (1.0 + (1.0 - self.depth).max(0.0).sqrt());
        rim.abs() < 8.0 * T::ULP.to_f64() * self.distance
    }

    /// Whether the origin is no farther below the surface than a point on it may be rounded: then it counts as one.
    fn starts_on<T: Real>(&self, sphere: &SphereShape<T>) -> bool {
        let center = sphere.center.to_dvec3().abs();
        let place = (center.x + center.y + center.z) / sphere.radius.to_f64();
        self.below > 0.0 && self.below <= 1.01 * T::ULP.to_f64() * (place + 4.0)
    }

    /// What `t` may be off by, in epsilons: the error of the way to the chord's middle and that of half the chord. See
    /// [`Chord::discriminant`](crate::geometry) for the two forms.
    fn bound(&self) -> f64 {
        let half = self.depth.max(0.0).sqrt();
        let is_near = 2.0 * self.middle * self.middle < 1.0 - self.depth;
        let across = if is_near { self.middle } else { 1.0 };
        BOUND.max(1.5 * self.distance / (self.middle + half) * (1.0 + across / half))
    }
}

/// Checks a kernel's answer for one ray.
fn judge<T: Real>(tally: &mut Tally, sphere: &SphereShape<T>, ray: &Ray<T>, found: Option<Crossing<T>>) {
    let truth = Truth::of(sphere, ray);
    tally.cases += 1;
    match (truth.hit(), found) {
        _ if truth.is_uncertain::<T>() => {}
        (None, None) => {}
        (Some(_), None) => tally.leaks += u64::from(!truth.starts_on(sphere)),
        (None, Some(_)) => tally.false_hits += 1,
        (Some((t, side)), Some(found)) => {
            let error = ((Double::of(found.t) - t) / t).abs().nearest() / T::ULP.to_f64();
            if truth.depth.sqrt() >= GRAZING {
                tally.measure(error, truth.bound());
            } else {
                tally.wrong += u64::from(error > truth.bound());
            }
            tally.wrong += u64::from(found.side != side);
        }
    }
}

/// Where the rays of a group start, and where they go.
#[derive(Clone, Copy, Debug)]
pub enum Aim {
    /// At pebbles, from up to 1e8 (in `f32`: 1e4) radii away.
    Far,
    /// At the rim of such.
    Rim,
    /// From as little as 1e-8 (in `f32`: 1e-6) radii above a sphere.
    Planet,
    /// From within, as close to the wall.
    Inside,
}

impl Aim {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Far, Self::Rim, Self::Planet, Self::Inside];

    fn group(self) -> &'static str {
        match self {
            Self::Far => "sphere, far",
            Self::Rim => "sphere, its rim",
            Self::Planet => "sphere, underfoot",
            Self::Inside => "sphere, from inside",
        }
    }

    fn draw<T: Real>(self, random: &mut Random) -> (SphereShape<T>, Ray<T>) {
        let is_single = T::LENGTH_LIMIT < 1e60;
        let (far, near, size) = if is_single { (4.0, 6.0, 2.0) } else { (8.0, 8.0, 8.0) };
        let radius = random.magnitude(-size, size);
        let center = random.direction() * (radius * random.magnitude(-2.0, 0.5));
        let up = random.direction();
        let (origin, direction) = match self {
            Self::Far | Self::Rim => {
                let distance = 1.001 * random.magnitude(0.0, far);
                let finest = if is_single { -7.7 } else { -16.5 };
                let beside = distance * random.magnitude(finest, finest + 4.0);
                let impact = match self {
                    Self::Far => 0.95 * random.share().sqrt(),
                    _ if random.coin() => 1.0 + beside,
                    _ => 1.0 - beside,
                };
                let sine = (impact / distance).clamp(-1.0, 1.0);
                let aim = random.across(up) * sine - up * (1.0 - sine * sine).sqrt();
                (center + up * (distance * radius), aim * random.magnitude(-3.0, 3.0))
            }
            Self::Planet => {
                (center + up * (radius + radius * random.magnitude(-near, 0.0)), random.direction() - up)
            }
            Self::Inside => {
                (center + up * (radius - radius * random.magnitude(-near, 0.0)), random.direction())
            }
        };
        let sphere = SphereShape { center: Vector::from_dvec3(center), radius: T::from_f64(radius) };
        (sphere, Ray { origin: Vector::from_dvec3(origin), direction: Vector::from_dvec3(direction) })
    }
}

/// Rays at spheres of many sizes, and what a kernel (or a formula to compare it with) says of them.
pub fn check_spheres<T: Real>(
    aim: Aim,
    rays: u64,
    seed: u64,
    kernel: impl Fn(&SphereShape<T>, &Ray<T>) -> Option<Crossing<T>>,
) -> Tally {
    let mut tally = Tally::new(aim.group(), T::NAME);
    for number in 0..rays {
        let (sphere, ray) = aim.draw::<T>(&mut Random::new(seed.wrapping_add(number)));
        let found = kernel(&sphere, &ray);
        tally.wrong += u64::from(sphere.meet_surely(&ray).crossing() != found);
        judge(&mut tally, &sphere, &ray, found);
    }
    tally
}

//! Rays that start on a surface: outwards they never come back, inwards they always leave.

use glam::DVec3;

use crate::geometry::{Convex, Crossing, CubeShape, PyramidShape, Ray, Real, Side, SphereShape, Vector};
use crate::trace::{Departure, Hit, SceneTables, closest_hit, is_occluded};

use super::random::Random;
use super::tally::Tally;

/// Where a ray met the one object of a scene: point and normal on the side that it came from.
struct Landing<T> {
    hit: Hit<T>,
    point: Vector<T>,
    normal: Vector<T>,
}

/// A scene of one object, around a point by about a size.
struct Stage<T: Real> {
    tables: SceneTables<T>,
    shape: Shape<T>,
    middle: DVec3,
    size: f64,
}

enum Shape<T> {
    Sphere(SphereShape<T>),
    Cube(CubeShape<T>),
    Pyramid(PyramidShape<T>),
}

impl<T: Real> Stage<T> {
    fn draw(random: &mut Random) -> Self {
        let sizes = if T::LENGTH_LIMIT < 1e60 { 2.0 } else { 8.0 };
        let size = random.magnitude(-sizes, sizes);
        let place = random.point() * (size * random.magnitude(-2.0, 1.0));
        let mut tables = SceneTables::default();
        let (shape, middle) = match random.below(3) {
            0 => {
                let sphere = SphereShape { center: Vector::from_dvec3(place), radius: T::from_f64(size) };
                tables.spheres.shapes.push(sphere);
                tables.spheres.order.push(0);
                (Shape::Sphere(sphere), place)
            }
            1 => {
                let cube = CubeShape::new(place, size);
                tables.cubes.shapes.push(cube);
                tables.cubes.order.push(0);
                (Shape::Cube(cube), place + DVec3::splat(0.5 * size))
            }
            _ => {
                let height = size * random.magnitude(-1.0, 1.0);
                let pyramid = PyramidShape::new(place, size, height);
                tables.pyramids.shapes.push(pyramid);
                tables.pyramids.order.push(0);
                (Shape::Pyramid(pyramid), place + DVec3::new(0.5 * size, 0.5 * size, 0.25 * height))
            }
        };
        Self { tables, shape, middle, size }
    }

    fn meet(&self, ray: &Ray<T>, departure: Departure) -> Option<Landing<T>> {
        let hit = closest_hit(&self.tables, ray, &departure, T::INFINITY)?;
        let at = match &self.shape {
            Shape::Sphere(shape) => shape.locate(ray, &hit.crossing),
            Shape::Cube(shape) => shape.locate(ray, &hit.crossing),
            Shape::Pyramid(shape) => shape.locate(ray, &hit.crossing),
        };
        let normal = if hit.crossing.side == Side::Outside { at.normal } else { -at.normal };
        Some(Landing { hit, point: at.point, normal })
    }

    /// A ray to the middle, from around it or from the middle itself.
    fn arriving(&self, random: &mut Random) -> Ray<T> {
        let around = random.direction() * (self.size * random.magnitude(0.5, 2.0));
        let aim = self.middle + random.point() * (0.02 * self.size);
        let (origin, target) = if random.coin() { (aim + around, aim) } else { (self.middle, aim + around) };
        Ray { origin: Vector::from_dvec3(origin), direction: Vector::from_dvec3(target - origin).unit() }
    }
}

/// A direction to the side of a normal, one time in four almost along the surface.
fn departing<T: Real>(random: &mut Random, normal: Vector<T>) -> Vector<T> {
    let up = normal.to_dvec3();
    loop {
        let free = if random.below(4) == 0 {
            random.across(up) + up * random.magnitude(-15.0, -2.0)
        } else {
            random.direction()
        };
        let direction = Vector::<T>::from_dvec3(free);
        let along = direction.dot(normal);
        if along != T::ZERO {
            return if along > T::ZERO { direction } else { -direction };
        }
    }
}

/// Whether a crossing is one that a ray within a body may have: ahead, and on the way out.
fn is_exit<T: Real>(crossing: &Crossing<T>) -> bool {
    crossing.side == Side::Inside && crossing.t >= T::ZERO && crossing.t.is_finite()
}

/// Rays from surface points of all bodies, as mirrors and shadows send them, through the trace itself.
pub fn check_leaving<T: Real>(rays: u64, seed: u64) -> Tally {
    let mut tally = Tally::new("leaving a surface", T::NAME);
    for number in 0..rays {
        let random = &mut Random::new(seed.wrapping_add(number));
        let stage = Stage::<T>::draw(random);
        let arriving = stage.arriving(random);
        tally.cases += 1;
        let Some(landing) = stage.meet(&arriving, Departure::Free) else {
            tally.leaks += 1;
            continue;
        };
        let ray = Ray { origin: landing.point, direction: departing(random, landing.normal) };
        let departure = landing.hit.departure();
        match (departure, stage.meet(&ray, departure)) {
            (Departure::Inward(..), Some(next)) => tally.wrong += u64::from(!is_exit(&next.hit.crossing)),
            (Departure::Inward(..), None) => tally.leaks += 1,
            (_, Some(_)) => tally.false_hits += 1,
            (_, None) => {
                tally.false_hits += u64::from(is_occluded(&stage.tables, &ray, &departure, T::INFINITY));
            }
        }
    }
    tally
}

//! Which object a scene shows to a ray, by every way there is to search it.

use archetrace::geometry::{Convex, Crossing, CubeShape, PlaneShape, PyramidShape, Ray, SphereShape, Vector};
use archetrace::trace::{
    BoardEffects, Departure, Kind, ObjectId, Query, SMALLEST_TREE, SceneTables, Sequential, Simd, closest_hit,
};

use crate::precision::Precision;

/// A shape that has a table.
pub(crate) trait Tabled<T: Precision>: Convex<T> {
    const KIND: Kind;
    /// Appends it.
    fn push(self, tables: &mut SceneTables<T>, order: u32);
}

impl<T: Precision> Tabled<T> for SphereShape<T> {
    const KIND: Kind = Kind::Sphere;
    fn push(self, tables: &mut SceneTables<T>, order: u32) {
        tables.spheres.shapes.push(self);
        tables.spheres.order.push(order);
    }
}

impl<T: Precision> Tabled<T> for CubeShape<T> {
    const KIND: Kind = Kind::Cube;
    fn push(self, tables: &mut SceneTables<T>, order: u32) {
        tables.cubes.shapes.push(self);
        tables.cubes.order.push(order);
    }
}

impl<T: Precision> Tabled<T> for PyramidShape<T> {
    const KIND: Kind = Kind::Pyramid;
    fn push(self, tables: &mut SceneTables<T>, order: u32) {
        tables.pyramids.shapes.push(self);
        tables.pyramids.order.push(order);
    }
}

impl<T: Precision> Tabled<T> for PlaneShape<T> {
    const KIND: Kind = Kind::Board;
    fn push(self, tables: &mut SceneTables<T>, order: u32) {
        let origin = Vector::new(T::ZERO, T::ZERO, self.height);
        tables.boards.shapes.push(origin, T::ONE, BoardEffects::default());
        tables.boards.order.push(order);
    }
}

/// What a ray meets in tables, with `t` bit by bit: row after row, in packets of every kind of vector instructions, and
/// both again through trees. All must agree.
pub(crate) fn shown<T: Precision>(
    tables: &mut SceneTables<T>,
    ray: &Ray<T>,
) -> Option<(ObjectId, Crossing<T>)> {
    let reach = T::INFINITY;
    let plain = |tables: &SceneTables<T>| {
        closest_hit(tables, ray, &Departure::Free, reach).map(|hit| (hit.object, hit.crossing))
    };
    let found = plain(tables);
    let check_packets = |tables: &SceneTables<T>, trees: &str| {
        for simd in Simd::available() {
            let queries = [Query { ray: *ray, departure: Departure::Free, reach }; 20];
            let mut hits = [None; 20];
            simd.closest_hits(tables, &queries, &mut hits);
            for hit in hits {
                let hit = hit.map(|hit| (hit.object, hit.crossing));
                assert_eq!(hit, found, "{}, {trees}: {ray:?}", simd.name());
            }
        }
    };
    check_packets(tables, "rows");
    tables.build_trees(&Sequential);
    assert_eq!(plain(tables), found, "trees: {ray:?}");
    check_packets(tables, "trees");
    found
}

/// A ball further on than a crossing, or than a ray's first steps; far enough for its centre to be a place of its own.
fn beyond<T: Precision>(ray: &Ray<T>, crossing: Option<Crossing<T>>) -> SphereShape<T> {
    let size = ray.origin.length();
    let far = crossing.map_or(size.at_least(T::ONE), |crossing| crossing.t * ray.direction.length());
    let far = far.at_least(size / T::from_u32(1024));
    let four = T::TWO * T::TWO;
    SphereShape { center: ray.origin + ray.direction.unit() * (four * far), radius: far }
}

/// A scene of many twins of a body and of a ball behind shows the body of lowest order where the kernel met it, and the
/// ball where the kernel met nothing.
pub(crate) fn check_shown<T: Precision, S: Tabled<T>>(shape: &S, ray: &Ray<T>) {
    let crossing = shape.intersect(ray);
    let mut tables = SceneTables::default();
    let twins = u32::try_from(SMALLEST_TREE).unwrap();
    (1..=twins).for_each(|order| shape.push(&mut tables, order));
    let ball = beyond(ray, crossing);
    let row = if S::KIND == Kind::Sphere { twins } else { 0 };
    ball.push(&mut tables, twins + 1);
    let expected = match crossing {
        Some(crossing) => (ObjectId { kind: S::KIND, row: 0 }, crossing),
        None => (ObjectId { kind: Kind::Sphere, row }, ball.intersect(ray).unwrap()),
    };
    assert_eq!(shown(&mut tables, ray), Some(expected), "{ray:?}");
}

//! The nearest surface along a ray.

use crate::geometry::{Convex, Crossing, Ray, Real};

use super::hit::DepartedRow;
use super::{Departure, Hit, Kind, ObjectId, SceneTables, ShapeColumns, ShapeTable};

/// The nearest crossing with `t <= reach`. Among crossings at the same `t` the lowest scene order wins, then the
/// kind, then the row: never the order in which the World keeps its entities.
#[inline(always)]
pub fn closest_hit<T: Real>(
    tables: &SceneTables<T>,
    ray: &Ray<T>,
    departure: &Departure,
    reach: T,
) -> Option<Hit<T>> {
    let mut nearest = Nearest { reach, order: u32::MAX, hit: None };
    nearest.search(&tables.spheres, ray, departure);
    nearest.search(&tables.cubes, ray, departure);
    nearest.search(&tables.pyramids, ray, departure);
    nearest.search(&tables.boards, ray, departure);
    nearest.hit
}

/// The crossing of one row, given how the ray starts.
#[inline(always)]
pub(super) fn cross_row<T: Real, C: ShapeColumns<T>>(
    shapes: &C,
    row: u32,
    ray: &Ray<T>,
    departed: DepartedRow,
) -> Option<Crossing<T>> {
    if row == departed.skipped {
        return None;
    }
    let shape = shapes.shape(row as usize);
    if row == departed.within { Some(shape.exit(ray, departed.face)) } else { shape.intersect(ray) }
}

/// Whether of two objects at the same distance, by their packed names, the first one shows; anything shows before
/// nobody.
pub(super) fn comes_first<T: Real>(tables: &SceneTables<T>, name: u32, other: u32) -> bool {
    if other == ObjectId::NOBODY {
        return true;
    }
    (order_of(tables, name), name) < (order_of(tables, other), other)
}

fn order_of<T: Real>(tables: &SceneTables<T>, name: u32) -> u32 {
    let ObjectId { kind, row } = ObjectId::unpacked(name);
    let order = match kind {
        Kind::Sphere => &tables.spheres.order,
        Kind::Cube => &tables.cubes.order,
        Kind::Pyramid => &tables.pyramids.order,
        Kind::Board => &tables.boards.order,
    };
    order[row as usize]
}

struct Nearest<T> {
    reach: T,
    order: u32,
    hit: Option<Hit<T>>,
}

impl<T: Real> Nearest<T> {
    #[inline(always)]
    fn search<C: ShapeColumns<T>>(&mut self, table: &ShapeTable<T, C>, ray: &Ray<T>, departure: &Departure) {
        let departed = departure.rows(C::KIND);
        for (row, &order) in (0_u32..).zip(&table.order) {
            let Some(crossing) = cross_row(&table.shapes, row, ray, departed) else {
                continue;
            };
            let nearer = crossing.t < self.reach;
            let tie_won = crossing.t == self.reach && (self.hit.is_none() || order < self.order);
            if nearer || tie_won {
                self.reach = crossing.t;
                self.order = order;
                self.hit = Some(Hit { object: ObjectId { kind: C::KIND, row }, crossing });
            }
        }
    }
}

//! Whether anything stands between two points.

use crate::geometry::{Ray, Real};

use super::closest::cross_row;
use super::{Departure, SceneTables, ShapeColumns, ShapeTable};

/// Whether a surface lies strictly between the two ends of a segment, `0 < t < 1` along `segment`. The segment's
/// far end lies exactly at 1, so that what touches a light does not hide it.
#[inline(always)]
pub fn is_occluded<T: Real>(tables: &SceneTables<T>, segment: &Ray<T>, departure: &Departure) -> bool {
    blocks(&tables.spheres, segment, departure)
        || blocks(&tables.cubes, segment, departure)
        || blocks(&tables.pyramids, segment, departure)
        || blocks(&tables.boards, segment, departure)
}

#[inline(always)]
fn blocks<T: Real, C: ShapeColumns<T>>(
    table: &ShapeTable<T, C>,
    segment: &Ray<T>,
    departure: &Departure,
) -> bool {
    let departed = departure.rows(C::KIND);
    (0_u32..).zip(&table.order).any(|(row, _)| {
        cross_row(&table.shapes, row, segment, departed).is_some_and(|crossing| crossing.t < T::ONE)
    })
}

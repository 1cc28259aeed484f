//! Whether anything stands between a point and a light.

use crate::geometry::{Ray, Real};

use super::closest::cross_row;
use super::{Departure, SceneTables, ShapeColumns, ShapeTable};

/// Whether a surface lies strictly before `reach`, `0 < t < reach` along the ray. A light that is somewhere lies exactly
/// at 1, so that what touches it does not hide it; one without a place lies beyond every number.
#[inline(always)]
pub fn is_occluded<T: Real>(tables: &SceneTables<T>, ray: &Ray<T>, departure: &Departure, reach: T) -> bool {
    blocks(&tables.spheres, ray, departure, reach)
        || blocks(&tables.cubes, ray, departure, reach)
        || blocks(&tables.pyramids, ray, departure, reach)
        || blocks(&tables.boards, ray, departure, reach)
}

#[inline(always)]
fn blocks<T: Real, C: ShapeColumns<T>>(
    table: &ShapeTable<T, C>,
    ray: &Ray<T>,
    departure: &Departure,
    reach: T,
) -> bool {
    let departed = departure.rows(C::KIND);
    (0_u32..).zip(&table.order).any(|(row, _)| {
        cross_row(&table.shapes, row, ray, departed).is_some_and(|crossing| crossing.t < reach)
    })
}

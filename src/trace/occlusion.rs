//! Whether anything stands between two points.

use crate::geometry::{Ray, Real};

use super::closest::cross_row;
use super::tree::{Any, NO_ROW, Packed, Stack, Tree, TreeRay};
use super::{Departure, SceneTables, ShapeColumns, ShapeTable};

/// Whether a surface lies strictly between the two ends of a segment, `0 < t < 1` along `segment`. The segment's
/// far end lies exactly at 1, so that what touches a light does not hide it. Tables that have a tree are searched
/// through it.
#[inline(always)]
pub fn is_occluded<T: Real>(tables: &SceneTables<T>, segment: &Ray<T>, departure: &Departure) -> bool {
    is_occluded_with(tables, segment, departure, &mut None)
}

/// [`is_occluded`], with a stack for the trees that is made where there is none yet.
#[inline(always)]
pub(super) fn is_occluded_with<T: Real>(
    tables: &SceneTables<T>,
    segment: &Ray<T>,
    departure: &Departure,
    stack: &mut Option<Stack<T>>,
) -> bool {
    let trees = &tables.trees;
    blocks(&tables.spheres, trees.spheres.as_deref(), segment, departure, stack)
        || blocks(&tables.cubes, trees.cubes.as_deref(), segment, departure, stack)
        || blocks(&tables.pyramids, trees.pyramids.as_deref(), segment, departure, stack)
        || any_row_blocks(&tables.boards, segment, departure)
}

#[inline(always)]
fn blocks<T: Real, C: ShapeColumns<T, Shape: Packed<T>>>(
    table: &ShapeTable<T, C>,
    tree: Option<&Tree<T, C::Shape>>,
    segment: &Ray<T>,
    departure: &Departure,
    stack: &mut Option<Stack<T>>,
) -> bool {
    match tree {
        Some(tree) => tree_blocks(table, tree, segment, departure, stack),
        None => any_row_blocks(table, segment, departure),
    }
}

#[inline(always)]
fn any_row_blocks<T: Real, C: ShapeColumns<T>>(
    table: &ShapeTable<T, C>,
    segment: &Ray<T>,
    departure: &Departure,
) -> bool {
    (0..).take(table.order.len()).any(|row| row_blocks(table, row, segment, departure))
}

#[inline(always)]
fn row_blocks<T: Real, C: ShapeColumns<T>>(
    table: &ShapeTable<T, C>,
    row: u32,
    segment: &Ray<T>,
    departure: &Departure,
) -> bool {
    cross_row(&table.shapes, row, segment, departure.rows(C::KIND))
        .is_some_and(|crossing| crossing.t < T::ONE)
}

#[inline(always)]
fn tree_blocks<T: Real, C: ShapeColumns<T, Shape: Packed<T>>>(
    table: &ShapeTable<T, C>,
    tree: &Tree<T, C::Shape>,
    segment: &Ray<T>,
    departure: &Departure,
    stack: &mut Option<Stack<T>>,
) -> bool {
    let departed = departure.rows(C::KIND);
    // A tree knows no exits.
    if departed.within != NO_ROW && row_blocks(table, departed.within, segment, departure) {
        return true;
    }
    let mut any = Any { row: NO_ROW };
    let ray = TreeRay::new(*segment, tree.rounding());
    tree.search::<false>(&ray, departed.row(), &mut any, stack.get_or_insert_with(Stack::new));
    any.row != NO_ROW
}

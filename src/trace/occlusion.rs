//! Whether anything stands between a point and a light.

use crate::geometry::{Ray, Real};

use super::closest::cross_row;
use super::tree::{Any, NO_ROW, Packed, Stack, Tree, TreeRay, Walk};
use super::{Departure, SceneTables, ShapeColumns, ShapeTable};

/// Whether a surface lies strictly before `reach`, `0 < t < reach` along the ray. A light that is somewhere lies exactly
/// at 1, so that what touches it does not hide it; one without a place lies beyond every number. Tables that have a tree
/// are searched through it.
#[inline(always)]
pub fn is_occluded<T: Real>(tables: &SceneTables<T>, ray: &Ray<T>, departure: &Departure, reach: T) -> bool {
    is_occluded_with(tables, ray, departure, reach, &mut None)
}

/// [`is_occluded`], with a stack for the trees that is made where there is none yet.
#[inline(always)]
pub(super) fn is_occluded_with<T: Real>(
    tables: &SceneTables<T>,
    ray: &Ray<T>,
    departure: &Departure,
    reach: T,
    stack: &mut Option<Stack>,
) -> bool {
    let trees = &tables.trees;
    blocks(&tables.spheres, trees.spheres.as_deref(), ray, departure, reach, stack)
        || blocks(&tables.cubes, trees.cubes.as_deref(), ray, departure, reach, stack)
        || blocks(&tables.pyramids, trees.pyramids.as_deref(), ray, departure, reach, stack)
        || any_row_blocks(&tables.boards, ray, departure, reach)
}

#[inline(always)]
fn blocks<T: Real, C: ShapeColumns<T, Shape: Packed<T>>>(
    table: &ShapeTable<T, C>,
    tree: Option<&Tree<T, C::Shape>>,
    ray: &Ray<T>,
    departure: &Departure,
    reach: T,
    stack: &mut Option<Stack>,
) -> bool {
    match tree {
        Some(tree) => tree_blocks(table, tree, ray, departure, reach, stack),
        None => any_row_blocks(table, ray, departure, reach),
    }
}

#[inline(always)]
fn any_row_blocks<T: Real, C: ShapeColumns<T>>(
    table: &ShapeTable<T, C>,
    ray: &Ray<T>,
    departure: &Departure,
    reach: T,
) -> bool {
    // No closure: whether that is inlined depends on what else there is in the program.
    for row in (0..).take(table.order.len()) {
        if row_blocks(table, row, ray, departure, reach) {
            return true;
        }
    }
    false
}

#[inline(always)]
fn row_blocks<T: Real, C: ShapeColumns<T>>(
    table: &ShapeTable<T, C>,
    row: u32,
    ray: &Ray<T>,
    departure: &Departure,
    reach: T,
) -> bool {
    cross_row(&table.shapes, row, ray, departure.rows(C::KIND)).is_some_and(|crossing| crossing.t < reach)
}

#[inline(always)]
fn tree_blocks<T: Real, C: ShapeColumns<T, Shape: Packed<T>>>(
    table: &ShapeTable<T, C>,
    tree: &Tree<T, C::Shape>,
    ray: &Ray<T>,
    departure: &Departure,
    reach: T,
    stack: &mut Option<Stack>,
) -> bool {
    let departed = departure.rows(C::KIND);
    // A tree knows no exits.
    if departed.within != NO_ROW && row_blocks(table, departed.within, ray, departure, reach) {
        return true;
    }
    let any = Any { row: NO_ROW, reach };
    let mut walk = Walk::new(TreeRay::new(*ray, tree.rounding()), departed.row(), any);
    tree.search::<false, _>(&mut walk, stack.get_or_insert_with(Stack::new));
    walk.search.row != NO_ROW
}

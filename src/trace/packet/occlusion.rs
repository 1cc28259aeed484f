//! Whether anything stands between the two ends of each segment of a packet.

use crate::geometry::{Real, Straight};
use crate::trace::{Kind, ObjectId, SceneTables, ShapeColumns, ShapeTable};

use super::bounds::{Candidates, Rows};
use super::bundle::Bundle;
use super::closest::exit_of;
use super::lanes::{LANES, RayLanes, Reach, any, nowhere};
use super::trees::{TreeScratch, block_trees};

/// [`is_occluded`](crate::trace::is_occluded) for every lane: those that are become idle.
#[inline(always)]
pub(super) fn occlude<T: Real>(
    tables: &SceneTables<T>,
    segments: &RayLanes<'_, T>,
    reach: &mut Reach<T>,
    bundle: &Bundle<T>,
    candidates: &Candidates,
    light: usize,
    scratch: &mut TreeScratch,
) {
    if segments.start.any_inward {
        *reach = leave(tables, segments, *reach);
    }
    let goes_on = block(&tables.spheres, candidates.of(Kind::Sphere), segments, reach)
        && block(&tables.cubes, candidates.of(Kind::Cube), segments, reach)
        && block(&tables.pyramids, candidates.of(Kind::Pyramid), segments, reach);
    let goes_on = goes_on && block(&tables.boards, candidates.of(Kind::Board), segments, reach);
    if goes_on && !tables.trees.is_empty() {
        *reach = block_trees(tables, segments, bundle, *reach, light, scratch);
    }
}

/// Whether any lane is left.
#[inline(always)]
fn block<T: Real, C>(
    table: &ShapeTable<T, C>,
    rows: Rows,
    segments: &RayLanes<'_, T>,
    reach: &mut Reach<T>,
) -> bool
where
    C: ShapeColumns<T, Shape: Straight<T>>,
{
    if rows.is_empty() {
        return true;
    }
    for row in rows {
        let shape = table.shapes.shape(row as usize);
        let name = ObjectId::packed(C::KIND, row);
        let mut worthwhile = false;
        for lane in 0..LANES {
            let counts = (reach[lane] > T::ZERO) & (segments.start.departed[lane] != name);
            worthwhile |= counts & shape.may_meet(&segments.get(lane));
        }
        if worthwhile && !test(&shape, name, segments, reach) {
            return false;
        }
    }
    true
}

#[inline(always)]
pub(super) fn test<T: Real>(
    shape: &impl Straight<T>,
    name: u32,
    segments: &RayLanes<'_, T>,
    reach: &mut Reach<T>,
) -> bool {
    let (mut any_left, mut any_unsure) = (false, false);
    for lane in 0..LANES {
        let met = shape.meet(&segments.get(lane));
        let counts = segments.start.departed[lane] != name;
        // Idle lanes hold anything.
        any_unsure |= counts & met.unsure & (reach[lane] > T::ZERO);
        let blocks = counts & (met.t < reach[lane]);
        reach[lane] = if blocks { nowhere() } else { reach[lane] };
        any_left |= reach[lane] > T::ZERO;
    }
    if any_unsure {
        *reach = settle_unsure(shape, name, segments, *reach);
        return any(|lane| reach[lane] > T::ZERO);
    }
    any_left
}

/// Lets a shape hide the lights of lanes in which rounding cannot tell whether it is met.
#[cold]
#[inline(never)]
fn settle_unsure<T: Real>(
    shape: &impl Straight<T>,
    name: u32,
    segments: &RayLanes<'_, T>,
    mut reach: Reach<T>,
) -> Reach<T> {
    for lane in 0..LANES {
        let segment = segments.get(lane);
        let counts = segments.start.departed[lane] != name && reach[lane] > T::ZERO;
        if counts
            && shape.meet(&segment).unsure
            && shape.intersect(&segment).is_some_and(|crossing| crossing.t < reach[lane])
        {
            reach[lane] = nowhere();
        }
    }
    reach
}

#[cold]
#[inline(never)]
fn leave<T: Real>(tables: &SceneTables<T>, segments: &RayLanes<'_, T>, mut reach: Reach<T>) -> Reach<T> {
    for lane in 0..LANES {
        if exit_of(tables, segments, lane).is_some_and(|crossing| crossing.t < reach[lane]) {
            reach[lane] = nowhere();
        }
    }
    reach
}

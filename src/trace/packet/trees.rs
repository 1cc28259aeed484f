//! Packets and trees: lane by lane, each ray by itself.

use crate::geometry::{Ray, Real, Straight as _};
use crate::trace::tree::{Any, NO_ROW, Nearest, Packed, Stack, Tree, TreeRay};
use crate::trace::{Kind, ObjectId, SceneTables, ShapeColumns, ShapeTable};

use super::closest::HitLanes;
use super::lanes::{LANES, RayLanes};

/// What searches need room for, kept from one to the next.
pub(in crate::trace) struct Scratch<T> {
    stack: Stack<T>,
    /// For some lights and each kind, the row that hid a light last: likely to hide it again.
    occluders: [[u32; 3]; LIGHTS],
}

/// Lights that a last occluder is remembered for; others share.
const LIGHTS: usize = 8;

impl<T: Real> Scratch<T> {
    pub(in crate::trace) fn new() -> Self {
        Self { stack: Stack::new(), occluders: [[NO_ROW; 3]; LIGHTS] }
    }
}

/// Searches the tree of one kind for every lane.
#[inline(always)]
pub(super) fn search_tree<T: Real, S: Packed<T>>(
    tables: &SceneTables<T>,
    kind: Kind,
    tree: Option<&Tree<T, S>>,
    rays: &RayLanes<T>,
    hits: &mut HitLanes<T>,
    scratch: &mut Scratch<T>,
) {
    let Some(tree) = tree else { return };
    for lane in 0..LANES {
        if rays.reach[lane] >= T::ZERO {
            let ray = TreeRay::new(rays.get(lane), tree.rounding());
            let mut nearest = Nearest { tables, kind, t: hits.t[lane], name: hits.name[lane] };
            let departed = departed_row(rays, lane, kind);
            tree.search::<true>(&ray, departed, &mut nearest, &mut scratch.stack);
            hits.t[lane] = nearest.t;
            hits.name[lane] = nearest.name;
        }
    }
}

/// Searches the tree of one kind for whatever hides a light.
#[inline(always)]
pub(super) fn block_tree<T: Real, C>(
    table: &ShapeTable<T, C>,
    tree: Option<&Tree<T, C::Shape>>,
    segments: &mut RayLanes<T>,
    light: usize,
    scratch: &mut Scratch<T>,
) where
    C: ShapeColumns<T, Shape: Packed<T>>,
{
    let Some(tree) = tree else { return };
    let last = &mut scratch.occluders[light % LIGHTS][C::KIND as usize % 3];
    for lane in 0..LANES {
        if segments.reach[lane] > T::ZERO {
            let segment = segments.get(lane);
            let departed = departed_row(segments, lane, C::KIND);
            if hides::<T, C>(table, *last, departed, &segment) {
                segments.reach[lane] = -T::INFINITY;
                continue;
            }
            let mut any = Any { row: NO_ROW, reach: T::ONE };
            let ray = TreeRay::new(segment, tree.rounding());
            tree.search::<false>(&ray, departed, &mut any, &mut scratch.stack);
            if any.row != NO_ROW {
                *last = any.row;
                segments.reach[lane] = -T::INFINITY;
            }
        }
    }
}

/// Whether the row that hid a light last hides it here.
#[inline(always)]
fn hides<T: Real, C>(table: &ShapeTable<T, C>, row: u32, departed: u32, segment: &Ray<T>) -> bool
where
    C: ShapeColumns<T, Shape: Packed<T>>,
{
    row != NO_ROW && row != departed && table.shapes.shape(row as usize).meet(segment).t < T::ONE
}

/// The row of one kind that the ray of a lane leaves.
#[inline(always)]
fn departed_row<T: Real>(rays: &RayLanes<T>, lane: usize, kind: Kind) -> u32 {
    let ObjectId { kind: departed, row } = ObjectId::unpacked(rays.departed[lane]);
    if departed == kind { row } else { NO_ROW }
}

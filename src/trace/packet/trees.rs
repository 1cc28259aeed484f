//! Packets and trees: lane by lane, each ray by itself.

use crate::geometry::{Ray, Real, Straight as _};
use crate::trace::tree::{Any, NO_ROW, Nearest, Packed, Stack, Tree, TreeRay};
use crate::trace::{Kind, ObjectId, SceneTables, ShapeColumns, ShapeTable};

use super::closest::{FaceCode, HitLanes};
use super::lanes::{LANES, RayLanes, Reach, nowhere};

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
pub(super) fn search_tree<T: Real, C>(
    tables: &SceneTables<T>,
    table: &ShapeTable<T, C>,
    tree: Option<&Tree<T, C::Shape>>,
    rays: &RayLanes<'_, T>,
    hits: &mut HitLanes<T>,
    scratch: &mut Scratch<T>,
) where
    C: ShapeColumns<T, Shape: Packed<T>>,
{
    let Some(tree) = tree else { return };
    for lane in 0..LANES {
        // An idle lane's reach is below 0, and so is its t.
        if hits.t[lane] >= T::ZERO {
            let ray = rays.get(lane);
            let tree_ray = TreeRay::new(ray, tree.rounding());
            let mut nearest = Nearest { tables, kind: C::KIND, t: hits.t[lane], name: hits.name[lane] };
            let departed = departed_row(rays, lane, C::KIND);
            tree.search::<true>(&tree_ray, departed, &mut nearest, &mut scratch.stack);
            if nearest.name != hits.name[lane] {
                let row = ObjectId::unpacked(nearest.name).row;
                hits.t[lane] = nearest.t;
                hits.name[lane] = nearest.name;
                hits.face[lane] = FaceCode::of(&table.shapes.shape(row as usize).meet_surely(&ray));
            }
        }
    }
}

/// Searches the tree of one kind for whatever hides a light.
#[inline(always)]
pub(super) fn block_tree<T: Real, C>(
    table: &ShapeTable<T, C>,
    tree: Option<&Tree<T, C::Shape>>,
    segments: &RayLanes<'_, T>,
    reach: &mut Reach<T>,
    light: usize,
    scratch: &mut Scratch<T>,
) where
    C: ShapeColumns<T, Shape: Packed<T>>,
{
    let Some(tree) = tree else { return };
    let last = &mut scratch.occluders[light % LIGHTS][C::KIND as usize % 3];
    for lane in 0..LANES {
        if reach[lane] > T::ZERO {
            let segment = segments.get(lane);
            let departed = departed_row(segments, lane, C::KIND);
            if hides::<T, C>(table, *last, departed, &segment) {
                reach[lane] = nowhere();
                continue;
            }
            let mut any = Any { row: NO_ROW, reach: T::ONE };
            let ray = TreeRay::new(segment, tree.rounding());
            tree.search::<false>(&ray, departed, &mut any, &mut scratch.stack);
            if any.row != NO_ROW {
                *last = any.row;
                reach[lane] = nowhere();
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
fn departed_row<T: Real>(rays: &RayLanes<'_, T>, lane: usize, kind: Kind) -> u32 {
    let ObjectId { kind: departed, row } = ObjectId::unpacked(rays.start.departed[lane]);
    if departed == kind { row } else { NO_ROW }
}

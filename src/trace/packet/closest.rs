//! The nearest surface along each ray of a packet.

use crate::geometry::{Convex, Crossing, Meeting, Ray, Real, Straight};
use crate::trace::closest::comes_first;
use crate::trace::hit::FaceCode;
use crate::trace::{Kind, ObjectId, SceneTables, ShapeColumns, ShapeTable};

use super::bounds::{Candidates, Rows};
use super::bundle::Bundle;
use super::lanes::{LANES, Lanes, OUTWARD, RayLanes, Reach};
use super::trees::{TreeScratch, search_trees};

/// What each ray met.
#[derive(Clone, Copy, Debug)]
pub(super) struct HitLanes<T> {
    /// Ray parameter, or the ray's reach.
    pub(super) t: Lanes<T>,
    /// Packed name of the object, or nobody's.
    pub(super) name: Lanes<u32>,
    /// Which face, see [`FaceCode`].
    pub(super) face: Lanes<u32>,
}

impl<T: Real> HitLanes<T> {
    /// Takes a crossing with an object if it is nearer, or as near and comes first.
    fn take(&mut self, tables: &SceneTables<T>, lane: usize, name: u32, crossing: Option<Crossing<T>>) {
        let Some(crossing) = crossing else { return };
        let is_tie = crossing.t == self.t[lane];
        if crossing.t < self.t[lane] || (is_tie && comes_first(tables, name, self.name[lane])) {
            self.t[lane] = crossing.t;
            self.name[lane] = name;
            self.face[lane] = FaceCode::of(&Meeting::from(crossing));
        }
    }
}

/// [`closest_hit`](crate::trace::closest_hit) for every lane.
#[inline(always)]
pub(super) fn closest<T: Real>(
    tables: &SceneTables<T>,
    rays: &RayLanes<'_, T>,
    reach: &Reach<T>,
    bundle: &Bundle<T>,
    candidates: &Candidates,
    scratch: &mut TreeScratch,
) -> HitLanes<T> {
    let mut hits = HitLanes { t: *reach, name: [ObjectId::NOBODY; LANES], face: [0; LANES] };
    search(tables, &tables.spheres, candidates.of(Kind::Sphere), rays, &mut hits);
    search(tables, &tables.cubes, candidates.of(Kind::Cube), rays, &mut hits);
    search(tables, &tables.pyramids, candidates.of(Kind::Pyramid), rays, &mut hits);
    search(tables, &tables.boards, candidates.of(Kind::Board), rays, &mut hits);
    if !tables.trees.is_empty() {
        hits = search_trees(tables, rays, bundle, hits, scratch);
    }
    if rays.start.any_inward {
        hits = leave(tables, rays, hits);
    }
    hits
}

#[inline(always)]
fn search<T: Real, C>(
    tables: &SceneTables<T>,
    table: &ShapeTable<T, C>,
    rows: Rows,
    rays: &RayLanes<'_, T>,
    hits: &mut HitLanes<T>,
) where
    C: ShapeColumns<T, Shape: Straight<T>>,
{
    if rows.is_empty() {
        return;
    }
    for row in rows {
        let shape = table.shapes.shape(row as usize);
        let name = ObjectId::packed(C::KIND, row);
        let mut worthwhile = false;
        for lane in 0..LANES {
            let counts = (hits.t[lane] >= T::ZERO) & (rays.start.departed[lane] != name);
            worthwhile |= counts & shape.may_meet(&rays.get(lane));
        }
        if worthwhile {
            test(tables, &shape, name, rays, hits);
        }
    }
}

#[inline(always)]
pub(super) fn test<T: Real>(
    tables: &SceneTables<T>,
    shape: &impl Straight<T>,
    name: u32,
    rays: &RayLanes<'_, T>,
    hits: &mut HitLanes<T>,
) {
    let (mut any_tie, mut any_unsure) = (false, false);
    for lane in 0..LANES {
        let met = shape.meet(&rays.get(lane));
        let t = met.t;
        let counts = rays.start.departed[lane] != name;
        // Idle lanes hold anything.
        any_unsure |= counts & met.unsure & (hits.t[lane] >= T::ZERO);
        let nearer = counts & (t < hits.t[lane]);
        any_tie |= counts & (t == hits.t[lane]);
        hits.t[lane] = if nearer { t } else { hits.t[lane] };
        hits.name[lane] = if nearer { name } else { hits.name[lane] };
        hits.face[lane] = if nearer { FaceCode::of(&met) } else { hits.face[lane] };
    }
    if any_tie {
        *hits = settle_ties(tables, shape, name, rays, *hits);
    }
    if any_unsure {
        *hits = settle_unsure(tables, shape, name, rays, *hits);
    }
}

/// Gives a shape those lanes in which it is as near as another one and comes first.
///
/// Hits are taken and given back by value, as in all that is not inlined: where their address is known elsewhere, compilers
/// must expect that what a loop over lanes reads is what it writes, and made one of single numbers in f64.
#[cold]
#[inline(never)]
fn settle_ties<T: Real>(
    tables: &SceneTables<T>,
    shape: &impl Straight<T>,
    name: u32,
    rays: &RayLanes<'_, T>,
    mut hits: HitLanes<T>,
) -> HitLanes<T> {
    for lane in 0..LANES {
        let met = shape.meet(&rays.get(lane));
        let is_tie = rays.start.departed[lane] != name && met.t == hits.t[lane];
        if is_tie && comes_first(tables, name, hits.name[lane]) {
            hits.name[lane] = name;
            hits.face[lane] = FaceCode::of(&met);
        }
    }
    hits
}

/// Gives a shape those lanes in which rounding cannot tell whether it is met, if it is, and nearer or first.
#[cold]
#[inline(never)]
fn settle_unsure<T: Real>(
    tables: &SceneTables<T>,
    shape: &impl Straight<T>,
    name: u32,
    rays: &RayLanes<'_, T>,
    mut hits: HitLanes<T>,
) -> HitLanes<T> {
    for lane in 0..LANES {
        let ray = rays.get(lane);
        let counts = rays.start.departed[lane] != name && hits.t[lane] >= T::ZERO;
        if counts && shape.meet(&ray).unsure {
            hits.take(tables, lane, name, shape.intersect(&ray));
        }
    }
    hits
}

/// Rays that started into an object leave it.
#[cold]
#[inline(never)]
fn leave<T: Real>(tables: &SceneTables<T>, rays: &RayLanes<T>, mut hits: HitLanes<T>) -> HitLanes<T> {
    for lane in 0..LANES {
        hits.take(tables, lane, rays.start.departed[lane], exit_of(tables, rays, lane));
    }
    hits
}

/// Where the ray of a lane leaves the object that it started into, if it did.
pub(super) fn exit_of<T: Real>(
    tables: &SceneTables<T>,
    rays: &RayLanes<'_, T>,
    lane: usize,
) -> Option<Crossing<T>> {
    let (name, face) = (rays.start.departed[lane], rays.start.face[lane]);
    if name == ObjectId::NOBODY || face == OUTWARD {
        return None;
    }
    let face = u8::try_from(face).unwrap_or(0);
    Some(exit(tables, ObjectId::unpacked(name), &rays.get(lane), face))
}

fn exit<T: Real>(tables: &SceneTables<T>, object: ObjectId, ray: &Ray<T>, face: u8) -> Crossing<T> {
    let row = object.row as usize;
    match object.kind {
        Kind::Sphere => tables.spheres.shapes.shape(row).exit(ray, face),
        Kind::Cube => tables.cubes.shapes.shape(row).exit(ray, face),
        Kind::Pyramid => tables.pyramids.shapes.shape(row).exit(ray, face),
        Kind::Board => tables.boards.shapes.shape(row).exit(ray, face),
    }
}

//! Packets and trees: all rays as one where they go much the same way, otherwise each by itself.

use crate::geometry::Real;
use crate::trace::tree::{Any, NO_ROW, Nearest, Packed, RayNumbers, Stack, Tree, TreeRay, Walk};
use crate::trace::{Kind, ObjectId, SceneTables, ShapeColumns, ShapeTable};

use super::beam::{AnyOfBeam, BeamRays, NearestOfBeam};
use super::bundle::Bundle;
use super::closest::HitLanes;
use super::lanes::{LANES, Lanes, RayLanes, Reach, VectorLanes, mask, nowhere};
use super::occlusion::test as test_occlusion;
use super::parties::{Parties, Party};

/// Rays that take turns in a tree.
const GROUP: usize = 8;

/// What searches need room for, kept from one to the next.
pub(in crate::trace) struct Scratch<T> {
    stacks: [Stack<T>; GROUP],
    /// For some lights and each kind, the row that hid a light last: likely to hide it again.
    occluders: [[u32; 3]; LIGHTS],
}

/// Lights that a last occluder is remembered for; others share.
const LIGHTS: usize = 8;

impl<T: Real> Scratch<T> {
    pub(in crate::trace) fn new() -> Self {
        Self { stacks: core::array::from_fn(|_| Stack::new()), occluders: [[NO_ROW; 3]; LIGHTS] }
    }
}

/// [`RayNumbers`] of every lane.
struct NumberLanes<T> {
    inverse: VectorLanes<T>,
    pad: Lanes<T>,
    inverse_length: Lanes<T>,
    inverse_square: Lanes<T>,
}

impl<T: Real> NumberLanes<T> {
    #[inline(always)]
    fn of(rays: &RayLanes<'_, T>, rounding: T) -> Self {
        let zero = [T::ZERO; LANES];
        let mut all =
            Self { inverse: VectorLanes::zero(), pad: zero, inverse_length: zero, inverse_square: zero };
        for lane in 0..LANES {
            let RayNumbers { inverse, pad, inverse_length, inverse_square } =
                RayNumbers::new(&rays.get(lane), rounding);
            all.inverse.set(lane, inverse);
            all.pad[lane] = pad;
            all.inverse_length[lane] = inverse_length;
            all.inverse_square[lane] = inverse_square;
        }
        all
    }

    #[inline(always)]
    fn get(&self, lane: usize) -> RayNumbers<T> {
        RayNumbers {
            inverse: self.inverse.get(lane),
            pad: self.pad[lane],
            inverse_length: self.inverse_length[lane],
            inverse_square: self.inverse_square[lane],
        }
    }
}

/// A bit for each ray of a group.
const ALL: u32 = (1 << GROUP) - 1;

/// Searches the tree of one kind for every lane.
#[inline(always)]
pub(super) fn search_tree<T: Real, C>(
    tables: &SceneTables<T>,
    tree: Option<&Tree<T, C::Shape>>,
    rays: &RayLanes<'_, T>,
    bundle: &Bundle<T>,
    hits: &mut HitLanes<T>,
    scratch: &mut Scratch<T>,
) where
    C: ShapeColumns<T, Shape: Packed<T>>,
{
    let Some(tree) = tree else { return };
    let search: ClosestSearch<'_, T, C> = ClosestSearch { tables, tree, rays };
    let mut parties = Parties::of(tree, rays, bundle, &hits.t);
    while let Some(party) = parties.next() {
        let before = core::mem::replace(&mut hits.t, party.reach);
        search.together(&party, hits, &mut scratch.stacks[0]);
        party.restore(&mut hits.t, &before);
    }
    let alone = parties.alone();
    if alone == 0 {
        return;
    }
    let numbers = NumberLanes::of(rays, tree.rounding());
    if tree.is_large() {
        search.in_turns(&numbers, alone, hits, &mut scratch.stacks);
    } else {
        search.one_by_one(&numbers, alone, hits, &mut scratch.stacks[0]);
    }
}

struct ClosestSearch<'a, T: Real, C: ShapeColumns<T, Shape: Packed<T>>> {
    tables: &'a SceneTables<T>,
    tree: &'a Tree<T, C::Shape>,
    rays: &'a RayLanes<'a, T>,
}

impl<'a, T: Real, C: ShapeColumns<T, Shape: Packed<T>>> ClosestSearch<'a, T, C> {
    #[inline(always)]
    fn together(&self, party: &Party<T>, hits: &mut HitLanes<T>, stack: &mut Stack<T>) {
        let rays = BeamRays::new(self.rays, &party.bundle, C::KIND);
        self.tree.search_beam::<true>(
            &party.beam,
            stack,
            &mut NearestOfBeam { tables: self.tables, rays, hits },
        );
    }

    /// The lanes with a bit.
    #[inline(always)]
    fn one_by_one(&self, numbers: &NumberLanes<T>, lanes: u32, hits: &mut HitLanes<T>, stack: &mut Stack<T>) {
        let mut left = lanes;
        while left != 0 {
            let lane = left.trailing_zeros() as usize;
            left &= left - 1;
            let mut walk = self.walk(lane, numbers, hits);
            self.tree.search::<true, _>(&mut walk, stack);
            self.settle(lane, &walk.search, hits);
        }
    }

    /// The lanes with a bit.
    #[inline(always)]
    fn in_turns(
        &self,
        numbers: &NumberLanes<T>,
        lanes: u32,
        hits: &mut HitLanes<T>,
        stacks: &mut [Stack<T>; GROUP],
    ) {
        for first in (0..LANES).step_by(GROUP) {
            let mut walks: [_; GROUP] =
                core::array::from_fn(|number| self.walk(first + number, numbers, hits));
            let active = lanes >> first & ALL;
            self.tree.search_in_turns::<true, _>(&mut walks, active, stacks);
            for (lane, walk) in (first..).zip(&walks) {
                self.settle(lane, &walk.search, hits);
            }
        }
    }

    #[inline(always)]
    fn walk(&self, lane: usize, numbers: &NumberLanes<T>, hits: &HitLanes<T>) -> Walk<T, Nearest<'a, T>> {
        let (t, name, face) = (hits.t[lane], hits.name[lane], hits.face[lane]);
        let search = Nearest { tables: self.tables, kind: C::KIND, t, name, face };
        let ray = TreeRay::of(self.rays.get(lane), &numbers.get(lane));
        Walk::new(ray, departed_row(self.rays, lane, C::KIND), search)
    }

    /// Takes over what was found.
    #[inline(always)]
    fn settle(&self, lane: usize, search: &Nearest<'_, T>, hits: &mut HitLanes<T>) {
        hits.t[lane] = search.t;
        hits.name[lane] = search.name;
        hits.face[lane] = search.face;
    }
}

/// Searches the tree of one kind for whatever hides a light.
#[inline(always)]
pub(super) fn block_tree<T: Real, C>(
    table: &ShapeTable<T, C>,
    tree: Option<&Tree<T, C::Shape>>,
    segments: &RayLanes<'_, T>,
    bundle: &Bundle<T>,
    reach: &mut Reach<T>,
    light: usize,
    scratch: &mut Scratch<T>,
) where
    C: ShapeColumns<T, Shape: Packed<T>>,
{
    let Some(tree) = tree else { return };
    let search = ShadowSearch { table, tree, segments };
    let last = &mut scratch.occluders[light % LIGHTS][C::KIND as usize % 3];
    if *last != NO_ROW && !search.hide(*last, reach) {
        return;
    }
    let mut parties = Parties::of(tree, segments, bundle, reach);
    while let Some(party) = parties.next() {
        let before = core::mem::replace(reach, party.reach);
        search.together(&party, reach, &mut scratch.stacks[0]);
        party.restore(reach, &before);
    }
    let alone = parties.alone();
    if alone == 0 {
        return;
    }
    let numbers = NumberLanes::of(segments, tree.rounding());
    if tree.is_large() {
        search.in_turns(&numbers, alone, reach, last, &mut scratch.stacks);
    } else {
        search.one_by_one(&numbers, alone, reach, last, &mut scratch.stacks[0]);
    }
}

struct ShadowSearch<'a, T: Real, C: ShapeColumns<T, Shape: Packed<T>>> {
    table: &'a ShapeTable<T, C>,
    tree: &'a Tree<T, C::Shape>,
    segments: &'a RayLanes<'a, T>,
}

impl<T: Real, C: ShapeColumns<T, Shape: Packed<T>>> ShadowSearch<'_, T, C> {
    #[inline(always)]
    fn together(&self, party: &Party<T>, reach: &mut Reach<T>, stack: &mut Stack<T>) {
        let rays = BeamRays::new(self.segments, &party.bundle, C::KIND);
        self.tree.search_beam::<false>(&party.beam, stack, &mut AnyOfBeam { rays, reach });
    }

    /// The lanes with a bit.
    #[inline(always)]
    fn one_by_one(
        &self,
        numbers: &NumberLanes<T>,
        lanes: u32,
        reach: &mut Reach<T>,
        last: &mut u32,
        stack: &mut Stack<T>,
    ) {
        let mut left = lanes;
        while left != 0 {
            let lane = left.trailing_zeros() as usize;
            let mut walk = self.walk(lane, numbers, reach);
            self.tree.search::<false, _>(&mut walk, stack);
            left &= left - 1;
            if walk.search.row != NO_ROW {
                *last = walk.search.row;
                self.hide(*last, reach);
                left &= mask(|lane| reach[lane] > T::ZERO);
            }
        }
    }

    /// The lanes with a bit.
    #[inline(always)]
    fn in_turns(
        &self,
        numbers: &NumberLanes<T>,
        lanes: u32,
        reach: &mut Reach<T>,
        last: &mut u32,
        stacks: &mut [Stack<T>; GROUP],
    ) {
        for first in (0..LANES).step_by(GROUP) {
            let mut walks: [_; GROUP] =
                core::array::from_fn(|number| self.walk(first + number, numbers, reach));
            let active = lanes >> first & ALL;
            self.tree.search_in_turns::<false, _>(&mut walks, active, stacks);
            for (lane, walk) in (first..).zip(&walks) {
                if walk.search.row != NO_ROW {
                    *last = walk.search.row;
                    reach[lane] = nowhere();
                }
            }
        }
    }

    #[inline(always)]
    fn walk(&self, lane: usize, numbers: &NumberLanes<T>, reach: &Reach<T>) -> Walk<T, Any<T>> {
        let ray = TreeRay::of(self.segments.get(lane), &numbers.get(lane));
        let any = Any { row: NO_ROW, reach: reach[lane] };
        Walk::new(ray, departed_row(self.segments, lane, C::KIND), any)
    }

    /// Lets a row hide the light in whatever lanes it does; whether any lane is left.
    #[inline(always)]
    fn hide(&self, row: u32, reach: &mut Reach<T>) -> bool {
        let shape = self.table.shapes.shape(row as usize);
        test_occlusion(&shape, ObjectId::packed(C::KIND, row), self.segments, reach)
    }
}

/// The row of one kind that the ray of a lane leaves.
#[inline(always)]
fn departed_row<T: Real>(rays: &RayLanes<'_, T>, lane: usize, kind: Kind) -> u32 {
    let ObjectId { kind: departed, row } = ObjectId::unpacked(rays.start.departed[lane]);
    if departed == kind { row } else { NO_ROW }
}

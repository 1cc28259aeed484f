//! Packets and trees: all rays as one where they go much the same way, otherwise each by itself, in a swarm where that is
//! faster.
//!
//! Trees know of no effect, so kernels share the code of both searches.

use crate::geometry::Real;
use crate::trace::simd::Vectorised;
use crate::trace::tree::{
    Any, NO_ROW, Nearest, Packed, RayNumbers, SWARM, Stack, SwarmStack, Tree, TreeRay, Walk, Walks,
};
use crate::trace::{
    CubeColumns, Kind, ObjectId, PyramidColumns, SceneTables, ShapeColumns, ShapeTable, Simd, SphereColumns,
};

use super::beam::{AnyOfBeam, BeamRays, NearestOfBeam};
use super::bundle::Bundle;
use super::closest::HitLanes;
use super::lanes::{LANES, Lanes, RayLanes, Reach, VectorLanes, mask, nowhere};
use super::occlusion::test as test_occlusion;
use super::parties::{Parties, Party};

/// Rays that take turns in a tree.
const GROUP: usize = 16;

/// A packet has a bit for each of its rays.
const _: () = assert!(LANES == SWARM);

/// What searches of trees need room for, kept from one to the next.
pub(in crate::trace) struct TreeScratch {
    /// What trees are searched with.
    simd: Simd,
    /// 128 KiB, which nobody clears where there is no tree.
    stacks: Option<[Stack; GROUP]>,
    /// 16 KiB.
    swarm: Option<SwarmStack>,
    /// For some lights and each kind, the row that hid a light last: likely to hide it again.
    occluders: [[u32; 3]; LIGHTS],
}

/// Lights that a last occluder is remembered for; others share.
const LIGHTS: usize = 8;

impl TreeScratch {
    pub(in crate::trace) fn new(simd: Simd) -> Self {
        Self { simd, stacks: None, swarm: None, occluders: [[NO_ROW; 3]; LIGHTS] }
    }
}

/// A stack for each ray that takes turns.
fn empty_stacks() -> [Stack; GROUP] {
    [const { Stack::new() }; GROUP]
}

/// [`RayNumbers`] of every lane.
struct NumberLanes<T> {
    inverse: VectorLanes<T>,
    far_inverse: VectorLanes<T>,
    near_origin: VectorLanes<T>,
    far_origin: VectorLanes<T>,
    inverse_length: Lanes<T>,
    inverse_square: Lanes<T>,
}

impl<T: Real> NumberLanes<T> {
    #[inline(always)]
    fn of(rays: &RayLanes<'_, T>, rounding: T) -> Self {
        let (zero, vectors) = ([T::ZERO; LANES], VectorLanes::zero());
        let mut all = Self {
            inverse: vectors,
            far_inverse: vectors,
            near_origin: vectors,
            far_origin: vectors,
            inverse_length: zero,
            inverse_square: zero,
        };
        for lane in 0..LANES {
            let numbers = RayNumbers::new(&rays.get(lane), rounding);
            all.inverse.set(lane, numbers.inverse);
            all.far_inverse.set(lane, numbers.far_inverse);
            all.near_origin.set(lane, numbers.near_origin);
            all.far_origin.set(lane, numbers.far_origin);
            all.inverse_length[lane] = numbers.inverse_length;
            all.inverse_square[lane] = numbers.inverse_square;
        }
        all
    }

    #[inline(always)]
    fn get(&self, lane: usize) -> RayNumbers<T> {
        RayNumbers {
            inverse: self.inverse.get(lane),
            far_inverse: self.far_inverse.get(lane),
            near_origin: self.near_origin.get(lane),
            far_origin: self.far_origin.get(lane),
            inverse_length: self.inverse_length[lane],
            inverse_square: self.inverse_square[lane],
        }
    }
}

/// Searches all trees for every lane.
#[inline(always)]
pub(super) fn search_trees<T: Real>(
    tables: &SceneTables<T>,
    rays: &RayLanes<'_, T>,
    bundle: &Bundle<T>,
    hits: HitLanes<T>,
    scratch: &mut TreeScratch,
) -> HitLanes<T> {
    scratch.simd.run(ClosestInTrees { tables, rays, bundle, hits, scratch })
}

/// Work shared by all kernels, see [`search_trees`].
struct ClosestInTrees<'a, T: Real> {
    tables: &'a SceneTables<T>,
    rays: &'a RayLanes<'a, T>,
    bundle: &'a Bundle<T>,
    hits: HitLanes<T>,
    scratch: &'a mut TreeScratch,
}

impl<T: Real> Vectorised for ClosestInTrees<'_, T> {
    type Output = HitLanes<T>;

    #[inline(always)]
    fn run(mut self) -> Self::Output {
        let trees = &self.tables.trees;
        self.search::<SphereColumns<T>>(trees.spheres.as_deref());
        self.search::<CubeColumns<T>>(trees.cubes.as_deref());
        self.search::<PyramidColumns<T>>(trees.pyramids.as_deref());
        self.hits
    }
}

impl<T: Real> ClosestInTrees<'_, T> {
    /// Searches the tree of one kind.
    #[inline(always)]
    fn search<C>(&mut self, tree: Option<&Tree<T, C::Shape>>)
    where
        C: ShapeColumns<T, Shape: Packed<T>>,
    {
        let Some(tree) = tree else { return };
        let Self { tables, rays, bundle, hits, scratch } = self;
        let stacks = scratch.stacks.get_or_insert_with(empty_stacks);
        let search: ClosestSearch<'_, T, C> = ClosestSearch { tables, tree, rays };
        let mut parties = Parties::of(tree, rays, bundle, &hits.t);
        while let Some(party) = parties.next() {
            let before = core::mem::replace(&mut hits.t, party.reach);
            search.together(&party, hits, &mut stacks[0]);
            party.restore(&mut hits.t, &before);
        }
        let alone = parties.alone();
        if alone == 0 {
            return;
        }
        let numbers = &NumberLanes::of(rays, tree.rounding());
        let mut rays = ClosestWalks { search, numbers, left: alone, hits };
        if parties.is_swarm() {
            tree.search_as_swarm(&mut rays, scratch.swarm.get_or_insert_with(SwarmStack::new));
        } else {
            tree.search_all::<true, _, _>(&mut rays, stacks);
        }
    }
}

struct ClosestSearch<'a, T: Real, C: ShapeColumns<T, Shape: Packed<T>>> {
    tables: &'a SceneTables<T>,
    tree: &'a Tree<T, C::Shape>,
    rays: &'a RayLanes<'a, T>,
}

impl<'a, T: Real, C: ShapeColumns<T, Shape: Packed<T>>> ClosestSearch<'a, T, C> {
    #[inline(always)]
    fn together(&self, party: &Party<T>, hits: &mut HitLanes<T>, stack: &mut Stack) {
        let rays = BeamRays::new(self.rays, &party.bundle, C::KIND);
        self.tree.search_beam::<true>(
            &party.beam,
            stack,
            &mut NearestOfBeam { tables: self.tables, rays, hits },
        );
    }
}

/// Rays by themselves.
struct ClosestWalks<'a, 'b, T: Real, C: ShapeColumns<T, Shape: Packed<T>>> {
    search: ClosestSearch<'a, T, C>,
    numbers: &'b NumberLanes<T>,
    /// Lanes that have not been sent out, one bit each.
    left: u32,
    hits: &'b mut HitLanes<T>,
}

impl<'a, T: Real, C: ShapeColumns<T, Shape: Packed<T>>> Walks<T, Nearest<'a, T>>
    for ClosestWalks<'a, '_, T, C>
{
    #[inline(always)]
    fn waiting(&mut self) -> &mut u32 {
        &mut self.left
    }

    #[inline(always)]
    fn walk(&self, lane: usize) -> Walk<T, Nearest<'a, T>> {
        let lane = lane % LANES;
        let ClosestSearch { tables, rays, .. } = self.search;
        let (t, name, face) = (self.hits.t[lane], self.hits.name[lane], self.hits.face[lane]);
        let search = Nearest { tables, kind: C::KIND, t, name, face };
        let ray = TreeRay::of(rays.get(lane), self.numbers.get(lane));
        Walk::new(ray, departed_row(rays, lane, C::KIND), search)
    }

    #[inline(always)]
    fn finish(&mut self, lane: usize, search: &Nearest<'a, T>) {
        let lane = lane % LANES;
        self.hits.t[lane] = search.t;
        self.hits.name[lane] = search.name;
        self.hits.face[lane] = search.face;
    }
}

/// Searches all trees for whatever hides a light.
#[inline(always)]
pub(super) fn block_trees<T: Real>(
    tables: &SceneTables<T>,
    segments: &RayLanes<'_, T>,
    bundle: &Bundle<T>,
    reach: Reach<T>,
    light: usize,
    scratch: &mut TreeScratch,
) -> Reach<T> {
    scratch.simd.run(OcclusionByTrees { tables, segments, bundle, reach, light, scratch })
}

/// Work shared by all kernels, see [`block_trees`].
struct OcclusionByTrees<'a, T: Real> {
    tables: &'a SceneTables<T>,
    segments: &'a RayLanes<'a, T>,
    bundle: &'a Bundle<T>,
    reach: Reach<T>,
    light: usize,
    scratch: &'a mut TreeScratch,
}

impl<T: Real> Vectorised for OcclusionByTrees<'_, T> {
    type Output = Reach<T>;

    #[inline(always)]
    fn run(mut self) -> Self::Output {
        let SceneTables { spheres, cubes, pyramids, trees, .. } = self.tables;
        self.block(spheres, trees.spheres.as_deref());
        self.block(cubes, trees.cubes.as_deref());
        self.block(pyramids, trees.pyramids.as_deref());
        self.reach
    }
}

impl<T: Real> OcclusionByTrees<'_, T> {
    /// Searches the tree of one kind.
    #[inline(always)]
    fn block<C>(&mut self, table: &ShapeTable<T, C>, tree: Option<&Tree<T, C::Shape>>)
    where
        C: ShapeColumns<T, Shape: Packed<T>>,
    {
        let Some(tree) = tree else { return };
        let Self { segments, bundle, reach, scratch, .. } = self;
        let search = ShadowSearch { table, tree, segments };
        let last = &mut scratch.occluders[self.light % LIGHTS][C::KIND as usize % 3];
        if *last != NO_ROW && !search.hide(*last, reach) {
            return;
        }
        let stacks = scratch.stacks.get_or_insert_with(empty_stacks);
        let mut parties = Parties::of(tree, segments, bundle, reach);
        while let Some(party) = parties.next() {
            let before = core::mem::replace(reach, party.reach);
            search.together(&party, reach, &mut stacks[0]);
            party.restore(reach, &before);
        }
        let alone = parties.alone();
        if alone == 0 {
            return;
        }
        let numbers = &NumberLanes::of(segments, tree.rounding());
        let shares = !tree.is_large();
        let mut rays = ShadowWalks { search, numbers, left: alone, reach, last, shares };
        if parties.is_swarm() {
            tree.search_as_swarm(&mut rays, scratch.swarm.get_or_insert_with(SwarmStack::new));
        } else {
            tree.search_all::<false, _, _>(&mut rays, stacks);
        }
    }
}

struct ShadowSearch<'a, T: Real, C: ShapeColumns<T, Shape: Packed<T>>> {
    table: &'a ShapeTable<T, C>,
    tree: &'a Tree<T, C::Shape>,
    segments: &'a RayLanes<'a, T>,
}

impl<T: Real, C: ShapeColumns<T, Shape: Packed<T>>> ShadowSearch<'_, T, C> {
    #[inline(always)]
    fn together(&self, party: &Party<T>, reach: &mut Reach<T>, stack: &mut Stack) {
        let rays = BeamRays::new(self.segments, &party.bundle, C::KIND);
        self.tree.search_beam::<false>(&party.beam, stack, &mut AnyOfBeam { rays, reach });
    }

    /// Lets a row hide the light in whatever lanes it does; whether any lane is left.
    #[inline(always)]
    fn hide(&self, row: u32, reach: &mut Reach<T>) -> bool {
        let shape = self.table.shapes.shape(row as usize);
        test_occlusion(&shape, ObjectId::packed(C::KIND, row), self.segments, reach)
    }
}

/// Rays by themselves.
struct ShadowWalks<'a, 'b, T: Real, C: ShapeColumns<T, Shape: Packed<T>>> {
    search: ShadowSearch<'a, T, C>,
    numbers: &'b NumberLanes<T>,
    /// Lanes that have not been sent out, one bit each.
    left: u32,
    reach: &'b mut Reach<T>,
    /// The row that hid the light last.
    last: &'b mut u32,
    /// Whether it is held against those that wait: in large trees objects are so small that it hides it from few.
    shares: bool,
}

impl<T: Real, C: ShapeColumns<T, Shape: Packed<T>>> Walks<T, Any<T>> for ShadowWalks<'_, '_, T, C> {
    #[inline(always)]
    fn waiting(&mut self) -> &mut u32 {
        &mut self.left
    }

    #[inline(always)]
    fn walk(&self, lane: usize) -> Walk<T, Any<T>> {
        let (lane, segments) = (lane % LANES, self.search.segments);
        let ray = TreeRay::of(segments.get(lane), self.numbers.get(lane));
        let any = Any { row: NO_ROW, reach: self.reach[lane] };
        Walk::new(ray, departed_row(segments, lane, C::KIND), any)
    }

    #[inline(always)]
    fn finish(&mut self, lane: usize, search: &Any<T>) {
        if search.row != NO_ROW {
            *self.last = search.row;
            self.reach[lane % LANES] = nowhere();
            if self.shares && self.left != 0 {
                self.search.hide(*self.last, self.reach);
                self.left &= mask(|lane| self.reach[lane] > T::ZERO);
            }
        }
    }
}

/// The row of one kind that the ray of a lane leaves.
#[inline(always)]
fn departed_row<T: Real>(rays: &RayLanes<'_, T>, lane: usize, kind: Kind) -> u32 {
    let ObjectId { kind: departed, row } = ObjectId::unpacked(rays.start.departed[lane]);
    if departed == kind { row } else { NO_ROW }
}

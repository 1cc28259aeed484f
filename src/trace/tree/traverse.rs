//! Rays down a tree, sixteen boxes or sixteen shapes at a time.

use crate::geometry::{Meeting, Ray, Real};
use crate::trace::hit::FaceCode;

use super::beam::Beam;
use super::prefetch::prefetch;
use super::ray::{Found, TreeRay, slack};
use super::stack::Stack;
use super::swarm::SWARM;
use super::{Child, Leaf, NO_ROW, Packed, Tree, WIDTH};

/// What a ray looks for in a tree.
pub(in crate::trace) trait TreeSearch<T: Real>: Copy {
    /// How far it still looks.
    fn reach(&self) -> T;

    /// Told of a crossing up to there with a row, and of its [`FaceCode`].
    fn meet(&mut self, row: u32, t: T, face: u32);

    /// Whether it has seen enough.
    fn is_done(&self) -> bool;
}

/// What the rays of a beam look for in a tree of shapes `S`.
///
/// A trait, because closures cannot be told to be inlined: where there were many copies of the search they were not, and
/// so compiled for the instructions that every processor has. Primary rays among 1e3 spheres took twice as long.
pub(in crate::trace) trait BeamSearch<T: Real, S> {
    /// How far any of the rays still looks; below 0 once the search is over.
    fn reach(&self) -> T;

    /// Whether any of the rays may meet a shape: asked of sixteen, one after the other.
    fn may_meet(&self, shape: &S) -> bool;

    /// Told of a shape that they may meet, and its row.
    fn meet(&mut self, shape: &S, row: u32);
}

/// Rays of a packet that go down a tree each by itself, and what becomes of them.
pub(in crate::trace) trait Walks<T: Real, Q: TreeSearch<T>> {
    /// The lanes that have not been sent out yet, one bit each.
    fn waiting(&mut self) -> &mut u32;

    /// The ray of a lane at the root, with what it looks for now.
    fn walk(&self, lane: usize) -> Walk<T, Q>;

    /// Told what that of a lane has found.
    fn finish(&mut self, lane: usize, search: &Q);

    /// Sends out the next one, if there is one left: its lane, and itself.
    #[inline(always)]
    fn start(&mut self) -> Option<(usize, Walk<T, Q>)> {
        let waiting = self.waiting();
        if *waiting == 0 {
            return None;
        }
        let lane = take_lane(waiting);
        Some((lane, self.walk(lane)))
    }
}

/// Takes the first lane out of some, of at least one.
#[inline(always)]
pub(super) fn take_lane(lanes: &mut u32) -> usize {
    let lane = lanes.trailing_zeros() as usize % SWARM;
    *lanes &= *lanes - 1;
    lane
}

/// A ray on its way down a tree.
#[derive(Clone, Copy, Debug)]
pub(in crate::trace) struct Walk<T, Q> {
    pub(super) ray: TreeRay<T>,
    /// The row that it leaves, which it does not meet.
    pub(super) departed: u32,
    /// What it looks for.
    pub(in crate::trace) search: Q,
    place: Place<T>,
}

/// Where it is.
#[derive(Clone, Copy, Debug)]
struct Place<T> {
    /// The node or leaf to look at next.
    code: u32,
    /// How many more are on its stack.
    height: usize,
    /// The reach of the search, with slack.
    limit: T,
}

impl<T: Real, Q: TreeSearch<T>> Walk<T, Q> {
    /// At the root.
    #[inline(always)]
    pub(in crate::trace) fn new(ray: TreeRay<T>, departed: u32, search: Q) -> Self {
        let place = Place { code: 0, height: 0, limit: search.reach() * slack() };
        Self { ray, departed, search, place }
    }

    /// The reach of the search, with slack.
    #[inline(always)]
    pub(super) fn limit(&self) -> T {
        self.place.limit
    }
}

impl<T: Real, S: Packed<T>> Tree<T, S> {
    /// How much rounding a ray must be prepared for.
    #[inline(always)]
    pub(in crate::trace) fn rounding(&self) -> T {
        self.rounding
    }

    /// How large a leaf is on average, along its longest side.
    #[inline(always)]
    pub(in crate::trace) fn leaf_size(&self) -> T {
        self.leaf_size
    }

    /// How large all of them together are.
    #[inline(always)]
    pub(in crate::trace) fn size(&self) -> T {
        self.size
    }

    /// Tells a search of every row that the ray meets up to its reach, other than the one it leaves; and of no row twice
    /// for nothing: near boxes come first if `SORTED`.
    #[inline(always)]
    pub(in crate::trace) fn search<const SORTED: bool, Q: TreeSearch<T>>(
        &self,
        walk: &mut Walk<T, Q>,
        stack: &mut Stack,
    ) {
        let (mut place, mut found) = (walk.place, Found::NONE);
        let Walk { ray, departed, search, .. } = walk;
        while self.step::<SORTED, Q>(ray, *departed, search, &mut place, stack, &mut found) {}
    }

    /// The same for several rays: one after the other, or in turns where that is faster.
    #[inline(always)]
    pub(in crate::trace) fn search_all<const SORTED: bool, Q: TreeSearch<T>, const GROUP: usize>(
        &self,
        rays: &mut impl Walks<T, Q>,
        stacks: &mut [Stack; GROUP],
    ) {
        if self.is_large() {
            return self.search_in_turns::<SORTED, Q, GROUP>(rays, stacks);
        }
        while let Some((lane, mut walk)) = rays.start() {
            self.search::<SORTED, Q>(&mut walk, &mut stacks[0]);
            rays.finish(lane, &walk.search);
        }
    }

    /// In a large tree a step waits for memory, and several can wait at the same time: as many rays as there are stacks
    /// take turns step by step, and where one is done the next one starts.
    #[inline(always)]
    fn search_in_turns<const SORTED: bool, Q: TreeSearch<T>, const GROUP: usize>(
        &self,
        rays: &mut impl Walks<T, Q>,
        stacks: &mut [Stack; GROUP],
    ) {
        let Some(first) = rays.start() else { return };
        let mut walks = [first; GROUP];
        let (mut active, mut found) = (1_u32, Found::NONE);
        for place in &mut walks[1..] {
            let Some(walk) = rays.start() else { break };
            *place = walk;
            active = active << 1 | 1;
        }
        while active != 0 {
            let mut left = active;
            while left != 0 {
                let slot = left.trailing_zeros() as usize % GROUP;
                left &= left - 1;
                let (lane, Walk { ray, departed, search, place }) = &mut walks[slot];
                if self.step::<SORTED, Q>(ray, *departed, search, place, &mut stacks[slot], &mut found) {
                    self.prefetch(place.code);
                    continue;
                }
                rays.finish(*lane, search);
                match rays.start() {
                    Some(walk) => walks[slot] = walk,
                    None => active &= !(1 << slot),
                }
            }
        }
    }

    /// Whether steps mostly wait for memory.
    #[inline(always)]
    pub(in crate::trace) fn is_large(&self) -> bool {
        size_of_val(&*self.nodes) + size_of_val(&*self.leaves) > LARGE
    }

    /// Tells a search of every shape that a ray of the beam may meet up to its reach, and of no row twice for nothing;
    /// near boxes come first if `SORTED`.
    #[inline(always)]
    pub(in crate::trace) fn search_beam<const SORTED: bool>(
        &self,
        beam: &Beam<T>,
        stack: &mut Stack,
        search: &mut impl BeamSearch<T, S>,
    ) {
        let mut place = Place { code: 0, height: 0, limit: search.reach() * slack() };
        let mut found = Found::NONE;
        loop {
            if place.code & Child::LEAF == 0 {
                let node = &self.nodes[place.code as usize];
                beam.enter(node, place.limit, &mut found);
                if !found.counted().is_empty() {
                    place.code = stack.push::<T, SORTED>(node, &found, &mut place.height);
                    continue;
                }
            } else {
                let leaf = &self.leaves[(place.code & !Child::LEAF) as usize];
                for slot in 0..WIDTH {
                    found.flags[slot] = u8::from(search.may_meet(&S::unpack(&leaf.block, slot)));
                }
                let (mut met, mut last) = (found.counted(), NO_ROW);
                while !met.is_empty() {
                    let slot = met.take();
                    if leaf.rows[slot] == last {
                        continue;
                    }
                    last = leaf.rows[slot];
                    search.meet(&S::unpack(&leaf.block, slot), last);
                    let reach = search.reach();
                    if reach < T::ZERO {
                        return;
                    }
                    place.limit = reach * slack();
                }
            }
            let Some(next) = stack.pop(&mut place.height, place.limit) else { return };
            place.code = next;
        }
    }

    /// Looks at a node or a leaf; whether there is another one. The parts of a walk are handed over by themselves: as one
    /// value they took random rays among 1e3 to 1e5 spheres 1.06 times as long.
    #[inline(always)]
    fn step<const SORTED: bool, Q: TreeSearch<T>>(
        &self,
        ray: &TreeRay<T>,
        departed: u32,
        search: &mut Q,
        place: &mut Place<T>,
        stack: &mut Stack,
        found: &mut Found<T>,
    ) -> bool {
        if place.code & Child::LEAF == 0 {
            let node = &self.nodes[place.code as usize];
            ray.enter(node, place.limit, found);
            if !found.counted().is_empty() {
                place.code = stack.push::<T, SORTED>(node, found, &mut place.height);
                return true;
            }
        } else {
            let leaf = &self.leaves[(place.code & !Child::LEAF) as usize];
            if Self::comes_near(leaf, ray, departed, search.reach()) {
                Self::meet(leaf, ray, departed, search, found);
            }
            if search.is_done() {
                return false;
            }
            place.limit = search.reach() * slack();
        }
        let next = stack.pop(&mut place.height, place.limit);
        place.code = next.unwrap_or(0);
        next.is_some()
    }

    #[inline(always)]
    fn prefetch(&self, code: u32) {
        if code & Child::LEAF == 0 {
            prefetch(&self.nodes[code as usize]);
        } else {
            prefetch(&self.leaves[(code & !Child::LEAF) as usize]);
        }
    }

    /// Whether a ray may meet a shape of a leaf at up to its reach: most leaves are told by that alone.
    #[inline(always)]
    pub(super) fn comes_near(leaf: &Leaf<S::Block>, ray: &TreeRay<T>, departed: u32, reach: T) -> bool {
        let TreeRay { ray, numbers, .. } = ray;
        let mut any = false;
        for slot in 0..WIDTH {
            let shape = S::unpack(&leaf.block, slot);
            let is_near = shape.may_meet_before(ray, numbers.inverse_length, numbers.inverse_square, reach);
            // A ray that leaves one of the shapes comes near it, of course.
            any |= is_near & (leaf.rows[slot] != departed);
        }
        any
    }

    /// Tells a search of the shapes of a leaf that the ray meets.
    #[inline(always)]
    pub(super) fn meet(
        leaf: &Leaf<S::Block>,
        ray: &TreeRay<T>,
        departed: u32,
        search: &mut impl TreeSearch<T>,
        found: &mut Found<T>,
    ) {
        let (ray, reach) = (&ray.ray, search.reach());
        let mut unsure = 0_u32;
        for slot in 0..WIDTH {
            let meeting = S::unpack(&leaf.block, slot).meet(ray);
            let counts = leaf.rows[slot] != departed;
            found.distances[slot] = meeting.t;
            found.faces[slot] = FaceCode::of(&meeting);
            found.flags[slot] = u8::from((meeting.t <= reach) & counts);
            unsure |= u32::from(meeting.unsure & counts) << slot;
        }
        let mut met = found.counted();
        while !met.is_empty() {
            let slot = met.take();
            search.meet(leaf.rows[slot], found.distances[slot], found.faces[slot]);
        }
        if unsure != 0 {
            settle::<T, S>(leaf, ray, unsure, search);
        }
    }
}

/// Tells a search of those rows of which rounding could not tell whether they are met, if they are.
#[cold]
#[inline(never)]
fn settle<T: Real, S: Packed<T>>(
    leaf: &Leaf<S::Block>,
    ray: &Ray<T>,
    unsure: u32,
    search: &mut impl TreeSearch<T>,
) {
    for slot in (0..WIDTH).filter(|slot| unsure >> slot & 1 == 1) {
        if let Some(crossing) = S::unpack(&leaf.block, slot).intersect(ray)
            && crossing.t <= search.reach()
        {
            search.meet(leaf.rows[slot], crossing.t, FaceCode::of(&Meeting::from(crossing)));
        }
    }
}

/// Bytes of nodes and leaves: half of a third-level cache. On a processor that has 32 MiB of it, random rays in f32 one after
/// the other are 1.4 times as fast as in turns among 1e5 spheres and 1.2 times among 3e5, half as fast among 1e6; in f64, where
/// trees are twice as large, 1.1, 0.9 and 0.4 times.
const LARGE: usize = 16 << 20;

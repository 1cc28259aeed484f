//! Packets that go down a tree as one.

use crate::geometry::{Bounded, Real, Straight};
use crate::trace::tree::{AxisBeam, Beam, BeamSearch, Packed, Tree};
use crate::trace::{Kind, ObjectId, SceneTables};

use super::bundle::Bundle;
use super::closest::{HitLanes, test as test_closest};
use super::lanes::{LANES, Lanes, RayLanes, Reach, greatest};
use super::occlusion::test as test_occlusion;

/// A packet is as wide as so many leaves at most. With two it is as fast, with eight slower than its rays one by one.
const LEAVES: u32 = 1;

/// The active rays of a packet as a tree sees them; `None` where they have too little in common to go together.
#[inline(always)]
pub(super) fn beam_of<T: Real, S: Packed<T>>(
    tree: &Tree<T, S>,
    rays: &RayLanes<'_, T>,
    bundle: &Bundle<T>,
    reach: &Reach<T>,
) -> Option<Beam<T>> {
    if !(bundle.is_narrow() && bundle.width(tree.size()) <= tree.leaf_size() * T::from_u32(LEAVES)) {
        return None;
    }
    let (point, direction) = (&rays.start.point, rays.direction);
    let origins = [
        range_of_active(&point.x, reach),
        range_of_active(&point.y, reach),
        range_of_active(&point.z, reach),
    ];
    let farthest = |[low, high]: [T; 2]| low.abs().at_least(high.abs());
    let pad = tree.rounding() * ((farthest(origins[0]) + farthest(origins[1])) + farthest(origins[2]));
    Some(Beam([
        AxisBeam::new(0, origins[0], range_of_active(&direction.x, reach), pad)?,
        AxisBeam::new(1, origins[1], range_of_active(&direction.y, reach), pad)?,
        AxisBeam::new(2, origins[2], range_of_active(&direction.z, reach), pad)?,
    ]))
}

/// The least and the greatest value of the active lanes.
///
/// Idle lanes get a number that loses. An active lane's value would do for both, but compilers make of it an address for
/// each lane, and then one number after the other: a thousand instructions.
#[inline(always)]
fn range_of_active<T: Real>(values: &Lanes<T>, reach: &Reach<T>) -> [T; 2] {
    let (mut high, mut negated) = ([-T::INFINITY; LANES], [-T::INFINITY; LANES]);
    for lane in 0..LANES {
        let is_active = reach[lane] >= T::ZERO;
        high[lane] = if is_active { values[lane] } else { high[lane] };
        negated[lane] = if is_active { -values[lane] } else { negated[lane] };
    }
    [-greatest(&negated), greatest(&high)]
}

/// Inverse lengths of directions, and their squares.
struct Inverses<T> {
    length: Lanes<T>,
    square: Lanes<T>,
}

impl<T: Real> Inverses<T> {
    #[inline(always)]
    fn of(rays: &RayLanes<'_, T>) -> Self {
        let (mut length, mut square) = ([T::ZERO; LANES], [T::ZERO; LANES]);
        for lane in 0..LANES {
            let direction = rays.direction.get(lane);
            let squared = direction.dot(direction);
            length[lane] = T::ONE / squared.sqrt();
            square[lane] = T::ONE / squared;
        }
        Self { length, square }
    }

    /// Whether any ray may meet a shape of this name within its reach.
    #[inline(always)]
    fn may_meet(
        &self,
        shape: &impl Straight<T>,
        name: u32,
        rays: &RayLanes<'_, T>,
        reach: &Reach<T>,
    ) -> bool {
        let mut any = false;
        for lane in 0..LANES {
            let (length, square) = (self.length[lane], self.square[lane]);
            let is_near = shape.may_meet_before(&rays.get(lane), length, square, reach[lane]);
            any |= is_near & (rays.start.departed[lane] != name);
        }
        any
    }
}

/// The rays of a beam.
pub(super) struct BeamRays<'a, T> {
    rays: &'a RayLanes<'a, T>,
    bundle: &'a Bundle<T>,
    inverses: Inverses<T>,
    kind: Kind,
}

impl<'a, T: Real> BeamRays<'a, T> {
    /// That look for objects of one kind.
    #[inline(always)]
    pub(super) fn new(rays: &'a RayLanes<'a, T>, bundle: &'a Bundle<T>, kind: Kind) -> Self {
        Self { rays, bundle, inverses: Inverses::of(rays), kind }
    }
}

/// The nearest surface along each ray of a beam.
pub(super) struct NearestOfBeam<'a, T: Real> {
    pub(super) tables: &'a SceneTables<T>,
    pub(super) rays: BeamRays<'a, T>,
    pub(super) hits: &'a mut HitLanes<T>,
}

impl<T: Real, S: Straight<T> + Bounded<T>> BeamSearch<T, S> for NearestOfBeam<'_, T> {
    #[inline(always)]
    fn reach(&self) -> T {
        greatest(&self.hits.t)
    }

    #[inline(always)]
    fn may_meet(&self, shape: &S) -> bool {
        self.rays.bundle.may_meet(shape)
    }

    #[inline(always)]
    fn meet(&mut self, shape: &S, row: u32) {
        let BeamRays { rays, inverses, kind, .. } = &self.rays;
        let name = ObjectId::packed(*kind, row);
        if inverses.may_meet(shape, name, rays, &self.hits.t) {
            test_closest(self.tables, shape, name, rays, self.hits);
        }
    }
}

/// Whether anything is before the reach of each ray of a beam: those that meet something become idle.
pub(super) struct AnyOfBeam<'a, T: Real> {
    pub(super) rays: BeamRays<'a, T>,
    pub(super) reach: &'a mut Reach<T>,
}

impl<T: Real, S: Straight<T> + Bounded<T>> BeamSearch<T, S> for AnyOfBeam<'_, T> {
    #[inline(always)]
    fn reach(&self) -> T {
        greatest(self.reach)
    }

    #[inline(always)]
    fn may_meet(&self, shape: &S) -> bool {
        self.rays.bundle.may_meet(shape)
    }

    #[inline(always)]
    fn meet(&mut self, shape: &S, row: u32) {
        let BeamRays { rays, inverses, kind, .. } = &self.rays;
        let name = ObjectId::packed(*kind, row);
        if inverses.may_meet(shape, name, rays, self.reach) {
            test_occlusion(shape, name, rays, self.reach);
        }
    }
}

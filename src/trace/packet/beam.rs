//! Packets that go down a tree as one.

use crate::geometry::{Real, Straight};
use crate::trace::tree::{AxisBeam, Beam, Packed, Tree};

use super::bundle::Bundle;
use super::lanes::{LANES, Lanes, RayLanes, Reach, mask, range};

/// A packet is as wide as so many leaves at most. Wider ones were measured to be slower than their rays one by one.
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
    let active = mask(|lane| reach[lane] >= T::ZERO);
    let any = active.trailing_zeros() as usize % LANES;
    let of_active = |values: &Lanes<T>| {
        let mut chosen = *values;
        for lane in 0..LANES {
            chosen[lane] = if reach[lane] >= T::ZERO { values[lane] } else { values[any] };
        }
        range(&chosen)
    };
    let (point, direction) = (&rays.start.point, rays.direction);
    let origins = [of_active(&point.x), of_active(&point.y), of_active(&point.z)];
    let farthest = |[low, high]: [T; 2]| low.abs().at_least(high.abs());
    let pad = tree.rounding() * ((farthest(origins[0]) + farthest(origins[1])) + farthest(origins[2]));
    Some(Beam([
        AxisBeam::new(0, origins[0], of_active(&direction.x), pad)?,
        AxisBeam::new(1, origins[1], of_active(&direction.y), pad)?,
        AxisBeam::new(2, origins[2], of_active(&direction.z), pad)?,
    ]))
}

/// Inverse lengths of directions, and their squares.
pub(super) struct Inverses<T> {
    length: Lanes<T>,
    square: Lanes<T>,
}

impl<T: Real> Inverses<T> {
    #[inline(always)]
    pub(super) fn of(rays: &RayLanes<'_, T>) -> Self {
        let (mut length, mut square) = ([T::ZERO; LANES], [T::ZERO; LANES]);
        for lane in 0..LANES {
            let direction = rays.direction.get(lane);
            let squared = direction.dot(direction);
            length[lane] = T::ONE / squared.sqrt();
            square[lane] = T::ONE / squared;
        }
        Self { length, square }
    }

    /// Whether any ray may meet a shape within its reach.
    #[inline(always)]
    pub(super) fn may_meet(
        &self,
        shape: &impl Straight<T>,
        rays: &RayLanes<'_, T>,
        reach: &Reach<T>,
    ) -> bool {
        let mut any = false;
        for lane in 0..LANES {
            any |= shape.may_meet_before(&rays.get(lane), self.length[lane], self.square[lane], reach[lane]);
        }
        any
    }
}

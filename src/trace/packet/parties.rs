//! Rays of a packet that go much the same way, where not all of them do: those that come from the same object, mostly.

use core::hint::black_box;

use crate::geometry::Real;
use crate::trace::ObjectId;
use crate::trace::tree::{Beam, Packed, Tree};

use super::beam::beam_of;
use super::bundle::{Bundle, Cluster, central_lane};
use super::lanes::{LANES, RayLanes, Reach, VectorLanes, mask, nowhere};

/// Fewer rays are not worth a beam.
const FEWEST: u32 = 4;

/// After so many rays that found no company, the others go alone, too.
const FAILURES: u32 = 2;

/// Parts of a packet, for one tree.
pub(super) struct Parties<'a, T: Real, S: Packed<T>> {
    tree: &'a Tree<T, S>,
    rays: &'a RayLanes<'a, T>,
    /// Around all of them.
    bundle: &'a Bundle<T>,
    /// The reach of those that no company has been looked for yet.
    left: Reach<T>,
    /// Whether all of them were asked to go together, and how often some could not.
    asked: bool,
    failures: u32,
    /// Whether those that are left go as a swarm.
    is_swarm: bool,
    /// A bit for each that found none.
    alone: u32,
}

/// Some rays, and the beam that they make.
pub(super) struct Party<T> {
    pub(super) beam: Beam<T>,
    pub(super) bundle: Bundle<T>,
    /// As it was; the other lanes are idle.
    pub(super) reach: Reach<T>,
}

impl<T: Real> Party<T> {
    /// Gives the rays that are not in it back how far they reached before.
    #[inline(always)]
    pub(super) fn restore(&self, reach: &mut Reach<T>, before: &Reach<T>) {
        for lane in 0..LANES {
            reach[lane] = if self.reach[lane] >= T::ZERO { reach[lane] } else { before[lane] };
        }
    }
}

impl<'a, T: Real, S: Packed<T>> Parties<'a, T, S> {
    /// Of the active rays of a packet, and the bundle around them. Where rays go as a swarm, all of them go together or none.
    #[inline(always)]
    pub(super) fn of(
        tree: &'a Tree<T, S>,
        rays: &'a RayLanes<'a, T>,
        bundle: &'a Bundle<T>,
        reach: &Reach<T>,
    ) -> Self {
        let is_swarm = tree.suits_swarm(rays.start.departed[central_lane(reach)] != ObjectId::NOBODY);
        let failures = if is_swarm { FAILURES } else { 0 };
        Self { tree, rays, bundle, left: *reach, asked: false, failures, is_swarm, alone: 0 }
    }

    /// Whether the lanes that are in no part go down the tree as a swarm.
    #[inline(always)]
    pub(super) fn is_swarm(&self) -> bool {
        self.is_swarm
    }

    /// The next part, if there is one: all of them, if they go together.
    #[inline(always)]
    pub(super) fn next(&mut self) -> Option<Party<T>> {
        if !self.asked {
            self.asked = true;
            if let Some(beam) = beam_of(self.tree, self.rays, self.bundle, &self.left) {
                let reach = self.left;
                self.left = [nowhere(); LANES];
                return Some(Party { beam, bundle: *self.bundle, reach });
            }
        }
        while self.failures < FAILURES && mask(|lane| self.left[lane] >= T::ZERO) != 0 {
            let seed = central_lane(&self.left);
            // Rays that do not come from an object have seldom anything else in common.
            if self.rays.start.departed[seed] == ObjectId::NOBODY {
                break;
            }
            let reach = self.company(seed);
            for lane in 0..LANES {
                self.left[lane] = if reach[lane] >= T::ZERO { nowhere() } else { self.left[lane] };
            }
            let lanes = mask(|lane| reach[lane] >= T::ZERO);
            if lanes.count_ones() >= FEWEST {
                let bundle = self.bundle_of(&reach);
                if let Some(beam) = beam_of(self.tree, self.rays, &bundle, &reach) {
                    return Some(Party { beam, bundle, reach });
                }
            }
            self.failures += 1;
            self.alone |= lanes;
        }
        None
    }

    /// The lanes that are in no part, after the last.
    #[inline(always)]
    pub(super) fn alone(&self) -> u32 {
        self.alone | mask(|lane| self.left[lane] >= T::ZERO)
    }

    /// The reach of a ray and of those that start close to it and go its way, the same way along every axis; the others are
    /// idle.
    #[inline(always)]
    fn company(&self, seed: usize) -> Reach<T> {
        let (starts, directions) = (&self.rays.start.point, self.rays.direction);
        let (point, direction) = (starts.get(seed), directions.get(seed));
        let near = self.tree.leaf_size() / T::TWO;
        let narrow = near / self.tree.size();
        let least = (T::ONE - narrow * narrow) * direction.dot(direction);
        let mut reach = [nowhere(); LANES];
        for lane in 0..LANES {
            let (way, other) = (starts.get(lane) - point, directions.get(lane));
            let along = other.dot(direction);
            let is_near = way.dot(way) <= near * near;
            let same_way = (along > T::ZERO)
                & (along * along >= least * other.dot(other))
                & ((other.x < T::ZERO) == (direction.x < T::ZERO))
                & ((other.y < T::ZERO) == (direction.y < T::ZERO))
                & ((other.z < T::ZERO) == (direction.z < T::ZERO));
            reach[lane] = if is_near & same_way { self.left[lane] } else { nowhere() };
        }
        reach[seed] = self.left[seed];
        reach
    }

    #[inline(always)]
    fn bundle_of(&self, reach: &Reach<T>) -> Bundle<T> {
        // Compilers would take this out of the loop and do it for every packet, before anybody asks: a tenth of the time of
        // primary rays.
        let directions = black_box(self.rays.direction);
        let mut units = VectorLanes::zero();
        for lane in 0..LANES {
            let direction = directions.get(lane);
            units.set(lane, direction * (T::ONE / direction.dot(direction).sqrt()));
        }
        Bundle::of_rays(&Cluster::of(&self.rays.start.point, reach), &units, reach)
    }
}

#[cfg(test)]
mod tests {
    use super::super::lanes::StartLanes;
    use super::*;
    use crate::geometry::{SphereShape, Vector};
    use crate::trace::{Kind, Sequential, SphereColumns};

    /// Spheres on a grid of so many a side; leaves are much smaller than all of them.
    fn spheres(side: u32) -> Tree<f64, SphereShape<f64>> {
        let mut spheres = SphereColumns::default();
        for number in 0..side.pow(3) {
            let at = |step: u32| f64::from(number / step % side) * 50.0;
            spheres.push(SphereShape { center: Vector::new(at(1), at(side), at(side * side)), radius: 1.0 });
        }
        Tree::build(&spheres, &Sequential).unwrap()
    }

    /// Too many for swarms.
    const MANY: u32 = 24;

    /// Rays from `start`, on an object, that all but go along x, and the reach of the lanes with a bit.
    fn packet(
        start: impl Fn(usize) -> Vector<f64>,
        lanes: u32,
    ) -> (StartLanes<f64>, VectorLanes<f64>, Reach<f64>) {
        let departed = [ObjectId::packed(Kind::Sphere, 0); LANES];
        let mut starts = StartLanes { departed, ..StartLanes::free() };
        let (mut directions, mut reach) = (VectorLanes::zero(), [nowhere(); LANES]);
        for (lane, slope) in (0..LANES).zip(1_u32..) {
            starts.point.set(lane, start(lane));
            directions.set(lane, Vector::new(3.0, f64::from(slope) / 8192.0, 1.0 / 8192.0));
            reach[lane] = if lanes >> lane & 1 == 1 { f64::INFINITY } else { nowhere() };
        }
        (starts, directions, reach)
    }

    fn bundle(start: &StartLanes<f64>, direction: &VectorLanes<f64>, reach: &Reach<f64>) -> Bundle<f64> {
        let mut units = *direction;
        units.normalize();
        Bundle::of_rays(&Cluster::of(&start.point, reach), &units, reach)
    }

    /// The lanes of every part, and those that are left.
    fn parted(start: &StartLanes<f64>, direction: &VectorLanes<f64>, reach: &Reach<f64>) -> (Vec<u32>, u32) {
        let tree = spheres(MANY);
        assert!(!tree.suits_swarm(true));
        parted_in(&tree, start, direction, reach)
    }

    fn parted_in(
        tree: &Tree<f64, SphereShape<f64>>,
        start: &StartLanes<f64>,
        direction: &VectorLanes<f64>,
        reach: &Reach<f64>,
    ) -> (Vec<u32>, u32) {
        let rays = RayLanes { start, direction };
        let bundle = bundle(start, direction, reach);
        let mut parties = Parties::of(tree, &rays, &bundle, reach);
        let mut parts = Vec::new();
        while let Some(party) = parties.next() {
            parts.push(mask(|lane| party.reach[lane] >= 0.0));
        }
        (parts, parties.alone())
    }

    const ACTIVE: u32 = 0xff0f_ffff;

    #[test]
    fn rays_that_go_together_are_one_part() {
        let (start, direction, reach) = packet(|_| Vector::new(-10.0, 20.0, 30.0), ACTIVE);
        assert_eq!(parted(&start, &direction, &reach), (vec![ACTIVE], 0));
    }

    #[test]
    fn rays_from_two_places_are_two_parts_and_idle_lanes_are_in_none() {
        let place = |lane| if lane % 3 == 0 { -10.0 } else { 150.0 };
        let (start, direction, reach) = packet(|lane| Vector::new(place(lane), 20.0, 30.0), ACTIVE);
        let first = mask(|lane| lane % 3 == 0) & ACTIVE;
        let (mut parts, alone) = parted(&start, &direction, &reach);
        parts.sort_unstable();
        let mut all = vec![first, ACTIVE & !first];
        all.sort_unstable();
        assert_eq!((parts, alone), (all, 0));
    }

    #[test]
    fn rays_that_turn_away_are_left_out() {
        let (start, mut direction, reach) = packet(|_| Vector::new(-10.0, 20.0, 30.0), ACTIVE);
        // The second passes for narrow, but goes the other way along one axis.
        direction.set(0, Vector::new(-3.0, 0.0, 0.0));
        direction.set(1, Vector::new(3.0, -1.0 / 8192.0, 1.0 / 8192.0));
        assert_eq!(parted(&start, &direction, &reach), (vec![ACTIVE & !3], 3));
    }

    #[test]
    fn rays_that_all_go_their_own_ways_are_alone() {
        let place = |lane| f64::from(u32::try_from(lane).unwrap()) * 100.0;
        let (start, direction, reach) = packet(|lane| Vector::new(0.0, place(lane), 0.0), ACTIVE);
        assert_eq!(parted(&start, &direction, &reach), (vec![], ACTIVE));
    }

    #[test]
    fn where_rays_go_as_a_swarm_parts_of_them_are_not_looked_for() {
        let place = |lane| if lane % 3 == 0 { -10.0 } else { 150.0 };
        let (start, direction, reach) = packet(|lane| Vector::new(place(lane), 20.0, 30.0), ACTIVE);
        let tree = spheres(8);
        assert!(tree.suits_swarm(true));
        assert_eq!(parted_in(&tree, &start, &direction, &reach), (vec![], ACTIVE));
        let (start, direction, reach) = packet(|_| Vector::new(-10.0, 20.0, 30.0), ACTIVE);
        assert_eq!(parted_in(&tree, &start, &direction, &reach), (vec![ACTIVE], 0));
    }

    #[test]
    fn rays_from_open_space_go_together_as_a_whole_or_not_at_all() {
        let place = |lane| if lane % 3 == 0 { -10.0 } else { 150.0 };
        let (mut start, direction, reach) = packet(|lane| Vector::new(place(lane), 20.0, 30.0), ACTIVE);
        start.departed = [ObjectId::NOBODY; LANES];
        assert_eq!(parted(&start, &direction, &reach), (vec![], ACTIVE));
        let (mut start, direction, reach) = packet(|_| Vector::new(-10.0, 20.0, 30.0), ACTIVE);
        start.departed = [ObjectId::NOBODY; LANES];
        assert_eq!(parted(&start, &direction, &reach), (vec![ACTIVE], 0));
    }
}

//! Rays from anywhere, thirty-two at a time.

use crate::geometry::{Real, Vector};
use crate::trace::hit::FaceCode;
use crate::trace::stream::Query;
use crate::trace::{Departure, Hit, ObjectId, SceneTables};

use super::bounds::Bounds;
use super::bundle::{Bundle, Cluster};
use super::closest::closest;
use super::lanes::{LANES, OUTWARD, RayLanes, Reach, StartLanes, VectorLanes, nowhere};
use super::occlusion::occlude;
use super::trees::TreeScratch;

/// Queries as a packet.
struct Packet<T> {
    start: StartLanes<T>,
    direction: VectorLanes<T>,
    reach: Reach<T>,
    bundle: Bundle<T>,
}

impl<T: Real> Packet<T> {
    /// At most a packet of them, in order.
    #[inline(always)]
    fn of(queries: &[Query<T>]) -> Self {
        let (mut start, mut direction, mut reach) =
            (StartLanes::free(), VectorLanes::zero(), [nowhere(); LANES]);
        let mut any_inward = false;
        for (lane, query) in queries.iter().enumerate().take(LANES) {
            start.point.set(lane, query.ray.origin);
            direction.set(lane, query.ray.direction);
            reach[lane] = query.reach;
            (start.departed[lane], start.face[lane]) = match query.departure {
                Departure::Free => (ObjectId::NOBODY, OUTWARD),
                Departure::Outward(object) => (ObjectId::packed(object.kind, object.row), OUTWARD),
                Departure::Inward(object, face) => (ObjectId::packed(object.kind, object.row), face.into()),
            };
            any_inward |= start.face[lane] != OUTWARD;
        }
        start.any_inward = any_inward;
        for lane in queries.len()..LANES {
            direction.set(lane, Vector::new(T::ONE, T::ZERO, T::ZERO));
        }
        let cluster = Cluster::of(&start.point, &reach);
        let mut units = direction;
        units.normalize();
        let bundle = Bundle::of_rays(&cluster, &units, &reach);
        Self { start, direction, reach, bundle }
    }

    #[inline(always)]
    fn rays(&self) -> RayLanes<'_, T> {
        RayLanes { start: &self.start, direction: &self.direction }
    }
}

/// [`closest_hit`](crate::trace::closest_hit) for each ray, in order.
#[inline(always)]
pub(in crate::trace) fn closest_hits<T: Real>(
    tables: &SceneTables<T>,
    queries: &[Query<T>],
    hits: &mut [Option<Hit<T>>],
    scratch: &mut TreeScratch,
) {
    let bounds = Bounds::new(tables);
    for (queries, hits) in queries.chunks(LANES).zip(hits.chunks_mut(LANES)) {
        let packet = Packet::of(queries);
        let candidates = bounds.near(&packet.bundle);
        let (reach, bundle) = (&packet.reach, &packet.bundle);
        let found = closest(tables, &packet.rays(), reach, bundle, &candidates, scratch);
        for (lane, hit) in hits.iter_mut().enumerate() {
            let crossing = FaceCode::meeting(found.face[lane], found.t[lane]).crossing();
            *hit = crossing
                .filter(|_| found.name[lane] != ObjectId::NOBODY)
                .map(|crossing| Hit { object: ObjectId::unpacked(found.name[lane]), crossing });
        }
    }
}

/// [`is_occluded`](crate::trace::is_occluded) for each ray, in order.
#[inline(always)]
pub(in crate::trace) fn occlusions<T: Real>(
    tables: &SceneTables<T>,
    queries: &[Query<T>],
    occluded: &mut [bool],
    scratch: &mut TreeScratch,
) {
    let bounds = Bounds::new(tables);
    for (queries, occluded) in queries.chunks(LANES).zip(occluded.chunks_mut(LANES)) {
        let packet = Packet::of(queries);
        let candidates = bounds.near(&packet.bundle);
        let mut reach = packet.reach;
        occlude(tables, &packet.rays(), &mut reach, &packet.bundle, &candidates, 0, scratch);
        for (lane, occluded) in occluded.iter_mut().enumerate() {
            *occluded = packet.reach[lane] > T::ZERO && reach[lane] <= T::ZERO;
        }
    }
}

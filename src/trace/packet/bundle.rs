//! Balls around the starts of a packet's rays, and cones around its rays.

use crate::geometry::{Ball, Bounded, Real, Vector};

use super::lanes::{LANES, Lanes, Reach, VectorLanes, greatest, mask};

/// Every active lane's point lies within `radius` of `center`, up to rounding.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cluster<T> {
    center: Vector<T>,
    radius: T,
}

/// Every ray of the packet starts within `spread` of `apex` and runs within the cone around `axis`, up to `length`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bundle<T> {
    pub(super) apex: Vector<T>,
    pub(super) spread: T,
    pub(super) axis: Vector<T>,
    /// Sine of the angle between axis and side, not below the true one, and the square of its cosine, not above. A cone
    /// so wide that it says nothing has one that is not above 0.
    pub(super) sine: T,
    pub(super) squared_cosine: T,
    pub(super) length: T,
}

/// A lane in the middle of a block, taken for the centre if it is active: near enough, and nothing to sum.
const MIDDLE: usize = 11;

/// An active lane, if there is one.
#[inline(always)]
pub(super) fn central_lane<T: Real>(reach: &Reach<T>) -> usize {
    if reach[MIDDLE] >= T::ZERO {
        MIDDLE
    } else {
        mask(|lane| reach[lane] >= T::ZERO).trailing_zeros() as usize % LANES
    }
}

impl<T: Real> Cluster<T> {
    /// Around the points of the active lanes.
    #[inline(always)]
    pub(super) fn of(points: &VectorLanes<T>, reach: &Reach<T>) -> Self {
        let center = points.get(central_lane(reach));
        let mut squares: Lanes<T> = [T::ZERO; LANES];
        for lane in 0..LANES {
            let apart = points.get(lane) - center;
            let square = apart.dot(apart);
            squares[lane] = if reach[lane] >= T::ZERO { square } else { T::ZERO };
        }
        Self { center, radius: greatest(&squares).sqrt() }
    }
}

impl<T: Real> Bundle<T> {
    /// The active rays of unit directions from a cluster, without end.
    #[inline(always)]
    pub(super) fn of_rays(starts: &Cluster<T>, directions: &VectorLanes<T>, reach: &Reach<T>) -> Self {
        let axis = directions.get(central_lane(reach));
        let mut squared_sines: Lanes<T> = [T::ZERO; LANES];
        for lane in 0..LANES {
            let direction = directions.get(lane);
            let cosine = direction.dot(axis);
            let across = direction - axis * cosine;
            let square = across.dot(across);
            let squared_sine = if cosine > T::ZERO { square } else { T::TWO };
            squared_sines[lane] = if reach[lane] >= T::ZERO { squared_sine } else { T::ZERO };
        }
        let (apex, spread) = (starts.center, starts.radius);
        Self { apex, spread, axis, length: T::INFINITY, ..Self::wide(greatest(&squared_sines).sqrt()) }
    }

    /// All ways from a point to a cluster.
    #[inline(always)]
    pub(super) fn from_point(apex: Vector<T>, ends: &Cluster<T>) -> Self {
        let way = ends.center - apex;
        let distance = way.length();
        let inverse = T::ONE / distance;
        let (axis, length) = (way * inverse, distance + ends.radius);
        Self { apex, spread: T::ZERO, axis, length, ..Self::wide(ends.radius * inverse) }
    }

    /// Whether it says anything.
    #[inline(always)]
    pub(super) fn is_narrow(&self) -> bool {
        self.squared_cosine > T::ZERO
    }

    /// Whether none of the rays of a narrow bundle meets what is in a ball, whatever rounding does.
    #[inline(always)]
    pub(super) fn misses(&self, ball: &Ball<T>, rounding: T) -> bool {
        let (apex, axis) = (self.apex, self.axis);
        let base = (apex.x.abs() + apex.y.abs()) + (apex.z.abs() + self.spread);
        let away = ball.center - apex;
        let along = away.dot(axis);
        let across = away - axis * along;
        let size = base + ((away.x.abs() + away.y.abs()) + (away.z.abs() + ball.radius));
        let radius = ball.radius + self.spread + rounding * size;
        // The distance from the side of the cone is no more than that from the cone; squares save a root.
        let side = radius + along.at_least(T::ZERO) * self.sine;
        let beside = across.dot(across) * self.squared_cosine > side * side;
        beside | (along < -radius) | (along > self.length + radius)
    }

    /// Whether a ray of a narrow bundle may meet a shape.
    #[inline(always)]
    pub(super) fn may_meet(&self, shape: &impl Bounded<T>) -> bool {
        !self.misses(&shape.ball(), shape.rounding())
    }

    /// How wide it is after this way.
    #[inline(always)]
    pub(super) fn width(&self, way: T) -> T {
        self.spread + self.sine * way.at_most(self.length)
    }

    /// A cone of this sine; one that is not below 1, or no number, says nothing.
    #[inline(always)]
    fn wide(sine: T) -> Self {
        // Unit vectors and their products are right to a few units in the last place of 1.
        let slack = T::from_u32(16) * T::ULP;
        let sine = sine + slack;
        let squared_cosine = (T::ONE - sine * sine) - T::TWO * slack;
        let nowhere = Vector::new(T::ZERO, T::ZERO, T::ZERO);
        Self { apex: nowhere, spread: T::ZERO, axis: nowhere, sine, squared_cosine, length: T::ZERO }
    }
}

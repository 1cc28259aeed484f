//! A cone around the rays of a packet.

use crate::geometry::{Real, Vector};

use super::lanes::{LANES, Lanes, VectorLanes, greatest};

/// Every ray of the packet starts within `spread` of `apex` and runs within the cone around `axis`, up to `length`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bundle<T> {
    pub(super) apex: Vector<T>,
    pub(super) spread: T,
    pub(super) axis: Vector<T>,
    /// Cosine and sine of the angle between axis and side: not above and not below the true ones.
    pub(super) cosine: T,
    pub(super) sine: T,
    pub(super) length: T,
}

/// A lane in the middle of a block, whose ray is taken for the axis: near enough, and nothing to sum.
const MIDDLE: usize = 5;

impl<T: Real> Bundle<T> {
    /// Rays with origins of their own and unit directions, without end. Every lane counts, also an idle one.
    #[inline(always)]
    pub(super) fn of_rays(origins: &VectorLanes<T>, directions: &VectorLanes<T>) -> Self {
        let apex = origins.get(MIDDLE);
        let mut squares: Lanes<T> = [T::ZERO; LANES];
        for lane in 0..LANES {
            let apart = origins.get(lane) - apex;
            squares[lane] = apart.dot(apart);
        }
        Self { spread: greatest(&squares).sqrt(), ..Self::from_point(apex, directions, T::INFINITY) }
    }

    /// Rays from one point, of which the unit directions are given.
    #[inline(always)]
    pub(super) fn from_point(apex: Vector<T>, directions: &VectorLanes<T>, length: T) -> Self {
        let axis = directions.get(MIDDLE);
        let mut squared_sines: Lanes<T> = [T::ZERO; LANES];
        for lane in 0..LANES {
            let direction = directions.get(lane);
            let cosine = direction.dot(axis);
            let across = direction - axis * cosine;
            squared_sines[lane] = if cosine > T::ZERO { across.dot(across) } else { T::TWO };
        }
        // Unit vectors and their products are right to a few units in the last place of 1.
        let slack = T::from_u32(16) * T::ULP;
        let sine = greatest(&squared_sines).sqrt() + slack;
        let cosine = (T::ONE - sine * sine).at_least(T::ZERO).sqrt() - slack;
        Self { apex, spread: T::ZERO, axis, cosine, sine, length }
    }
}

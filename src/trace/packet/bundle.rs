//! A cone around the rays of a packet.

use crate::geometry::{Real, Vector};

use super::lanes::{LANES, Lanes, VectorLanes, greatest, least, sum};

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

impl<T: Real> Bundle<T> {
    /// Rays with origins of their own and unit directions, without end. Every lane counts, also an idle one.
    #[inline(always)]
    pub(super) fn of_rays(origins: &VectorLanes<T>, directions: &VectorLanes<T>) -> Self {
        let low = Vector::new(least(&origins.x), least(&origins.y), least(&origins.z));
        let high = Vector::new(greatest(&origins.x), greatest(&origins.y), greatest(&origins.z));
        let half = T::ONE / T::TWO;
        let apex = (low + high) * half;
        Self { spread: (high - low).length() * half, ..Self::from_point(apex, directions, T::INFINITY) }
    }

    /// Rays from one point, of which the unit directions are given.
    #[inline(always)]
    pub(super) fn from_point(apex: Vector<T>, directions: &VectorLanes<T>, length: T) -> Self {
        let axis = Vector::new(sum(&directions.x), sum(&directions.y), sum(&directions.z)).unit_of_long();
        let mut cosines: Lanes<T> = [T::ZERO; LANES];
        let mut squared_sines: Lanes<T> = [T::ZERO; LANES];
        for lane in 0..LANES {
            let direction = directions.get(lane);
            let cosine = direction.dot(axis);
            let across = direction - axis * cosine;
            cosines[lane] = cosine;
            squared_sines[lane] = across.dot(across);
        }
        // Unit vectors and their products are right to a few units in the last place of 1.
        let slack = T::from_u32(16) * T::ULP;
        let cosine = least(&cosines) - slack;
        let sine = greatest(&squared_sines).sqrt() + slack;
        Self { apex, spread: T::ZERO, axis, cosine, sine, length }
    }
}

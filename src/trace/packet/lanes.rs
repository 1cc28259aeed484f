//! Numbers and vectors, thirty-two at a time.

use crate::geometry::{Ray, Real, Vector};
use crate::trace::ObjectId;

/// Rays in a packet: two vectors of the widest registers in single precision, four in double. With sixteen, what is done
/// once a packet took so much of the time that a picture of eight objects took 1.15 times as long in single precision,
/// and as long as now in double.
pub(in crate::trace) const LANES: usize = 32;

/// One number a lane.
pub(in crate::trace) type Lanes<T> = [T; LANES];

/// One vector a lane.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(in crate::trace) struct VectorLanes<T> {
    pub(in crate::trace) x: Lanes<T>,
    pub(in crate::trace) y: Lanes<T>,
    pub(in crate::trace) z: Lanes<T>,
}

impl<T: Real> VectorLanes<T> {
    #[inline(always)]
    pub(in crate::trace) fn zero() -> Self {
        Self { x: [T::ZERO; LANES], y: [T::ZERO; LANES], z: [T::ZERO; LANES] }
    }

    #[inline(always)]
    pub(in crate::trace) fn get(&self, lane: usize) -> Vector<T> {
        Vector::new(self.x[lane], self.y[lane], self.z[lane])
    }

    #[inline(always)]
    pub(in crate::trace) fn set(&mut self, lane: usize, v: Vector<T>) {
        self.x[lane] = v.x;
        self.y[lane] = v.y;
        self.z[lane] = v.z;
    }

    /// Sets a lane, or leaves it.
    #[inline(always)]
    pub(in crate::trace) fn set_if(&mut self, condition: bool, lane: usize, v: Vector<T>) {
        self.x[lane] = if condition { v.x } else { self.x[lane] };
        self.y[lane] = if condition { v.y } else { self.y[lane] };
        self.z[lane] = if condition { v.z } else { self.z[lane] };
    }

    /// Makes every lane its [`Vector::unit`].
    #[inline(always)]
    pub(super) fn normalize(&mut self) {
        if any(|lane| !self.get(lane).is_long()) {
            return self.normalize_short();
        }
        for lane in 0..LANES {
            self.set(lane, self.get(lane).unit_of_long());
        }
    }

    #[cold]
    #[inline(never)]
    fn normalize_short(&mut self) {
        for lane in 0..LANES {
            self.set(lane, self.get(lane).unit());
        }
    }
}

/// Where rays start.
#[derive(Clone, Copy, Debug)]
pub(super) struct StartLanes<T> {
    pub(super) point: VectorLanes<T>,
    /// Packed name of the object that the ray leaves, or nobody's.
    pub(super) departed: Lanes<u32>,
    /// The face that it leaves into its object, or [`OUTWARD`].
    pub(super) face: Lanes<u32>,
    /// Whether any lane goes into its object.
    pub(super) any_inward: bool,
}

/// In place of a face: the ray does not go into an object.
pub(super) const OUTWARD: u32 = u32::MAX;

impl<T: Real> StartLanes<T> {
    /// In open space.
    #[inline(always)]
    pub(super) fn free() -> Self {
        Self {
            point: VectorLanes::zero(),
            departed: [ObjectId::NOBODY; LANES],
            face: [OUTWARD; LANES],
            any_inward: false,
        }
    }
}

/// Rays, with what each may meet.
#[derive(Clone, Copy, Debug)]
pub(super) struct RayLanes<'a, T> {
    pub(super) start: &'a StartLanes<T>,
    pub(super) direction: &'a VectorLanes<T>,
}

impl<T: Real> RayLanes<'_, T> {
    #[inline(always)]
    pub(super) fn get(&self, lane: usize) -> Ray<T> {
        Ray { origin: self.start.point.get(lane), direction: self.direction.get(lane) }
    }
}

/// How far crossings count; below 0 in idle lanes.
pub(super) type Reach<T> = Lanes<T>;

/// The reach of an idle lane.
#[inline(always)]
pub(super) fn nowhere<T: Real>() -> T {
    -T::INFINITY
}

/// Lanes counted one by one, again and again: a vector addition each time, and one sum in the end.
#[derive(Clone, Copy, Debug)]
pub(super) struct LaneCounts(Lanes<u32>);

impl LaneCounts {
    pub(super) const NONE: Self = Self([0; LANES]);

    /// Counts the lanes that are not idle.
    #[inline(always)]
    pub(super) fn add<T: Real>(&mut self, reach: &Reach<T>) {
        for lane in 0..LANES {
            self.0[lane] += u32::from(reach[lane] >= T::ZERO);
        }
    }

    #[inline(always)]
    pub(super) fn sum(&self) -> u64 {
        self.0.iter().map(|&count| u64::from(count)).sum()
    }
}

/// Whether something is true of any lane.
#[inline(always)]
pub(super) fn any(is_true: impl Fn(usize) -> bool) -> bool {
    let mut any = false;
    for lane in 0..LANES {
        any |= is_true(lane);
    }
    any
}

/// The lanes of which something is true, one bit each.
#[inline(always)]
pub(super) fn mask(is_true: impl Fn(usize) -> bool) -> u32 {
    let mut bits = 0;
    for lane in 0..LANES {
        bits |= u32::from(is_true(lane)) << lane;
    }
    bits
}

/// The greatest of all lanes, none of them NaN.
#[inline(always)]
pub(super) fn greatest<T: Real>(values: &Lanes<T>) -> T {
    folded(values, |a, b| a.at_least(b))
}

/// The least of all lanes.
#[inline(always)]
pub(super) fn least(values: &Lanes<u32>) -> u32 {
    folded(values, |a, b| a.min(b))
}

/// All lanes as one, by halves: the order does not matter to the operation. Loops, because what the array functions of the
/// standard library are given is not always inlined.
#[inline(always)]
fn folded<V: Copy>(values: &Lanes<V>, joined: impl Fn(V, V) -> V) -> V {
    let (mut sixteen, mut eight, mut four) = ([values[0]; 16], [values[0]; 8], [values[0]; 4]);
    for lane in 0..16 {
        sixteen[lane] = joined(values[lane], values[lane + 16]);
    }
    for lane in 0..8 {
        eight[lane] = joined(sixteen[lane], sixteen[lane + 8]);
    }
    for lane in 0..4 {
        four[lane] = joined(eight[lane], eight[lane + 4]);
    }
    joined(joined(four[0], four[2]), joined(four[1], four[3]))
}

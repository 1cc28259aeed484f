//! Which objects the rays of a packet can meet at all.

use crate::geometry::{Ball, Bounded, Real, Vector};
use crate::trace::{Kind, SceneTables, ShapeColumns, ShapeTable};

use super::bundle::Bundle;

/// The most finite objects that are looked at one by one.
const MOST: usize = 64;

/// Objects that are looked at together: few scenes without trees have more than one or two times as many.
const GROUP: usize = 8;

/// Balls around the finite objects that are in no tree, if they are few: spheres, cubes, pyramids, row by row.
#[derive(Clone, Debug)]
pub(in crate::trace) struct Bounds<T> {
    x: [T; MOST],
    y: [T; MOST],
    z: [T; MOST],
    radius: [T; MOST],
    /// By how many units in the last place of a distance a kernel may take a ray to be elsewhere than it is.
    rounding: [T; MOST],
    /// Rows of spheres, cubes, pyramids, boards.
    rows: [u32; 4],
    /// Whether all finite objects are here.
    complete: bool,
}

/// The rows that are to be tested.
#[derive(Clone, Copy, Debug)]
pub(super) struct Candidates {
    /// One bit an object of the bounds.
    bits: u64,
    rows: [u32; 4],
    complete: bool,
}

impl<T: Real> Bounds<T> {
    /// The balls of a scene's objects, if they are few.
    pub(in crate::trace) fn new(tables: &SceneTables<T>) -> Self {
        let trees = &tables.trees;
        let rows = [
            if trees.spheres.is_none() { count(&tables.spheres) } else { 0 },
            if trees.cubes.is_none() { count(&tables.cubes) } else { 0 },
            if trees.pyramids.is_none() { count(&tables.pyramids) } else { 0 },
            count(&tables.boards),
        ];
        let finite: u64 = rows[..3].iter().map(|&rows| u64::from(rows)).sum();
        let zero = [T::ZERO; MOST];
        let complete = finite <= MOST as u64;
        let mut bounds = Self { x: zero, y: zero, z: zero, radius: zero, rounding: zero, rows, complete };
        if complete {
            bounds.add(&tables.spheres, rows[0], 0);
            bounds.add(&tables.cubes, rows[1], rows[0]);
            bounds.add(&tables.pyramids, rows[2], rows[0] + rows[1]);
        }
        bounds
    }

    fn add<C: ShapeColumns<T, Shape: Bounded<T>>>(
        &mut self,
        table: &ShapeTable<T, C>,
        rows: u32,
        first: u32,
    ) {
        for (row, at) in (0..rows as usize).zip(first as usize..) {
            let shape = table.shapes.shape(row);
            let ball = shape.ball();
            self.x[at] = ball.center.x;
            self.y[at] = ball.center.y;
            self.z[at] = ball.center.z;
            self.radius[at] = ball.radius;
            self.rounding[at] = shape.rounding();
        }
    }

    /// Every object.
    #[inline(always)]
    pub(super) fn all(&self) -> Candidates {
        Candidates { bits: u64::MAX, rows: self.rows, complete: self.complete }
    }

    /// The objects that a ray of the bundle may meet; those left out are met by none, whatever rounding does.
    #[inline(always)]
    pub(super) fn near(&self, bundle: &Bundle<T>) -> Candidates {
        let mut candidates = self.all();
        let count = (self.rows[0] + self.rows[1] + self.rows[2]) as usize;
        if self.complete && bundle.is_narrow() {
            candidates.bits = 0;
            for first in (0..count.min(MOST)).step_by(GROUP) {
                candidates.bits |= u64::from(self.near_in_group(bundle, first)) << first;
            }
        }
        candidates
    }

    #[inline(always)]
    fn near_in_group(&self, bundle: &Bundle<T>, first: usize) -> u32 {
        let (x, y, z) = (&self.x[first..][..GROUP], &self.y[first..][..GROUP], &self.z[first..][..GROUP]);
        let (radius, rounding) = (&self.radius[first..][..GROUP], &self.rounding[first..][..GROUP]);
        let mut bits = 0;
        for lane in 0..GROUP {
            let center = Vector::new(x[lane], y[lane], z[lane]);
            let misses = bundle.misses(&Ball { center, radius: radius[lane] }, rounding[lane]);
            bits |= u32::from(!misses) << lane;
        }
        bits
    }
}

fn count<T: Real, C>(table: &ShapeTable<T, C>) -> u32 {
    // Objects are far fewer than 2^32.
    u32::try_from(table.order.len()).unwrap_or(u32::MAX)
}

impl Candidates {
    /// The rows of one kind.
    #[inline(always)]
    pub(super) fn of(&self, kind: Kind) -> Rows {
        let [spheres, cubes, _, _] = self.rows;
        let first = match kind {
            Kind::Sphere | Kind::Board => 0,
            Kind::Cube => spheres,
            Kind::Pyramid => spheres + cubes,
        };
        let rows = self.rows[kind as usize];
        if self.complete && kind != Kind::Board {
            let bits = self.bits.checked_shr(first).unwrap_or(0) & low_bits(rows);
            Rows { bits, next: 0, end: 0 }
        } else {
            Rows { bits: 0, next: 0, end: rows }
        }
    }
}

#[inline(always)]
fn low_bits(count: u32) -> u64 {
    if count < u64::BITS { (1 << count) - 1 } else { u64::MAX }
}

/// Rows one after the other: those of the bits, then a range.
pub(super) struct Rows {
    bits: u64,
    next: u32,
    end: u32,
}

impl Rows {
    /// Whether there is none. To be asked before a loop: what compilers take out of it is then not done for nothing.
    #[inline(always)]
    pub(super) fn is_empty(&self) -> bool {
        self.bits == 0 && self.next >= self.end
    }
}

impl Iterator for Rows {
    type Item = u32;

    #[inline(always)]
    fn next(&mut self) -> Option<u32> {
        if self.bits != 0 {
            let row = self.bits.trailing_zeros();
            self.bits &= self.bits - 1;
            return Some(row);
        }
        let row = self.next;
        self.next += 1;
        (row < self.end).then_some(row)
    }
}

//! Many rays, in packets, with the vector instructions that there are.

use crate::geometry::{Ray, Real};

use super::packet::{TreeScratch, closest_hits, occlusions};
use super::simd::Vectorised;
use super::{Departure, Hit, SceneTables, Simd};

/// A ray, and what it may meet.
#[derive(Clone, Copy, Debug)]
pub struct Query<T> {
    /// The ray.
    pub ray: Ray<T>,
    /// How it starts.
    pub departure: Departure,
    /// How far it looks.
    pub reach: T,
}

impl Simd {
    /// [`closest_hit`](super::closest_hit) for each ray, in order.
    pub fn closest_hits<T: Real>(
        self,
        tables: &SceneTables<T>,
        queries: &[Query<T>],
        hits: &mut [Option<Hit<T>>],
    ) {
        self.run(ClosestHits { simd: self, tables, queries, hits });
    }

    /// [`is_occluded`](super::is_occluded) for each ray, in order.
    pub fn occlusions<T: Real>(self, tables: &SceneTables<T>, queries: &[Query<T>], occluded: &mut [bool]) {
        self.run(Occlusions { simd: self, tables, queries, occluded });
    }
}

struct ClosestHits<'a, T: Real> {
    simd: Simd,
    tables: &'a SceneTables<T>,
    queries: &'a [Query<T>],
    hits: &'a mut [Option<Hit<T>>],
}

impl<T: Real> Vectorised for ClosestHits<'_, T> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        closest_hits(self.tables, self.queries, self.hits, &mut TreeScratch::new(self.simd));
    }
}

struct Occlusions<'a, T: Real> {
    simd: Simd,
    tables: &'a SceneTables<T>,
    queries: &'a [Query<T>],
    occluded: &'a mut [bool],
}

impl<T: Real> Vectorised for Occlusions<'_, T> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        occlusions(self.tables, self.queries, self.occluded, &mut TreeScratch::new(self.simd));
    }
}

//! Rays asked for many at a time: with any vector instructions, through trees, and whether they have anything in common
//! or not, the answers are those of row after row.

use archetrace::geometry::{Ray, Real, Vector};
use archetrace::systems::{Tables, extract_schedule, prepare};
use archetrace::trace::{
    Departure, Hit, ObjectId, Query, SceneTables, Simd, Trees, closest_hit, is_occluded,
};

use crate::crowds::{CROWDS, Crowd, crowd};
use crate::support::random::Random;
use crate::support::tracing::workers;

/// Rays between points of a box around the crowd; some start on what others met.
fn queries<T: Real>(tables: &SceneTables<T>, count: usize, random: &mut Random) -> Vec<Query<T>> {
    let mut queries: Vec<Query<T>> = Vec::with_capacity(count);
    let mut departure = Departure::Free;
    for _ in 0..count {
        let (from, to) = (random.point(80.0), random.point(80.0));
        let ray = Ray { origin: Vector::from_dvec3(from), direction: Vector::from_dvec3(to - from) };
        queries.push(Query { ray, departure, reach: T::ONE });
        departure =
            closest_hit(tables, &ray, &departure, T::INFINITY).map_or(Departure::Free, |hit| hit.departure());
    }
    queries
}

/// Rays that go much the same way, or exactly the same: from a point, side by side, and along the axes with either zero.
fn fans<T: Real>(count: usize, random: &mut Random) -> Vec<Query<T>> {
    let mut queries = Vec::with_capacity(count);
    while queries.len() < count {
        let (from, to) = (random.point(150.0), random.point(60.0));
        let (spread, shift) = (10.0_f64.powf(random.between(-6.0, 1.0)), random.between(-1.0, 1.0).max(0.0));
        let axis = (queries.len() / 16).is_multiple_of(4).then_some(queries.len() / 64 % 6);
        let reach = if queries.len() % 32 < 16 { T::ONE } else { T::INFINITY };
        for _ in 0..16 {
            let (origin, end) = (from + random.point(shift), to + random.point(spread));
            let along = |direction: usize| {
                let zero = T::from_f64(if random.between(0.0, 1.0) < 0.5 { 0.0 } else { -0.0 });
                let far = T::from_f64(if direction.is_multiple_of(2) { 200.0 } else { -200.0 });
                let [x, y, z] = core::array::from_fn(|axis| if axis == direction / 2 { far } else { zero });
                Vector::new(x, y, z)
            };
            let direction = axis.map_or_else(|| Vector::from_dvec3(end - origin), along);
            let ray = Ray { origin: Vector::from_dvec3(origin), direction };
            queries.push(Query { ray, departure: Departure::Free, reach });
        }
    }
    queries
}

fn name<T: Real>(hit: Option<Hit<T>>) -> Option<(ObjectId, u64, u8)> {
    hit.map(|hit| (hit.object, hit.crossing.t.to_f64().to_bits(), hit.crossing.face))
}

fn check<T: Real>(kind: Crowd, count: usize, seed: u64) {
    let mut world = crowd(kind, count, seed, 8).world();
    prepare::<T>(&mut world, workers(1));
    extract_schedule::<T>().run(&mut world);
    let tables = &world.resource::<Tables<T>>().scene;
    let plain = SceneTables { trees: Trees::default(), ..(**tables).clone() };
    let mut queries = queries(&plain, 500, &mut Random::new(seed));
    queries.truncate(496);
    queries.extend(fans(1024, &mut Random::new(seed)));
    queries.truncate(queries.len() - 5);
    let hit = |query: &Query<T>| name(closest_hit(&plain, &query.ray, &query.departure, query.reach));
    let is_occluded = |query: &Query<T>| is_occluded(&plain, &query.ray, &query.departure, query.reach);
    let truths: Vec<_> = queries.iter().map(|query| (hit(query), is_occluded(query))).collect();
    for simd in Simd::available() {
        let (mut hits, mut occluded) = (vec![None; queries.len()], vec![false; queries.len()]);
        simd.closest_hits(tables, &queries, &mut hits);
        simd.occlusions(tables, &queries, &mut occluded);
        for (((query, truth), hit), occluded) in queries.iter().zip(&truths).zip(hits).zip(occluded) {
            let found = (name(hit), occluded);
            assert_eq!(found, *truth, "{count} {kind:?}, {}, {simd:?}, {query:?}", T::NAME);
        }
    }
}

/// Objects of three kinds: so many that any rays go down their trees as a swarm, that only those do that come from objects,
/// that none do.
#[test]
fn every_way_to_ask_gives_the_same_answer() {
    for kind in CROWDS {
        for count in [200, 8000, 24_000] {
            check::<f64>(kind, count, 41);
            check::<f32>(kind, count, 42);
        }
    }
}

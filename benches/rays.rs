//! Rays of four classes by themselves: millions a second, by processor time.
//!
//! ```text
//! cargo bench --bench rays -- SCENE [--eye X,Y,Z] [--look X,Y,Z] [--size N] [--precision f32] [--threads N] [--repeats N]
//!     [--class CLASS]
//! ```
//!
//! One line of JSON a class. `primary`: from the camera, 4 x 4 pixels after each other. `shadow`: from what they meet to
//! the first light, where it faces it. `mirror`: from there as from a mirror. `random`: anywhere in a box of
//! 200 x 200 x 100 in any direction. The boards are met beforehand and only bound the rays, so that the figures compare
//! with libraries that know no planes.

#![expect(clippy::cast_precision_loss, reason = "counts of rays, and random bits")]

#[path = "support/clock.rs"]
mod clock;
#[path = "support/view.rs"]
mod view;

use std::error::Error;
use std::io::Write as _;
use std::num::NonZeroUsize;

use archetrace::effects::reflect;
use archetrace::geometry::{Convex, Ray, Real, SurfacePoint, Vector};
use archetrace::systems::{Tables, Workers, extract_schedule, prepare};
use archetrace::trace::{
    CameraRays, Departure, Hit, Kind, ObjectId, Query, SceneTables, ShapeColumns, ShapeTable, Simd,
    closest_hit,
};
use bevy_ecs::prelude::World;
use clap::Parser;
use clock::Laps;
use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder};
use serde::Serialize;
use view::{Precision, View};

/// Traces rays of four classes over and over.
#[derive(Debug, Parser)]
struct Args {
    #[command(flatten)]
    view: View,
    /// Passes over all rays of a class that are measured, after one that is not
    #[arg(long, default_value = "5")]
    repeats: usize,
    /// One class only: primary, shadow, mirror or random
    #[arg(long)]
    class: Option<String>,
}

/// What a class gave.
#[derive(Serialize)]
struct Report {
    class: &'static str,
    precision: &'static str,
    threads: usize,
    rays: usize,
    hits: usize,
    mrays: f64,
}

fn main() -> Result<(), Box<dyn Error>> {
    let args = Args::parse();
    match args.view.precision {
        Precision::F32 => measure::<f32>(&args),
        Precision::F64 => measure::<f64>(&args),
    }
}

fn measure<T: Real>(args: &Args) -> Result<(), Box<dyn Error>> {
    let mut world = World::new();
    args.view.set_up(&mut world)?;
    prepare::<T>(&mut world, Workers::new(args.view.threads)?);
    extract_schedule::<T>().run(&mut world);
    let tables = world.resource::<Tables<T>>();
    let camera = tables.camera.as_ref().ok_or("no camera")?;
    let rays = Rays::new(&tables.scene, camera);
    let bench = Bench {
        tables: SceneTables { boards: ShapeTable::default(), ..(*tables.scene).clone() },
        pool: pool(args.view.threads)?,
        simd: args.view.simd()?,
        repeats: args.repeats,
        class: args.class.clone(),
    };
    bench.closest("primary", &rays.primary)?;
    bench.occlusion("shadow", &rays.shadow)?;
    bench.closest("mirror", &rays.mirror)?;
    bench.closest("random", &random(rays.primary.len()))
}

/// As many threads, or one per processor.
fn pool(threads: Option<NonZeroUsize>) -> Result<ThreadPool, ThreadPoolBuildError> {
    ThreadPoolBuilder::new().num_threads(threads.map_or(0, NonZeroUsize::get)).build()
}

struct Bench<T: Real> {
    tables: SceneTables<T>,
    pool: ThreadPool,
    simd: Simd,
    repeats: usize,
    class: Option<String>,
}

/// Rays that a thread takes at a time.
const CHUNK: usize = 4096;

impl<T: Real> Bench<T> {
    fn asks_for(&self, class: &str) -> bool {
        self.class.as_ref().is_none_or(|only| only == class)
    }

    fn closest(&self, class: &'static str, queries: &[Query<T>]) -> Result<(), Box<dyn Error>> {
        if !self.asks_for(class) {
            return Ok(());
        }
        let mut hits = vec![None; queries.len()];
        let mrays = self.time(queries.len(), || {
            let chunks = queries.par_chunks(CHUNK).zip(hits.par_chunks_mut(CHUNK));
            chunks.for_each(|(queries, hits)| self.simd.closest_hits(&self.tables, queries, hits));
        });
        self.report(class, mrays, hits.iter().map(Option::is_some))
    }

    fn occlusion(&self, class: &'static str, queries: &[Query<T>]) -> Result<(), Box<dyn Error>> {
        if !self.asks_for(class) {
            return Ok(());
        }
        let mut occluded = vec![false; queries.len()];
        let mrays = self.time(queries.len(), || {
            let chunks = queries.par_chunks(CHUNK).zip(occluded.par_chunks_mut(CHUNK));
            chunks.for_each(|(queries, occluded)| self.simd.occlusions(&self.tables, queries, occluded));
        });
        self.report(class, mrays, occluded.into_iter())
    }

    /// Millions of rays a second that the threads would trace with nothing else to do.
    fn time(&self, rays: usize, mut pass: impl FnMut() + Send) -> f64 {
        let mut laps = Laps::default();
        self.pool.install(&mut pass);
        for _ in 0..self.repeats {
            laps.time(|| self.pool.install(&mut pass));
        }
        let times = laps.times();
        let threads = self.pool.current_num_threads() as f64;
        let milliseconds = times.cpu_ms_median.map_or(times.ms_median, |cpu| cpu / threads);
        rays as f64 / milliseconds / 1e3
    }

    fn report(
        &self,
        class: &'static str,
        mrays: f64,
        hits: impl ExactSizeIterator<Item = bool>,
    ) -> Result<(), Box<dyn Error>> {
        let (precision, threads, rays) = (T::NAME, self.pool.current_num_threads(), hits.len());
        let hits = hits.filter(|&hit| hit).count();
        let report = Report { class, precision, threads, rays, hits, mrays };
        Ok(writeln!(std::io::stdout(), "{}", serde_json::to_string(&report)?)?)
    }
}

struct Rays<T> {
    primary: Vec<Query<T>>,
    shadow: Vec<Query<T>>,
    mirror: Vec<Query<T>>,
}

impl<T: Real> Rays<T> {
    fn new(tables: &SceneTables<T>, camera: &CameraRays<T>) -> Self {
        let mut rays = Self { primary: Vec::new(), shadow: Vec::new(), mirror: Vec::new() };
        let light = (!tables.lights.is_empty()).then(|| tables.lights.row(0).position);
        for (column, row) in pixels(camera.pixels()) {
            let start = camera.ray(column, row);
            let departure = Departure::Free;
            rays.primary.push(up_to_boards(tables, Query { ray: start.ray, departure, reach: start.reach }));
            let Some(hit) = closest_hit(tables, &start.ray, &departure, start.reach) else { continue };
            let (at, departure) = (locate(tables, &hit, &start.ray), hit.departure());
            let segment = light.map(|light| light - at.point).filter(|s| s.dot(at.normal) > T::ZERO);
            let query =
                |direction, reach| Query { ray: Ray { origin: at.point, direction }, departure, reach };
            rays.shadow.extend(segment.map(|segment| query(segment, T::ONE)));
            let mirrored = reflect(start.ray.direction, at.normal);
            rays.mirror.push(up_to_boards(tables, query(mirrored, T::INFINITY)));
        }
        rays
    }
}

/// The same query, up to the nearest board.
fn up_to_boards<T: Real>(tables: &SceneTables<T>, query: Query<T>) -> Query<T> {
    let left = |row| query.departure == Departure::Outward(ObjectId { kind: Kind::Board, row });
    let crossings = (0..).take(tables.boards.order.len()).filter(|&row| !left(row)).filter_map(|row| {
        tables.boards.shapes.shape(row as usize).intersect(&query.ray).map(|crossing| crossing.t)
    });
    Query { reach: crossings.fold(query.reach, T::at_most), ..query }
}

fn locate<T: Real>(tables: &SceneTables<T>, hit: &Hit<T>, ray: &Ray<T>) -> SurfacePoint<T> {
    let row = hit.object.row as usize;
    match hit.object.kind {
        Kind::Sphere => tables.spheres.shapes.shape(row).locate(ray, &hit.crossing),
        Kind::Cube => tables.cubes.shapes.shape(row).locate(ray, &hit.crossing),
        Kind::Pyramid => tables.pyramids.shapes.shape(row).locate(ray, &hit.crossing),
        Kind::Board => tables.boards.shapes.shape(row).locate(ray, &hit.crossing),
    }
}

/// Column and row of every pixel: tiles of 16 x 16, in them blocks of 4 x 4, two of which make a packet.
fn pixels(side: u32) -> impl Iterator<Item = (u32, u32)> {
    let tiles = side.div_ceil(16);
    let square = |index: u32, side: u32| (index % side, index / side);
    let all = (0..tiles * tiles).flat_map(move |tile| (0..256).map(move |index| (tile, index)));
    let places = all.map(move |(tile, index)| {
        let ((x, y), (column, row), (a, b)) =
            (square(tile, tiles), square(index / 16, 4), square(index % 16, 4));
        (x * 16 + column * 4 + a, y * 16 + row * 4 + b)
    });
    places.filter(move |&(column, row)| column < side && row < side)
}

/// Rays from anywhere in the box to anywhere, the same each time.
fn random<T: Real>(count: usize) -> Vec<Query<T>> {
    let mut state = 88_172_645_463_325_252_u64;
    let mut number = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 40) as f64 / 16_777_216.0
    };
    let mut query = || {
        let origin = [number() * 200.0 - 100.0, number() * 200.0 - 100.0, number() * 100.0];
        let (z, angle) = (number() * 2.0 - 1.0, number() * core::f64::consts::TAU);
        let across = (1.0 - z * z).max(0.0).sqrt();
        let [origin, direction] = [origin, [across * angle.cos(), across * angle.sin(), z]]
            .map(|[x, y, z]| Vector::new(T::from_f64(x), T::from_f64(y), T::from_f64(z)));
        Query { ray: Ray { origin, direction }, departure: Departure::Free, reach: T::INFINITY }
    };
    (0..count).map(|_| query()).collect()
}

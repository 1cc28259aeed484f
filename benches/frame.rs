//! Traced frames, warm and again and again: the milliseconds of `Stage::Trace` alone.
//!
//! ```text
//! cargo bench --bench frame -- SCENE [--eye X,Y,Z] [--look X,Y,Z] [--precision f32] [--threads N] [--simd N] [--repeats N]
//! ```
//!
//! One line of JSON: wall and processor milliseconds a frame (least and median), rays by kind. Processor time is that of
//! all threads and absent where the system does not tell; of a run with other work beside it, it is the firm figure.

#[path = "support/clock.rs"]
mod clock;
#[path = "support/view.rs"]
mod view;

use std::error::Error;
use std::io::Write as _;
use std::path::PathBuf;

use archetrace::geometry::Real;
use archetrace::systems::{Frame, Workers, extract_schedule, prepare, trace_schedule};
use archetrace::trace::RayCounts;
use bevy_ecs::prelude::World;
use clap::Parser;
use clock::{Laps, Times};
use serde::Serialize;
use view::{Precision, View};

/// Traces a scene file over and over.
#[derive(Debug, Parser)]
struct Args {
    #[command(flatten)]
    view: View,
    /// Frames that are measured, after one that is not
    #[arg(long, default_value = "15")]
    repeats: usize,
}

/// What a run found.
#[derive(Serialize)]
struct Report<'a> {
    scene: &'a PathBuf,
    precision: &'static str,
    threads: usize,
    simd: String,
    pixels: u32,
    #[serde(flatten)]
    times: Times,
    primary: u64,
    shadow: u64,
    mirror: u64,
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
    let pixels = args.view.set_up(&mut world)?;
    let simd = args.view.simd()?;
    let workers = Workers::new(args.view.threads)?.with_simd(simd);
    let threads = workers.threads();
    prepare::<T>(&mut world, workers);
    extract_schedule::<T>().run(&mut world);

    let mut trace = trace_schedule::<T>();
    trace.run(&mut world);
    let mut laps = Laps::default();
    for _ in 0..args.repeats {
        laps.time(|| trace.run(&mut world));
    }
    let RayCounts { primary, shadow, mirror, .. } = world.resource::<Frame>().traced()?.1.rays;
    let (scene, simd, times) = (&args.view.scene, format!("{simd:?}"), laps.times());
    let report = Report { scene, precision: T::NAME, threads, simd, pixels, times, primary, shadow, mirror };
    Ok(writeln!(std::io::stdout(), "{}", serde_json::to_string(&report)?)?)
}

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

use std::error::Error;
use std::io::Write as _;
use std::num::NonZeroUsize;
use std::path::PathBuf;

use archetrace::components::{CameraPose, Snapshot};
use archetrace::geometry::Real;
use archetrace::scene::{Source, spawn};
use archetrace::systems::{Frame, Workers, extract_schedule, prepare, trace_schedule};
use archetrace::trace::{RayCounts, Simd};
use bevy_ecs::prelude::World;
use clap::{Parser, ValueEnum};
use clock::{Laps, Times};
use glam::DVec3;
use serde::Serialize;

/// Traces a scene file over and over.
#[derive(Debug, Parser)]
struct Args {
    /// Scene description
    scene: PathBuf,
    /// Eye position
    #[arg(long, default_value = "0,-150,50", value_parser = vector, allow_hyphen_values = true)]
    eye: DVec3,
    /// Direction of view
    #[arg(long, default_value = "0,1,0", value_parser = vector, allow_hyphen_values = true)]
    look: DVec3,
    /// Pixels along each side; the scene's unless given
    #[arg(long)]
    size: Option<u32>,
    #[arg(long, value_enum, default_value = "f64")]
    precision: Precision,
    /// Threads that trace; one per processor unless given
    #[arg(long)]
    threads: Option<NonZeroUsize>,
    /// Vector instructions by number, 0 for those that every processor has; the widest unless given
    #[arg(long)]
    simd: Option<usize>,
    /// Frames that are measured, after one that is not
    #[arg(long, default_value = "15")]
    repeats: usize,
    /// Given by cargo
    #[arg(long, hide = true)]
    bench: bool,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Precision {
    F32,
    F64,
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
    match args.precision {
        Precision::F32 => measure::<f32>(&args),
        Precision::F64 => measure::<f64>(&args),
    }
}

fn measure<T: Real>(args: &Args) -> Result<(), Box<dyn Error>> {
    let mut world = World::new();
    spawn(&mut world, &Source::read(&args.scene)?.load()?.description);
    let pixels = set_camera(args, &mut world)?;
    let simd = match args.simd {
        Some(number) => *Simd::available().get(number).ok_or("this processor has no such instructions")?,
        None => Simd::detect(),
    };
    let workers = Workers::new(args.threads)?.with_simd(simd);
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
    let (scene, simd, times) = (&args.scene, format!("{simd:?}"), laps.times());
    let report = Report { scene, precision: T::NAME, threads, simd, pixels, times, primary, shadow, mirror };
    writeln!(std::io::stdout(), "{}", serde_json::to_string(&report)?)?;
    Ok(())
}

fn set_camera(args: &Args, world: &mut World) -> Result<u32, Box<dyn Error>> {
    let pose = CameraPose::looking(args.eye, args.look, DVec3::Z).ok_or("no direction of view")?;
    for mut camera in world.query::<&mut CameraPose>().iter_mut(world) {
        *camera = pose;
    }
    let mut snapshot = world.resource_mut::<Snapshot>();
    snapshot.pixels = args.size.unwrap_or(snapshot.pixels);
    Ok(snapshot.pixels)
}

fn vector(text: &str) -> Result<DVec3, String> {
    let numbers: Vec<f64> =
        text.split(',').map(str::parse).collect::<Result<_, _>>().map_err(|_| "three numbers X,Y,Z")?;
    <[f64; 3]>::try_from(numbers).map(DVec3::from_array).map_err(|_| "three numbers X,Y,Z".to_owned())
}

//! `archetrace render`

use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use bevy_ecs::prelude::*;
use indicatif::{ProgressBar, ProgressStyle};

use crate::components::{Sampling, Snapshot};
use crate::geometry::Real;
use crate::image_file::encode;
use crate::systems::{
    Frame, FrameError, Monitor, Muted, Tables, Workers, build_schedule, prepare, tables_schedule,
    trace_schedule,
};
use crate::trace::Kernel;
use crate::whole_file::{check_writable, write_whole};

use super::args::{Precision, RenderArgs};
use super::load::load_picture;
use super::stats::{Phases, Stats, Stopwatch};
use super::stop::stop_flag;
use super::{CliError, say};

fn workers(args: &RenderArgs) -> Result<Workers, CliError> {
    let least = if args.all_effects { Kernel::Everything } else { Kernel::Plain };
    Ok(Workers::new(args.picture.threads)?.with_least_kernel(least))
}

/// Traces a scene file to a picture file.
pub(super) fn render(args: &RenderArgs) -> Result<(), CliError> {
    match args.picture.precision {
        Precision::F64 => render_as::<f64>(args),
        Precision::F32 => render_as::<f32>(args),
    }
}

fn render_as<T: Real>(args: &RenderArgs) -> Result<(), CliError> {
    // What would make the work useless is asked before it.
    for path in [Some(&args.output), args.stats.as_ref()].into_iter().flatten() {
        check_writable(path)?;
    }
    let stop = stop_flag()?;
    let mut clock = Stopwatch::start();
    let mut phases = Phases::default();

    let mut world = World::new();
    let snapshot = load_picture(&args.scene, &args.picture, &mut world)?;
    world.insert_resource(Muted(args.without.iter().copied().collect()));
    phases.load = clock.lap();

    prepare::<T>(&mut world, workers(args)?);
    tables_schedule::<T>().run(&mut world);
    phases.extract = clock.lap();
    build_schedule::<T>().run(&mut world);
    phases.build = clock.lap();

    let progress = progress_bar(snapshot, args.picture.samples);
    world.insert_resource(monitor(&progress, &stop));
    trace_schedule::<T>().run(&mut world);
    progress.finish_and_clear();
    phases.trace = clock.lap();

    let frame = world.resource::<Frame>();
    let (film, counts) = frame.traced().map_err(|error| match error {
        FrameError::Cancelled => interrupted(&args.output),
        error => error.into(),
    })?;
    let picture = encode(film, &args.output)?;
    if stop.load(Ordering::Relaxed) {
        return Err(interrupted(&args.output));
    }
    write_whole(&args.output, &picture)?;
    phases.write = clock.lap();

    if counts.non_finite > 0 {
        say(&format!("warning: {} samples had no finite radiance and are black", counts.non_finite));
    }
    if let Some(path) = &args.stats {
        let threads = world.resource::<Workers>().threads();
        let tables = world.resource::<Tables<T>>();
        let stats = Stats::new((snapshot, args.picture.samples), threads, phases, counts, tables);
        write_whole(path, &stats.to_json()?)?;
    }
    Ok(())
}

/// A bar on a terminal, nothing elsewhere.
fn progress_bar(snapshot: Snapshot, sampling: Sampling) -> ProgressBar {
    let samples = u64::from(snapshot.pixels).pow(2) * u64::from(sampling.side).pow(2);
    let bar = ProgressBar::new(samples);
    // A template that does not parse would only lose its looks.
    if let Ok(style) = ProgressStyle::with_template("tracing {wide_bar} {percent:>3}% {eta} left") {
        bar.set_style(style);
    }
    bar
}

fn monitor(progress: &ProgressBar, stop: &Arc<AtomicBool>) -> Monitor {
    let progress = progress.clone();
    Monitor::new(move |pixels| progress.inc(pixels), stop.clone())
}

fn interrupted(output: &Path) -> CliError {
    CliError::Interrupted(output.display().to_string())
}

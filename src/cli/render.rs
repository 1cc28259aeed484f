//! `archetrace render`

use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use bevy_ecs::prelude::*;
use indicatif::{ProgressBar, ProgressStyle};

use crate::components::Precision;
use crate::geometry::Real;
use crate::image_file::encode_rgb8;
use crate::study::{Choice, FrontPoint, Lab, Setting, Wish, choose};
use crate::systems::{
    Frame, FrameError, Monitor, Muted, Tables, Workers, build_schedule, levels_schedule, prepare,
    tables_schedule,
};
use crate::trace::{Kernel, Refinement};
use crate::whole_file::{check_writable, write_whole};

use super::args::RenderArgs;
use super::load::load_picture;
use super::stats::{Phases, Stats, Stopwatch};
use super::stop::stop_flag;
use super::{CliError, say};

fn workers(args: &RenderArgs) -> Result<Workers, CliError> {
    let least = if args.all_effects { Kernel::EVERYTHING } else { Kernel::Plain };
    Ok(Workers::new(args.picture.threads)?.with_least_kernel(least))
}

/// Traces a scene file to a picture file.
pub(super) fn render(args: &RenderArgs) -> Result<(), CliError> {
    // What would make the work useless is asked before it.
    for path in [Some(&args.output), args.stats.as_ref()].into_iter().flatten() {
        check_writable(path)?;
    }
    let stop = stop_flag()?;
    let mut clock = Stopwatch::start();
    let mut phases = Phases::default();

    let mut world = World::new();
    let setting = load_picture(&args.scene, &args.picture, &mut world)?;
    world.insert_resource(Muted(args.without.iter().copied().collect()));
    phases.load = clock.lap();
    let choice = args.wish.wish().map(|wish| chosen(args, setting, wish, &mut world)).transpose()?;
    let setting = choice.as_ref().map_or(setting, |choice| choice.point.setting);
    setting.apply(&mut world);
    phases.choose = clock.lap();
    let job = Job { args, setting, choice, stop };
    match setting.precision {
        Precision::F64 => job.run::<f64>(world, clock, phases),
        Precision::F32 => job.run::<f32>(world, clock, phases),
    }
}

/// What meets a wish, with a warning where nothing does.
fn chosen(args: &RenderArgs, start: Setting, wish: Wish, world: &mut World) -> Result<Choice, CliError> {
    let began = Instant::now();
    let mut clock = || began.elapsed().as_secs_f64() * 1e3;
    let workers = workers(args)?;
    let free = args.picture.accuracy.free();
    let choice = choose(&mut Lab::new(world, &workers), start, free, wish, &mut clock)?;
    let FrontPoint { setting, milliseconds, .. } = choice.point;
    let expected = format!("{milliseconds:.0} ms and {:.1} dB expected", choice.point.psnr_db());
    if choice.meets {
        say(&format!("chosen: {} ({expected})", setting.flags()));
    } else {
        say(&format!(
            "warning: nothing tried meets {}; the closest is {} ({expected})",
            in_words(wish),
            setting.flags()
        ));
    }
    Ok(choice)
}

fn in_words(wish: Wish) -> String {
    match wish {
        Wish::Budget(milliseconds) => format!("a budget of {milliseconds} ms"),
        Wish::Decibels(decibels) => format!("a target of {decibels} dB"),
        Wish::Levels(levels) => format!("a target of {levels} levels"),
    }
}

/// A picture to be traced.
struct Job<'a> {
    args: &'a RenderArgs,
    setting: Setting,
    choice: Option<Choice>,
    stop: Arc<AtomicBool>,
}

impl Job<'_> {
    fn run<T: Real>(
        &self,
        mut world: World,
        mut clock: Stopwatch,
        mut phases: Phases,
    ) -> Result<(), CliError> {
        let &Job { args, setting, ref choice, ref stop } = self;
        prepare::<T>(&mut world, workers(args)?);
        tables_schedule::<T>().run(&mut world);
        phases.extract = clock.lap();
        build_schedule::<T>().run(&mut world);
        phases.build = clock.lap();

        let progress = progress_bar(setting);
        world.insert_resource(monitor(&progress, stop));
        levels_schedule::<T>().run(&mut world);
        progress.finish_and_clear();
        phases.trace = clock.lap();

        let traced = world.resource_mut::<Frame>().take_levels();
        let (levels, counts) = traced.map_err(|error| match error {
            FrameError::Cancelled => interrupted(&args.output),
            error => error.into(),
        })?;
        let picture = encode_rgb8(setting.pixels, levels, &args.output)?;
        if stop.load(Ordering::Relaxed) {
            return Err(interrupted(&args.output));
        }
        write_whole(&args.output, &picture)?;
        phases.write = clock.lap();

        if choice.is_some() {
            say(&format!("traced in {:.0} ms", phases.trace));
        }
        if counts.non_finite > 0 {
            say(&format!("warning: {} samples had no finite radiance and are black", counts.non_finite));
        }
        if let Some(path) = &args.stats {
            let threads = world.resource::<Workers>().threads();
            let tables = world.resource::<Tables<T>>();
            let samples = world.resource::<Frame>().refinement().map(Refinement::mean_samples);
            let stats = Stats::new((setting, samples), threads, phases, &counts, tables);
            let stats = stats.with_prediction(choice.as_ref());
            write_whole(path, &stats.to_json()?)?;
        }
        Ok(())
    }
}

/// A bar on a terminal, nothing elsewhere.
fn progress_bar(setting: Setting) -> ProgressBar {
    let samples = u64::from(setting.pixels).pow(2) * u64::from(setting.side).pow(2);
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

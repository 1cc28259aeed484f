//! `archetrace cost`

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use bevy_ecs::prelude::*;
use indicatif::{ProgressBar, ProgressStyle};

use crate::components::{Precision, Snapshot};
use crate::film::Film;
use crate::image_file::encode_rgb8;
use crate::study::{
    CostReport, CostRow, EffectRow, HeatMap, Lab, Machine, PagePicture, PictureEntry, Setting, Sweep,
    SweepPlan, Watch, ablate, adaptive_gains, cost_csv, cost_json, cost_page, draw_front, error_colors,
    error_map, false_colors, front_of_rows, knob_steps, next_6_db, price_of_care, sweep,
};
use crate::systems::{FrameError, Monitor, Workers, prepare};
use crate::whole_file::{WriteError, check_folder, write_whole};

use super::args::{CostArgs, PictureArgs};
use super::instructions::Counter;
use super::load::{aim, lay_texture, load_world};
use super::stop::stop_flag;
use super::{CliError, print, say};

/// Pixels along each side with `--quick`, if the scene has more and nothing else is asked for.
const QUICK_PIXELS: u32 = 256;
/// Pictures of the front that the report shows beside those of the presets.
const SHOWN: usize = 8;

/// Measures what accuracy costs on a scene, and writes the report.
pub(super) fn cost(args: &CostArgs) -> Result<(), CliError> {
    let folder = folder_of(args);
    fs::create_dir_all(&folder).map_err(|error| CliError::Folder(folder.display().to_string(), error))?;
    check_folder(&folder)?;
    let stop = stop_flag()?;
    let mut world = World::new();
    load_world(&args.scene, &mut world)?;
    // Only now: what was loaded is a file, and no endless one.
    let bytes = fs::read(&args.scene).unwrap_or_default();
    lay_texture(&args.images, &args.scene, &mut world)?;
    aim(&args.camera, &mut world)?;
    let own = world.resource::<Snapshot>().pixels;
    let pixels = args.size.unwrap_or(if args.quick { own.min(QUICK_PIXELS) } else { own });
    let scene = Setting { pixels, ..Setting::of(&mut world, Precision::F64) };

    let workers = Workers::new(args.threads)?;
    world.insert_resource(Monitor::new(|_| (), stop.clone()));
    let start = Instant::now();
    let mut clock = || start.elapsed().as_secs_f64() * 1e3;
    let rounds = args.rounds.unwrap_or(if args.quick { 3 } else { 7 });
    let plan = SweepPlan { quick: args.quick, rounds };
    let mut watch = Progress { bar: progress_bar(), stop: stop.clone() };
    let mut lab = Lab::new(&mut world, &workers);
    let found = sweep(&mut lab, scene, plan, &mut clock, &mut watch).map_err(|error| match error {
        FrameError::Cancelled => CliError::Interrupted(folder.display().to_string()),
        error => error.into(),
    })?;
    let mut report = report(args, &found, scene, &workers, &bytes);
    let pictures = pictures(&mut lab, &found, &mut report, &folder)?;
    if !found.interrupted {
        report.care = price_of_care(&mut clock);
        report.effects = effects(&mut world, found.settings[0], &workers, rounds, &mut clock)?;
        count_instructions(args, &found, &mut report, &watch)?;
    }
    watch.bar.finish_and_clear();
    report.interrupted |= stop.load(Ordering::Relaxed);
    write_report(&report, &pictures, &folder)?;
    print(&summary(&report, &folder))
}

fn folder_of(args: &CostArgs) -> PathBuf {
    let name = args.scene.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    args.output.clone().unwrap_or_else(|| PathBuf::from(format!("{name}-cost")))
}

/// A bar on a terminal with the time that is left, and Ctrl-C.
struct Progress {
    bar: ProgressBar,
    stop: Arc<AtomicBool>,
}

impl Watch for Progress {
    fn before(&mut self, what: &str, done: usize, all: usize) {
        self.bar.set_length(all as u64);
        self.bar.set_position(done as u64);
        self.bar.set_message(what.to_owned());
    }

    fn is_cancelled(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}

fn progress_bar() -> ProgressBar {
    let bar = ProgressBar::new(0);
    if let Ok(style) = ProgressStyle::with_template("{pos}/{len} {wide_bar} {eta} left  {msg}") {
        bar.set_style(style);
    }
    bar
}

fn report(args: &CostArgs, found: &Sweep, scene: Setting, workers: &Workers, bytes: &[u8]) -> CostReport {
    let front = front_of_rows(&found.rows);
    CostReport {
        version: env!("CARGO_PKG_VERSION"),
        machine: Machine::here(&fs::read_to_string("/proc/cpuinfo").unwrap_or_default(), workers),
        scene: args.scene.display().to_string(),
        scene_hash: fnv(bytes),
        seed: 0,
        command: std::env::args().collect::<Vec<_>>().join(" "),
        quick: args.quick,
        interrupted: found.interrupted,
        pixels: scene.pixels,
        rounds: found.rounds,
        reference: found.reference.clone(),
        rows: found.rows.clone(),
        next_6_db: next_6_db(&found.rows, &front),
        steps: knob_steps(&found.rows, &found.changes_model),
        adaptive: adaptive_gains(&found.rows),
        front,
        care: Vec::new(),
        effects: Vec::new(),
        pictures: Vec::new(),
    }
}

/// FNV-1a, 64 bits, in hexadecimal.
fn fnv(bytes: &[u8]) -> String {
    let step = |hash: u64, byte: &u8| (hash ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3);
    format!("{:016x}", bytes.iter().fold(0xcbf2_9ce4_8422_2325, step))
}

/// Writes the pictures that a reader wants to see, with their errors and rays, and notes them in the report.
fn pictures(
    lab: &mut Lab<'_>,
    found: &Sweep,
    report: &mut CostReport,
    folder: &Path,
) -> Result<Vec<PagePicture>, CliError> {
    let mut shown = Vec::new();
    let truth = encode_rgb8(found.truth.side(), found.truth.to_rgb8(), Path::new("truth.png"))?;
    write_whole(&folder.join("truth.png"), &truth)?;
    report.pictures.push(PictureEntry {
        setting: "truth".to_owned(),
        picture: "truth.png".to_owned(),
        error: None,
        rays: None,
    });
    shown.push(PagePicture { setting: "truth".to_owned(), picture: truth, error: None, rays: None });
    let is_preset = |number: &usize| found.rows[*number].knob == "preset";
    let presets = (0..found.rows.len()).filter(is_preset);
    let on_front = report.front.iter().copied().filter(|number| !is_preset(number)).take(SHOWN);
    for number in presets.chain(on_front).collect::<Vec<_>>() {
        let (entry, page) = picture(lab, found, number, folder)?;
        report.pictures.push(entry);
        shown.push(page);
    }
    Ok(shown)
}

fn picture(
    lab: &mut Lab<'_>,
    found: &Sweep,
    number: usize,
    folder: &Path,
) -> Result<(PictureEntry, PagePicture), CliError> {
    let (shot, row, setting) = (&found.shots[number], &found.rows[number], found.settings[number]);
    let name = file_name(&row.setting);
    let [picture, error, rays] = ["", "-error", "-rays"].map(|kind| format!("{name}{kind}.png"));
    let encode = |film: &Film, rgb8, file: &str| -> Result<Vec<u8>, CliError> {
        let png = encode_rgb8(film.side(), rgb8, Path::new(file))?;
        write_whole(&folder.join(file), &png)?;
        Ok(png)
    };
    let errors = error_map(&shot.film, &found.truth).unwrap_or_default();
    let counts = lab.rays(setting)?;
    let samples = shot.refinement.as_ref().map(|refinement| refinement.samples());
    let uniform = f64::from(setting.side * setting.side);
    // Every sample of a pixel is taken to need as many rays as the first.
    let of_pixel = |(index, &rays): (usize, &u32)| {
        f64::from(rays) * samples.map_or(uniform, |samples| f64::from(samples[index]))
    };
    let per_pixel: Vec<f64> = counts.iter().enumerate().map(of_pixel).collect();
    let most = per_pixel.iter().copied().fold(0.0, f64::max);
    let traced = Film::new(setting.pixels).ok_or(FrameError::Memory(setting.pixels))?;
    let page = PagePicture {
        setting: row.setting.clone(),
        picture: encode(&shot.film, shot.film.to_rgb8(), &picture)?,
        error: Some(encode(&shot.film, error_colors(&errors), &error)?),
        rays: Some(HeatMap { png: encode(&traced, false_colors(&per_pixel, most), &rays)?, most }),
    };
    let entry = PictureEntry { setting: row.setting.clone(), picture, error: Some(error), rays: Some(rays) };
    Ok((entry, page))
}

/// A setting's name as that of a file.
fn file_name(setting: &str) -> String {
    let words: String = setting.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).collect();
    words.split('-').filter(|word| !word.is_empty()).collect::<Vec<_>>().join("-")
}

fn effects(
    world: &mut World,
    assignment: Setting,
    workers: &Workers,
    rounds: u32,
    clock: &mut dyn FnMut() -> f64,
) -> Result<Vec<EffectRow>, CliError> {
    assignment.apply(world);
    prepare::<f64>(world, workers.clone());
    let ablation = match ablate::<f64>(world, rounds, clock, |_, _| ()) {
        Err(FrameError::Cancelled) => return Ok(Vec::new()),
        ablation => ablation?,
    };
    let rows = ablation.effects.iter().map(|price| EffectRow {
        effect: price.count.effect.name(),
        present: price.is_present(),
        milliseconds: price.without.map(|without| without.milliseconds).unwrap_or_default(),
        rays: price.rays(),
        rows: price.count.rows,
        bytes: price.count.bytes,
        rmse: price.without.map_or(0.0, |without| without.picture.rmse),
    });
    Ok(rows.collect())
}

/// Instructions a pixel of every row, if that is asked for.
fn count_instructions(
    args: &CostArgs,
    found: &Sweep,
    report: &mut CostReport,
    watch: &Progress,
) -> Result<(), CliError> {
    if !args.instructions {
        return Ok(());
    }
    let picture = PictureArgs::of_scene(&args.camera, &args.images);
    let counter = Counter::new(&args.scene, &picture)?;
    let all = report.rows.len();
    watch.bar.set_length(all as u64);
    for (number, (row, &setting)) in report.rows.iter_mut().zip(&found.settings).enumerate() {
        watch.bar.set_position(number as u64);
        watch.bar.set_message(format!("instructions of {}", row.setting));
        if watch.is_cancelled() {
            return Ok(());
        }
        let counted = counter.per_pixel(setting, None)?;
        row.instructions = Some(f64::from(u32::try_from(counted).unwrap_or(u32::MAX)));
    }
    Ok(())
}

fn write_report(report: &CostReport, pictures: &[PagePicture], folder: &Path) -> Result<(), CliError> {
    let write = |name: &str, text: &str| -> Result<(), WriteError> {
        write_whole(&folder.join(name), text.as_bytes())
    };
    write("cost.csv", &cost_csv(report)?)?;
    write("cost.json", &cost_json(report)?)?;
    write("cost.svg", &draw_front(report))?;
    write("cost.md", &markdown(report))?;
    Ok(write("cost.html", &cost_page(report, pictures))?)
}

/// The presets and the front as a table for a README.
fn markdown(report: &CostReport) -> String {
    let mut text =
        "| setting | ms | quartiles apart | rays a pixel | instructions a pixel | dB | worst level | \
                    off by more than 1 level |\n|---|---|---|---|---|---|---|---|\n"
            .to_owned();
    let is_shown = |(number, row): &(usize, &CostRow)| row.knob == "preset" || report.front.contains(number);
    for (_, row) in report.rows.iter().enumerate().filter(is_shown) {
        let instructions = row.instructions.map(|count| format!("{count:.0}")).unwrap_or_default();
        let at_least = if row.at_floor { "at least " } else { "" };
        text.push_str(&format!(
            "| {} | {:.1} | {:.1} | {:.2} | {instructions} | {at_least}{:.1} | {} | {:.1} % |\n",
            row.setting,
            row.milliseconds.median,
            row.milliseconds.iqr,
            rays_a_pixel(report, row),
            row.psnr_db,
            row.worst_level,
            100.0 * row.over1
        ));
    }
    text
}

/// Far fewer than 2^53.
#[expect(clippy::cast_precision_loss, reason = "two digits are shown")]
fn rays_a_pixel(report: &CostReport, row: &CostRow) -> f64 {
    row.rays as f64 / f64::from(report.pixels).powi(2)
}

/// The front in a few lines.
fn summary(report: &CostReport, folder: &Path) -> String {
    let mut text = format!(
        "{} settings, {} rounds, {} x {} pixels; errors below {:.1} dB are not told apart\n\n{:>10} {:>8} {:>12}  setting\n",
        report.rows.len(),
        report.rounds,
        report.pixels,
        report.pixels,
        report.reference.floor_psnr_db,
        "ms",
        "dB",
        "rays a pixel"
    );
    let mut line = |row: &CostRow| {
        let rays = rays_a_pixel(report, row);
        let (ms, db) = (row.milliseconds.median, row.psnr_db);
        text.push_str(&format!("{ms:>10.2} {db:>8.1} {rays:>12.2}  {}\n", row.setting));
    };
    report.rows.first().map(&mut line);
    report.front.iter().filter(|&&number| number > 0).for_each(|&number| line(&report.rows[number]));
    let gains = report.adaptive.iter().filter_map(|adaptive| Some((adaptive.gain?, &adaptive.setting)));
    if let Some((gain, setting)) = gains.max_by(|a, b| a.0.total_cmp(&b.0)) {
        let verdict = if gain > 1.0 { "" } else { ": it does not pay here" };
        text.push_str(&format!(
            "\nuniform samples take {gain:.2} times the rays of {setting} for the same error{verdict}\n"
        ));
    }
    if report.interrupted {
        say("warning: interrupted; what was not measured is missing");
    }
    text.push_str(&format!("\nwritten: {}\n", folder.join("cost.html").display()));
    text
}

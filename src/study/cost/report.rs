//! What a study of cost finds out: plain numbers, ready to be written as CSV, JSON and a page.

use std::env::consts::{ARCH, OS};

use serde::Serialize;

use crate::study::{Knobs, Spread};
use crate::systems::Workers;
use crate::trace::Simd;

/// Everything that `archetrace cost` finds out about a scene.
#[derive(Clone, Debug, Serialize)]
pub struct CostReport {
    /// Version of the program.
    pub version: &'static str,
    /// Where it was measured.
    pub machine: Machine,
    /// The scene's file, or its name if it is code.
    pub scene: String,
    /// FNV-1a of the scene's bytes, 64 bits in hexadecimal.
    pub scene_hash: String,
    /// Seed of every sequence of samples. The samples of a pixel follow from its place and their number alone, so it is 0.
    pub seed: u64,
    /// The command line that makes this report again.
    pub command: String,
    /// Whether it is the quick version: smaller pictures, fewer settings, fewer rounds.
    pub quick: bool,
    /// Whether it was interrupted: then rows are missing.
    pub interrupted: bool,
    /// Pixels along each side of every picture compared.
    pub pixels: u32,
    /// Rounds in which the settings were traced in turns.
    pub rounds: u32,
    /// What the pictures are compared with.
    pub reference: Reference,
    /// One for each setting, `assignment` first.
    pub rows: Vec<CostRow>,
    /// Numbers of the rows that no other row beats in both time and error, the fastest first.
    pub front: Vec<usize>,
    /// What the next 6 dB cost, along the front.
    pub next_6_db: Vec<NextSixDb>,
    /// Each knob one step up and down from `assignment`.
    pub steps: Vec<KnobStep>,
    /// What adaptive sampling saves, one for each of its rows.
    pub adaptive: Vec<AdaptiveGain>,
    /// What numerical care costs and buys.
    pub care: Vec<CareRow>,
    /// What the effects of the scene cost.
    pub effects: Vec<EffectRow>,
    /// Pictures beside the report, in the order of a reader's interest.
    pub pictures: Vec<PictureEntry>,
}

/// Where something was measured.
#[derive(Clone, Debug, Serialize)]
pub struct Machine {
    /// The processor's name.
    pub processor: String,
    /// Threads that traced.
    pub threads: usize,
    /// Operating system and architecture.
    pub system: String,
    /// The widest vector instructions in use.
    pub simd: String,
}

/// The picture that stands for the truth, and how far it can be trusted.
#[derive(Clone, Debug, Serialize)]
pub struct Reference {
    /// Sample points along each side of a pixel of the two pictures that it is the mean of; co-prime.
    pub sides: [u32; 2],
    /// Its level of recursion.
    pub level: u32,
    /// Its contribution cutoff.
    pub cutoff: f64,
    /// Root mean squared difference of the two: no error below it is claimed.
    pub floor_rmse: f64,
    /// The same in decibels.
    pub floor_psnr_db: f64,
    /// The largest difference of the two in levels of 8 bits.
    pub floor_worst_level: u8,
    /// Milliseconds that it took.
    pub milliseconds: f64,
}

/// One setting, what it costs, and how far its picture is from the reference.
#[derive(Clone, Debug, Serialize)]
pub struct CostRow {
    /// Unique name: `assignment`, `draft`, ... or what is different from `assignment`, as `samples 9, f32`.
    pub setting: String,
    /// The knob of which this row is a step (`samples`, `adaptive`, `level`, `cutoff`, `precision`, `checker_filter`,
    /// `texture_filter`, `light_samples`, `resolution`), `preset` or `grid`.
    pub knob: &'static str,
    /// The flags of `render` that give this setting.
    pub flags: String,
    /// Every knob.
    #[serde(flatten)]
    pub knobs: Knobs,
    /// Samples of a pixel, on average.
    pub samples: f64,
    /// Milliseconds of the trace.
    pub milliseconds: Spread,
    /// Rays of every kind together, and by kind.
    pub rays: u64,
    /// From the camera.
    pub primary: u64,
    /// Towards lights.
    pub shadow: u64,
    /// Off mirrors and glass.
    pub mirror: u64,
    /// Into glass and out of it.
    pub refracted: u64,
    /// Instructions a pixel, where they were counted.
    pub instructions: Option<f64>,
    /// Root mean squared difference from the reference, 0 to 1; not below the floor.
    pub rmse: f64,
    /// The same in decibels; not above the floor.
    pub psnr_db: f64,
    /// Whether the difference is as small as the reference's own: nothing more is claimed.
    pub at_floor: bool,
    /// The largest difference of a channel in levels of 8 bits.
    pub worst_level: u8,
    /// Share of the pixels that differ by more than 1 level.
    pub over1: f64,
    /// Share of the pixels that differ by more than 8 levels.
    pub over8: f64,
    /// Mean structural similarity, 1 for equal pictures.
    pub ssim: f64,
    /// Root mean squared difference from the same setting with this row's knob at its truest, everything else equal: the
    /// error of this knob alone. Nothing for presets and the grid.
    pub alone_rmse: Option<f64>,
}

/// Adaptive samples against as many everywhere.
#[derive(Clone, Debug, Serialize)]
pub struct AdaptiveGain {
    /// The adaptive setting.
    pub setting: String,
    /// Rays that uniform sampling needs for the same error, interpolated between its rows, by those of this one: above 1
    /// where it pays. Nothing where no uniform row is as good.
    pub gain: Option<f64>,
}

/// One step along the front.
#[derive(Clone, Debug, Serialize)]
pub struct NextSixDb {
    /// Decibels to start from.
    pub from_db: f64,
    /// The setting that is needed there.
    pub from: String,
    /// At least 6 dB more.
    pub to_db: f64,
    /// The setting that is needed there.
    pub to: String,
    /// Milliseconds that it costs more.
    pub milliseconds: f64,
    /// Rays that it costs more.
    pub rays: i64,
}

/// One knob one step away from `assignment`.
#[derive(Clone, Debug, Serialize)]
pub struct KnobStep {
    /// The knob.
    pub knob: &'static str,
    /// `truer` or `faster`.
    pub direction: &'static str,
    /// What it is then, as `samples 4`.
    pub to: String,
    /// Milliseconds more.
    pub milliseconds: f64,
    /// Rays more.
    pub rays: i64,
    /// Decibels more.
    pub decibels: f64,
    /// Whether the knob changes what is computed (a filter, say) and not only how closely.
    pub changes_model: bool,
}

/// A way to compute the same rays, what it costs and how far off it is.
#[derive(Clone, Debug, Serialize)]
pub struct CareRow {
    /// As `f64, textbook`.
    pub way: &'static str,
    /// Nanoseconds a ray.
    pub nanoseconds: f64,
    /// Instructions a ray, where they were counted.
    pub instructions: Option<f64>,
    /// The largest relative error of the distance to a far, small sphere.
    pub worst_far: f64,
    /// The largest relative error of the distance to a huge sphere underfoot.
    pub worst_near: f64,
    /// Share of rays leaving a surface that meet the surface they leave.
    pub self_hits: f64,
}

/// What one effect of the scene costs.
#[derive(Clone, Debug, Serialize)]
pub struct EffectRow {
    /// Its name.
    pub effect: &'static str,
    /// Whether the scene asks for it. All else is 0 if not.
    pub present: bool,
    /// Milliseconds that it adds.
    pub milliseconds: Spread,
    /// Rays that it adds.
    pub rays: i64,
    /// Rows in the tables.
    pub rows: usize,
    /// Bytes in the tables.
    pub bytes: usize,
    /// Root mean squared difference that it makes to the picture.
    pub rmse: f64,
}

/// A picture, its error and its rays.
#[derive(Clone, Debug, Serialize)]
pub struct PictureEntry {
    /// Name of the setting, or `reference`.
    pub setting: String,
    /// The picture's file beside the report.
    pub picture: String,
    /// The file with the error of each pixel in false colours; nothing for the reference.
    pub error: Option<String>,
    /// The file with the rays of each pixel in false colours.
    pub rays: Option<String>,
}

impl Machine {
    /// This machine, tracing with these threads. `cpuinfo` is Linux' `/proc/cpuinfo`, and empty elsewhere.
    pub fn here(cpuinfo: &str, workers: &Workers) -> Self {
        let model = cpuinfo.lines().find_map(|line| {
            let (key, name) = line.split_once(':')?;
            (key.trim() == "model name").then(|| name.trim().to_owned())
        });
        Self {
            processor: model.unwrap_or_else(|| ARCH.to_owned()),
            threads: workers.threads(),
            system: format!("{OS} {ARCH}"),
            simd: Simd::detect().name().to_owned(),
        }
    }
}

//! What trades truth for time, on the command line.

use clap::builder::TypedValueParser;
use clap::{Args as ClapArgs, ValueEnum};

use crate::components::range::{COEFFICIENT, MAX_GRID, MAX_LEVEL, MAX_LIGHT_SAMPLES};
use crate::components::{Sampling, TextureFilter};
use crate::study::{Chooser, Preset, Setting, Wish};

use super::args::Precision;

/// What trades truth for time.
#[derive(Debug, Default, ClapArgs)]
#[command(next_help_heading = "Accuracy")]
pub(super) struct AccuracyArgs {
    /// Where to start from; the other flags go on from there [default: assignment]
    #[arg(long, value_name = "NAME", value_parser = preset())]
    pub(super) preset: Option<Preset>,
    /// Samples of each pixel, on a regular grid: 1, 4, 9, 16, ... The pixel is their mean [default: 1]
    #[arg(long, value_name = "N", value_parser = samples)]
    pub(super) samples: Option<Sampling>,
    /// Take the samples one after the other, in each pixel until its error is expected to be no more than this, 0 to 1
    #[arg(long, value_name = "ERROR", value_parser = share, allow_negative_numbers = true)]
    pub(super) adaptive: Option<f64>,
    /// Level of recursion: 0 is black, 1 has no mirror image [default: the scene's]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(0..=i64::from(MAX_LEVEL)))]
    pub(super) level: Option<u32>,
    /// Follow no ray that carries no more than this share of the light in a pixel, 0 to 1 [default: 0]
    #[arg(long, value_name = "SHARE", value_parser = share, allow_negative_numbers = true)]
    pub(super) cutoff: Option<f64>,
    /// Floating-point precision of the trace [default: f64]
    #[arg(long, value_enum)]
    pub(super) precision: Option<Precision>,
    /// Plain checkerboards show the mean of what a pixel covers; another model than the assignment's
    #[arg(long)]
    pub(super) checker_filter: bool,
    /// How images are read [default: nearest]
    #[arg(long, value_name = "FILTER", value_enum)]
    pub(super) texture_filter: Option<ImageFilter>,
    /// Shadow rays towards each area light [default: the light's own number]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=i64::from(MAX_LIGHT_SAMPLES)))]
    pub(super) light_samples: Option<u32>,
}

impl AccuracyArgs {
    /// The knobs that nobody has set.
    pub(super) fn free(&self) -> Chooser {
        Chooser { precision: self.precision.is_none(), depth: self.level.is_none() && self.cutoff.is_none() }
    }

    /// The setting that is asked for, of a scene with this one.
    pub(super) fn setting(&self, scene: Setting) -> Setting {
        let start = self.preset.unwrap_or(Preset::Assignment).of(scene);
        Setting {
            side: self.samples.map_or(start.side, |sampling| sampling.side),
            // A number of samples alone asks for just as many.
            threshold: self.adaptive.or(start.threshold.filter(|_| self.samples.is_none())),
            level: self.level.unwrap_or(start.level),
            cutoff: self.cutoff.unwrap_or(start.cutoff),
            precision: self.precision.map_or(start.precision, Into::into),
            checker_filter: self.checker_filter || start.checker_filter,
            texture_filter: self.texture_filter.map(Into::into).or(start.texture_filter),
            light_samples: self.light_samples.or(start.light_samples),
            ..start
        }
    }
}

/// What the accuracy is chosen for.
#[derive(Debug, ClapArgs)]
#[command(next_help_heading = "Accuracy chosen from a wish")]
#[group(multiple = false, conflicts_with_all = ["preset", "samples", "adaptive"])]
pub(super) struct WishArgs {
    /// The truest picture that is traced in this time, as 200ms or 1.5s
    #[arg(long, value_name = "TIME", value_parser = time)]
    budget: Option<f64>,
    /// The fastest picture with this peak signal to noise, as 40dB
    #[arg(long, value_name = "DECIBELS", value_parser = decibels)]
    target: Option<f64>,
    /// The fastest picture whose channels are off by no more levels of 8 bits, as the root of the mean square
    #[arg(long, value_name = "LEVELS", value_parser = levels)]
    target_level: Option<f64>,
}

impl WishArgs {
    /// What is wished for, if anything.
    pub(super) fn wish(&self) -> Option<Wish> {
        let budget = self.budget.map(Wish::Budget);
        budget.or(self.target.map(Wish::Decibels)).or(self.target_level.map(Wish::Levels))
    }
}

/// How images on the checkerboard are read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum ImageFilter {
    /// The texel at the point itself
    Nearest,
    /// The nearest four texels, in proportion
    Bilinear,
    /// The mean of what the pixel covers
    Mip,
}

impl From<ImageFilter> for TextureFilter {
    fn from(filter: ImageFilter) -> Self {
        match filter {
            ImageFilter::Nearest => Self::Nearest,
            ImageFilter::Bilinear => Self::Bilinear,
            ImageFilter::Mip => Self::Mip,
        }
    }
}

fn samples(text: &str) -> Result<Sampling, String> {
    let count: Option<u32> = text.parse().ok();
    let side = count.map(u32::isqrt).filter(|&side| (1..=MAX_GRID).contains(&side));
    let side = side.filter(|side| Some(side * side) == count);
    side.map(|side| Sampling { side })
        .ok_or_else(|| format!("must be a square number from 1 to {}: 1, 4, 9, 16, ...", MAX_GRID * MAX_GRID))
}

fn share(text: &str) -> Result<f64, String> {
    let share = text.parse().ok().filter(|share| COEFFICIENT.contains(*share));
    share.ok_or_else(|| format!("must be {}", COEFFICIENT.words))
}

fn time(text: &str) -> Result<f64, String> {
    let factors = [("ms", 1.0), ("s", 1e3)];
    let found = factors.into_iter().find_map(|(unit, factor)| {
        let number: f64 = text.strip_suffix(unit)?.trim().parse().ok()?;
        Some(number * factor)
    });
    let within = |milliseconds: &f64| *milliseconds > 0.0 && *milliseconds <= 1e9;
    found.filter(within).ok_or_else(|| "must be a time above 0, as 200ms or 1.5s".to_owned())
}

fn decibels(text: &str) -> Result<f64, String> {
    let number = text.strip_suffix("dB").or_else(|| text.strip_suffix("db")).unwrap_or(text).trim();
    let found = number.parse().ok().filter(|decibels| (0.0..=200.0).contains(decibels));
    found.ok_or_else(|| "must be a number of decibels from 0 to 200, as 40dB".to_owned())
}

fn levels(text: &str) -> Result<f64, String> {
    let found = text.parse().ok().filter(|levels| (1e-6..=255.0).contains(levels));
    found.ok_or_else(|| "must be a number of levels from 0.000001 to 255".to_owned())
}

fn preset() -> impl TypedValueParser<Value = Preset> {
    clap::builder::PossibleValuesParser::new(Preset::ALL.map(Preset::name)).try_map(|name| {
        Preset::ALL.into_iter().find(|preset| preset.name() == name).ok_or("must be the name of a preset")
    })
}

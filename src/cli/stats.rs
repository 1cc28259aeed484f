//! The `--stats` file.

use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use serde::Serialize;

use crate::geometry::Real;
use crate::study::{Choice, Knobs, Setting};
use crate::systems::Tables;
use crate::trace::Counts;

/// What a render measured and counted.
#[derive(Debug, Serialize)]
pub(super) struct Stats {
    version: &'static str,
    precision: &'static str,
    threads: usize,
    pixels: u64,
    samples: u64,
    /// Of a pixel, on average: fewer than `samples` where that was decided pixel by pixel.
    mean_samples: f64,
    level: u32,
    setting: Knobs,
    /// Of the trace, where the setting was chosen from a wish; beside it what `phases_ms.trace` is in fact.
    #[serde(skip_serializing_if = "Option::is_none")]
    predicted_ms: Option<f64>,
    /// Of the picture, where the setting was chosen from a wish.
    #[serde(skip_serializing_if = "Option::is_none")]
    predicted_psnr_db: Option<f64>,
    /// Whether the wish is expected to be met.
    #[serde(skip_serializing_if = "Option::is_none")]
    wish_met: Option<bool>,
    phases_ms: Phases,
    rays: Rays,
    rows: BTreeMap<&'static str, usize>,
    effects: Vec<&'static str>,
    non_finite: u64,
}

/// Milliseconds of each phase, on the wall clock.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub(super) struct Phases {
    /// Reading, parsing, spawning, textures.
    pub(super) load: f64,
    /// Choosing a setting from a wish.
    pub(super) choose: f64,
    /// World to tables.
    pub(super) extract: f64,
    /// Building what makes large tables fast to search.
    pub(super) build: f64,
    /// Tables to film.
    pub(super) trace: f64,
    /// Film to file.
    pub(super) write: f64,
}

#[derive(Clone, Copy, Debug, Serialize)]
struct Rays {
    primary: u64,
    shadow: u64,
    mirror: u64,
    refracted: u64,
}

impl Stats {
    /// The statistics of one picture.
    pub(super) fn new<T: Real>(
        (setting, mean_samples): (Setting, Option<f64>),
        threads: usize,
        phases: Phases,
        counts: &Counts,
        tables: &Tables<T>,
    ) -> Self {
        let effects = tables.effect_counts();
        let tables = tables.scene.table_counts().map(|count| (count.table, count.rows));
        Self {
            version: env!("CARGO_PKG_VERSION"),
            precision: T::NAME,
            threads,
            pixels: u64::from(setting.pixels).pow(2),
            samples: u64::from(setting.side).pow(2),
            mean_samples: mean_samples.unwrap_or(f64::from(setting.side * setting.side)),
            level: setting.level,
            setting: setting.knobs(),
            predicted_ms: None,
            predicted_psnr_db: None,
            wish_met: None,
            phases_ms: phases,
            rays: Rays {
                primary: counts.rays.primary,
                shadow: counts.rays.shadow,
                mirror: counts.rays.mirror,
                refracted: counts.rays.refracted,
            },
            rows: tables
                .into_iter()
                .chain(effects.iter().map(|count| (count.effect.name(), count.rows)))
                .collect(),
            effects: effects.iter().filter(|count| count.rows > 0).map(|count| count.effect.name()).collect(),
            non_finite: counts.non_finite,
        }
    }

    /// With what was predicted of it.
    pub(super) fn with_prediction(self, choice: Option<&Choice>) -> Self {
        Self {
            predicted_ms: choice.map(|choice| choice.point.milliseconds),
            predicted_psnr_db: choice.map(|choice| choice.point.psnr_db()),
            wish_met: choice.map(|choice| choice.meets),
            ..self
        }
    }

    /// The file's bytes.
    pub(super) fn to_json(&self) -> Result<Vec<u8>, serde_json::Error> {
        let mut bytes = serde_json::to_vec_pretty(self)?;
        bytes.push(b'\n');
        Ok(bytes)
    }
}

/// Measures phases that follow each other.
pub(super) struct Stopwatch(Instant);

impl Stopwatch {
    /// Starts the first phase.
    pub(super) fn start() -> Self {
        Self(Instant::now())
    }

    /// Milliseconds of the phase that ends here; the next one starts.
    pub(super) fn lap(&mut self) -> f64 {
        let now = Instant::now();
        let lap: Duration = now - core::mem::replace(&mut self.0, now);
        lap.as_secs_f64() * 1e3
    }
}

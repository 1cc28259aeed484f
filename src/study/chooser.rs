//! The cheapest setting that meets a wish, from a look at a few parts of the picture.
//!
//! Whole pictures with one sample a pixel tell what depth and precision cost, and where errors are to be expected. Cells drawn
//! by that are traced with every candidate and compared with the same cells at many samples. What comes out is a prediction:
//! a picture can hold a surprise between the cells.

use crate::components::Precision;
use crate::film::Film;
use crate::systems::FrameError;

use super::cells::{Cells, price_of_ray};
use super::{Difference, Glimpse, Lab, Setting, Shot, Spread};

/// What somebody wants of a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Wish {
    /// Milliseconds that the trace may take.
    Budget(f64),
    /// Decibels of peak signal to noise, against a converged picture.
    Decibels(f64),
    /// Levels of 8 bits by which a channel may be off, as the root of the mean square.
    Levels(f64),
}

/// A setting with its predicted price.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrontPoint {
    /// The setting.
    pub setting: Setting,
    /// Milliseconds of the trace, predicted.
    pub milliseconds: f64,
    /// Root mean squared error, 0 to 1, predicted; 0 where no difference was seen.
    pub rmse: f64,
    /// What it hardly exceeds: two standard errors of the mean square more.
    pub rmse_bound: f64,
}

impl FrontPoint {
    /// Peak signal to noise in decibels, infinite where no difference was seen.
    pub fn psnr_db(&self) -> f64 {
        decibels(self.rmse)
    }

    /// Whether it is expected to meet a wish.
    fn meets(&self, wish: Wish) -> bool {
        let is_close_to = |wanted: f64| decibels(self.rmse_bound) >= wanted + CAUTION_DB;
        match wish {
            Wish::Budget(milliseconds) => self.milliseconds <= CAUTION * milliseconds,
            Wish::Decibels(wanted) => is_close_to(wanted),
            Wish::Levels(levels) => is_close_to(decibels(levels / 255.0)),
        }
    }
}

/// What was chosen.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// The cheapest candidate that is expected to meet the wish, or the closest to it.
    pub point: FrontPoint,
    /// Whether it is expected to meet it.
    pub meets: bool,
    /// All candidates that were tried and that no other beats in both, the fastest first.
    pub front: Vec<FrontPoint>,
}

/// Which knobs are free.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Chooser {
    /// Whether the precision may be single.
    pub precision: bool,
    /// Whether level and cutoff may differ from the start.
    pub depth: bool,
}

/// Pixels along each side of the whole pictures that are traced, at most: for more of them times are scaled.
const LOOK: u32 = 1024;
/// Sample points along each side of a pixel of what cells are compared with: prime to those of the candidates.
const TRUTH: u32 = 13;
/// How deep mirrors are followed there.
const TRUTH_LEVEL: u32 = 64;
/// How often a time is taken, where it is short.
const ROUNDS: u32 = 3;
/// Share of a budget that is planned with, and decibels beyond a target: predictions are off by about as much.
const CAUTION: f64 = 0.92;
const CAUTION_DB: f64 = 0.3;
/// Mean square of what single precision may change: a pixel or two that fall on the other side of an edge.
const VISIBLE: f64 = 1e-5;

/// Sampling of the candidates: points along each side of a pixel, and the threshold of adaptive ones.
const SAMPLINGS: [(u32, Option<f64>); 17] = [
    (1, None),
    (2, None),
    (3, Some(1.0 / 16.0)),
    (3, Some(1.0 / 64.0)),
    (3, None),
    (5, Some(1.0 / 32.0)),
    (5, Some(1.0 / 128.0)),
    (4, None),
    (5, None),
    (7, Some(1.0 / 128.0)),
    (9, Some(1.0 / 128.0)),
    (9, Some(1.0 / 256.0)),
    (15, Some(1.0 / 256.0)),
    (15, Some(1.0 / 512.0)),
    (8, None),
    (12, None),
    (16, None),
];

/// Chooses for a World with a setting to start from. `clock` tells milliseconds.
pub fn choose(
    lab: &mut Lab<'_>,
    start: Setting,
    free: Chooser,
    wish: Wish,
    clock: &mut dyn FnMut() -> f64,
) -> Result<Choice, FrameError> {
    let points = free.points(lab, start, Some(wish), clock)?;
    Ok(pick(points, wish).unwrap_or_else(|| {
        let point = FrontPoint { setting: start, milliseconds: 0.0, rmse: 1.0, rmse_bound: 1.0 };
        Choice { point, meets: false, front: Vec::new() }
    }))
}

impl Chooser {
    /// The candidates that no other beats in both time and error, the fastest first.
    pub fn front(
        self,
        lab: &mut Lab<'_>,
        start: Setting,
        clock: &mut dyn FnMut() -> f64,
    ) -> Result<Vec<FrontPoint>, FrameError> {
        Ok(front_of(self.points(lab, start, None, clock)?))
    }

    /// The candidates, without those that cannot be what is wished.
    fn points(
        self,
        lab: &mut Lab<'_>,
        start: Setting,
        wish: Option<Wish>,
        clock: &mut dyn FnMut() -> f64,
    ) -> Result<Vec<FrontPoint>, FrameError> {
        let plain = Setting { side: 1, threshold: None, pixels: start.pixels.min(LOOK), ..start };
        let precision = if self.precision { cheapest_precision(lab, plain, clock)? } else { start.precision };
        let plain = Setting { precision, ..plain };
        // 1. Whole pictures: what depths cost. Their errors do not mix with those of sampling.
        let deep = Setting { level: start.level.max(TRUTH_LEVEL), cutoff: 1.0 / 65536.0, ..plain };
        let reference = lab.shoot(deep, clock)?;
        let mut depths = Vec::new();
        for setting in self.depths(plain) {
            depths.push(Depth::of(lab, setting, &reference.film, clock)?);
        }
        // 2. Cells where errors are to be expected, what it takes to know that, and the truth there.
        let met = lab.shoot(Setting { threshold: Some(f64::INFINITY), ..deep }, clock)?;
        let errors = met.refinement.map(|refinement| refinement.expected_errors(&met.film));
        let cells = Cells::draw(start.pixels, plain.pixels, &errors.unwrap_or_default());
        let deep = Setting { pixels: start.pixels, ..deep };
        let truth = lab.glimpse(Setting { side: TRUTH, ..deep }, cells.windows(), clock)?;
        let one = lab.glimpse(deep, cells.windows(), clock)?;
        // 3. Samplings there, at the depth of the truth.
        let scale = (f64::from(start.pixels) / f64::from(plain.pixels.max(1))).powi(2);
        let care = (met.milliseconds - reference.milliseconds).max(0.0) * scale;
        let mut points: Vec<FrontPoint> = Vec::new();
        for (side, threshold) in SAMPLINGS {
            let least = depths.iter().map(|depth| depth.milliseconds).fold(f64::INFINITY, f64::min) * scale;
            if threshold.is_none() && is_too_slow(least * f64::from(side * side), wish, &points) {
                continue;
            }
            let glimpse = glance(lab, Setting { side, threshold, ..deep }, &cells, clock)?;
            // Rays of a few samples here and there cost more than those of a whole picture.
            let (scatter, care) = match threshold {
                Some(_) => (price_of_ray(&glimpse) / price_of_ray(&truth).max(f64::MIN_POSITIVE), care),
                None => (1.0, 0.0),
            };
            let times = cells.times_the_rays(&glimpse, &one) * scatter.max(1.0) * scale;
            let error = cells.mean_square(&glimpse, &truth);
            points.extend(depths.iter().map(|depth| FrontPoint {
                setting: Setting { side, threshold, pixels: start.pixels, ..depth.setting },
                milliseconds: depth.milliseconds * times + care,
                rmse: (error.mean + depth.error).sqrt(),
                rmse_bound: (error.mean + 2.0 * error.deviation + depth.error).sqrt(),
            }));
        }
        Ok(points)
    }

    fn depths(self, plain: Setting) -> Vec<Setting> {
        if !self.depth {
            return vec![plain];
        }
        let levels = [(1, 0.0), (2, 0.0), (plain.level, 0.0), (8, 1.0 / 256.0), (TRUTH_LEVEL, 1.0 / 4096.0)];
        let mut depths: Vec<Setting> = Vec::new();
        for (level, cutoff) in levels {
            let depth = Setting { level, cutoff, ..plain };
            if !depths.contains(&depth) {
                depths.push(depth);
            }
        }
        depths
    }
}

/// How far paths are followed, and what that costs at one sample a pixel.
struct Depth {
    setting: Setting,
    milliseconds: f64,
    /// Mean square of what is lost.
    error: f64,
}

impl Depth {
    fn of(
        lab: &mut Lab<'_>,
        setting: Setting,
        reference: &Film,
        clock: &mut dyn FnMut() -> f64,
    ) -> Result<Self, FrameError> {
        let Shot { film, milliseconds, .. } = lab.shoot(setting, clock)?;
        let mut times = vec![milliseconds];
        for _ in 1..ROUNDS {
            times.push(lab.shoot(setting, clock)?.milliseconds);
        }
        Ok(Self { setting, milliseconds: Spread::of(&times).median, error: mean_square(&film, reference) })
    }
}

/// Single precision, unless it shows.
fn cheapest_precision(
    lab: &mut Lab<'_>,
    plain: Setting,
    clock: &mut dyn FnMut() -> f64,
) -> Result<Precision, FrameError> {
    let double = lab.shoot(Setting { precision: Precision::F64, ..plain }, clock)?;
    // A World beyond the range of single precision has no such picture.
    let single = lab.shoot(Setting { precision: Precision::F32, ..plain }, clock);
    let is_equal = single.is_ok_and(|single| mean_square(&single.film, &double.film) < VISIBLE);
    Ok(if is_equal { Precision::F32 } else { Precision::F64 })
}

/// Whether something that takes at least so many milliseconds will not be chosen.
fn is_too_slow(least: f64, wish: Option<Wish>, points: &[FrontPoint]) -> bool {
    match wish {
        None => false,
        Some(Wish::Budget(milliseconds)) => !points.is_empty() && least > milliseconds,
        Some(wish) => points.iter().any(|point| point.meets(wish) && point.milliseconds < least),
    }
}

/// The cells with a setting, and the least time of some.
fn glance(
    lab: &mut Lab<'_>,
    setting: Setting,
    cells: &Cells,
    clock: &mut dyn FnMut() -> f64,
) -> Result<Glimpse, FrameError> {
    let mut first = lab.glimpse(setting, cells.windows(), clock)?;
    // What takes long is measured well enough at once, and uniform samples take as many times as long as they are.
    let rounds = if setting.side > 5 || setting.threshold.is_none() { 1 } else { ROUNDS };
    for _ in 1..rounds {
        first.milliseconds =
            first.milliseconds.min(lab.glimpse(setting, cells.windows(), clock)?.milliseconds);
    }
    Ok(first)
}

fn mean_square(a: &Film, b: &Film) -> f64 {
    Difference::between(a, b).map_or(1.0, |difference| difference.rmse.powi(2))
}

/// Those that no other beats in both, the fastest first.
fn front_of(mut points: Vec<FrontPoint>) -> Vec<FrontPoint> {
    points.sort_by(|a, b| a.milliseconds.total_cmp(&b.milliseconds).then(a.rmse.total_cmp(&b.rmse)));
    let mut least = f64::INFINITY;
    points.retain(|point| {
        let is_better = point.rmse < least;
        least = least.min(point.rmse);
        is_better
    });
    points
}

/// What meets a wish; nothing of nothing.
fn pick(points: Vec<FrontPoint>, wish: Wish) -> Option<Choice> {
    let by_time = |a: &&FrontPoint, b: &&FrontPoint| a.milliseconds.total_cmp(&b.milliseconds);
    let by_error =
        |a: &&FrontPoint, b: &&FrontPoint| a.rmse_bound.total_cmp(&b.rmse_bound).then(by_time(a, b));
    let fitting = || points.iter().filter(|point| point.meets(wish));
    let found = match wish {
        // The best of what fits; else what takes least.
        Wish::Budget(_) => fitting().min_by(by_error).or(points.iter().min_by(by_time)),
        // The cheapest that is good enough; else the best there is.
        Wish::Decibels(_) | Wish::Levels(_) => fitting().min_by(by_time).or(points.iter().min_by(by_error)),
    };
    let point = *found?;
    Some(Choice { point, meets: point.meets(wish), front: front_of(points) })
}

/// Peak signal to noise of a root mean squared error, 0 to 1.
fn decibels(rmse: f64) -> f64 {
    -20.0 * rmse.log10()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(milliseconds: f64, rmse: f64) -> FrontPoint {
        let setting = Setting {
            side: 1,
            threshold: None,
            level: 3,
            cutoff: 0.0,
            precision: Precision::F64,
            checker_filter: false,
            texture_filter: None,
            light_samples: None,
            pixels: 8,
        };
        FrontPoint { setting, milliseconds, rmse, rmse_bound: rmse }
    }

    #[test]
    fn a_front_keeps_what_nothing_beats() {
        let points =
            vec![point(3.0, 0.1), point(1.0, 0.5), point(2.0, 0.6), point(4.0, 0.1), point(9.0, 0.0)];
        let front: Vec<_> = front_of(points).iter().map(|p| (p.milliseconds, p.rmse)).collect();
        assert_eq!(front, [(1.0, 0.5), (3.0, 0.1), (9.0, 0.0)]);
    }

    #[test]
    fn the_cheapest_that_meets_a_wish_is_picked_and_the_impossible_said() {
        let front = vec![point(1.0, 0.1), point(10.0, 0.01), point(100.0, 0.001)];
        let picked = |wish| pick(front.clone(), wish).map(|c| (c.point.milliseconds, c.meets));
        assert_eq!(picked(Wish::Budget(50.0)), Some((10.0, true)));
        assert_eq!(picked(Wish::Budget(0.5)), Some((1.0, false)));
        assert_eq!(picked(Wish::Decibels(35.0)), Some((10.0, true)));
        // 0.01 is 40 dB: too close to be sure of.
        assert_eq!(picked(Wish::Decibels(39.8)), Some((100.0, true)));
        assert_eq!(picked(Wish::Decibels(70.0)), Some((100.0, false)));
        assert_eq!(picked(Wish::Levels(3.0)), Some((10.0, true)));
        assert_eq!(pick(Vec::new(), Wish::Budget(1.0)), None);
    }
}

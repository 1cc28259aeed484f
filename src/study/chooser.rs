//! The cheapest setting that meets a wish, from a look at a few parts of the picture.
//!
//! Windows of the picture, spread over it, are traced with every candidate and compared with the same windows at many samples
//! and great depth. Times are scaled by those of one whole picture. Both are predictions: a picture can hold a surprise
//! between the windows.

use crate::components::Precision;
use crate::film::Film;
use crate::systems::FrameError;

use super::{Glimpse, Lab, Setting, Windows};

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
}

impl FrontPoint {
    /// Peak signal to noise in decibels, infinite where no difference was seen.
    pub fn psnr_db(&self) -> f64 {
        -20.0 * self.rmse.log10()
    }
}

/// What was chosen.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// The cheapest candidate that is expected to meet the wish, or the closest to it.
    pub point: FrontPoint,
    /// Whether it is expected to meet it.
    pub meets: bool,
    /// All candidates that no other beats in both, the fastest first.
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

/// Pixels along each side of a window, and how many of them at its edge are not judged: adaptive sampling cannot look
/// around there.
const WINDOW: u32 = 16;
const RIM: usize = 1;
/// A window for so many pixels along each side of the picture.
const SPACING: u32 = 96;
/// Sample points along each side of a pixel of what windows are compared with: prime to those of the candidates.
const TRUTH: u32 = 13;
/// How deep mirrors are followed there.
const TRUTH_LEVEL: u32 = 64;
/// How often each time is taken.
const ROUNDS: u32 = 3;
/// Share of a budget that is planned with, and decibels beyond a target: predictions are off by about as much.
const CAUTION: f64 = 0.92;
const CAUTION_DB: f64 = 1.0;

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
    let front = free.front(lab, start, clock)?;
    Ok(pick(front, wish).unwrap_or_else(|| {
        let point = FrontPoint { setting: start, milliseconds: 0.0, rmse: 1.0 };
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
        let precision =
            if self.precision { self.cheapest_precision(lab, start, clock)? } else { start.precision };
        let plain = Setting { side: 1, threshold: None, precision, ..start };
        let windows = spread(plain.pixels);
        // 1. The truth, and one whole picture.
        let deep = Setting { level: start.level.max(TRUTH_LEVEL), cutoff: 1.0 / 65536.0, ..plain };
        let truth = lab.glimpse(Setting { side: TRUTH, ..deep }, &windows, clock)?;
        let whole = (0..ROUNDS)
            .map(|_| lab.shoot(plain, clock).map(|shot| shot.milliseconds))
            .try_fold(f64::INFINITY, |least, next| next.map(|next| least.min(next)))?;
        // 2. Depths, at one sample a pixel; their errors do not mix with those of sampling.
        let look = |lab: &mut Lab<'_>, setting, clock: &mut dyn FnMut() -> f64| {
            glance(lab, setting, &windows, clock)
        };
        let (deep_glimpse, deep_time) = look(lab, deep, clock)?;
        let (_, plain_time) = look(lab, plain, clock)?;
        let scale = whole / plain_time.max(f64::MIN_POSITIVE);
        let mut depths = Vec::new();
        for setting in self.depths(plain) {
            let (glimpse, time) = look(lab, setting, clock)?;
            depths.push((
                setting,
                time / deep_time.max(f64::MIN_POSITIVE),
                mean_square(&glimpse, &deep_glimpse),
            ));
        }
        // 3. Samplings, at the depth of the truth.
        let mut points = Vec::new();
        for (side, threshold) in SAMPLINGS {
            let sampled = Setting { side, threshold, ..deep };
            let (glimpse, time) = look(lab, sampled, clock)?;
            let error = mean_square(&glimpse, &truth);
            points.extend(depths.iter().map(|&(depth, share, depth_error)| FrontPoint {
                setting: Setting { side, threshold, ..depth },
                milliseconds: time * share * scale,
                rmse: (error + depth_error).sqrt(),
            }));
        }
        Ok(front_of(points))
    }

    /// Single precision, unless it shows.
    fn cheapest_precision(
        self,
        lab: &mut Lab<'_>,
        start: Setting,
        clock: &mut dyn FnMut() -> f64,
    ) -> Result<Precision, FrameError> {
        /// A pixel or two that fall on the other side of an edge do not.
        const VISIBLE: f64 = 1e-5;
        let windows = spread(start.pixels);
        let plain = Setting { side: 1, threshold: None, ..start };
        let double = lab.glimpse(Setting { precision: Precision::F64, ..plain }, &windows, clock)?;
        // A World beyond the range of single precision has no such picture.
        let single = lab.glimpse(Setting { precision: Precision::F32, ..plain }, &windows, clock);
        let is_equal = single.is_ok_and(|single| mean_square(&single, &double) < VISIBLE);
        Ok(if is_equal { Precision::F32 } else { Precision::F64 })
    }

    fn depths(self, plain: Setting) -> Vec<Setting> {
        if !self.depth {
            return vec![plain];
        }
        let levels = [(1, 0.0), (2, 0.0), (plain.level, 0.0), (8, 1.0 / 256.0), (TRUTH_LEVEL, 1.0 / 4096.0)];
        levels.map(|(level, cutoff)| Setting { level, cutoff, ..plain }).to_vec()
    }
}

/// Windows over a picture of so many pixels along each side, one in each cell of a square grid, at a place of its own in it.
fn spread(pixels: u32) -> Windows {
    let side = WINDOW.min(pixels);
    let cells = (pixels / SPACING).clamp(4, 24).min(pixels / side).max(1);
    let cell = pixels / cells;
    let room = cell - side + 1;
    let corner = |row: u32, column: u32| {
        // The golden section and its square spread the places evenly (R. Roberts' R2 sequence has the same idea).
        let number = row * cells + column;
        let place = |step: u32| (number.wrapping_mul(step) >> 16) * room >> 16;
        [column * cell + place(0x9e37_79b9), row * cell + place(0x6180_339d)]
    };
    let corners = (0..cells).flat_map(|row| (0..cells).map(move |column| corner(row, column))).collect();
    Windows { corners, side }
}

/// The windows with a setting, and the least time of some.
fn glance(
    lab: &mut Lab<'_>,
    setting: Setting,
    windows: &Windows,
    clock: &mut dyn FnMut() -> f64,
) -> Result<(Glimpse, f64), FrameError> {
    let first = lab.glimpse(setting, windows, clock)?;
    let mut least = first.milliseconds;
    // What takes long is measured well enough at once.
    let rounds = if setting.side > 5 { 1 } else { ROUNDS };
    for _ in 1..rounds {
        least = least.min(lab.glimpse(setting, windows, clock)?.milliseconds);
    }
    Ok((first, least))
}

/// Of all channels within the rims of the windows.
fn mean_square(a: &Glimpse, b: &Glimpse) -> f64 {
    let (mut sum, mut count) = (0.0, 0_u32);
    for (a, b) in a.films.iter().zip(&b.films) {
        for (a, b) in inner(a).zip(inner(b)) {
            sum += (0..3).map(|channel| (a[channel] - b[channel]).powi(2)).sum::<f64>();
            count += 3;
        }
    }
    sum / f64::from(count.max(1))
}

fn inner(film: &Film) -> impl Iterator<Item = &[f64; 3]> {
    let side = film.side() as usize;
    let rim = if side > 2 * RIM { RIM } else { 0 };
    let inside = move |place: usize| (rim..side - rim).contains(&place);
    film.pixels()
        .iter()
        .enumerate()
        .filter(move |(index, _)| inside(index % side) && inside(index / side))
        .map(|(_, pixel)| pixel)
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

/// What meets a wish on a front; nothing on an empty one.
fn pick(front: Vec<FrontPoint>, wish: Wish) -> Option<Choice> {
    let fitting = |point: &&FrontPoint| match wish {
        Wish::Budget(milliseconds) => point.milliseconds <= CAUTION * milliseconds,
        Wish::Decibels(decibels) => point.psnr_db() >= decibels + CAUTION_DB,
        Wish::Levels(levels) => point.psnr_db() >= decibels_of(levels) + CAUTION_DB,
    };
    let found = match wish {
        // The best of what fits, which is the last; else what takes least.
        Wish::Budget(_) => front.iter().rfind(fitting).or(front.first()),
        // The first that is good enough; else the best there is.
        Wish::Decibels(_) | Wish::Levels(_) => front.iter().find(fitting).or(front.last()),
    };
    let point = *found?;
    let meets = fitting(&&point);
    Some(Choice { point, meets, front })
}

/// Peak signal to noise of a root mean squared error of so many levels of 8 bits.
fn decibels_of(levels: f64) -> f64 {
    -20.0 * (levels / 255.0).log10()
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
        FrontPoint { setting, milliseconds, rmse }
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
        assert_eq!(picked(Wish::Decibels(39.5)), Some((100.0, true)));
        assert_eq!(picked(Wish::Decibels(70.0)), Some((100.0, false)));
        assert_eq!(picked(Wish::Levels(3.0)), Some((10.0, true)));
        assert_eq!(pick(Vec::new(), Wish::Budget(1.0)), None);
    }

    #[test]
    fn windows_lie_in_the_picture_and_apart() {
        for pixels in [1, 3, 15, 16, 17, 64, 100, 255, 768, 1024, 8192] {
            let Windows { corners, side } = spread(pixels);
            assert!(!corners.is_empty() && side <= pixels, "{pixels}");
            for (number, [column, row]) in corners.iter().enumerate() {
                assert!(column + side <= pixels && row + side <= pixels, "{pixels}");
                let apart =
                    |other: &[u32; 2]| column.abs_diff(other[0]) >= side || row.abs_diff(other[1]) >= side;
                assert!(corners[..number].iter().all(apart), "{pixels}");
            }
        }
    }
}

//! How coarse a picture must be to be there at once.

use std::iter;
use std::time::Duration;

/// The time that a coarse picture should take: a frame or two.
const AT_ONCE: Duration = Duration::from_millis(25);
/// How much coarser than the full picture it is as long as nothing has been measured.
const FIRST_FACTOR: u32 = 8;
/// Pixels along each side that it has at least, however slow the trace is.
const LEAST_SIDE: u32 = 8;

/// The speed of the trace, as measured so far.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Pace {
    seconds_a_sample: Option<f64>,
}

impl Pace {
    /// Takes in that so many samples took so long, with as much weight as all that was measured before. A pass that
    /// was cancelled after next to no time says nothing.
    pub(super) fn learn(&mut self, samples: u64, taken: Duration) {
        if samples == 0 && taken < AT_ONCE {
            return;
        }
        let samples = u32::try_from(samples.max(1)).unwrap_or(u32::MAX);
        let measured = taken.as_secs_f64() / f64::from(samples);
        self.seconds_a_sample =
            Some(self.seconds_a_sample.map_or(measured, |so_far| 0.5 * (so_far + measured)));
    }

    /// Pixels along each side of the coarse picture for a full one of `side`: as many as are there at once, of that
    /// number and its halves; `side` itself if nothing coarser is needed.
    pub(super) fn coarse_side(&self, side: u32) -> u32 {
        self.side_within(side, AT_ONCE)
    }

    /// The same for another time than that.
    pub(super) fn side_within(&self, side: u32, time: Duration) -> u32 {
        let Some(seconds) = self.seconds_a_sample else {
            return side.div_ceil(FIRST_FACTOR);
        };
        let fits = |side: u32| f64::from(side).powi(2) * seconds <= time.as_secs_f64();
        let mut sides = iter::successors(Some(side), |side| Some(side.div_ceil(2)));
        sides.find(|&coarse| coarse <= LEAST_SIDE || fits(coarse)).unwrap_or(side)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pace(samples: u64, milliseconds: u64) -> Pace {
        let mut pace = Pace::default();
        pace.learn(samples, Duration::from_millis(milliseconds));
        pace
    }

    #[test]
    fn the_coarse_picture_fits_into_its_time() {
        // A million samples a second: 25 ms are 25000 samples, a picture of 158 x 158.
        let pace = pace(1_000_000, 1000);
        for (side, coarse) in [(1, 1), (158, 158), (159, 80), (316, 158), (317, 80), (768, 96), (8192, 128)] {
            assert_eq!(pace.coarse_side(side), coarse, "side {side}");
        }
    }

    #[test]
    fn a_picture_is_never_coarser_than_a_few_pixels() {
        let pace = pace(0, 10_000);
        for (side, coarse) in [(1, 1), (8, 8), (9, 5), (768, 6), (8192, 8)] {
            assert_eq!(pace.coarse_side(side), coarse, "side {side}");
        }
    }

    #[test]
    fn before_anything_is_measured_an_eighth_is_tried() {
        assert_eq!(Pace::default().coarse_side(768), 96);
        assert_eq!(Pace::default().coarse_side(1), 1);
        // Cancelled before it began.
        assert_eq!(pace(0, 1).coarse_side(768), 96);
    }

    #[test]
    fn a_changed_speed_is_learnt_within_a_few_pictures() {
        let mut pace = pace(1_000_000, 1);
        for _ in 0..8 {
            pace.learn(1000, Duration::from_secs(1));
        }
        assert_eq!(pace.coarse_side(768), 6);
        for _ in 0..20 {
            pace.learn(1_000_000, Duration::from_millis(1));
        }
        assert_eq!(pace.coarse_side(768), 768);
    }
}

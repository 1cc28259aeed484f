//! A request that is worked on.

use std::time::{Duration, Instant};

use crate::film::Film;
use crate::study::{ERROR_LEVELS, error_colors, false_colors};
use crate::systems::{FrameError, Monitor, Workers};
use crate::trace::{Counts, Refinement, SampleGrid};

use super::estimate::Estimate;
use super::{LiveRequest, Shared, Shown, Shows};
use crate::viewer::pace::Pace;
use crate::viewer::traced_view::Samples;

/// The time that counting rays one by one may take, by the pace of tracing many at once. It cannot be given up half way.
const COUNTING: Duration = Duration::from_millis(100);
/// After the first sample the window has so long to show it with all processors. Whoever flies on by then has asked for
/// another picture, and has not waited for what is traced of this one.
const PAUSE: Duration = Duration::from_millis(30);
/// Samples along each side of a pixel of which a few tell the error of a single one.
const PROBES: u32 = 3;

/// One request.
pub(super) struct Job<'a> {
    shared: &'a Shared,
    workers: &'a Workers,
    request: LiveRequest,
    generation: u64,
    monitor: Monitor,
}

/// What some passes have come to.
#[derive(Clone, Copy, Default)]
struct Tally {
    counts: Counts,
    taken: Duration,
}

/// A picture with all its samples.
struct Whole {
    /// The first sample of each pixel.
    first: Film,
    /// The mean of all.
    film: Film,
    refinement: Option<Refinement>,
    tally: Tally,
}

impl<'a> Job<'a> {
    pub(super) fn new(
        shared: &'a Shared,
        workers: &'a Workers,
        request: LiveRequest,
        generation: u64,
        monitor: Monitor,
    ) -> Self {
        Self { shared, workers, request, generation, monitor }
    }

    /// Says why there is no picture.
    pub(super) fn fail(&self, error: FrameError) {
        self.shared.show(self.generation, Err(error));
    }

    pub(super) fn run(&self, pace: &mut Pace) -> Result<(), FrameError> {
        let side = self.request.side;
        let coarse = pace.coarse_side(side);
        if coarse < side {
            match self.request.shows {
                Shows::Picture => drop(self.passes(coarse, SampleGrid::CENTER, pace)?),
                Shows::Errors | Shows::Rays => self.develop(coarse, false, pace)?,
            }
        }
        self.develop(side, true, pace)
    }

    /// Traces all samples, and shows what is asked for.
    fn develop(&self, side: u32, is_last: bool, pace: &mut Pace) -> Result<(), FrameError> {
        let whole = self.whole(side, pace)?;
        if self.monitor.is_cancelled() {
            return Ok(());
        }
        let error = self.estimate(&whole, pace);
        if self.monitor.is_cancelled() {
            return Ok(());
        }
        let Whole { film, tally, .. } = &whole;
        let shown = Shown { is_final: is_last, error: Some(error.rmse()), ..self.picture(film, 1, *tally) };
        let samples = self.request.samples.grid.count();
        self.show(match self.request.shows {
            Shows::Picture => Shown { samples, ..shown },
            Shows::Errors => {
                Shown { samples, rgb8: error_colors(&error.of_pixels()), most: ERROR_LEVELS, ..shown }
            }
            Shows::Rays => {
                let side = pace.side_within(side, COUNTING);
                let rays = self.rays(&whole, side);
                let most = rays.iter().copied().fold(1.0, f64::max);
                Shown { samples, side, rgb8: false_colors(&rays, most), most, ..shown }
            }
        });
        Ok(())
    }

    /// Traces a picture. On the way there it is shown after each sample.
    fn whole(&self, side: u32, pace: &mut Pace) -> Result<Whole, FrameError> {
        let Samples { grid, threshold } = self.request.samples;
        // Only an odd grid begins with the pixel's centre, and adaptive samples are shown when all are there.
        let begins_elsewhere = grid.side().is_multiple_of(2) || threshold.is_some();
        let center =
            if begins_elsewhere { Some(self.passes(side, SampleGrid::CENTER, pace)?.first) } else { None };
        let whole = if threshold.is_some() { self.adaptive(side)? } else { self.passes(side, grid, pace)? };
        Ok(Whole { first: center.unwrap_or(whole.first), ..whole })
    }

    /// Traces samples one after the other and shows the picture after each, except the last if there are several.
    fn passes(&self, side: u32, grid: SampleGrid, pace: &mut Pace) -> Result<Whole, FrameError> {
        let mut film = Film::new(side).ok_or(FrameError::Memory(side))?;
        let (mut first, mut tally) = (Film::default(), Tally::default());
        for pass in (0..grid.count()).take_while(|_| !self.monitor.is_cancelled()) {
            self.trace((grid, pass), &mut film, &mut tally, pace);
            let is_on_the_way = pass + 1 < grid.count() || pass == 0;
            if is_on_the_way && self.request.shows == Shows::Picture && !self.monitor.is_cancelled() {
                self.show(self.picture(&film, pass + 1, tally));
                // A coarse picture is followed by a better one at once.
                if pass == 0 && side == self.request.side {
                    self.shared.pause(self.generation, PAUSE);
                }
            }
            if pass == 0 {
                first = film.clone();
            }
        }
        film.divide(grid.count());
        Ok(Whole { first, film, refinement: None, tally })
    }

    fn adaptive(&self, side: u32) -> Result<Whole, FrameError> {
        let mut film = Film::new(side).ok_or(FrameError::Memory(side))?;
        let start = Instant::now();
        let (samples, view) = (self.request.samples, &self.request.view);
        let (counts, refinement) = view.trace_picture(samples, &mut film, self.workers, &self.monitor);
        let tally = Tally { counts, taken: start.elapsed() };
        Ok(Whole { first: Film::default(), film, refinement, tally })
    }

    fn trace(&self, pass: (SampleGrid, u32), film: &mut Film, tally: &mut Tally, pace: &mut Pace) {
        let start = Instant::now();
        let workers = self.workers.clone().with_tile_size(tile_size(film.side()));
        let counts = self.request.view.trace_pass(pass, film, &workers, &self.monitor);
        let taken = start.elapsed();
        tally.counts += counts;
        tally.taken += taken;
        let is_whole = !self.monitor.is_cancelled();
        pace.learn(if is_whole { u64::from(film.side()).pow(2) } else { counts.rays.primary }, taken);
    }

    /// What the samples tell of the picture's error. A single sample tells nothing: two more are taken beside it.
    fn estimate(&self, whole: &Whole, pace: &mut Pace) -> Estimate {
        let Whole { first, film, refinement, .. } = whole;
        if let Some(refinement) = refinement {
            return Estimate::adaptive(first, film, refinement.samples());
        }
        let samples = self.request.samples.grid.count();
        if samples > 1 {
            return Estimate::uniform(first, (film, samples), samples);
        }
        let mut sum = first.clone();
        for pass in 1..PROBES {
            self.trace((SampleGrid::new(PROBES), pass), &mut sum, &mut Tally::default(), pace);
        }
        sum.divide(PROBES);
        Estimate::uniform(first, (&sum, PROBES), 1)
    }

    /// The rays of each pixel of a picture, coarser than this one as need be: those of its first sample, as many times as it
    /// has samples.
    fn rays(&self, whole: &Whole, side: u32) -> Vec<f64> {
        let grid = self.request.samples.grid;
        let rays = self.request.view.count_rays(grid, side, self.workers);
        let uniform = f64::from(grid.count());
        let samples = |index: usize| {
            let Some(refinement) = &whole.refinement else { return uniform };
            let (side, fine) = (side as usize, whole.film.side() as usize);
            let [column, row] = [index % side, index / side].map(|place| (2 * place + 1) * fine / (2 * side));
            refinement.samples().get(row * fine + column).map_or(uniform, |&samples| f64::from(samples))
        };
        rays.iter().enumerate().map(|(index, &rays)| f64::from(rays) * samples(index)).collect()
    }

    /// A film that holds the sum of so many samples.
    fn picture(&self, film: &Film, samples: u32, tally: Tally) -> Shown {
        Shown {
            side: film.side(),
            rgb8: self.workers.run(|| film.mean_to_rgb8(samples)),
            shows: self.request.shows,
            samples,
            is_final: false,
            counts: tally.counts,
            milliseconds: tally.taken.as_secs_f64() * 1e3,
            error: None,
            most: 0.0,
        }
    }

    fn show(&self, shown: Shown) {
        self.shared.show(self.generation, Ok(shown));
    }
}

/// Coarse pictures are cut into smaller tiles, so that there is one for every thread.
fn tile_size(side: u32) -> u32 {
    (side / 16).clamp(1, 32)
}

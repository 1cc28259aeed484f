//! The traced picture in the window: asked for when the view changes, shown as it gets better.

use std::time::Duration;

use crate::components::{Adaptive, CameraPose, Cutoff, Lens, Precision, Sampling, Snapshot};
use crate::preview::Layout;
use crate::systems::Workers;
use crate::trace::{CameraEffects, SampleGrid};

use super::ViewerError;
use super::editor::Traced;
use super::live::{Live, LiveRequest, Shown, Shows};
use super::report::{Happened, hash};
use super::session::Session;
use super::traced_view::Samples;

/// Sample points along each side of a pixel that a picture ends with where the World asks for no more than one and
/// nobody has chosen that. Odd, so that the first of them is the centre, which `render` takes.
const GRID: u32 = 3;
/// How long a frame waits for the first, coarse picture after a change.
const FIRST_PICTURE: Duration = Duration::from_millis(60);

/// The live trace and the newest picture of it.
pub(super) struct Refined {
    live: Live,
    asked_for: Option<Wanted>,
    newest: Option<Shown>,
    is_drawn: bool,
}

/// What a traced picture depends on, to know when another one is needed.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Wanted {
    pose: CameraPose,
    lens: Lens,
    effects: CameraEffects,
    level: u32,
    cutoff: f64,
    side: u32,
    samples: Samples,
    shows: Shows,
    revision: u64,
    precision: Precision,
}

impl Refined {
    pub(super) fn new(
        workers: Workers,
        wake: impl Fn() + Send + Sync + 'static,
    ) -> Result<Self, ViewerError> {
        let live = Live::new(workers, wake).map_err(ViewerError::Thread)?;
        Ok(Self { live, asked_for: None, newest: None, is_drawn: false })
    }

    /// The newest picture.
    pub(super) fn newest(&self) -> Option<&Shown> {
        self.newest.as_ref()
    }

    /// The newest picture, unless it was given out before.
    pub(super) fn take_undrawn(&mut self) -> Option<&Shown> {
        let is_drawn = std::mem::replace(&mut self.is_drawn, true);
        self.newest.as_ref().filter(|_| !is_drawn)
    }

    /// Has the newest picture given out again, to a new GL context.
    pub(super) fn draw_again(&mut self) {
        self.is_drawn = false;
    }
}

impl Session {
    /// Rays that may follow each other.
    pub(super) fn level(&self) -> u32 {
        self.world.resource::<Snapshot>().level
    }

    /// Share of the light in a pixel up to which no ray is followed.
    pub(super) fn cutoff(&self) -> f64 {
        self.world.get_resource::<Cutoff>().map_or(0.0, |cutoff| cutoff.0)
    }

    /// What the window shows: a traced picture only where there is one.
    pub(super) fn shown_mode(&self) -> Layout {
        match self.refined.newest {
            Some(_) => self.switches.mode,
            None => Layout::Preview,
        }
    }

    /// Has the view traced if it is to be seen and differs from the one before, and takes the newest picture.
    pub(super) fn refine(&mut self) {
        let wanted = self.wanted();
        if wanted != self.refined.asked_for {
            self.refined.asked_for = wanted;
            match (wanted, self.view()) {
                (Some(Wanted { side, samples, shows, .. }), Some(view)) => {
                    self.refined.live.request(LiveRequest { view, side, samples, shows });
                    let first = self.refined.live.wait(FIRST_PICTURE);
                    self.take(first);
                }
                _ => {
                    self.refined.live.stop();
                    self.refined.newest = None;
                }
            }
        }
        let newest = self.refined.live.latest();
        self.take(newest);
    }

    /// What the traced picture depends on; `None` if none is to be seen.
    fn wanted(&mut self) -> Option<Wanted> {
        if self.switches.mode == Layout::Preview || self.side == 0 || !self.problems().is_empty() {
            return None;
        }
        let (pose, lens) = self.camera()?;
        let (samples, shows, side) = (self.live_samples(), self.switches.shows, self.side);
        let (revision, precision) = (self.revision(), self.precision());
        let (effects, level, cutoff) = (self.camera_effects(), self.level(), self.cutoff());
        Some(Wanted { pose, lens, effects, level, cutoff, side, samples, shows, revision, precision })
    }

    /// The samples that a picture ends with in a file.
    pub(super) fn samples(&self) -> Samples {
        let grid = SampleGrid::new(self.world.resource::<Sampling>().side);
        Samples { grid, threshold: self.world.get_resource::<Adaptive>().map(|adaptive| adaptive.threshold) }
    }

    /// The same in the window: more than one, unless it was said that one is enough.
    fn live_samples(&self) -> Samples {
        let samples = self.samples();
        let is_one = samples.grid == SampleGrid::CENTER && !self.world.resource::<Traced>().is_chosen();
        if is_one { Samples::of(SampleGrid::new(GRID)) } else { samples }
    }

    fn take(&mut self, picture: Option<Result<Shown, crate::systems::FrameError>>) {
        match picture {
            None => {}
            Some(Ok(picture)) => {
                self.tell_picture(&picture);
                self.refined.newest = Some(picture);
                self.refined.is_drawn = false;
            }
            Some(Err(error)) => self.refuse("live trace", &error.to_string()),
        }
    }

    /// Tells of complete pictures: the one with one sample, and the last.
    fn tell_picture(&mut self, picture: &Shown) {
        let &Shown { side, samples, is_final, most, .. } = picture;
        let what = match picture.shows {
            Shows::Picture if self.report.has_events() && side == self.side && (samples == 1 || is_final) => {
                let hash = hash(&picture.rgb8);
                return self.report.event(&Happened::Picture { side, samples, is_final, hash: &hash });
            }
            Shows::Errors if is_final => "errors",
            Shows::Rays if is_final => "rays",
            _ => return,
        };
        self.report.event(&Happened::HeatMap { what, side, most });
    }
}

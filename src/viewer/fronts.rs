//! What accuracy costs on the scene at hand: measured beside the window, on a World of its own.

use std::sync::Arc;
use std::sync::mpsc::{self, Receiver, TryRecvError};
use std::thread;
use std::time::Instant;

use bevy_ecs::prelude::*;

use crate::components::{CameraPose, Checkerboard, Precision, Textured};
use crate::effects::EffectSet;
use crate::scene::{Description, describe, spawn};
use crate::study::{Chooser, FrontPoint, Lab, Setting};
use crate::systems::{Muted, Tables, Workers};

use super::editor::accuracy;
use super::live::Shows;
use super::report::Happened;
use super::session::Session;
use super::traced_view::traced_pose;

/// Pixels along each side of the largest picture that is traced to be measured; for larger ones times are scaled.
const MOST_PIXELS: u32 = 1024;
/// Objects of the largest scene that is copied to be measured.
const MOST_OBJECTS: usize = 100_000;

/// The settings that nothing beats in both time and error, the fastest first.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Front {
    /// Empty while nothing is measured.
    pub(crate) points: Vec<FrontPoint>,
    /// Whether it is being measured.
    pub(crate) is_under_way: bool,
}

/// The front of the scene, and the thread that measures it, once and whenever it is forgotten.
pub(super) struct Fronts {
    front: Front,
    is_wanted: bool,
    found: Option<Receiver<Vec<FrontPoint>>>,
    wake: Arc<dyn Fn() + Send + Sync>,
}

/// What a World is copied from.
struct Original {
    description: Description,
    pose: CameraPose,
    textured: Option<Textured>,
    muted: Muted,
    setting: Setting,
    effects: EffectSet,
    workers: Workers,
}

impl Fronts {
    /// `wake` is called when a measurement ends.
    pub(super) fn new(wake: impl Fn() + Send + Sync + 'static) -> Self {
        Self { front: Front::default(), is_wanted: true, found: None, wake: Arc::new(wake) }
    }

    /// What is known.
    pub(super) fn front(&self) -> &Front {
        &self.front
    }

    /// Lets it be measured anew.
    pub(super) fn forget(&mut self) {
        self.is_wanted = true;
    }

    fn start(&mut self, original: Original) {
        let (sender, found) = mpsc::channel();
        let wake = self.wake.clone();
        let work = move || {
            // If the window has been closed meanwhile, nobody wants to know.
            let _ = sender.send(original.measure().unwrap_or_default());
            wake();
        };
        // It is not waited for: the window may close at any time.
        let is_started = thread::Builder::new().name("front".into()).spawn(work).is_ok();
        self.found = is_started.then_some(found);
        self.front.is_under_way = is_started;
    }

    /// Takes what was measured; returns whether anything was.
    fn collect(&mut self) -> bool {
        let Some(found) = &self.found else { return false };
        let measured = match found.try_recv() {
            Err(TryRecvError::Empty) => return false,
            measured => measured.ok(),
        };
        (self.found, self.front.is_under_way) = (None, false);
        let is_new = measured.is_some();
        if let Some(points) = measured {
            self.front.points = points;
        }
        is_new
    }
}

impl Session {
    /// Takes what has been measured, and begins to measure as soon as a picture is complete and nobody has done so.
    pub(super) fn measure_front(&mut self) {
        if self.fronts.collect() {
            self.report.event(&Happened::Front { settings: self.fronts.front.points.len() });
        }
        let is_complete = |shown: &super::live::Shown| shown.is_final && shown.shows == Shows::Picture;
        let is_time = self.switches.strip && self.refined.newest().is_some_and(is_complete);
        if is_time && self.fronts.is_wanted && self.fronts.found.is_none() {
            self.fronts.is_wanted = false;
            if let Some(original) = self.original() {
                self.fronts.start(original);
            }
        }
    }

    /// Nothing if the scene is too large, or no file could hold it.
    fn original(&mut self) -> Option<Original> {
        let description = describe(&mut self.world).ok()?;
        if description.objects.len() > MOST_OBJECTS {
            return None;
        }
        let effects = match self.precision() {
            Precision::F64 => self.tables::<f64>().effects(),
            Precision::F32 => self.tables::<f32>().effects(),
        };
        let (pose, _) = self.camera()?;
        Some(Original {
            description,
            pose: traced_pose(&pose),
            textured: self.world.query::<&Textured>().iter(&self.world).next().cloned(),
            muted: *self.world.resource::<Muted>(),
            setting: accuracy(&mut self.world),
            effects,
            workers: Workers::new(std::num::NonZeroUsize::new(self.workers.threads())).ok()?,
        })
    }
}

impl Original {
    /// The front; nothing if the scene has effects that the copy has not, so that figures of it would be those of another
    /// scene.
    fn measure(&self) -> Option<Vec<FrontPoint>> {
        let mut world = self.copy();
        let mut lab = Lab::new(&mut world, &self.workers);
        let start = Instant::now();
        let mut clock = || start.elapsed().as_secs_f64() * 1e3;
        let pixels = self.setting.pixels.min(MOST_PIXELS);
        let begin = Setting { pixels, ..self.setting };
        let front = Chooser { precision: true, depth: true }.front(&mut lab, begin, &mut clock).ok()?;
        if lab.world().resource::<Tables<f64>>().effects() != self.effects {
            return None;
        }
        let scale = (f64::from(self.setting.pixels) / f64::from(pixels.max(1))).powi(2);
        let scaled = |point: FrontPoint| FrontPoint { milliseconds: point.milliseconds * scale, ..point };
        Some(front.into_iter().map(scaled).collect())
    }

    fn copy(&self) -> World {
        let mut world = World::new();
        spawn(&mut world, &self.description);
        for mut pose in world.query::<&mut CameraPose>().iter_mut(&mut world) {
            *pose = self.pose;
        }
        if let Some(textured) = &self.textured {
            let mut boards = world.query_filtered::<Entity, With<Checkerboard>>();
            let boards: Vec<Entity> = boards.iter(&world).collect();
            for board in boards {
                world.entity_mut(board).insert(textured.clone());
            }
        }
        world.insert_resource(self.muted);
        world
    }
}

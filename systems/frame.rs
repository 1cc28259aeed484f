//! What a frame leaves in the World: its tables and its picture.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use bevy_ecs::prelude::*;
use thiserror::Error;

use crate::components::range::MAX_PIXELS;
use crate::effects::{Effect, EffectSet};
use crate::film::Film;
use crate::geometry::{Real, Unit};
use crate::trace::{CameraEffects, CameraRays, Counts, EffectCount, Kind, ObjectId, Refinement, SceneTables};

use super::WorldProblem;
use super::choose_unit::Extremes;
use super::problem::lacking;
use super::runs::Runs;

/// The tables of one precision, kept from frame to frame.
#[derive(Resource, Default)]
pub struct Tables<T: Real> {
    /// Objects and lights. Shared, so that a picture can be traced from them while the World goes on: the extraction
    /// copies them before it changes them if somebody does.
    pub scene: Arc<SceneTables<T>>,
    /// The camera's rays; absent until there is exactly one usable camera.
    pub camera: Option<CameraRays<T>>,
    /// Grows with every change of the tables of objects and lights.
    pub(super) revision: u64,
    /// The entity of each row of the object tables.
    pub(super) entities: BTreeMap<Kind, Vec<Entity>>,
    /// How often systems worked for each effect.
    pub(super) runs: Runs,
    /// What is wrong, by the table that it keeps from being right.
    pub(super) problems: BTreeMap<&'static str, Vec<WorldProblem>>,
    /// The least and the greatest length of objects, by their tables; not measured in double precision.
    pub(super) lengths: BTreeMap<&'static str, Extremes>,
    /// Tables of objects that changed since they were extracted; not noted in double precision.
    pub(super) outdated: BTreeSet<&'static str>,
    /// The unit in which each table was extracted.
    units: BTreeMap<&'static str, Unit>,
}

impl<T: Real> Tables<T> {
    /// A number that grows whenever the tables of objects or lights were extracted anew.
    pub fn revision(&self) -> u64 {
        self.revision
    }

    /// How many runs of systems there have been that had a row of an effect to make.
    pub fn systems_run(&self, effect: Effect) -> u64 {
        self.runs.of(effect)
    }

    /// The entity that a row was extracted from.
    pub fn entity(&self, object: ObjectId) -> Option<Entity> {
        self.entities.get(&object.kind)?.get(object.row as usize).copied()
    }

    /// The effects that some row, or the camera, asks for.
    pub fn effects(&self) -> EffectSet {
        self.scene.effects().union(self.camera_effects().set())
    }

    /// What every effect takes, in rows of tables and in the camera, in the order of reports.
    pub fn effect_counts(&self) -> Vec<EffectCount> {
        let camera = self.camera_effects();
        let with_camera = |count: EffectCount| {
            let here = camera.count(count.effect);
            EffectCount { rows: count.rows + here.rows, bytes: count.bytes + here.bytes, ..count }
        };
        self.scene.effect_counts().into_iter().map(with_camera).collect()
    }

    /// What the camera does beyond that of a pinhole; nothing while there is none.
    pub fn camera_effects(&self) -> CameraEffects {
        self.camera.as_ref().map(CameraRays::effects).unwrap_or_default()
    }

    /// Notes that a table has been extracted in the unit of now, and what is wrong with it.
    pub(super) fn mark_extracted(&mut self, table: &'static str, problems: Vec<WorldProblem>) {
        self.problems.insert(table, problems);
        self.units.insert(table, self.scene.unit);
    }

    /// Whether there is nothing wrong with a table, or with its unit, so that its rows mean what they say.
    pub(super) fn is_sound(&self, table: &'static str) -> bool {
        let is_empty = |name| self.problems.get(name).map(Vec::is_empty);
        is_empty(table) == Some(true) && is_empty("Unit") != Some(false)
    }

    /// Whether a table has been extracted in another unit than that of now.
    pub(super) fn is_in_old_unit(&self, table: &'static str) -> bool {
        self.units.get(table).is_some_and(|&unit| unit != self.scene.unit)
    }

    /// Everything that is wrong with the World, as of the last extraction.
    pub fn problems(&self) -> Vec<WorldProblem> {
        let lacking = lacking(self.effects(), EffectSet::COMPILED);
        self.problems.values().flatten().cloned().chain(lacking).collect()
    }
}

/// The picture of the last frame.
#[derive(Resource, Default)]
pub struct Frame {
    pub(super) film: Film,
    /// In 8 bits a channel, where that was asked for.
    pub(super) levels: Vec<u8>,
    pub(super) counts: Counts,
    pub(super) refinement: Option<Refinement>,
    pub(super) error: Option<FrameError>,
}

impl Frame {
    /// The film and what was counted while it was traced; or why there is none.
    pub fn traced(&self) -> Result<(&Film, &Counts), FrameError> {
        match &self.error {
            Some(error) => Err(error.clone()),
            None => Ok((&self.film, &self.counts)),
        }
    }
}

impl Frame {
    /// The picture in 8 bits a channel, red, green, blue, top row first, as
    /// [`levels_schedule`](super::levels_schedule) has left it, and what was counted; or why there is none. It is there once.
    pub fn take_levels(&mut self) -> Result<(Vec<u8>, Counts), FrameError> {
        match &self.error {
            Some(error) => Err(error.clone()),
            None => Ok((core::mem::take(&mut self.levels), self.counts)),
        }
    }

    /// How many samples each pixel has, where that was decided pixel by pixel.
    pub fn refinement(&self) -> Option<&Refinement> {
        self.refinement.as_ref()
    }
}

/// Why a frame has no picture.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum FrameError {
    /// The World holds something that cannot be traced.
    #[error("{}", list(.0))]
    World(Vec<WorldProblem>),
    /// The film does not fit into memory.
    #[error("no memory for a picture of {0} x {0} pixels (the most allowed is {MAX_PIXELS})")]
    Memory(u32),
    /// The monitor asked to stop.
    #[error("interrupted")]
    Cancelled,
}

/// One problem a line, the first few.
fn list(problems: &[WorldProblem]) -> String {
    const SHOWN: usize = 10;
    let mut lines: Vec<String> = problems.iter().take(SHOWN).map(WorldProblem::to_string).collect();
    if problems.len() > SHOWN {
        lines.push(format!("and {} more", problems.len() - SHOWN));
    }
    lines.join("\n")
}

//! Accuracy: every knob of a picture, turned in one step wherever in the World it is.

use bevy_ecs::prelude::*;

use crate::components::{
    Adaptive, AreaLight, CheckerFilter, Checkerboard, Cutoff, Precision, Sampling, Snapshot, TextureFilter,
    Textured,
};
use crate::study;

use super::Editor;
use super::edit::{Edit, put, set};
use super::history::Step;

/// What the window traces with, beyond what the World says of its pictures.
#[derive(Resource, Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Traced {
    /// Of tables and kernels.
    pub(crate) precision: Precision,
    /// The level that the scene had when the user chose an accuracy for the first time; nothing before. Until then a
    /// picture in the window may have more samples than one in a file.
    pub(crate) own_level: Option<u32>,
}

impl Traced {
    /// Whether the user has chosen an accuracy.
    pub(crate) fn is_chosen(self) -> bool {
        self.own_level.is_some()
    }
}

/// The level of the scene itself, if it may have been turned since.
pub(crate) fn own_level(world: &World) -> Option<u32> {
    world.get_resource::<Traced>()?.own_level
}

/// The accuracy of a World's pictures, with filters and shadow rays where all boards and lights agree.
pub(crate) fn accuracy(world: &mut World) -> study::Setting {
    let precision = world.get_resource::<Traced>().copied().unwrap_or_default().precision;
    let setting = study::Setting::of(world, precision);
    let filters = filters(world).into_iter().map(|(_, filter)| filter.unwrap_or_default());
    let mut lights = world.query::<&AreaLight>();
    let lights = lights.iter(world).map(|light| light.samples);
    let (texture_filter, light_samples) = (common(filters), common(lights));
    study::Setting { texture_filter, light_samples, ..setting }
}

/// The one value of all, if they have one.
fn common<V: PartialEq>(mut values: impl Iterator<Item = V>) -> Option<V> {
    let first = values.next()?;
    values.all(|value| value == first).then_some(first)
}

fn filters(world: &mut World) -> Vec<(Entity, Option<TextureFilter>)> {
    let mut boards = world.query_filtered::<(Entity, Option<&TextureFilter>), With<Textured>>();
    boards.iter(world).map(|(board, filter)| (board, filter.copied())).collect()
}

/// Everything that a setting touches.
#[derive(Clone, PartialEq)]
struct Knobs {
    traced: Traced,
    sampling: Option<Sampling>,
    snapshot: Option<Snapshot>,
    adaptive: Option<Adaptive>,
    cutoff: Option<Cutoff>,
    checkers: Vec<(Entity, bool)>,
    images: Vec<(Entity, Option<TextureFilter>)>,
    lights: Vec<(Entity, AreaLight)>,
}

impl Knobs {
    fn of(world: &mut World) -> Self {
        let mut boards = world.query_filtered::<(Entity, Has<CheckerFilter>), With<Checkerboard>>();
        let checkers = boards.iter(world).collect();
        let mut lights = world.query::<(Entity, &AreaLight)>();
        let lights = lights.iter(world);
        Self {
            lights: lights.map(|(light, &area)| (light, area)).collect(),
            checkers,
            images: filters(world),
            traced: world.get_resource().copied().unwrap_or_default(),
            sampling: world.get_resource().copied(),
            snapshot: world.get_resource().copied(),
            adaptive: world.get_resource().copied(),
            cutoff: world.get_resource().copied(),
        }
    }

    fn restore(&self, world: &mut World) {
        set(world, Some(&self.traced));
        set(world, self.sampling.as_ref());
        set(world, self.snapshot.as_ref());
        set(world, self.adaptive.as_ref());
        set(world, self.cutoff.as_ref());
        for &(board, is_filtered) in &self.checkers {
            put(world, board, is_filtered.then_some(&CheckerFilter));
        }
        for (board, filter) in &self.images {
            put(world, *board, filter.as_ref());
        }
        for (light, area) in &self.lights {
            put(world, *light, Some(area));
        }
    }

    /// Whether a scene file says the same of both.
    fn are_alike_in_a_file(&self, other: &Self) -> bool {
        self.snapshot == other.snapshot
    }
}

struct AccuracyEdit {
    before: Knobs,
    after: Knobs,
}

impl Edit for AccuracyEdit {
    fn make(&self, world: &mut World) {
        self.after.restore(world);
    }

    fn take_back(&self, world: &mut World) {
        self.before.restore(world);
    }

    fn is_empty(&self) -> bool {
        self.before == self.after
    }

    fn hides(&self, _while_made: bool) -> &[Entity] {
        &[]
    }
}

impl Editor {
    /// Gives the World another accuracy, like [`change`](Self::change).
    pub(crate) fn change_accuracy(&mut self, world: &mut World, new: &study::Setting) {
        if accuracy(world) == *new {
            return;
        }
        let before = Knobs::of(world);
        new.apply(world);
        let own_level = before.traced.own_level.or(before.snapshot.map(|snapshot| snapshot.level));
        let own_level = own_level.or(Some(Snapshot::default().level));
        world.insert_resource(Traced { precision: new.precision, own_level });
        let after = Knobs::of(world);
        if let Some(open) = self.history.open_edit::<AccuracyEdit>()
            && open.before.are_alike_in_a_file(&before) == open.before.are_alike_in_a_file(&after)
        {
            open.after = after;
            return;
        }
        let is_in_file = !before.are_alike_in_a_file(&after);
        let step = Step::new("Accuracy").and(AccuracyEdit { before, after });
        self.begin_gesture(world, if is_in_file { step } else { step.outside_the_file() });
    }
}

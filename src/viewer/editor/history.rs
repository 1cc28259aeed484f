//! What was done, step by step: for undo and redo.

use core::any::Any;
use std::collections::VecDeque;

use bevy_ecs::entity_disabling::Disabled;
use bevy_ecs::prelude::*;

use super::edit::Edit;

/// How much is remembered. The newest step always is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limits {
    /// Steps that can be undone.
    pub(super) steps: usize,
    /// Entities that are hidden in the World because a step may bring them back.
    pub(super) hidden: usize,
}

impl Default for Limits {
    fn default() -> Self {
        Self { steps: 10_000, hidden: 2_000_000 }
    }
}

/// Something that the user did, undone and redone as a whole.
pub(super) struct Step {
    what: &'static str,
    edits: Vec<Box<dyn Edit>>,
    is_in_file: bool,
    /// Number of the step itself.
    number: u64,
    /// Number of the content that the scene has after it.
    content: u64,
}

impl Step {
    /// A step without edits.
    pub(super) fn new(what: &'static str) -> Self {
        Self { what, edits: Vec::new(), is_in_file: true, number: 0, content: 0 }
    }

    /// The step with one edit more, which has been made already.
    pub(super) fn and(mut self, edit: impl Edit) -> Self {
        self.edits.push(Box::new(edit));
        self
    }

    /// The step, which changes nothing that a scene file holds.
    pub(super) fn outside_the_file(mut self) -> Self {
        self.is_in_file = false;
        self
    }

    fn hidden(&self, while_made: bool) -> impl Iterator<Item = Entity> {
        self.edits.iter().flat_map(move |edit| edit.hides(while_made).iter().copied())
    }
}

/// Steps that were made, and steps that were undone. Every content that the scene has had has a number, that of the
/// step which led to it, so that it is known again after undo; a step that changes nothing in a file leads to none.
#[derive(Default)]
pub(super) struct History {
    made: VecDeque<Step>,
    undone: Vec<Step>,
    limits: Limits,
    /// Whether the newest step may still be changed.
    open: bool,
    /// Number of the newest step that there ever was.
    newest: u64,
    /// Content before the oldest step.
    oldest: u64,
    saved: u64,
}

impl History {
    /// An empty history that forgets sooner.
    #[cfg(test)]
    pub(super) fn with_limits(limits: Limits) -> Self {
        Self { limits, ..Self::default() }
    }

    /// Adds a step that has been made already. What was undone is gone then.
    pub(super) fn push(&mut self, world: &mut World, mut step: Step) {
        self.close();
        for step in self.undone.drain(..) {
            despawn(world, step.hidden(false));
        }
        self.newest += 1;
        step.number = self.newest;
        step.content = if step.is_in_file { step.number } else { self.content() };
        self.made.push_back(step);
        self.forget(world);
    }

    /// Lets the newest step be changed until [`close`](Self::close).
    pub(super) fn open(&mut self) {
        self.open = true;
    }

    /// The newest step's only edit, if it may still be changed and is of this kind.
    pub(super) fn open_edit<E: Edit>(&mut self) -> Option<&mut E> {
        let [edit] = self.made.back_mut().filter(|_| self.open)?.edits.as_mut_slice() else { return None };
        let edit: &mut dyn Any = edit.as_mut();
        edit.downcast_mut()
    }

    /// Nothing can be added to the newest step any more. If it came to nothing, it is forgotten.
    pub(super) fn close(&mut self) {
        let came_to_nothing = |step: &Step| step.edits.iter().all(|edit| edit.is_empty());
        if core::mem::take(&mut self.open) && self.made.back().is_some_and(came_to_nothing) {
            self.made.pop_back();
        }
    }

    /// Takes the newest step back.
    pub(super) fn undo(&mut self, world: &mut World) -> Option<&'static str> {
        self.close();
        let step = self.made.pop_back()?;
        step.edits.iter().rev().for_each(|edit| edit.take_back(world));
        let what = step.what;
        self.undone.push(step);
        Some(what)
    }

    /// Makes the step again that was undone last.
    pub(super) fn redo(&mut self, world: &mut World) -> Option<&'static str> {
        self.close();
        let step = self.undone.pop()?;
        step.edits.iter().for_each(|edit| edit.make(world));
        let what = step.what;
        self.made.push_back(step);
        Some(what)
    }

    /// What would be undone, and what redone.
    pub(super) fn next(&self) -> [Option<&'static str>; 2] {
        [self.made.back(), self.undone.last()].map(|step| step.map(|step| step.what))
    }

    /// What the newest step is, and a number that every step has for itself.
    pub(super) fn newest(&self) -> Option<(u64, &'static str)> {
        self.made.back().map(|step| (step.number, step.what))
    }

    /// Number of the scene's present content.
    pub(super) fn content(&self) -> u64 {
        self.made.back().map_or(self.oldest, |step| step.content)
    }

    pub(super) fn is_saved(&self) -> bool {
        self.content() == self.saved
    }

    pub(super) fn mark_saved(&mut self) {
        self.close();
        self.saved = self.content();
    }

    /// Drops the oldest steps beyond the limits. Entities that only they could bring back are despawned.
    fn forget(&mut self, world: &mut World) {
        let mut hidden: usize = self.made.iter().map(|step| step.hidden(true).count()).sum();
        let Limits { steps, hidden: most } = self.limits;
        while self.made.len() > 1 && (self.made.len() > steps || hidden > most) {
            let Some(step) = self.made.pop_front() else { break };
            hidden -= step.hidden(true).count();
            despawn(world, step.hidden(true));
            self.oldest = step.content;
        }
    }
}

/// Those that somebody else has enabled again stay.
fn despawn(world: &mut World, entities: impl Iterator<Item = Entity>) {
    for entity in entities {
        if world.get_entity(entity).is_ok_and(|entity| entity.contains::<Disabled>()) {
            world.despawn(entity);
        }
    }
}

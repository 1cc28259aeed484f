//! Edits of the scene, with undo and redo.
//!
//! An edit goes through the World and change detection does the rest: nothing here knows tables or pictures.

mod accuracy;
mod add;
mod edit;
mod history;
mod place;
mod replace;

#[cfg(test)]
mod tests;

use core::any::type_name;

use bevy_ecs::entity_disabling::Disabled;
use bevy_ecs::prelude::*;

use crate::components::{CameraPose, Lens, Sampling, Snapshot};
use crate::systems::Muted;

use edit::{ComponentEdit, Presence, ResourceEdit};
use history::{History, Step};

pub(crate) use accuracy::{Traced, accuracy, own_level};
pub(crate) use add::New;
pub(crate) use place::significant;

/// What the user has done to the World, and what is selected.
#[derive(Default)]
pub(crate) struct Editor {
    history: History,
    selected: Option<Entity>,
    arrivals: u64,
}

/// A resource that can be edited.
pub(crate) trait Setting: Resource + Clone + PartialEq {
    /// Whether a scene file holds it.
    const IS_IN_FILE: bool;
}

impl Setting for Snapshot {
    const IS_IN_FILE: bool = true;
}

impl Setting for Sampling {
    const IS_IN_FILE: bool = false;
}

impl Setting for Muted {
    const IS_IN_FILE: bool = false;
}

impl Editor {
    /// The selected entity. It may have been despawned since by somebody else, see [`look`](Self::look).
    pub(crate) fn selected(&self) -> Option<Entity> {
        self.selected
    }

    /// Selects an entity, or none.
    pub(crate) fn select(&mut self, entity: Option<Entity>) {
        self.selected = entity;
    }

    /// Lets the selection go if its entity is not there any more.
    pub(crate) fn look(&mut self, world: &World) {
        self.selected = self.selected.filter(|&entity| is_there(world, entity));
    }

    /// Gives a component of an entity another value, adds it, or with `None` removes it. Further changes of the same
    /// component belong to the same step until [`end_gesture`](Self::end_gesture).
    pub(crate) fn change<C: Component + Clone + PartialEq>(
        &mut self,
        world: &mut World,
        entity: Entity,
        new: Option<C>,
    ) {
        let Ok(now) = world.get_entity(entity).map(|entity| entity.get::<C>().cloned()) else { return };
        if now == new {
            return;
        }
        let mut edit = ComponentEdit { entity, before: now, after: new };
        edit::Edit::make(&edit, world);
        match self.history.open_edit::<ComponentEdit<C>>() {
            Some(open) if open.entity == entity => open.after = edit.after.take(),
            _ => self.begin_gesture(world, Step::new(short_name::<C>()).and(edit)),
        }
    }

    /// Gives a setting another value, like [`change`](Self::change).
    pub(crate) fn change_setting<R: Setting>(&mut self, world: &mut World, new: R) {
        let now = world.get_resource::<R>().cloned();
        if now.as_ref() == Some(&new) {
            return;
        }
        let mut edit = ResourceEdit { before: now, after: Some(new) };
        edit::Edit::make(&edit, world);
        if let Some(open) = self.history.open_edit::<ResourceEdit<R>>() {
            open.after = edit.after.take();
            return;
        }
        let step = Step::new(short_name::<R>()).and(edit);
        self.begin_gesture(world, if R::IS_IN_FILE { step } else { step.outside_the_file() });
    }

    fn begin_gesture(&mut self, world: &mut World, step: Step) {
        self.history.push(world, step);
        self.history.open();
    }

    /// Ends a drag, or whatever else should be one step: the next change begins another.
    pub(crate) fn end_gesture(&mut self) {
        self.history.close();
    }

    /// Removes the selected entity. The camera stays: there must be one.
    pub(crate) fn delete(&mut self, world: &mut World) -> bool {
        let Some(entity) =
            self.selected.filter(|&entity| is_there(world, entity) && !is_camera(world, entity))
        else {
            return false;
        };
        let edit = Presence { entities: vec![entity], present: false };
        edit::Edit::make(&edit, world);
        self.selected = None;
        self.commit(world, Step::new("delete").and(edit));
        true
    }

    /// Takes the newest step back and tells what it was.
    pub(crate) fn undo(&mut self, world: &mut World) -> Option<&'static str> {
        let what = self.history.undo(world);
        self.after_travel(world);
        what
    }

    /// Makes the step again that was taken back last, and tells what it is.
    pub(crate) fn redo(&mut self, world: &mut World) -> Option<&'static str> {
        let what = self.history.redo(world);
        self.after_travel(world);
        what
    }

    fn after_travel(&mut self, world: &World) {
        self.arrivals += 1;
        self.look(world);
    }

    /// What [`undo`](Self::undo) would take back: a component, or what was done.
    pub(crate) fn undoes(&self) -> Option<&'static str> {
        self.history.next()[0]
    }

    /// What [`redo`](Self::redo) would do again.
    pub(crate) fn redoes(&self) -> Option<&'static str> {
        self.history.next()[1]
    }

    /// The number of the newest step, which grows with each, and what it is.
    pub(crate) fn newest(&self) -> Option<(u64, &'static str)> {
        self.history.newest()
    }

    /// Whether the scene differs from the file, as far as a file can hold it.
    pub(crate) fn is_modified(&self) -> bool {
        !self.history.is_saved()
    }

    /// Says that the scene is now what the file holds.
    pub(crate) fn mark_saved(&mut self) {
        self.history.mark_saved();
    }

    /// A number that changes whenever edits may have made entities come or go.
    pub(crate) fn arrivals(&self) -> u64 {
        self.arrivals
    }

    /// Adds a step that makes entities come or go.
    fn commit(&mut self, world: &mut World, step: Step) {
        self.arrivals += 1;
        self.history.push(world, step);
    }
}

/// Whether an entity is in the World and not hidden.
fn is_there(world: &World, entity: Entity) -> bool {
    world.get_entity(entity).is_ok_and(|entity| !entity.contains::<Disabled>())
}

/// Whether an entity is part of the one camera.
pub(crate) fn is_camera(world: &World, entity: Entity) -> bool {
    world.get_entity(entity).is_ok_and(|entity| entity.contains::<CameraPose>() || entity.contains::<Lens>())
}

/// The name of a type without its path.
fn short_name<C>() -> &'static str {
    let name = type_name::<C>();
    name.rsplit("::").next().unwrap_or(name)
}

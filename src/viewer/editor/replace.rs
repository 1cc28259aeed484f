//! Hot reload: the whole scene by another one, in one step.

use bevy_ecs::prelude::*;

use crate::components::{CameraPose, Checkerboard, Cube, Lens, Light, Pyramid, Snapshot, Sphere, Textured};
use crate::scene::{Description, describe, spawn};

use super::Editor;
use super::edit::{ComponentEdit, Edit, Presence, ResourceEdit};
use super::history::Step;

type IsScene = Or<(With<Sphere>, With<Cube>, With<Pyramid>, With<Checkerboard>, With<Light>)>;

impl Editor {
    /// Puts what a file says in place of all objects and lights, in one step, and takes lens and [`Snapshot`] from it.
    /// The camera stays where it is, and boards stay textured. Nothing is done if the World says the same already;
    /// tells whether something was. Either way the scene then counts as saved.
    pub(crate) fn replace_scene(&mut self, world: &mut World, description: &Description) -> bool {
        let differs = describe(world).ok().as_ref() != Some(description);
        if differs {
            let step = replace(world, description);
            self.commit(world, step);
            self.look(world);
        }
        self.mark_saved();
        differs
    }
}

fn replace(world: &mut World, description: &Description) -> Step {
    let cameras = entities::<With<CameraPose>>(world);
    let textured = world.query::<&Textured>().iter(world).next().cloned();
    let snapshot = world.get_resource::<Snapshot>().copied();
    let gone = Presence { entities: entities::<IsScene>(world), present: false };
    gone.make(world);

    spawn(world, description);
    if let Some(textured) = textured {
        for board in entities::<With<Checkerboard>>(world) {
            world.entity_mut(board).insert(textured.clone());
        }
    }
    let mut come = Presence { entities: entities::<IsScene>(world), present: true };
    let snapshot = ResourceEdit { before: snapshot, after: world.get_resource::<Snapshot>().copied() };
    let spawned = entities::<With<CameraPose>>(world).into_iter().filter(|camera| !cameras.contains(camera));
    let mut step = Step::new("reload").and(gone).and(snapshot);
    for new in spawned {
        match cameras.first() {
            Some(&camera) => step = step.and(take_lens(world, new, camera)),
            None => come.entities.push(new),
        }
    }
    step.and(come)
}

fn entities<F: bevy_ecs::query::QueryFilter>(world: &mut World) -> Vec<Entity> {
    world.query_filtered::<Entity, F>().iter(world).collect()
}

/// Gives the lens of a new camera to the old one and despawns the new one.
fn take_lens(world: &mut World, new: Entity, camera: Entity) -> ComponentEdit<Lens> {
    let [before, after] = [camera, new].map(|entity| world.get::<Lens>(entity).copied());
    world.despawn(new);
    let edit = ComponentEdit { entity: camera, before, after };
    edit.make(world);
    edit
}

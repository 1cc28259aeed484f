//! Single changes of the World, each of which can be made and taken back.

use core::any::Any;

use bevy_ecs::entity_disabling::Disabled;
use bevy_ecs::prelude::*;

use crate::components::{Checkerboard, Cube, Light, Pyramid, Sphere};

/// Something that was done to the World.
pub(super) trait Edit: Any + Send + Sync {
    /// Does it (again).
    fn make(&self, world: &mut World);

    /// Takes it back.
    fn take_back(&self, world: &mut World);

    /// Whether it leaves the World as it was.
    fn is_empty(&self) -> bool;

    /// Entities that are hidden while it is made, or while it is not: only the step can bring them back then.
    fn hides(&self, while_made: bool) -> &[Entity];
}

/// One component of one entity: another value, a new one, or none any more.
pub(super) struct ComponentEdit<C> {
    pub(super) entity: Entity,
    pub(super) before: Option<C>,
    pub(super) after: Option<C>,
}

impl<C: Component + Clone + PartialEq> Edit for ComponentEdit<C> {
    fn make(&self, world: &mut World) {
        put(world, self.entity, self.after.as_ref());
    }

    fn take_back(&self, world: &mut World) {
        put(world, self.entity, self.before.as_ref());
    }

    fn is_empty(&self) -> bool {
        self.before == self.after
    }

    fn hides(&self, _while_made: bool) -> &[Entity] {
        &[]
    }
}

/// An entity that the scene's own systems have despawned is left alone.
pub(super) fn put<C: Component + Clone>(world: &mut World, entity: Entity, value: Option<&C>) {
    if let Ok(mut entity) = world.get_entity_mut(entity) {
        match value {
            Some(value) => entity.insert(value.clone()),
            None => entity.remove::<C>(),
        };
    }
}

/// A setting of the whole picture.
pub(super) struct ResourceEdit<R> {
    pub(super) before: Option<R>,
    pub(super) after: Option<R>,
}

impl<R: Resource + Clone + PartialEq> Edit for ResourceEdit<R> {
    fn make(&self, world: &mut World) {
        set(world, self.after.as_ref());
    }

    fn take_back(&self, world: &mut World) {
        set(world, self.before.as_ref());
    }

    fn is_empty(&self) -> bool {
        self.before == self.after
    }

    fn hides(&self, _while_made: bool) -> &[Entity] {
        &[]
    }
}

pub(super) fn set<R: Resource + Clone>(world: &mut World, value: Option<&R>) {
    match value {
        Some(value) => world.insert_resource(value.clone()),
        None => drop(world.remove_resource::<R>()),
    }
}

/// Entities that come, or go. They are not despawned but disabled, so that no query finds them: their ids stay good,
/// and so does whatever else a program has put into them.
pub(super) struct Presence {
    pub(super) entities: Vec<Entity>,
    /// Whether they are there once this is made.
    pub(super) present: bool,
}

impl Edit for Presence {
    fn make(&self, world: &mut World) {
        present(world, &self.entities, self.present);
    }

    fn take_back(&self, world: &mut World) {
        present(world, &self.entities, !self.present);
    }

    fn is_empty(&self) -> bool {
        self.entities.is_empty()
    }

    fn hides(&self, while_made: bool) -> &[Entity] {
        if while_made == self.present { &[] } else { &self.entities }
    }
}

fn present(world: &mut World, entities: &[Entity], present: bool) {
    for &entity in entities {
        let Ok(mut entity) = world.get_entity_mut(entity) else { continue };
        if present {
            entity.remove::<Disabled>();
            mark_changed(&mut entity);
        } else {
            entity.insert(Disabled);
        }
    }
}

/// Change detection hears of entities that come or go by counting them: one that comes back while another goes would
/// be missed.
fn mark_changed(entity: &mut EntityWorldMut<'_>) {
    mark::<Sphere>(entity);
    mark::<Cube>(entity);
    mark::<Pyramid>(entity);
    mark::<Checkerboard>(entity);
    mark::<Light>(entity);
}

fn mark<C: Component<Mutability = bevy_ecs::component::Mutable>>(entity: &mut EntityWorldMut<'_>) {
    if let Some(mut component) = entity.get_mut::<C>() {
        component.set_changed();
    }
}

//! Run conditions: whether entities of a kind changed, came or went since the last look.

use bevy_ecs::lifecycle::RemovedComponents;
use bevy_ecs::prelude::*;
use bevy_ecs::system::SystemParam;

use crate::components::{
    Ambient, Color, Diffuse, Falloff, Gloss, Light, Mirror, Order, Position, SpotCone, Textured,
};

type ObjectChange<S> = Or<(
    Changed<S>,
    Changed<Position>,
    Changed<Color>,
    Changed<Ambient>,
    Changed<Diffuse>,
    Changed<Gloss>,
    Changed<Mirror>,
    Changed<Textured>,
    Changed<Order>,
)>;

type LightChange =
    Or<(Changed<Light>, Changed<Position>, Changed<Falloff>, Changed<SpotCone>, Changed<Order>)>;

#[derive(SystemParam)]
pub(super) struct ObjectChanges<'w, 's, S: Component> {
    changed: Query<'w, 's, (), (With<S>, ObjectChange<S>)>,
    living: Living<'w, 's, S>,
    matte: (
        RemovedComponents<'w, 's, Color>,
        RemovedComponents<'w, 's, Ambient>,
        RemovedComponents<'w, 's, Diffuse>,
    ),
    effects: (
        RemovedComponents<'w, 's, Gloss>,
        RemovedComponents<'w, 's, Mirror>,
        RemovedComponents<'w, 's, Textured>,
    ),
    place: (RemovedComponents<'w, 's, Position>, RemovedComponents<'w, 's, Order>),
}

#[derive(SystemParam)]
pub(super) struct LightChanges<'w, 's> {
    changed: Query<'w, 's, (), (With<Light>, LightChange)>,
    living: Living<'w, 's, Light>,
    effects: (RemovedComponents<'w, 's, Falloff>, RemovedComponents<'w, 's, SpotCone>),
    place: (RemovedComponents<'w, 's, Position>, RemovedComponents<'w, 's, Order>),
}

/// How many entities have a component. Together with additions, which are changes, this notices every despawn,
/// even one whose report was cleared in between.
#[derive(SystemParam)]
pub(super) struct Living<'w, 's, S: Component> {
    entities: Query<'w, 's, (), With<S>>,
    before: Local<'s, usize>,
    removed: RemovedComponents<'w, 's, S>,
}

impl<S: Component> Living<'_, '_, S> {
    fn differ(&mut self) -> bool {
        let now = self.entities.iter().len();
        let before = core::mem::replace(&mut *self.before, now);
        drain(&mut self.removed) | (now != before)
    }
}

/// Whether the table of objects with shape `S` is out of date. Every report is read to its end, so that none
/// counts twice: hence `|`, not `||`.
pub(super) fn objects_changed<S: Component>(mut changes: ObjectChanges<S>) -> bool {
    let (color, ambient, diffuse) = &mut changes.matte;
    let (gloss, mirror, textured) = &mut changes.effects;
    let (position, order) = &mut changes.place;
    !changes.changed.is_empty()
        | changes.living.differ()
        | drain(color)
        | drain(ambient)
        | drain(diffuse)
        | drain(gloss)
        | drain(mirror)
        | drain(textured)
        | drain(position)
        | drain(order)
}

/// Whether the light table is out of date.
pub(super) fn lights_changed(mut changes: LightChanges) -> bool {
    let (falloff, cone) = &mut changes.effects;
    let (position, order) = &mut changes.place;
    !changes.changed.is_empty()
        | changes.living.differ()
        | drain(falloff)
        | drain(cone)
        | drain(position)
        | drain(order)
}

/// Reads all reports of a removed component; whether there were any.
fn drain<C: Component>(removed: &mut RemovedComponents<C>) -> bool {
    let any = !removed.is_empty();
    removed.clear();
    any
}

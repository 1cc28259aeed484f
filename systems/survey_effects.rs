//! Which effects the World asks for.

use bevy_ecs::archetype::Archetypes;
use bevy_ecs::component::Components;
use bevy_ecs::entity_disabling::Disabled;
use bevy_ecs::prelude::*;

use crate::components;
use crate::effects::{Effect, EffectSet, survey};

use super::Muted;

macro_rules! define_carriers {
    ({ $($effect:ident $name:ident: $component:ident [$($stage:ident)*] $what:literal;)* }) => {
        /// Which component stands for which effect.
        const CARRIERS: [Carrier; Effect::ALL.len()] =
            [$(Carrier::of::<components::$component>(Effect::$effect),)*];
    };
}

survey!(all, define_carriers);

/// How many living entities carry each effect, whatever its value.
#[derive(Resource, Clone, Debug, Default, PartialEq, Eq)]
pub struct Survey {
    entities: Vec<(Effect, usize)>,
    muted: EffectSet,
}

impl Survey {
    /// The effects that some entity carries, but for those that are switched off.
    pub fn asked(&self) -> EffectSet {
        let carried = self.entities.iter().filter(|(_, entities)| *entities > 0).map(|&(effect, _)| effect);
        carried.filter(|&effect| !self.muted.contains(effect)).collect()
    }

    /// How many entities carry an effect.
    pub fn entities(&self, effect: Effect) -> usize {
        self.entities.iter().filter(|entry| entry.0 == effect).map(|entry| entry.1).sum()
    }
}

/// Counts the carriers of every effect: one step an archetype, none an entity.
pub(super) fn survey_effects(
    archetypes: &Archetypes,
    components: &Components,
    muted: Res<Muted>,
    mut survey: ResMut<Survey>,
) {
    let found = CARRIERS.map(|carrier| (carrier.effect, (carrier.count)(archetypes, components)));
    survey.set_if_neq(Survey { entities: found.to_vec(), muted: muted.0 });
}

/// The entities that carry an effect.
pub fn carriers_of(world: &mut World, effect: Effect) -> Vec<Entity> {
    let carriers = CARRIERS.iter().filter(|carrier| carrier.effect == effect);
    carriers.flat_map(|carrier| (carrier.entities)(world)).collect()
}

/// Takes an effect away from every entity that carries it: the scene as it would be without.
pub fn take_away(world: &mut World, effect: Effect) {
    for carrier in CARRIERS.iter().filter(|carrier| carrier.effect == effect) {
        (carrier.remove)(world);
    }
}

/// What is done with a component without knowing it.
struct Carrier {
    effect: Effect,
    count: fn(&Archetypes, &Components) -> usize,
    entities: fn(&mut World) -> Vec<Entity>,
    remove: fn(&mut World),
}

impl Carrier {
    const fn of<C: Component>(effect: Effect) -> Self {
        Self { effect, count: count::<C>, entities: entities::<C>, remove: remove::<C> }
    }
}

/// An archetype stays registered when its last entity is gone, so it is the number of entities that counts.
fn count<C: Component>(archetypes: &Archetypes, components: &Components) -> usize {
    let Some(carried) = components.component_id::<C>() else { return 0 };
    let disabled = components.component_id::<Disabled>();
    let living = archetypes.iter().filter(|archetype| {
        archetype.contains(carried) && !disabled.is_some_and(|disabled| archetype.contains(disabled))
    });
    living.map(|archetype| archetype.len() as usize).sum()
}

fn entities<C: Component>(world: &mut World) -> Vec<Entity> {
    world.query_filtered::<Entity, With<C>>().iter(world).collect()
}

fn remove<C: Component>(world: &mut World) {
    for entity in entities::<C>(world) {
        world.entity_mut(entity).remove::<C>();
    }
}

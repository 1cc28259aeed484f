//! Which effects the World asks for.

use bevy_ecs::archetype::Archetypes;
use bevy_ecs::component::{ComponentId, Components};
use bevy_ecs::entity_disabling::Disabled;
use bevy_ecs::prelude::*;

use crate::components::{Falloff, Gloss, Mirror, SpotCone, Textured};
use crate::effects::{Effect, EffectSet};

/// How many living entities carry each effect, whatever its value.
#[derive(Resource, Clone, Debug, Default, PartialEq, Eq)]
pub struct Survey {
    entities: Vec<(Effect, usize)>,
}

impl Survey {
    /// The effects that some entity carries.
    pub fn asked(&self) -> EffectSet {
        self.entities.iter().filter(|(_, entities)| *entities > 0).map(|&(effect, _)| effect).collect()
    }

    /// How many entities carry an effect.
    pub fn entities(&self, effect: Effect) -> usize {
        self.entities.iter().filter(|entry| entry.0 == effect).map(|entry| entry.1).sum()
    }
}

/// Counts the carriers of every effect: one step an archetype, none an entity. An archetype stays registered when its last
/// entity is gone, so it is the number of entities that counts.
pub(super) fn survey_effects(archetypes: &Archetypes, components: &Components, mut survey: ResMut<Survey>) {
    let world = Population { archetypes, components };
    let found = Survey {
        entities: vec![
            (Effect::Gloss, world.carriers::<Gloss>()),
            (Effect::Mirror, world.carriers::<Mirror>()),
            (Effect::Texture, world.carriers::<Textured>()),
            (Effect::Falloff, world.carriers::<Falloff>()),
            (Effect::SpotCone, world.carriers::<SpotCone>()),
        ],
    };
    survey.set_if_neq(found);
}

struct Population<'w> {
    archetypes: &'w Archetypes,
    components: &'w Components,
}

impl Population<'_> {
    fn carriers<C: Component>(&self) -> usize {
        let Some(carried) = self.components.component_id::<C>() else { return 0 };
        let disabled: Option<ComponentId> = self.components.component_id::<Disabled>();
        let living = self.archetypes.iter().filter(|archetype| {
            archetype.contains(carried) && !disabled.is_some_and(|disabled| archetype.contains(disabled))
        });
        living.map(|archetype| archetype.len() as usize).sum()
    }
}

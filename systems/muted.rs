//! Effects that are switched off.

use bevy_ecs::prelude::*;

use crate::effects::{Effect, EffectSet};

/// Effects that are extracted as if no entity carried them: what a scene would be without.
#[derive(Resource, Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Muted(pub EffectSet);

impl Muted {
    /// A component, unless its effect is switched off.
    pub(super) fn hear<C>(self, effect: Effect, component: Option<C>) -> Option<C> {
        component.filter(|_| !self.0.contains(effect))
    }
}

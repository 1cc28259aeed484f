//! How often systems worked for effects.

use std::collections::BTreeMap;

use crate::effects::{Effect, EffectSet};

/// How many runs of systems there have been for each effect: runs that found a row of it to make. A run that only looks at
/// what changed elsewhere counts for nobody.
#[derive(Clone, Debug, Default)]
pub(super) struct Runs(BTreeMap<Effect, u64>);

impl Runs {
    /// One more run, for each of these.
    pub(super) fn note(&mut self, effects: EffectSet) {
        for effect in effects.iter() {
            *self.0.entry(effect).or_default() += 1;
        }
    }

    /// Runs for an effect.
    pub(super) fn of(&self, effect: Effect) -> u64 {
        self.0.get(&effect).copied().unwrap_or(0)
    }
}

//! What can be wrong with a World.

use core::fmt::{self, Display, Formatter};

use bevy_ecs::prelude::*;
use glam::DVec3;
use thiserror::Error;

use crate::components::range::{COORDINATE, Range};
use crate::effects::{Effect, EffectComponent, EffectSet, Number};

/// A number as one writes it: with an exponent in place of dozens of zeros.
fn short(value: f64) -> String {
    let plain = value.to_string();
    if plain.len() > 24 { format!("{value:e}") } else { plain }
}

/// Something in the World that cannot be traced. Nothing is traced while there is one.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum WorldProblem {
    /// A value outside what its component allows.
    #[error("entity {entity}: {value} is {}, but must be {allowed}", short(*found))]
    Value {
        /// The entity.
        entity: Entity,
        /// Component and field.
        value: &'static str,
        /// The value.
        found: f64,
        /// What is allowed, in words.
        allowed: &'static str,
    },
    /// Lengths that only `f64` can trace.
    #[error(
        "{least} and {greatest} are too far apart for {precision}: it traces lengths up to {ratio:e} times the least"
    )]
    Precision {
        /// The least length.
        least: Measure,
        /// The greatest length, coordinate or way.
        greatest: Measure,
        /// The precision asked for.
        precision: &'static str,
        /// The greatest by the least length that it can always trace.
        ratio: f64,
    },
    /// An object or light that had a component taken away that it cannot be traced without.
    #[error("entity {entity}: a {kind} needs {needs}, and not all of that is there")]
    Incomplete {
        /// The entity.
        entity: Entity,
        /// Its shape, or `Light`.
        kind: &'static str,
        /// Components that it needs.
        needs: &'static str,
    },
    /// A spotlight that points nowhere.
    #[error(
        "entity {entity}: SpotCone.target is, in {precision}, the light's own position: the cone has no direction"
    )]
    NoDirection {
        /// The entity.
        entity: Entity,
        /// The precision asked for.
        precision: &'static str,
    },
    /// A direction that is none.
    #[error("entity {entity}: {value} is zero, which is no direction")]
    Zero {
        /// The entity.
        entity: Entity,
        /// Component and field.
        value: &'static str,
    },
    /// A surface that sends on more light than it receives.
    #[error("entity {entity}: Mirror and Glass.transmission add up to {found}, but must not exceed 1")]
    Excess {
        /// The entity.
        entity: Entity,
        /// The sum.
        found: f64,
    },
    /// More than one of what there is at most one of.
    #[error("the World must have no more than one {kind}, but has {found}")]
    Surplus {
        /// The component.
        kind: &'static str,
        /// How many there are.
        found: usize,
    },
    /// A camera that is no basis.
    #[error("entity {entity}: CameraPose l, r and u must be unit vectors at right angles, with u = r x l")]
    NoBasis {
        /// The entity.
        entity: Entity,
    },
    /// Clipping planes in the wrong order.
    #[error("entity {entity}: Lens.far is {}, but must be greater than Lens.near, {}", short(*far), short(*near))]
    Planes {
        /// The entity.
        entity: Entity,
        /// Distance of the near plane.
        near: f64,
        /// Distance of the far plane.
        far: f64,
    },
    /// A shutter that closes before it opens.
    #[error("entity {entity}: Shutter.close is {close}, but must not be before Shutter.open, {open}")]
    ShutterOrder {
        /// The entity.
        entity: Entity,
        /// When it opens.
        open: f64,
        /// When it closes.
        close: f64,
    },
    /// Effects of which this program has no code.
    #[error("the World asks for {effects}, but this program was built without (ARCHETRACE_WITHOUT)")]
    NotCompiled {
        /// Their names.
        effects: String,
    },
    /// No camera, or more than one.
    #[error("the World must have one camera (an entity with CameraPose and Lens), but has {found}")]
    Cameras {
        /// How many there are.
        found: usize,
    },
    /// A picture of an impossible size, depth or number of samples.
    #[error("{value} is {found}, but must be from {low} to {high}")]
    Setting {
        /// Resource and field.
        value: &'static str,
        /// The value.
        found: u32,
        /// Least allowed.
        low: u32,
        /// Most allowed.
        high: u32,
    },
}

/// A length in the World.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measure {
    /// Whose it is.
    pub entity: Entity,
    /// Component and field.
    pub value: &'static str,
    /// The length, in world units; of a point the greatest coordinate, without its sign.
    pub found: f64,
}

impl Display for Measure {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "{:e} (entity {}: {})", self.found, self.entity, self.value)
    }
}

/// What is wrong with a World that asks for effects of which a program has no code.
pub(super) fn lacking(asked: EffectSet, compiled: EffectSet) -> Option<WorldProblem> {
    let effects = asked.minus(compiled);
    (!effects.is_empty()).then(|| {
        let names: Vec<_> = effects.iter().map(Effect::name).collect();
        WorldProblem::NotCompiled { effects: names.join(", ") }
    })
}

/// Checks values of one entity after the other and keeps what is wrong.
#[derive(Default)]
pub(super) struct Checks {
    pub(super) problems: Vec<WorldProblem>,
}

impl Checks {
    /// A number in its range.
    pub(super) fn value(&mut self, entity: Entity, value: &'static str, found: f64, range: &Range) {
        if !range.contains(found) {
            self.problems.push(WorldProblem::Value { entity, value, found, allowed: range.words });
        }
    }

    /// All numbers of a component in their ranges.
    pub(super) fn numbers(&mut self, entity: Entity, component: &impl EffectComponent) {
        for Number { name, found, allowed } in component.numbers() {
            self.value(entity, name, found, allowed);
        }
    }

    /// Coordinates in their range.
    pub(super) fn point(&mut self, entity: Entity, value: &'static str, point: DVec3) {
        for found in point.to_array() {
            self.value(entity, value, found, &COORDINATE);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_effect_that_a_program_was_built_without_is_named() {
        for effect in Effect::ALL {
            let compiled = EffectSet::ALL.without(effect);
            let problem = lacking(EffectSet::ALL, compiled).unwrap();
            assert_eq!(problem, WorldProblem::NotCompiled { effects: effect.name().to_owned() });
            assert!(problem.to_string().starts_with(&format!("the World asks for {}, but", effect.name())));
            assert_eq!(lacking(compiled, compiled), None, "{effect:?} is not asked for");
        }
        let two = EffectSet::of(&[Effect::Mirror, Effect::Fog]);
        let effects = "mirror, fog".to_owned();
        assert_eq!(lacking(two, EffectSet::NONE), Some(WorldProblem::NotCompiled { effects }));
        assert_eq!(lacking(EffectSet::NONE, EffectSet::NONE), None);
    }
}

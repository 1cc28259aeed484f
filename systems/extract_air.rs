//! Background, fog and what else surrounds all objects, to the tables.

use std::sync::Arc;

use bevy_ecs::prelude::*;

use crate::components;
use crate::effects::{Bearer, Effect, EffectComponent, survey};
use crate::geometry::Real;
use crate::trace::{Air, SceneTables};

use super::carried::visible;
use super::problem::{Checks, WorldProblem};
use super::{Muted, Tables};

macro_rules! define_queries {
    ({ $($effect:ident $name:ident: $component:ident [$($stage:ident)*] $what:literal;)* }) => {
        /// Everyone that carries one of the components.
        pub(super) type Queries<'w, 's> = ($(Query<'w, 's, (Entity, &'static components::$component)>,)*);

        /// The one of each kind that there may be, without those that would show nothing.
        fn found<T: Real>(
            ($($name,)*): &Queries<'_, '_>,
            muted: Muted,
            bearer: &Bearer<'_>,
            checks: &mut Checks,
        ) -> Air<T> {
            let mut air = Air::default();
            $(
                let heard = muted.hear(Effect::$effect, only(stringify!($component), $name, checks));
                if let Some((entity, component)) = heard {
                    checks.numbers(entity, component);
                    air.$name = visible(Some(component)).and_then(|component| component.row(bearer));
                }
            )*
            air
        }
    };
}

survey!(air, define_queries);

/// Extracts what surrounds all objects.
pub(super) fn extract_air<T: Real>(queries: Queries, muted: Res<Muted>, mut tables: ResMut<Tables<T>>) {
    let mut checks = Checks::default();
    tables.revision += 1;
    let SceneTables { air, unit, .. } = Arc::make_mut(&mut tables.scene);
    *air = found(&queries, *muted, &Bearer { unit: *unit, ..Bearer::default() }, &mut checks);
    let made = air.set();
    tables.runs.note(made);
    tables.mark_extracted("Air", checks.problems);
}

/// The one component of its kind, if any.
fn only<'a, C: Component>(
    kind: &'static str,
    all: &'a Query<(Entity, &C)>,
    checks: &mut Checks,
) -> Option<(Entity, &'a C)> {
    let found = all.iter().len();
    if found > 1 {
        checks.problems.push(WorldProblem::Surplus { kind, found });
    }
    all.iter().next()
}

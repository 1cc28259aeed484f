//! Background and fog to the tables.

use std::sync::Arc;

use bevy_ecs::prelude::*;
use glam::DVec3;

use crate::components::range::{COLOR, DENSITY};
use crate::components::{Background, Fog};
use crate::effects::{Effect, Gradient, Haze, Rgb};
use crate::geometry::{Real, Unit};
use crate::trace::SceneTables;

use super::problem::{Checks, WorldProblem};
use super::{Muted, Tables};

/// Extracts the one background and the one fog that there may be, without those that would show nothing.
pub(super) fn extract_air<T: Real>(
    backgrounds: Query<(Entity, &Background)>,
    fogs: Query<(Entity, &Fog)>,
    muted: Res<Muted>,
    mut tables: ResMut<Tables<T>>,
) {
    let mut checks = Checks::default();
    let background = muted.hear(Effect::Background, only("Background", &backgrounds, &mut checks));
    let fog = muted.hear(Effect::Fog, only("Fog", &fogs, &mut checks));
    tables.revision += 1;
    let SceneTables { air, unit, .. } = Arc::make_mut(&mut tables.scene);
    let unit = *unit;
    air.background = background.and_then(|(entity, background)| gradient(entity, background, &mut checks));
    air.haze = fog.and_then(|(entity, fog)| haze(entity, fog, unit, &mut checks));
    let made = air.effects();
    tables.runs.note(made);
    tables.mark_extracted("Air", checks.problems);
}

/// The one component of its kind, if any.
fn only<C: Component + Copy>(
    kind: &'static str,
    all: &Query<(Entity, &C)>,
    checks: &mut Checks,
) -> Option<(Entity, C)> {
    let found = all.iter().len();
    if found > 1 {
        checks.problems.push(WorldProblem::Surplus { kind, found });
    }
    all.iter().next().map(|(entity, &component)| (entity, component))
}

fn gradient<T: Real>(
    entity: Entity,
    Background { below, above }: Background,
    checks: &mut Checks,
) -> Option<Gradient<T>> {
    check_color(entity, "Background.below", below, checks);
    check_color(entity, "Background.above", above, checks);
    let is_black = below == DVec3::ZERO && above == DVec3::ZERO;
    (!is_black).then(|| Gradient { below: Rgb::from_dvec3(below), above: Rgb::from_dvec3(above) })
}

fn haze<T: Real>(
    entity: Entity,
    Fog { density, color }: Fog,
    unit: Unit,
    checks: &mut Checks,
) -> Option<Haze<T>> {
    checks.value(entity, "Fog.density", density, &DENSITY);
    check_color(entity, "Fog.color", color, checks);
    // Beyond the largest number, the density times a distance of 0 would be NaN.
    let dense = |density| T::from_f64(unit.per_length(density)).at_most(T::MAX);
    (density != 0.0).then(|| Haze { density: dense(density), color: Rgb::from_dvec3(color) })
}

fn check_color(entity: Entity, value: &'static str, color: DVec3, checks: &mut Checks) {
    for channel in color.to_array() {
        checks.value(entity, value, channel, &COLOR);
    }
}

//! Lights to their table.

use core::cmp::Ordering;

use std::sync::Arc;

use bevy_ecs::prelude::*;
use glam::DVec3;

use crate::components::{Directional, Light, Order, Position};
use crate::effects::{Bearer, cone_axis};
use crate::geometry::{Real, Unit, Vector};
use crate::trace::{LightEffects, LightRow, LightTable};

use super::carried::{LightCarried, LightData};
use super::problem::{Checks, WorldProblem};
use super::{Muted, Tables};

type Lights<'w, 's> =
    Query<'w, 's, (Entity, &'static Position, Option<&'static Order>, LightData), With<Light>>;

/// Rebuilds the light table, rows sorted by scene order and then by value. The order matters: it is the order in
/// which light is summed, and sums round.
pub(super) fn extract_lights<T: Real>(
    lights: Lights,
    incomplete: Query<Entity, (With<Light>, Without<Position>)>,
    muted: Res<Muted>,
    mut tables: ResMut<Tables<T>>,
) {
    let mut sources: Vec<_> = gather(&lights).into_iter().map(|source| source.without(*muted)).collect();
    sources.sort_by(Source::compare);
    let mut checks = Checks::default();
    let (kind, needs) = ("Light", "Position");
    let missing = incomplete.iter().map(|entity| WorldProblem::Incomplete { entity, kind, needs });
    checks.problems.extend(missing);
    let mut table = LightTable::default();
    let unit = tables.scene.unit;
    for source in sources {
        source.check(&mut checks);
        source.check_direction::<T>(unit, &mut checks);
        table.push(source.row(unit));
    }
    tables.revision += 1;
    tables.runs.note(table.effects.set());
    Arc::make_mut(&mut tables.scene).lights = table;
    tables.mark_extracted("Light", checks.problems);
}

/// One light as the World has it.
struct Source {
    entity: Entity,
    position: DVec3,
    order: u32,
    carried: LightCarried,
}

fn gather(lights: &Lights) -> Vec<Source> {
    let all = lights.iter().map(|(entity, position, order, carried)| Source {
        entity,
        position: position.0,
        order: order.map_or(u32::MAX, |order| order.0),
        carried: LightCarried::found(carried),
    });
    all.collect()
}

impl Source {
    /// The same without effects that are switched off.
    fn without(self, muted: Muted) -> Self {
        Self { carried: self.carried.without(muted), ..self }
    }

    fn compare(&self, other: &Self) -> Ordering {
        let pairs = self.position.to_array().into_iter().zip(other.position.to_array());
        let by_place = || pairs.map(|(a, b)| a.total_cmp(&b)).fold(Ordering::Equal, Ordering::then);
        self.order.cmp(&other.order).then_with(by_place).then_with(|| self.carried.compare(&other.carried))
    }

    fn check(&self, checks: &mut Checks) {
        let entity = self.entity;
        checks.point(entity, "Position", self.position);
        self.carried.check(entity, checks);
        if self.carried.directional == Some(Directional { direction: DVec3::ZERO }) {
            checks.problems.push(WorldProblem::Zero { entity, value: "Directional.direction" });
        }
    }

    /// Notes a cone whose direction this precision loses.
    fn check_direction<T: Real>(&self, unit: Unit, checks: &mut Checks) {
        let Some(cone) = self.carried.spot_cone.filter(|_| self.carried.directional.is_none()) else {
            return;
        };
        let axis: Vector<T> = cone_axis(unit.point(self.position), unit.point(cone.target));
        if axis == Vector::default() {
            checks.problems.push(WorldProblem::NoDirection { entity: self.entity, precision: T::NAME });
        }
    }

    /// The row, without effects that would change nothing.
    fn row<T: Real>(&self, unit: Unit) -> LightRow<T> {
        let position = unit.point(self.position);
        let effects: LightEffects<T> = self.carried.rows(&Bearer { position, unit, images: None });
        match effects.directional {
            // What a light does only if it is somewhere is not for this one.
            Some(_) => LightRow {
                position: Vector::default(),
                effects: LightEffects { falloff: None, spot_cone: None, area_light: None, ..effects },
            },
            None => LightRow { position: Vector::from_dvec3(position), effects },
        }
    }
}

//! Lights to their table.

use core::cmp::Ordering;

use std::sync::Arc;

use bevy_ecs::prelude::*;
use glam::DVec3;

use crate::components::range::{CUTOFF, FALLOFF};
use crate::components::{Falloff, Light, Order, Position, SpotCone};
use crate::effects::Cone;
use crate::geometry::{Real, Vector};
use crate::trace::{LightRow, LightTable};

use super::Tables;
use super::problem::{Checks, WorldProblem};

type Lights<'w, 's> = Query<
    'w,
    's,
    (Entity, &'static Position, Option<&'static Order>, Option<&'static Falloff>, Option<&'static SpotCone>),
    With<Light>,
>;

/// Rebuilds the light table, rows sorted by scene order and then by value. The order matters: it is the order in
/// which light is summed, and sums round.
pub(super) fn extract_lights<T: Real>(
    lights: Lights,
    incomplete: Query<Entity, (With<Light>, Without<Position>)>,
    mut tables: ResMut<Tables<T>>,
) {
    let mut sources = gather(&lights);
    sources.sort_by(Source::compare);
    let mut checks = Checks::default();
    let (kind, needs) = ("Light", "Position");
    let missing = incomplete.iter().map(|entity| WorldProblem::Incomplete { entity, kind, needs });
    checks.problems.extend(missing);
    let mut table = LightTable::default();
    for source in &sources {
        source.check::<T>(&mut checks);
        table.push(source.row());
    }
    tables.revision += 1;
    Arc::make_mut(&mut tables.scene).lights = table;
    tables.problems.insert("Light", checks.problems);
}

/// One light as the World has it.
struct Source {
    entity: Entity,
    position: DVec3,
    order: u32,
    falloff: Option<Falloff>,
    cone: Option<SpotCone>,
}

fn gather(lights: &Lights) -> Vec<Source> {
    let all = lights.iter().map(|(entity, position, order, falloff, cone)| Source {
        entity,
        position: position.0,
        order: order.map_or(u32::MAX, |order| order.0),
        falloff: falloff.copied(),
        cone: cone.copied(),
    });
    all.collect()
}

impl Source {
    fn compare(&self, other: &Self) -> Ordering {
        let by_value = || {
            let pairs = self.values().into_iter().zip(other.values());
            pairs.map(|(a, b)| a.total_cmp(&b)).find(|order| order.is_ne()).unwrap_or(Ordering::Equal)
        };
        self.order.cmp(&other.order).then_with(by_value)
    }

    fn values(&self) -> [f64; 8] {
        let falloff = self.falloff.map_or(0.0, |falloff| falloff.0);
        let (target, cutoff) = self.cone.map_or((DVec3::ZERO, 180.0), |cone| (cone.target, cone.cutoff));
        let p = self.position;
        [p.x, p.y, p.z, falloff, target.x, target.y, target.z, cutoff]
    }

    fn check<T: Real>(&self, checks: &mut Checks) {
        let entity = self.entity;
        checks.point::<T>(entity, "Position", self.position);
        if let Some(falloff) = self.falloff {
            checks.value(entity, "Falloff", falloff.0, &FALLOFF);
        }
        if let Some(cone) = self.cone {
            checks.point::<T>(entity, "SpotCone.target", cone.target);
            checks.value(entity, "SpotCone.cutoff", cone.cutoff, &CUTOFF);
            if axis::<T>(self.position, &cone) == Vector::default() {
                checks.problems.push(WorldProblem::NoDirection { entity, precision: T::NAME });
            }
        }
    }

    /// The row, without effects that would take nothing away.
    fn row<T: Real>(&self) -> LightRow<T> {
        let narrowing = self.cone.filter(|cone| cone.cutoff < 180.0);
        LightRow {
            position: Vector::from_dvec3(self.position),
            // Beyond the largest number, falloff times a distance of 0 would be NaN.
            falloff: self
                .falloff
                .filter(|falloff| falloff.0 != 0.0)
                .map(|f| T::from_f64(f.0).at_most(T::MAX)),
            cone: narrowing.map(|cone| Cone::new(axis(self.position, &cone), cone.cutoff)),
        }
    }
}

/// From the light to the point that its cone's axis runs through.
fn axis<T: Real>(position: DVec3, cone: &SpotCone) -> Vector<T> {
    Vector::from_dvec3(cone.target) - Vector::from_dvec3(position)
}

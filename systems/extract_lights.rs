//! Lights to their table.

use core::cmp::Ordering;

use std::sync::Arc;

use bevy_ecs::prelude::*;
use glam::DVec3;

use crate::components::range::{CUTOFF, EXTENT, FALLOFF, LIGHT_COLOR, LIGHT_SAMPLES};
use crate::components::{AreaLight, Directional, Falloff, Light, LightColor, Order, Position, SpotCone};
use crate::effects::{Ball, Cone, Effect, Rgb};
use crate::geometry::{Real, Unit, Vector};
use crate::trace::{LightRow, LightTable};

use super::problem::{Checks, WorldProblem};
use super::{Muted, Tables};

type LightData = (
    Entity,
    &'static Position,
    Option<&'static Order>,
    (Option<&'static Falloff>, Option<&'static SpotCone>),
    (Option<&'static LightColor>, Option<&'static Directional>, Option<&'static AreaLight>),
);
type Lights<'w, 's> = Query<'w, 's, LightData, With<Light>>;

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
        let source = source.in_unit(unit);
        source.check_direction::<T>(&mut checks);
        table.push(source.row());
    }
    tables.revision += 1;
    tables.runs.note(table.effects());
    Arc::make_mut(&mut tables.scene).lights = table;
    tables.mark_extracted("Light", checks.problems);
}

/// One light as the World has it.
struct Source {
    entity: Entity,
    position: DVec3,
    order: u32,
    falloff: Option<Falloff>,
    cone: Option<SpotCone>,
    color: Option<LightColor>,
    directional: Option<Directional>,
    area: Option<AreaLight>,
}

fn gather(lights: &Lights) -> Vec<Source> {
    let all =
        lights.iter().map(|(entity, position, order, (falloff, cone), (color, directional, area))| Source {
            entity,
            position: position.0,
            order: order.map_or(u32::MAX, |order| order.0),
            falloff: falloff.copied(),
            cone: cone.copied(),
            color: color.copied(),
            directional: directional.copied(),
            area: area.copied(),
        });
    all.collect()
}

impl Source {
    /// The same without effects that are switched off.
    fn without(self, muted: Muted) -> Self {
        Self {
            falloff: muted.hear(Effect::Falloff, self.falloff),
            cone: muted.hear(Effect::SpotCone, self.cone),
            color: muted.hear(Effect::LightColor, self.color),
            directional: muted.hear(Effect::Directional, self.directional),
            area: muted.hear(Effect::AreaLight, self.area),
            ..self
        }
    }

    fn compare(&self, other: &Self) -> Ordering {
        let by_value = || {
            let pairs = self.values().into_iter().zip(other.values());
            pairs.map(|(a, b)| a.total_cmp(&b)).find(|order| order.is_ne()).unwrap_or(Ordering::Equal)
        };
        self.order.cmp(&other.order).then_with(by_value)
    }

    fn values(&self) -> [f64; 16] {
        let falloff = self.falloff.map_or(0.0, |falloff| falloff.0);
        let (target, cutoff) = self.cone.map_or((DVec3::ZERO, 180.0), |cone| (cone.target, cone.cutoff));
        let color = self.color.map_or(DVec3::ONE, |color| color.0);
        let direction = self.directional.map_or(DVec3::ZERO, |directional| directional.direction);
        let (radius, samples) = self.area.map_or((0.0, 1), |area| (area.radius, area.samples));
        let p = self.position;
        let [x, y, z] = target.to_array();
        let [r, g, b] = color.to_array();
        let [i, j, k] = direction.to_array();
        [p.x, p.y, p.z, falloff, x, y, z, cutoff, r, g, b, i, j, k, radius, samples.into()]
    }

    fn check(&self, checks: &mut Checks) {
        let entity = self.entity;
        checks.point(entity, "Position", self.position);
        if let Some(falloff) = self.falloff {
            checks.value(entity, "Falloff", falloff.0, &FALLOFF);
        }
        if let Some(cone) = self.cone {
            checks.point(entity, "SpotCone.target", cone.target);
            checks.value(entity, "SpotCone.cutoff", cone.cutoff, &CUTOFF);
        }
        for channel in self.color.map_or([1.0; 3], |color| color.0.to_array()) {
            checks.value(entity, "LightColor", channel, &LIGHT_COLOR);
        }
        if let Some(Directional { direction }) = self.directional {
            let value = "Directional.direction";
            checks.point(entity, value, direction);
            if direction == DVec3::ZERO {
                checks.problems.push(WorldProblem::Zero { entity, value });
            }
        }
        if let Some(AreaLight { radius, samples }) = self.area {
            checks.value(entity, "AreaLight.radius", radius, &EXTENT);
            checks.value(entity, "AreaLight.samples", samples.into(), &LIGHT_SAMPLES);
        }
    }

    /// Notes a cone whose direction this precision loses.
    fn check_direction<T: Real>(&self, checks: &mut Checks) {
        let cone = self.cone.filter(|_| self.directional.is_none());
        if cone.is_some_and(|cone| axis::<T>(self.position, &cone) == Vector::default()) {
            checks.problems.push(WorldProblem::NoDirection { entity: self.entity, precision: T::NAME });
        }
    }

    /// The same in the unit of the tables.
    fn in_unit(self, unit: Unit) -> Self {
        Self {
            position: unit.point(self.position),
            falloff: self.falloff.map(|falloff| Falloff(unit.per_area(falloff.0))),
            cone: self.cone.map(|cone| SpotCone { target: unit.point(cone.target), ..cone }),
            area: self.area.map(|area| AreaLight { radius: unit.length(area.radius), ..area }),
            ..self
        }
    }

    /// The row, without effects that would change nothing.
    fn row<T: Real>(&self) -> LightRow<T> {
        let color = self.color.filter(|color| color.0 != DVec3::ONE).map(|color| Rgb::from_dvec3(color.0));
        let position = Vector::from_dvec3(self.position);
        match self.directional {
            Some(directional) => LightRow { color, toward: Some(toward(directional)), ..LightRow::default() },
            None => LightRow { position, color, ..self.local_row() },
        }
    }

    /// What a light does only if it is somewhere.
    fn local_row<T: Real>(&self) -> LightRow<T> {
        let narrowing = self.cone.filter(|cone| cone.cutoff < 180.0);
        let extended = self.area.filter(|area| area.radius != 0.0);
        LightRow {
            // Beyond the largest number, falloff times a distance of 0 would be NaN.
            falloff: self
                .falloff
                .filter(|falloff| falloff.0 != 0.0)
                .map(|f| T::from_f64(f.0).at_most(T::MAX)),
            cone: narrowing.map(|cone| Cone::new(axis(self.position, &cone), cone.cutoff)),
            ball: extended.map(|area| Ball { radius: T::from_f64(area.radius), samples: area.samples }),
            ..LightRow::default()
        }
    }
}

/// From the light to the point that its cone's axis runs through.
fn axis<T: Real>(position: DVec3, cone: &SpotCone) -> Vector<T> {
    Vector::from_dvec3(cone.target) - Vector::from_dvec3(position)
}

/// Against the light, unit.
fn toward<T: Real>(directional: Directional) -> Vector<T> {
    // In double first: in single its squares, or even itself, could underflow.
    let unit = Vector::<f64>::from_dvec3(-directional.direction).unit();
    Vector::<T>::from_dvec3(unit.to_dvec3()).unit()
}

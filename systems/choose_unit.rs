//! The unit in which tables keep lengths.

use std::sync::Arc;

use bevy_ecs::prelude::*;
use bevy_ecs::system::SystemParam;
use glam::DVec3;

use crate::components::range::{COORDINATE, EXTENT, LENGTH};
use crate::components::{
    CameraPose, Checkerboard, Cube, Lens, Light, Position, Pyramid, Shutter, Sphere, Velocity,
};
use crate::effects::{Effect, Number};
use crate::geometry::{Real, Unit};

use super::carried::{CameraCarried, CameraData, LightCarried, LightData};
use super::problem::{Measure, WorldProblem};
use super::shape_tables::Shape;
use super::{Muted, Tables};

/// Finds the least and the greatest length of objects with shape `S`, and notes that their table is out of date.
pub(super) fn measure_objects<T: Real, S: Shape>(objects: Objects<S>, mut tables: ResMut<Tables<T>>) {
    let mut extremes = Extremes::default();
    extremes.objects(&objects);
    tables.lengths.insert(S::NAME, extremes);
    tables.outdated.insert(S::NAME);
}

/// Chooses the unit from the lengths that there are, whatever it was before; tables in another one are extracted anew.
/// Where no unit holds them all, that is a problem of the World.
pub(super) fn choose_unit<T: Real>(lengths: Lengths, mut tables: ResMut<Tables<T>>) {
    let mut problems = Vec::new();
    let all = tables.lengths.values().fold(lengths.extremes(), |all, &of_kind| all.and(of_kind));
    if let Extremes { least: Some(least), greatest: Some(greatest) } = all {
        match Unit::holding(least.found, greatest.found, T::LENGTH_LIMIT) {
            Some(unit) if unit != tables.scene.unit => Arc::make_mut(&mut tables.scene).unit = unit,
            Some(_) => {}
            None => problems.push(WorldProblem::Precision {
                least,
                greatest,
                precision: T::NAME,
                // A power of two lies between any two numbers that are twice as far apart.
                ratio: 0.5 * T::LENGTH_LIMIT * T::LENGTH_LIMIT,
            }),
        }
    }
    tables.problems.insert("Unit", problems);
}

type Objects<'w, 's, S> = Query<'w, 's, (Entity, &'static S, &'static Position)>;
type SeenFrom = (Entity, &'static CameraPose, &'static Lens, Option<&'static Shutter>, CameraData);
type AnyShape = Or<(With<Sphere>, With<Cube>, With<Pyramid>, With<Checkerboard>)>;

/// Whatever has a length that the trace computes with, but for objects.
#[derive(SystemParam)]
pub(super) struct Lengths<'w, 's> {
    lights: Query<'w, 's, (Entity, &'static Position, LightData), With<Light>>,
    cameras: Query<'w, 's, SeenFrom>,
    velocities: Query<'w, 's, (Entity, &'static Velocity), AnyShape>,
    muted: Res<'w, Muted>,
}

impl Lengths<'_, '_> {
    fn extremes(&self) -> Extremes {
        let mut extremes = Extremes::default();
        self.lights(&mut extremes);
        self.cameras(&mut extremes);
        extremes
    }

    fn lights(&self, extremes: &mut Extremes) {
        for (entity, position, carried) in &self.lights {
            let carried = LightCarried::found(carried).without(*self.muted);
            // One that is infinitely far away has no length.
            if carried.directional.is_none() {
                extremes.point(entity, "Position", position.0);
                carried.each_number(|number| extremes.number(entity, number));
            }
        }
    }

    fn cameras(&self, extremes: &mut Extremes) {
        for (entity, pose, lens, shutter, carried) in &self.cameras {
            extremes.point(entity, "CameraPose.position", pose.position);
            extremes.length(entity, "Lens.near", lens.near);
            let carried = CameraCarried::found(carried).without(*self.muted);
            carried.each_number(|number| extremes.number(entity, number));
            if let Some(shutter) = self.muted.hear(Effect::MotionBlur, shutter) {
                self.ways(*shutter, extremes);
            }
        }
    }

    /// How far things move while a shutter is open.
    fn ways(&self, shutter: Shutter, extremes: &mut Extremes) {
        for (entity, &Velocity(velocity)) in &self.velocities {
            extremes.point(entity, "Velocity", velocity);
            extremes.point(entity, "Velocity * Shutter.open", velocity * shutter.open);
            extremes.point(entity, "Velocity * Shutter.close", velocity * shutter.close);
        }
    }
}

/// The least and the greatest length found so far; of those outside their ranges others will tell.
#[derive(Clone, Copy, Default)]
pub(super) struct Extremes {
    least: Option<Measure>,
    greatest: Option<Measure>,
}

impl Extremes {
    /// Of both.
    fn and(mut self, other: Self) -> Self {
        if let Some(Measure { entity, value, found }) = other.greatest {
            self.extent(entity, value, found);
        }
        if let Some(Measure { entity, value, found }) = other.least {
            self.length(entity, value, found);
        }
        self
    }

    fn objects<S: Shape>(&mut self, objects: &Objects<S>) {
        for (entity, shape, position) in objects {
            self.point(entity, "Position", position.0);
            for (value, found) in shape.lengths().into_iter().flatten() {
                self.length(entity, value, found);
            }
        }
    }

    fn point(&mut self, entity: Entity, value: &'static str, point: DVec3) {
        self.extent(entity, value, point.abs().max_element());
    }

    /// A number of an effect, if it is a length.
    fn number(&mut self, entity: Entity, Number { name, found, allowed }: Number) {
        if *allowed == LENGTH {
            self.length(entity, name, found);
        } else if *allowed == EXTENT || *allowed == COORDINATE {
            self.extent(entity, name, found.abs());
        }
    }

    /// A length that may be 0, or any part of another.
    fn extent(&mut self, entity: Entity, value: &'static str, found: f64) {
        let is_greatest = self.greatest.is_none_or(|greatest| greatest.found < found);
        if is_greatest && COORDINATE.contains(found) {
            self.greatest = Some(Measure { entity, value, found });
        }
    }

    fn length(&mut self, entity: Entity, value: &'static str, found: f64) {
        self.extent(entity, value, found);
        let is_least = self.least.is_none_or(|least| least.found > found);
        if is_least && LENGTH.contains(found) {
            self.least = Some(Measure { entity, value, found });
        }
    }
}

//! Velocities to the rows that move.

use std::sync::Arc;

use bevy_ecs::prelude::*;
use glam::DVec3;

use crate::components::{Shutter, Velocity};
use crate::effects::{Effect, EffectSet};
use crate::geometry::{Real, Vector};
use crate::trace::{MovingRow, ObjectId};

use super::Tables;
use super::problem::Checks;

/// Lists the objects that move while the shutter is open, by the rows that they have been given before.
pub(super) fn extract_motion<T: Real>(velocities: Query<&Velocity>, mut tables: ResMut<Tables<T>>) {
    let mut checks = Checks::default();
    let moving = match tables.camera_effects().shutter {
        Some(shutter) => moving_rows(&velocities, shutter, &tables, &mut checks),
        None => Vec::new(),
    };
    tables.problems.insert("Motion", checks.problems);
    if !moving.is_empty() {
        tables.runs.note(EffectSet::of(&[Effect::MotionBlur]));
    }
    if tables.scene.moving != moving {
        Arc::make_mut(&mut tables.scene).moving = moving;
        tables.revision += 1;
    }
}

/// Whether somebody has a velocity, or had one.
pub(super) fn something_moves<T: Real>(
    velocities: Query<(), With<Velocity>>,
    tables: Res<Tables<T>>,
) -> bool {
    !velocities.is_empty() || !tables.scene.moving.is_empty()
}

fn moving_rows<T: Real>(
    velocities: &Query<&Velocity>,
    shutter: Shutter,
    tables: &Tables<T>,
    checks: &mut Checks,
) -> Vec<MovingRow<T>> {
    let mut moving = Vec::new();
    for (&kind, entities) in &tables.entities {
        for (row, &entity) in (0..).zip(entities) {
            let Ok(&Velocity(velocity)) = velocities.get(entity) else { continue };
            checks.point(entity, "Velocity", velocity);
            checks.point(entity, "Velocity * Shutter.open", velocity * shutter.open);
            checks.point(entity, "Velocity * Shutter.close", velocity * shutter.close);
            if velocity != DVec3::ZERO {
                let velocity = Vector::from_dvec3(tables.scene.unit.point(velocity));
                moving.push(MovingRow { object: ObjectId { kind, row }, velocity });
            }
        }
    }
    moving
}

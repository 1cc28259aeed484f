//! The camera to its rays.

use bevy_ecs::prelude::*;

use crate::components::range::{FIELD_OF_VIEW, LENGTH, MAX_GRID, MAX_LEVEL, MAX_PIXELS, RATIO};
use crate::components::{CameraPose, Lens, Sampling, Snapshot};
use crate::geometry::{Real, is_camera_basis};
use crate::trace::CameraRays;

use super::Tables;
use super::problem::{Checks, WorldProblem};

/// Sets up the rays of the one camera there must be, for the size of the snapshot.
pub(super) fn extract_camera<T: Real>(
    cameras: Query<(Entity, &CameraPose, &Lens)>,
    (snapshot, sampling): (Res<Snapshot>, Res<Sampling>),
    mut tables: ResMut<Tables<T>>,
) {
    let mut checks = Checks::default();
    check_settings(&snapshot, &sampling, &mut checks);
    tables.camera = match cameras.single() {
        Ok((entity, pose, lens)) => {
            check_camera::<T>(entity, pose, lens, &mut checks);
            checks.problems.is_empty().then(|| CameraRays::new(pose, lens, snapshot.pixels))
        }
        Err(_) => {
            checks.problems.push(WorldProblem::Cameras { found: cameras.iter().len() });
            None
        }
    };
    tables.problems.insert("Camera", checks.problems);
}

fn check_settings(snapshot: &Snapshot, sampling: &Sampling, checks: &mut Checks) {
    let values = [
        ("Snapshot.pixels", snapshot.pixels, 1, MAX_PIXELS),
        ("Snapshot.level", snapshot.level, 0, MAX_LEVEL),
        ("Sampling.side", sampling.side, 1, MAX_GRID),
    ];
    for (value, found, low, high) in values {
        if !(low..=high).contains(&found) {
            checks.problems.push(WorldProblem::Setting { value, found, low, high });
        }
    }
}

fn check_camera<T: Real>(entity: Entity, pose: &CameraPose, lens: &Lens, checks: &mut Checks) {
    checks.point::<T>(entity, "CameraPose.position", pose.position);
    if !is_camera_basis([pose.l, pose.r, pose.u]) {
        checks.problems.push(WorldProblem::NoBasis { entity });
    }
    checks.length::<T>(entity, "Lens.near", lens.near);
    checks.value(entity, "Lens.far", lens.far, &LENGTH);
    if lens.far <= lens.near {
        checks.problems.push(WorldProblem::Planes { entity, near: lens.near, far: lens.far });
    }
    checks.value(entity, "Lens.fovy", lens.fovy, &FIELD_OF_VIEW);
    checks.value(entity, "Lens.aspect", lens.aspect, &RATIO);
    checks.value(entity, "Lens.fovy * aspect", lens.fovx(), &FIELD_OF_VIEW);
}

//! The camera to its rays.

use bevy_ecs::prelude::*;

use crate::components::range::{FIELD_OF_VIEW, LENGTH, MAX_GRID, MAX_LEVEL, MAX_PIXELS, RATIO, SECONDS};
use crate::components::{CameraPose, Lens, Sampling, Shutter, Snapshot};
use crate::effects::{Bearer, Effect};
use crate::geometry::{Real, is_camera_basis};
use crate::trace::{CameraEffects, CameraRays};

use super::carried::{CameraCarried, CameraData};
use super::problem::{Checks, WorldProblem};
use super::{Muted, Tables};

/// Sets up the rays of the one camera there must be, for the size of the snapshot.
pub(super) fn extract_camera<T: Real>(
    cameras: Query<(Entity, &CameraPose, &Lens, Option<&Shutter>, CameraData)>,
    (snapshot, sampling, muted): (Res<Snapshot>, Res<Sampling>, Res<Muted>),
    mut tables: ResMut<Tables<T>>,
) {
    let mut checks = Checks::default();
    check_settings(&snapshot, &sampling, &mut checks);
    tables.camera = match cameras.single() {
        Ok((entity, pose, lens, shutter, carried)) => {
            let carried = CameraCarried::found(carried);
            check_camera(entity, pose, lens, &mut checks);
            carried.check(entity, &mut checks);
            check_shutter(entity, shutter, &mut checks);
            let rays = CameraRays::in_unit(pose, lens, snapshot.pixels, tables.scene.unit);
            checks.problems.is_empty().then(|| rays.with_effects(visible(shutter, carried, *muted)))
        }
        Err(_) => {
            checks.problems.push(WorldProblem::Cameras { found: cameras.iter().len() });
            None
        }
    };
    let made = tables.camera_effects().set();
    tables.runs.note(made);
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

fn check_camera(entity: Entity, pose: &CameraPose, lens: &Lens, checks: &mut Checks) {
    checks.point(entity, "CameraPose.position", pose.position);
    if !is_camera_basis([pose.l, pose.r, pose.u]) {
        checks.problems.push(WorldProblem::NoBasis { entity });
    }
    checks.value(entity, "Lens.near", lens.near, &LENGTH);
    checks.value(entity, "Lens.far", lens.far, &LENGTH);
    if lens.far <= lens.near {
        checks.problems.push(WorldProblem::Planes { entity, near: lens.near, far: lens.far });
    }
    checks.value(entity, "Lens.fovy", lens.fovy, &FIELD_OF_VIEW);
    checks.value(entity, "Lens.aspect", lens.aspect, &RATIO);
    checks.value(entity, "Lens.fovy * aspect", lens.fovx(), &FIELD_OF_VIEW);
}

fn check_shutter(entity: Entity, shutter: Option<&Shutter>, checks: &mut Checks) {
    let Some(&Shutter { open, close }) = shutter else { return };
    checks.value(entity, "Shutter.open", open, &SECONDS);
    checks.value(entity, "Shutter.close", close, &SECONDS);
    if close < open {
        checks.problems.push(WorldProblem::ShutterOrder { entity, open, close });
    }
}

/// A shutter that shows second 0 alone, as a camera without one does.
const STILL: Shutter = Shutter { open: 0.0, close: 0.0 };

/// The effects that are not switched off, without those that would show nothing.
fn visible(shutter: Option<&Shutter>, carried: CameraCarried, muted: Muted) -> CameraEffects {
    CameraEffects {
        rows: carried.without(muted).rows::<f64>(&Bearer::default()),
        shutter: muted.hear(Effect::MotionBlur, shutter.copied()).filter(|&shutter| shutter != STILL),
    }
}

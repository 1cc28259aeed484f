//! The camera to its rays.

use bevy_ecs::prelude::*;

use crate::components::range::{
    FIELD_OF_VIEW, LENGTH, MAX_GRID, MAX_LEVEL, MAX_PIXELS, OPENING, RATIO, SECONDS, STOPS,
};
use crate::components::{
    Aperture, CameraPose, ExposureStops, Lens, Sampling, Shutter, Snapshot, SrgbTransfer,
};
use crate::effects::{Effect, Transfer};
use crate::geometry::{Real, is_camera_basis};
use crate::trace::{CameraEffects, CameraRays};

use super::problem::{Checks, WorldProblem};
use super::{Muted, Tables};

/// What makes a camera more than a pinhole.
type EffectData =
    (Option<&'static Aperture>, Option<&'static Shutter>, Option<&'static ExposureStops>, Has<SrgbTransfer>);
/// The same of one camera.
type Effects<'w> = (Option<&'w Aperture>, Option<&'w Shutter>, Option<&'w ExposureStops>, bool);

/// Sets up the rays of the one camera there must be, for the size of the snapshot.
pub(super) fn extract_camera<T: Real>(
    cameras: Query<(Entity, &CameraPose, &Lens, EffectData)>,
    (snapshot, sampling, muted): (Res<Snapshot>, Res<Sampling>, Res<Muted>),
    mut tables: ResMut<Tables<T>>,
) {
    let mut checks = Checks::default();
    check_settings(&snapshot, &sampling, &mut checks);
    tables.camera = match cameras.single() {
        Ok((entity, pose, lens, effects)) => {
            check_camera(entity, pose, lens, &mut checks);
            check_effects(entity, effects, &mut checks);
            let rays = CameraRays::in_unit(pose, lens, snapshot.pixels, tables.scene.unit);
            checks.problems.is_empty().then(|| rays.with_effects(visible(effects, *muted)))
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

fn check_effects(entity: Entity, (aperture, shutter, exposure, _): Effects<'_>, checks: &mut Checks) {
    if let Some(aperture) = aperture {
        checks.value(entity, "Aperture.focus", aperture.focus, &LENGTH);
        checks.value(entity, "Aperture.radius / focus", aperture.radius / aperture.focus, &OPENING);
    }
    if let Some(&Shutter { open, close }) = shutter {
        checks.value(entity, "Shutter.open", open, &SECONDS);
        checks.value(entity, "Shutter.close", close, &SECONDS);
        if close < open {
            checks.problems.push(WorldProblem::ShutterOrder { entity, open, close });
        }
    }
    if let Some(exposure) = exposure {
        checks.value(entity, "ExposureStops", exposure.0, &STOPS);
    }
}

/// A shutter that shows second 0 alone, as a camera without one does.
const STILL: Shutter = Shutter { open: 0.0, close: 0.0 };

/// The effects that are not switched off, without those that would show nothing.
fn visible((aperture, shutter, exposure, srgb): Effects<'_>, muted: Muted) -> CameraEffects {
    let transfer = srgb.then_some(Transfer::Srgb);
    CameraEffects {
        aperture: muted.hear(Effect::Aperture, aperture.copied()).filter(|aperture| aperture.radius != 0.0),
        shutter: muted.hear(Effect::MotionBlur, shutter.copied()).filter(|&shutter| shutter != STILL),
        exposure: muted.hear(Effect::Exposure, exposure.copied()).filter(|exposure| exposure.0 != 0.0),
        transfer: muted.hear(Effect::Srgb, transfer).unwrap_or_default(),
    }
}

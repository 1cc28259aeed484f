//! What was asked of the camera to its pose.

use bevy_ecs::prelude::*;
use glam::DVec3;

use crate::components::range::COORDINATE;
use crate::components::{CameraInput, CameraMove, CameraPose, Home, Lens, Reference};
use crate::geometry::{along, head_left, raise, tilt, turn_left, turn_up};

/// Makes the moves of [`CameraInput`], in their order, and empties it. A move that cannot be made (see [`raise`]), or
/// that would take the eye beyond [`COORDINATE`], is left out; without a camera, or with several, all are. A pose is
/// marked as changed only if it is another one.
pub(super) fn control_camera(
    mut input: ResMut<CameraInput>,
    mut cameras: Query<(&mut CameraPose, &mut Reference, Option<&Home>), With<Lens>>,
) {
    if input.0.is_empty() {
        return;
    }
    let moves = input.0.drain(..);
    let Ok((mut pose, mut reference, home)) = cameras.single_mut() else { return };
    let home = home.map_or_else(CameraPose::default, |home| home.0);
    let before = View { pose: *pose, reference: *reference };
    let after = moves.fold(before, |view, asked| view.after(asked, home).unwrap_or(view));
    pose.set_if_neq(after.pose);
    reference.set_if_neq(after.reference);
}

/// What a move may change.
#[derive(Clone, Copy)]
struct View {
    pose: CameraPose,
    reference: Reference,
}

impl View {
    /// The view after one move, if it can be made.
    fn after(self, asked: CameraMove, home: CameraPose) -> Option<Self> {
        let CameraPose { l, r, u, .. } = self.pose;
        let view = match asked {
            CameraMove::Forward(distance) => self.shifted(l, distance),
            CameraMove::Right(distance) => self.shifted(r, distance),
            CameraMove::Up(distance) => self.shifted(u, distance),
            CameraMove::Turn(degrees) => self.turned(turn_left([l, r, u], degrees)?),
            CameraMove::Heading(degrees) => self.turned(head_left([l, r, u], degrees)?),
            CameraMove::Pitch(degrees) => self.turned(turn_up([l, r, u], degrees)?),
            CameraMove::Tilt(degrees) => self.turned(tilt([l, r, u], degrees)?),
            CameraMove::Raise(height) => self.raised(height)?,
            CameraMove::Home => Self { pose: home, reference: Reference::default() },
        };
        view.is_in_range().then_some(view)
    }

    fn shifted(mut self, direction: DVec3, distance: f64) -> Self {
        self.pose.position = along(self.pose.position, direction, distance);
        self
    }

    fn turned(mut self, [l, r, u]: [DVec3; 3]) -> Self {
        self.pose = CameraPose { l, r, u, ..self.pose };
        self
    }

    fn raised(mut self, height: f64) -> Option<Self> {
        let CameraPose { position, l, r, u } = self.pose;
        let raised = raise(position, [l, r, u], self.reference.distance, height)?;
        self.pose.position = raised.position;
        self.reference.distance = raised.distance;
        Some(self.turned(raised.basis))
    }

    fn is_in_range(&self) -> bool {
        self.pose.position.to_array().into_iter().all(|coordinate| COORDINATE.contains(coordinate))
    }
}

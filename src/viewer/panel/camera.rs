//! The camera: where it is, and its lens.

use bevy_ecs::prelude::*;
use egui::Ui;
use glam::DVec3;

use crate::components::range::{FIELD_OF_VIEW, LENGTH, RATIO};
use crate::components::{CameraPose, Lens, Reference};

use super::Panel;
use super::camera_effects;
use super::digits::short;
use super::fields::{length_row, number_row, relative, row, share_of_width};

/// The pose is for looking only: it belongs to the keys.
pub(super) fn show(ui: &mut Ui, panel: &mut Panel<'_>) {
    let mut cameras = panel.world.query::<(Entity, &CameraPose, &Lens, Option<&Reference>)>();
    let Ok((entity, pose, lens, reference)) = cameras.single(panel.world) else {
        ui.weak("There is not exactly one camera.");
        return;
    };
    let (pose, mut lens, reference) = (*pose, *lens, reference.copied());
    vector(ui, "position", "the eye, in world units", pose.position);
    vector(ui, "look", "l: along the middle of the view, of length 1", pose.l);
    vector(ui, "right", "r: to the right of the picture, of length 1", pose.r);
    vector(ui, "up", "u: to the top of the picture, of length 1", pose.u);
    if let Some(Reference { distance }) = reference {
        row(
            ui,
            "reference",
            "how far ahead the point lies that w and s keep in view, in world units",
            |ui| ui.monospace(short(distance)),
        );
    }
    ui.add_space(3.0);
    if edit_lens(ui, &mut lens) {
        panel.editor.change(panel.world, entity, Some(lens));
    }
    ui.push_id(entity, |ui| camera_effects::show(ui, panel, entity));
}

fn vector(ui: &mut Ui, label: &str, hover: &str, vector: DVec3) {
    row(ui, label, hover, |ui| {
        let size = egui::vec2(share_of_width(ui, 3.0), ui.spacing().interact_size.y);
        for coordinate in vector.to_array() {
            let text = egui::RichText::new(short(rounded(coordinate, vector))).monospace();
            ui.add_sized(size, egui::Label::new(text).truncate());
        }
    });
}

/// Without the dust that rounding leaves beside larger coordinates.
fn rounded(coordinate: f64, among: DVec3) -> f64 {
    if coordinate.abs() < 1e-12 * among.length() { 0.0 } else { coordinate }
}

/// The values must be allowed together, not only each for itself: the one that is edited gives way.
fn edit_lens(ui: &mut Ui, lens: &mut Lens) -> bool {
    let Lens { near, far, .. } = *lens;
    let mut changed = false;
    if length_row(
        ui,
        "near",
        "distance of the near plane along look, in world units",
        &mut lens.near,
        &LENGTH,
    ) {
        lens.near = lens.near.min(far.next_down());
        changed = true;
    }
    if length_row(
        ui,
        "far",
        "distance of the far plane from the near one, in world units",
        &mut lens.far,
        &LENGTH,
    ) {
        lens.far = lens.far.max(near.next_up());
        changed = true;
    }
    if number_row(ui, "fovy", "vertical field of view, in degrees", &mut lens.fovy, (&FIELD_OF_VIEW, 0.25)) {
        lens.fovy = below_half_turn(lens.fovy, lens.aspect);
        changed = true;
    }
    let speed = relative(lens.aspect);
    let hover = "horizontal by vertical field of view, as a ratio of angles";
    if number_row(ui, "aspect", hover, &mut lens.aspect, (&RATIO, speed)) {
        lens.aspect = below_half_turn(lens.aspect, lens.fovy);
        changed = true;
    }
    row(ui, "fovx", "horizontal field of view, in degrees", |ui| ui.monospace(short(lens.fovx())));
    changed
}

/// The greatest value up to this one whose product with `factor` is an angle below 180 degrees.
fn below_half_turn(value: f64, factor: f64) -> f64 {
    let mut value = value.min(180.0 / factor);
    while value * factor >= 180.0 {
        value = value.next_down();
    }
    value
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_field_of_view_stays_below_half_a_turn() {
        for (value, factor) in [(400.0, 0.5), (179.0, 3.0), (1e6, 0.1), (1e6, 179.99)] {
            let limited = below_half_turn(value, factor);
            assert!(FIELD_OF_VIEW.contains(limited * factor), "{limited} times {factor}");
            assert!(
                !FIELD_OF_VIEW.contains(limited.next_up().next_up() * factor),
                "{limited} is less than need be"
            );
        }
        assert_eq!(below_half_turn(60.0, 1.0), 60.0);
    }
}

//! What the camera does beyond that of a pinhole.

use bevy_ecs::prelude::*;
use egui::Ui;

use crate::components::range::{EXTENT, LENGTH, SECONDS, STOPS};
use crate::components::{Aperture, ExposureStops, Shutter, SrgbTransfer};
use crate::viewer::editor::significant;

use super::Panel;
use super::component::{effect, offer};
use super::fields::{length_row, number_row, row};

/// Every effect that the camera has, and buttons for the others.
pub(super) fn show(ui: &mut Ui, panel: &mut Panel<'_>, camera: Entity) {
    effect::<Aperture>(ui, panel, camera, "Aperture", edit_aperture);
    effect::<Shutter>(ui, panel, camera, "Shutter", edit_shutter);
    effect::<ExposureStops>(ui, panel, camera, "Exposure", |ui, exposure| {
        let hover = "in stops: all light counts 2^stops times";
        number_row(ui, "stops", hover, &mut exposure.0, (&STOPS, 0.02))
    });
    effect::<SrgbTransfer>(ui, panel, camera, "sRGB", |_, _| false);
    ui.add_space(3.0);
    row(ui, "add effect", "what the camera does not have costs nothing", |ui| {
        ui.horizontal_wrapped(|ui| {
            let focus = significant(panel.scale, 2);
            offer(ui, panel, camera, "Aperture", Aperture { radius: focus / 50.0, focus });
            offer(ui, panel, camera, "Shutter", Shutter { open: 0.0, close: 0.04 });
            offer(ui, panel, camera, "Exposure", ExposureStops(-1.0));
            offer(ui, panel, camera, "sRGB", SrgbTransfer);
        });
    });
}

/// The lens is no wider than its focus is far: of both the one that is edited gives way.
fn edit_aperture(ui: &mut Ui, aperture: &mut Aperture) -> bool {
    let Aperture { radius, focus } = *aperture;
    let hover = "radius of the lens, in world units";
    let widened = length_row(ui, "lens", hover, &mut aperture.radius, &EXTENT);
    if widened {
        aperture.radius = aperture.radius.min(focus);
    }
    let hover = "distance of the plane in focus along look, in world units";
    let focused = length_row(ui, "focus", hover, &mut aperture.focus, &LENGTH);
    if focused {
        aperture.focus = aperture.focus.max(radius);
    }
    widened | focused
}

/// It closes no sooner than it opens: of both the one that is edited gives way.
fn edit_shutter(ui: &mut Ui, shutter: &mut Shutter) -> bool {
    let Shutter { open, close } = *shutter;
    let opened = number_row(
        ui,
        "opens",
        "in seconds; moving things are in place at 0",
        &mut shutter.open,
        (&SECONDS, 0.001),
    );
    if opened {
        shutter.open = shutter.open.min(close);
    }
    let closed = number_row(ui, "closes", "in seconds", &mut shutter.close, (&SECONDS, 0.001));
    if closed {
        shutter.close = shutter.close.max(open);
    }
    opened | closed
}

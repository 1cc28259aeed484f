//! What surrounds all objects.

use bevy_ecs::prelude::*;
use bevy_ecs::query::QueryFilter;
use egui::Ui;
use glam::DVec3;

use crate::components::range::{COLOR, DENSITY};
use crate::components::{Background, CameraPose, Fog};
use crate::viewer::editor::significant;

use super::Panel;
use super::component::{effect, offer};
use super::fields::{color_row, number_row, relative, row};

/// Background and fog, whichever entity has them. What is not there can be given to the camera: a scene has one.
pub(super) fn show(ui: &mut Ui, panel: &mut Panel<'_>) {
    let background = only::<With<Background>>(panel.world);
    let fog = only::<With<Fog>>(panel.world);
    let least = significant(0.1 / panel.scale, 1);
    if let Some(entity) = background {
        ui.push_id(entity, |ui| effect::<Background>(ui, panel, entity, "Background", edit_background));
    }
    if let Some(entity) = fog {
        ui.push_id(entity, |ui| {
            effect::<Fog>(ui, panel, entity, "Fog", |ui, fog| {
                let hover = "in 1/unit: after a distance d, exp(-d density) of the light is left";
                let speed = relative(fog.density.max(least));
                number_row(ui, "density", hover, &mut fog.density, (&DENSITY, speed))
                    | color_row(ui, "fog", "linear red, green, blue, 0 to 1", &mut fog.color, &COLOR)
            });
        });
    }
    let Some(camera) = only::<With<CameraPose>>(panel.world) else { return };
    row(ui, "add", "what is not there costs nothing", |ui| {
        if background.is_none() {
            let [below, above] = [DVec3::new(0.9, 0.8, 0.7), DVec3::new(0.2, 0.4, 0.8)];
            offer(ui, panel, camera, "Background", Background { below, above });
        }
        if fog.is_none() {
            offer(ui, panel, camera, "Fog", Fog { density: least, color: DVec3::splat(0.7) });
        }
    });
}

/// The first of the entities that have something of which there is at most one.
fn only<F: QueryFilter>(world: &mut World) -> Option<Entity> {
    world.query_filtered::<Entity, F>().iter(world).next()
}

fn edit_background(ui: &mut Ui, background: &mut Background) -> bool {
    color_row(ui, "below", "straight down: linear red, green, blue, 0 to 1", &mut background.below, &COLOR)
        | color_row(
            ui,
            "above",
            "straight up: linear red, green, blue, 0 to 1",
            &mut background.above,
            &COLOR,
        )
}

//! The components of the selected entity.

use core::any::TypeId;

use bevy_ecs::prelude::*;
use egui::{Align, Layout, RichText, Ui};

use crate::components::range::{COEFFICIENT, COLOR, LENGTH};
use crate::components::{
    Absorption, Ambient, Aperture, AreaLight, Background, CheckerFilter, Checkerboard, Color, Cube, Diffuse,
    Directional, ExposureStops, Falloff, Fog, Glass, Gloss, Light, LightColor, Mirror, Order, Position,
    Pyramid, Shutter, Sphere, SpotCone, SrgbTransfer, TextureFilter, Textured, Velocity,
};

use super::Panel;
use super::component::edit;
use super::effects;
use super::fields::{color_row, length_row, point_row, row, share_row};
use super::name::{Kind, name_of};

/// Name, what can be done with the whole, and every component.
pub(super) fn show(ui: &mut Ui, panel: &mut Panel<'_>) {
    let selected = panel.editor.selected().filter(|&entity| panel.world.get_entity(entity).is_ok());
    let Some(entity) = selected else {
        ui.weak("Nothing is selected: click on an object in the scene or in the list.");
        return;
    };
    // A field of one entity is not that of another: what is being typed does not move on.
    ui.push_id(entity, |ui| {
        head(ui, panel, entity);
        parts(ui, panel, entity);
        effects::show(ui, panel, entity);
        others(ui, panel.world, entity);
    });
}

fn head(ui: &mut Ui, panel: &mut Panel<'_>, entity: Entity) {
    ui.horizontal(|ui| {
        let name = RichText::new(name_of(panel.world, entity)).strong();
        ui.label(name).on_hover_text(format!("entity {entity}"));
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if ui.button("Delete").on_hover_text("Delete").clicked() {
                panel.editor.delete(panel.world);
            }
            if ui.button("Duplicate").on_hover_text("Ctrl+D").clicked() {
                panel.editor.duplicate(panel.world);
            }
        });
    });
}

/// What an entity is not itself without.
fn parts(ui: &mut Ui, panel: &mut Panel<'_>, entity: Entity) {
    let step = panel.scale / 300.0;
    let at = match panel.world.get_entity(entity).ok().and_then(Kind::of) {
        Some(Kind::Sphere) => "the centre, in world units",
        Some(Kind::Cube) => "the corner with the least x, y and z, in world units",
        Some(Kind::Pyramid) => "the base's corner with the least x and y, in world units",
        Some(Kind::Board) => "a corner of a white cell, in world units",
        _ => "in world units",
    };
    edit::<Position>(ui, panel, entity, |ui, at_| point_row(ui, "position", at, &mut at_.0, step));
    edit::<Sphere>(ui, panel, entity, |ui, sphere| {
        length_row(ui, "radius", "in world units", &mut sphere.radius, &LENGTH)
    });
    edit::<Cube>(ui, panel, entity, |ui, cube| {
        length_row(ui, "side", "in world units", &mut cube.side, &LENGTH)
    });
    edit::<Pyramid>(ui, panel, entity, |ui, pyramid| {
        length_row(ui, "width", "of the base, in world units", &mut pyramid.width, &LENGTH)
            | length_row(
                ui,
                "height",
                "of the apex above the base, in world units",
                &mut pyramid.height,
                &LENGTH,
            )
    });
    edit::<Checkerboard>(ui, panel, entity, |ui, board| {
        length_row(ui, "cell", "edge of a cell, in world units", &mut board.cell, &LENGTH)
    });
    edit::<Color>(ui, panel, entity, |ui, color| {
        color_row(ui, "color", "own colour: linear red, green, blue, 0 to 1", &mut color.0, &COLOR)
    });
    edit::<Ambient>(ui, panel, entity, |ui, ambient| {
        share_row(
            ui,
            "ambient",
            "share of the own colour that shows without light",
            &mut ambient.0,
            &COEFFICIENT,
        )
    });
    edit::<Diffuse>(ui, panel, entity, |ui, diffuse| {
        share_row(ui, "diffuse", "share of the own colour that shows by light", &mut diffuse.0, &COEFFICIENT)
    });
}

/// Components that the panel does not edit: images, and those of a program's own, by name.
fn others(ui: &mut Ui, world: &World, entity: Entity) {
    if let Some(textured) = world.get::<Textured>(entity) {
        let sizes =
            [&textured.white, &textured.black].map(|image| format!("{} × {}", image.width(), image.height()));
        row(ui, "images", "on the white and on the black cells, in texels", |ui| {
            ui.monospace(sizes.join(", "))
        });
    }
    let known = known();
    let Ok(components) = world.inspect_entity(entity) else { return };
    let own = components.filter(|(_, info)| info.type_id().is_none_or(|id| !known.contains(&id)));
    let mut names: Vec<String> = own.map(|(_, info)| info.name().shortname().to_string()).collect();
    names.sort();
    if !names.is_empty() {
        row(ui, "also", "components of the scene's own", |ui| ui.label(names.join(", ")));
    }
}

fn known() -> [TypeId; 31] {
    [
        TypeId::of::<Position>(),
        TypeId::of::<Order>(),
        TypeId::of::<Name>(),
        TypeId::of::<Sphere>(),
        TypeId::of::<Cube>(),
        TypeId::of::<Pyramid>(),
        TypeId::of::<Checkerboard>(),
        TypeId::of::<Color>(),
        TypeId::of::<Ambient>(),
        TypeId::of::<Diffuse>(),
        TypeId::of::<Gloss>(),
        TypeId::of::<Mirror>(),
        TypeId::of::<Glass>(),
        TypeId::of::<Absorption>(),
        TypeId::of::<Velocity>(),
        TypeId::of::<Textured>(),
        TypeId::of::<TextureFilter>(),
        TypeId::of::<CheckerFilter>(),
        TypeId::of::<Light>(),
        TypeId::of::<Falloff>(),
        TypeId::of::<SpotCone>(),
        TypeId::of::<LightColor>(),
        TypeId::of::<Directional>(),
        TypeId::of::<AreaLight>(),
        TypeId::of::<Background>(),
        TypeId::of::<Fog>(),
        TypeId::of::<Aperture>(),
        TypeId::of::<Shutter>(),
        TypeId::of::<ExposureStops>(),
        TypeId::of::<SrgbTransfer>(),
        TypeId::of::<bevy_ecs::entity_disabling::Disabled>(),
    ]
}

//! Effects of the selected entity: those that it has, and those that it could have.

use bevy_ecs::prelude::*;
use egui::Ui;
use glam::DVec3;

use crate::components::range::{
    COEFFICIENT, CUTOFF, DENSITY, EXTENT, FALLOFF, INDEX, LIGHT_COLOR, MAX_LIGHT_SAMPLES, SHININESS,
};
use crate::components::{
    Absorption, AreaLight, CheckerFilter, Checkerboard, Directional, Falloff, Glass, Gloss, Light,
    LightColor, Mirror, Position, SpotCone, TextureFilter, Textured, Velocity,
};
use crate::viewer::editor::significant;

use super::Panel;
use super::component::{effect, offer};
use super::fields::{
    color_row, length_row, number_row, point_row, relative, row, share_row, triple, whole_row,
};

/// Every effect that the entity has, and buttons for the others that its kind can have.
pub(super) fn show(ui: &mut Ui, panel: &mut Panel<'_>, entity: Entity) {
    surface(ui, panel, entity);
    body(ui, panel, entity);
    board(ui, panel, entity);
    narrowing(ui, panel, entity);
    lamp(ui, panel, entity);
    ui.add_space(3.0);
    row(ui, "add effect", "what the entity does not have costs nothing", |ui| {
        ui.horizontal_wrapped(|ui| missing(ui, panel, entity));
    });
}

fn surface(ui: &mut Ui, panel: &mut Panel<'_>, entity: Entity) {
    effect::<Gloss>(ui, panel, entity, "Gloss", |ui, gloss| {
        let speed = relative(gloss.shininess.max(10.0));
        share_row(ui, "specular", "share of the own colour in a highlight", &mut gloss.specular, &COEFFICIENT)
            | number_row(
                ui,
                "shininess",
                "Phong exponent: larger is a smaller highlight",
                &mut gloss.shininess,
                (&SHININESS, speed),
            )
    });
    let glass = panel.world.get::<Glass>(entity).map_or(0.0, |glass| glass.transmission);
    effect::<Mirror>(ui, panel, entity, "Mirror", |ui, mirror| {
        let hover = "share of the light received that is added";
        let changed = share_row(ui, "reflection", hover, &mut mirror.0, &COEFFICIENT);
        give_way(changed, &mut mirror.0, glass)
    });
}

/// A surface sends on no more light than it receives: of two shares the one that is edited gives way.
fn give_way(changed: bool, share: &mut f64, other: f64) -> bool {
    if changed {
        *share = share.min(1.0 - other);
    }
    changed
}

fn body(ui: &mut Ui, panel: &mut Panel<'_>, entity: Entity) {
    let mirror = panel.world.get::<Mirror>(entity).map_or(0.0, |mirror| mirror.0);
    effect::<Glass>(ui, panel, entity, "Glass", |ui, glass| {
        let hover = "of refraction, inside by outside: 1.5 for glass, 1.33 for water";
        let indexed = number_row(ui, "index", hover, &mut glass.index, (&INDEX, 0.005));
        let hover = "share of what glass shows";
        let changed = share_row(ui, "transmission", hover, &mut glass.transmission, &COEFFICIENT);
        give_way(changed, &mut glass.transmission, mirror) | indexed
    });
    let speed = 0.01 / panel.scale;
    effect::<Absorption>(ui, panel, entity, "Absorption", |ui, absorption| {
        let hover = "of red, green, blue, in 1/unit: after a distance d in glass, exp(-d absorption) is left";
        row(ui, "absorption", hover, |ui| triple(ui, &mut absorption.0, (&DENSITY, speed)))
    });
    let step = panel.scale / 300.0;
    effect::<Velocity>(ui, panel, entity, "Velocity", |ui, velocity| {
        let hover = "the way in a second, in world units; shows while the camera has a shutter";
        point_row(ui, "velocity", hover, &mut velocity.0, step)
    });
}

fn board(ui: &mut Ui, panel: &mut Panel<'_>, entity: Entity) {
    effect::<TextureFilter>(ui, panel, entity, "Texture filter", |ui, filter| {
        let before = *filter;
        row(ui, "filter", "how the images are looked up", |ui| {
            ui.selectable_value(filter, TextureFilter::Nearest, "nearest");
            ui.selectable_value(filter, TextureFilter::Bilinear, "bilinear");
            ui.selectable_value(filter, TextureFilter::Mip, "mip");
        });
        *filter != before
    });
    effect::<CheckerFilter>(ui, panel, entity, "Checker filter", |_, _| false);
}

/// What takes light away from where a light shines.
fn narrowing(ui: &mut Ui, panel: &mut Panel<'_>, entity: Entity) {
    let (step, least) = (panel.scale / 300.0, usual_falloff(panel.scale));
    effect::<Falloff>(ui, panel, entity, "Falloff", |ui, falloff| {
        let speed = relative(falloff.0.max(least));
        let hover = "1/unit²: at distance d, exp(-d² falloff) of the light is left";
        number_row(ui, "falloff", hover, &mut falloff.0, (&FALLOFF, speed))
    });
    effect::<SpotCone>(ui, panel, entity, "Cone", |ui, cone| {
        point_row(
            ui,
            "target",
            "the point that the axis runs through, in world units",
            &mut cone.target,
            step,
        ) | number_row(
            ui,
            "cutoff",
            "angle between axis and side, in degrees",
            &mut cone.cutoff,
            (&CUTOFF, 0.25),
        )
    });
}

fn lamp(ui: &mut Ui, panel: &mut Panel<'_>, entity: Entity) {
    effect::<LightColor>(ui, panel, entity, "Light colour", |ui, color| {
        let hover = "colour and intensity: linear red, green, blue; white is 1 in all three";
        color_row(ui, "intensity", hover, &mut color.0, &LIGHT_COLOR)
    });
    effect::<Directional>(ui, panel, entity, "Directional", |ui, directional| {
        let hover = "the direction in which the light travels, of any length but 0";
        let before = directional.direction;
        let changed = point_row(ui, "direction", hover, &mut directional.direction, 0.01);
        if directional.direction == DVec3::ZERO {
            directional.direction = before;
        }
        changed
    });
    effect::<AreaLight>(ui, panel, entity, "Area light", |ui, ball| {
        let hover = "shadow rays for each surface point and sample of a pixel";
        length_row(ui, "extent", "radius of the ball, in world units", &mut ball.radius, &EXTENT)
            | whole_row(ui, "shadow rays", hover, &mut ball.samples, 1..=MAX_LIGHT_SAMPLES)
    });
}

/// Effects that the entity could have and has not.
fn missing(ui: &mut Ui, panel: &mut Panel<'_>, entity: Entity) {
    let Ok(at) = panel.world.get_entity(entity) else { return };
    if at.contains::<Light>() {
        return missing_of_light(ui, panel, entity);
    }
    let (is_board, is_textured, is_glass) =
        (at.contains::<Checkerboard>(), at.contains::<Textured>(), at.contains::<Glass>());
    let (mirror, glass) = (at.get::<Mirror>().copied(), at.get::<Glass>().copied());
    let left_by_glass = 1.0 - glass.map_or(0.0, |glass| glass.transmission);
    let left_by_mirror = 1.0 - mirror.map_or(0.0, |mirror| mirror.0);
    offer(ui, panel, entity, "Gloss", Gloss { specular: 0.3, shininess: 30.0 });
    offer(ui, panel, entity, "Mirror", Mirror(left_by_glass.min(0.3)));
    offer(ui, panel, entity, "Glass", Glass { index: 1.5, transmission: left_by_mirror.min(0.9) });
    if is_glass {
        let absorption = Absorption(DVec3::new(0.2, 0.5, 1.0) * significant(1.0 / panel.scale, 1));
        offer(ui, panel, entity, "Absorption", absorption);
    }
    if is_board && is_textured {
        offer(ui, panel, entity, "Texture filter", TextureFilter::Mip);
    } else if is_board {
        offer(ui, panel, entity, "Checker filter", CheckerFilter);
    }
    offer(ui, panel, entity, "Velocity", Velocity(DVec3::X * significant(panel.scale, 1)));
}

fn missing_of_light(ui: &mut Ui, panel: &mut Panel<'_>, entity: Entity) {
    let position = panel.world.get::<Position>(entity).copied().unwrap_or_default().0;
    let size = significant(panel.scale, 1);
    offer(ui, panel, entity, "Falloff", Falloff(usual_falloff(panel.scale)));
    offer(ui, panel, entity, "Cone", SpotCone { target: position - DVec3::Z * size, cutoff: 30.0 });
    offer(ui, panel, entity, "Light colour", LightColor(DVec3::new(1.0, 0.8, 0.6)));
    offer(ui, panel, entity, "Directional", Directional { direction: DVec3::NEG_Z });
    offer(ui, panel, entity, "Area light", AreaLight { radius: size / 10.0, samples: 16 });
}

/// Half of the light is left at the distance of the camera's reference point.
fn usual_falloff(distance: f64) -> f64 {
    FALLOFF.nearest(significant(core::f64::consts::LN_2 / (distance * distance), 1)).unwrap_or(0.0)
}

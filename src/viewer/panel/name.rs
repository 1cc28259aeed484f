//! What an entity is called, and how it is drawn in a list.

use bevy_ecs::prelude::*;
use egui::{Color32, CornerRadius, Painter, Pos2, Rect, Shape, Stroke, vec2};
use glam::DVec3;

use crate::components::{Checkerboard, Color, Cube, Light, Order, Pyramid, Sphere, SpotCone};

/// What kind of thing an entity is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Sphere,
    Cube,
    Pyramid,
    Board,
    Light,
    Spotlight,
}

impl Kind {
    /// The kind of an entity; `None` for what is neither object nor light.
    pub(super) fn of(entity: EntityRef<'_>) -> Option<Self> {
        let kinds = [
            (entity.contains::<Sphere>(), Self::Sphere),
            (entity.contains::<Cube>(), Self::Cube),
            (entity.contains::<Pyramid>(), Self::Pyramid),
            (entity.contains::<Checkerboard>(), Self::Board),
            (entity.contains::<Light>() && entity.contains::<SpotCone>(), Self::Spotlight),
            (entity.contains::<Light>(), Self::Light),
        ];
        kinds.into_iter().find_map(|(is_it, kind)| is_it.then_some(kind))
    }

    pub(super) fn is_light(self) -> bool {
        matches!(self, Self::Light | Self::Spotlight)
    }

    fn word(self) -> &'static str {
        match self {
            Self::Sphere => "sphere",
            Self::Cube => "cube",
            Self::Pyramid => "pyramid",
            Self::Board => "checkerboard",
            Self::Light => "light",
            Self::Spotlight => "spotlight",
        }
    }
}

/// What an entity is called: its [`Name`] if it has one, else its kind and its place in the scene's order, counted
/// from 1, such as `sphere 3`; without a place, its number in the World.
pub(crate) fn name_of(world: &World, entity: Entity) -> String {
    let Ok(at) = world.get_entity(entity) else { return format!("entity {entity}") };
    if let Some(name) = at.get::<Name>() {
        return name.to_string();
    }
    let word = Kind::of(at).map_or("entity", Kind::word);
    match at.get::<Order>() {
        Some(order) => format!("{word} {}", u64::from(order.0) + 1),
        None => format!("{word} {entity}"),
    }
}

/// Draws the outline of an entity's kind in its own colour.
pub(super) fn paint_icon(painter: &Painter, rect: Rect, kind: Kind, color: Option<&Color>) {
    // Lights have no colour of their own.
    let fill = color.map_or(Color32::from_rgb(238, 222, 170), |color| shown(color.0));
    let rim = Stroke::new(1.0, Color32::from_white_alpha(48));
    let center = rect.center();
    match kind {
        Kind::Sphere => {
            painter.circle(center, rect.width() / 2.0, fill, rim);
        }
        Kind::Cube => {
            let square = rect.shrink(1.0);
            painter.rect(square, CornerRadius::same(1), fill, rim, egui::StrokeKind::Inside);
        }
        Kind::Pyramid => {
            let corners = vec![rect.center_top(), rect.right_bottom(), rect.left_bottom()];
            painter.add(Shape::convex_polygon(corners, fill, rim));
        }
        Kind::Board => paint_cells(painter, rect, fill),
        Kind::Light => {
            let halo = Stroke::new(2.0, fill.gamma_multiply(0.3));
            painter.circle(center, rect.width() / 3.2, fill, halo);
        }
        Kind::Spotlight => {
            painter.circle_filled(rect.center_top() + vec2(0.0, 2.5), 2.5, fill);
            let beam: Vec<Pos2> =
                vec![rect.center_top() + vec2(0.0, 4.0), rect.right_bottom(), rect.left_bottom()];
            painter.add(Shape::convex_polygon(beam, fill.gamma_multiply(0.35), Stroke::NONE));
        }
    }
}

fn paint_cells(painter: &Painter, rect: Rect, white: Color32) {
    let half = rect.size() / 2.0;
    painter.rect_filled(rect, CornerRadius::ZERO, Color32::BLACK);
    painter.rect_filled(Rect::from_min_size(rect.min, half), CornerRadius::ZERO, white);
    painter.rect_filled(Rect::from_min_size(rect.center(), half), CornerRadius::ZERO, white);
}

/// A colour as the picture shows it: its numbers are the bytes of the picture, without any curve between.
pub(super) fn shown(color: DVec3) -> Color32 {
    let [r, g, b] = bytes(color);
    Color32::from_rgb(r, g, b)
}

/// The nearest 8-bit colour.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 0..=255 first")]
pub(super) fn bytes(color: DVec3) -> [u8; 3] {
    color.to_array().map(|channel| (channel.clamp(0.0, 1.0) * 255.0).round() as u8)
}

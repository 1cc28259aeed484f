//! The list of objects and lights.

use bevy_ecs::prelude::*;
use egui::{Align2, CornerRadius, Rect, Role, ScrollArea, Sense, TextStyle, Ui, WidgetInfo, vec2};

use crate::components::Color;

use super::Panel;
use super::name::{Kind, name_of, paint_icon};

/// Height of a row.
const ROW: f32 = 20.0;
/// Rows that are shown at once.
const SHOWN: f32 = 9.0;

/// Rows are made for what is in sight only, so that any number of entities is as good as a few.
pub(super) fn show(ui: &mut Ui, panel: &mut Panel<'_>) {
    let entities = panel.state.listing.update(panel.world, panel.editor.arrivals());
    let selected = panel.editor.selected();
    let mut area = ScrollArea::vertical().max_height(ROW * SHOWN).auto_shrink([false, true]);
    if panel.state.listed != selected {
        let place = selected.and_then(|selected| entities.iter().position(|&entity| entity == selected));
        if let Some(place) = place {
            area = area.vertical_scroll_offset(offset(place));
        }
    }
    ui.spacing_mut().item_spacing.y = 0.0;
    area.show_rows(ui, ROW, entities.len(), |ui, rows| {
        for &entity in entities.get(rows).unwrap_or_default() {
            if row(ui, panel.world, entity, selected == Some(entity)) {
                panel.clicked = Some(entity);
            }
        }
    });
    panel.state.listed = selected;
}

/// So far down that the row comes into the middle.
#[expect(clippy::cast_precision_loss, reason = "a row more or less does not matter among so many")]
fn offset(place: usize) -> f32 {
    (place as f32 * ROW - (SHOWN - 1.0) / 2.0 * ROW).max(0.0)
}

/// One row; tells whether it was clicked. It never takes the keyboard, which belongs to the camera.
fn row(ui: &mut Ui, world: &World, entity: Entity, is_selected: bool) -> bool {
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), ROW), Sense::CLICK);
    let Ok(at) = world.get_entity(entity) else { return false };
    let name = name_of(world, entity);
    response.widget_info(|| WidgetInfo::selected(Role::ListBoxOption, true, is_selected, &name));
    let visuals = ui.style().interact_selectable(&response, is_selected);
    if is_selected || response.hovered() {
        ui.painter().rect_filled(rect, CornerRadius::same(3), visuals.weak_bg_fill);
    }
    let icon = Rect::from_center_size(rect.left_center() + vec2(12.0, 0.0), vec2(12.0, 12.0));
    if let Some(kind) = Kind::of(at) {
        paint_icon(ui.painter(), icon, kind, at.get::<Color>());
    }
    let (at_text, font) = (rect.left_center() + vec2(26.0, 0.0), TextStyle::Body.resolve(ui.style()));
    ui.painter().text(at_text, Align2::LEFT_CENTER, name, font, visuals.text_color());
    response.on_hover_text(format!("entity {entity}")).clicked()
}

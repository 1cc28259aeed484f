//! One component of an entity: shown, edited, taken away, given.

use bevy_ecs::prelude::*;
use egui::{Align, Layout, Ui};

use super::Panel;

/// Shows a component, if it is there, and passes on what was changed.
pub(super) fn edit<C: Component + Clone + PartialEq>(
    ui: &mut Ui,
    panel: &mut Panel<'_>,
    entity: Entity,
    rows: impl FnOnce(&mut Ui, &mut C) -> bool,
) {
    let Some(mut value) = panel.world.get::<C>(entity).cloned() else { return };
    if rows(ui, &mut value) {
        panel.editor.change(panel.world, entity, Some(value));
    }
}

/// A component that can be taken away again.
pub(super) fn effect<C: Component + Clone + PartialEq>(
    ui: &mut Ui,
    panel: &mut Panel<'_>,
    entity: Entity,
    name: &str,
    rows: impl FnOnce(&mut Ui, &mut C) -> bool,
) {
    if panel.world.get::<C>(entity).is_none() {
        return;
    }
    ui.add_space(3.0);
    let removed = ui.horizontal(|ui| {
        ui.label(name);
        let right = Layout::right_to_left(Align::Center);
        let button = |ui: &mut Ui| ui.small_button("×").on_hover_text(format!("remove {name}")).clicked();
        ui.with_layout(right, button).inner
    });
    edit(ui, panel, entity, rows);
    if removed.inner {
        panel.editor.end_gesture();
        panel.editor.change::<C>(panel.world, entity, None);
        panel.editor.end_gesture();
    }
}

/// A button that gives an entity a component that it has not.
pub(super) fn offer<C: Component + Clone + PartialEq>(
    ui: &mut Ui,
    panel: &mut Panel<'_>,
    entity: Entity,
    name: &str,
    value: C,
) {
    let is_missing = panel.world.get::<C>(entity).is_none();
    if ui.add_enabled(is_missing, egui::Button::new(name).small()).clicked() {
        panel.editor.end_gesture();
        panel.editor.change(panel.world, entity, Some(value));
        panel.editor.end_gesture();
    }
}

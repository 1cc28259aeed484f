//! The panel beside the scene, and the messages over it.
//!
//! It looks at the World and edits it through the [`Editor`]; whatever else is asked of the program it returns as
//! [`Request`]s. It knows no window: `egui` hands it events and takes its shapes.

mod accuracy;
mod air;
mod camera;
mod camera_effects;
mod component;
mod components;
mod digits;
mod effects;
mod entities;
mod fields;
mod figures;
mod listing;
mod messages;
mod name;
mod overlay;
mod picture;
mod save;
mod scene;
mod status;
mod strip;
mod theme;

#[cfg(test)]
mod tests;

use std::path::PathBuf;

use bevy_ecs::prelude::*;
use egui::{CollapsingHeader, Frame, Margin, RichText, ScrollArea, Ui};

use super::editor::Editor;
use crate::components::{CameraPose, Reference};

use listing::Listing;
use save::SaveName;

pub(crate) use messages::Messages;
pub(crate) use name::name_of;
pub(crate) use overlay::show_overlay;
pub(crate) use save::unused_name;
pub(crate) use status::{Request, Status};
pub(crate) use strip::show_strip;
pub(crate) use theme::apply as apply_theme;

/// Width of the panel in points: at first, and between which bounds it can be dragged.
const WIDTH: f32 = 330.0;
const WIDTHS: core::ops::RangeInclusive<f32> = 280.0..=560.0;

/// What the panel remembers from frame to frame.
#[derive(Default)]
pub(crate) struct PanelState {
    save: SaveName,
    listing: Listing,
    /// The entity that was selected when the list was drawn.
    listed: Option<Entity>,
}

/// What the sections work on.
struct Panel<'a> {
    world: &'a mut World,
    editor: &'a mut Editor,
    status: &'a Status,
    state: &'a mut PanelState,
    requests: Vec<Request>,
    /// The entity that was clicked in the list. It is selected when the others have seen the last of the click.
    clicked: Option<Entity>,
    /// Distance of the camera's reference point: what counts as far in this scene.
    scale: f64,
}

impl Panel<'_> {
    fn ask(&mut self, request: Request) {
        self.requests.push(request);
    }

    fn save(&mut self, path: PathBuf, overwrite: bool) {
        self.state.save.keep(&path);
        self.ask(Request::Save { path, overwrite });
    }
}

/// Shows the panel at the right of a root `Ui`, edits the World as the user asks, and returns what is asked beyond
/// that. Once a frame: edits belong to one gesture as long as a button of the pointer is held.
pub(crate) fn show(
    ui: &mut Ui,
    world: &mut World,
    editor: &mut Editor,
    status: &Status,
    state: &mut PanelState,
) -> Vec<Request> {
    editor.look(world);
    fields::note_escape(ui);
    let typing = ui.memory(egui::Memory::focused);
    if !is_held(ui) {
        editor.end_gesture();
    }
    let scale = scale(world);
    let mut panel = Panel { world, editor, status, state, requests: Vec::new(), clicked: None, scale };
    let side = egui::Panel::right("panel").default_size(WIDTH).size_range(WIDTHS);
    let frame =
        Frame::side_top_panel(ui.style()).inner_margin(Margin { left: 10, right: 4, top: 8, bottom: 4 });
    side.frame(frame).show(ui, |ui| {
        ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
            Frame::new()
                .inner_margin(Margin { right: 10, ..Margin::ZERO })
                .show(ui, |ui| sections(ui, &mut panel));
        });
    });
    let Panel { requests, clicked, .. } = panel;
    if clicked.is_some() {
        state.listed = clicked;
        editor.select(clicked);
    }
    // What was typed and what is dragged next are two edits, even of one component.
    if typing.is_some() && ui.memory(egui::Memory::focused) != typing {
        editor.end_gesture();
    }
    requests
}

/// Whether a gesture that began in an earlier frame goes on. The frame of a release still belongs to it.
fn is_held(ui: &Ui) -> bool {
    ui.input(|input| {
        let pointer = &input.pointer;
        (pointer.any_down() || pointer.any_released()) && !pointer.any_pressed()
    })
}

fn scale(world: &mut World) -> f64 {
    let mut references = world.query_filtered::<&Reference, With<CameraPose>>();
    let distance = references.iter(world).next().copied().unwrap_or_default().distance;
    if distance.is_finite() && distance > 0.0 { distance } else { Reference::default().distance }
}

fn sections(ui: &mut Ui, panel: &mut Panel<'_>) {
    scene::show(ui, panel);
    problems(ui, panel.status);
    section(ui, "Entities", true, |ui| entities::show(ui, panel));
    section(ui, "Selected", true, |ui| components::show(ui, panel));
    section(ui, "Camera", false, |ui| camera::show(ui, panel));
    section(ui, "Surroundings", false, |ui| air::show(ui, panel));
    section(ui, "Picture", true, |ui| picture::show(ui, panel));
    section(ui, "Effects in use", false, |ui| figures::effects(ui, panel));
    section(ui, "Figures", false, |ui| figures::figures(ui, panel));
    section(ui, "Keys", false, |ui| keys(ui, panel.status));
    ui.add_space(8.0);
}

fn section(ui: &mut Ui, title: &str, is_open: bool, contents: impl FnOnce(&mut Ui)) {
    ui.add_space(2.0);
    ui.separator();
    let header = CollapsingHeader::new(RichText::new(title).strong()).default_open(is_open);
    header.show_unindented(ui, contents);
}

/// Why nothing can be traced.
fn problems(ui: &mut Ui, status: &Status) {
    const SHOWN: usize = 8;
    let line = |ui: &mut Ui, text: &str| ui.label(RichText::new(text).small().color(theme::RED));
    for problem in status.problems.iter().take(SHOWN) {
        line(ui, problem);
    }
    if status.problems.len() > SHOWN {
        line(ui, &format!("and {} more", status.problems.len() - SHOWN));
    }
}

fn keys(ui: &mut Ui, status: &Status) {
    egui::Grid::new("keys").num_columns(2).spacing([12.0, 3.0]).show(ui, |ui| {
        for (key, meaning) in &status.keys {
            ui.label(RichText::new(key).monospace());
            ui.add(egui::Label::new(RichText::new(meaning).weak()).wrap());
            ui.end_row();
        }
    });
}

//! The traced picture: what it shows, and how well.

use egui::{ProgressBar, Ui};

use super::fields::row;
use super::status::Request;
use super::{Panel, accuracy};
use crate::preview::Layout;
use crate::viewer::live::Shows;

pub(super) fn show(ui: &mut Ui, panel: &mut Panel<'_>) {
    modes(ui, panel);
    maps(ui, panel);
    accuracy::show(ui, panel);
    let status = panel.status;
    row(ui, "texture", "images on the checkerboard (space)", |ui| {
        let mut is_on = status.texture;
        if ui.checkbox(&mut is_on, "").changed() {
            panel.ask(Request::ToggleTexture);
        }
    });
    to_file(ui, panel);
}

fn maps(ui: &mut Ui, panel: &mut Panel<'_>) {
    let all = [(Shows::Picture, "picture"), (Shows::Errors, "errors"), (Shows::Rays, "rays")];
    let now = panel.status.shows;
    row(ui, "as", "the traced picture, its estimated errors, or its rays per pixel (h)", |ui| {
        for (shows, name) in all {
            if ui.selectable_label(now == shows, name).clicked() {
                panel.ask(Request::SetShows(shows));
            }
        }
    });
}

fn modes(ui: &mut Ui, panel: &mut Panel<'_>) {
    let modes = [(Layout::Preview, "preview"), (Layout::Traced, "traced"), (Layout::Split, "split")];
    let now = panel.status.mode;
    row(ui, "shows", "what the window shows (t)", |ui| {
        for (mode, name) in modes {
            if ui.selectable_label(now == mode, name).clicked() {
                panel.ask(Request::SetMode(mode));
            }
        }
    });
}

/// The picture in a file, which is what the key 0 does.
fn to_file(ui: &mut Ui, panel: &mut Panel<'_>) {
    let status = panel.status;
    row(ui, "file", "a picture of this view in a new file", |ui| match status.progress {
        Some(progress) => {
            if ui.button("Cancel").on_hover_text("Esc").clicked() {
                panel.ask(Request::CancelTrace);
            }
            ui.add(ProgressBar::new(progress).show_percentage());
        }
        None => {
            if ui.button("Trace").on_hover_text("0").clicked() {
                panel.ask(Request::Trace);
            }
            if let Some(path) = &status.written {
                let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy();
                ui.weak(name).on_hover_text(path.display().to_string());
            }
        }
    });
}

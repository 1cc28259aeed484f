//! The scene as a whole: its file, undo and redo, and what can be added.

use std::path::{Path, PathBuf};

use egui::{RichText, TextEdit, Ui};

use crate::viewer::editor::New;

use super::Panel;
use super::fields::row;
use super::save::is_taken;
use super::status::Request;
use super::theme;

pub(super) fn show(ui: &mut Ui, panel: &mut Panel<'_>) {
    title(ui, panel);
    ui.horizontal(|ui| history(ui, panel));
    row(ui, "add", "in front of the camera", |ui| {
        ui.horizontal_wrapped(|ui| {
            for (what, name) in New::ALL {
                if ui.button(name).clicked() {
                    panel.editor.add(panel.world, what);
                }
            }
        });
    });
    save(ui, panel);
}

fn title(ui: &mut Ui, panel: &Panel<'_>) {
    let scene = panel.status.scene.as_deref();
    ui.horizontal(|ui| {
        let (name, place) = match scene {
            Some(path) => (file_name(path), path.display().to_string()),
            None => (panel.status.name.clone(), "spawned by a program, not read from a file".to_owned()),
        };
        ui.label(RichText::new(name).heading().strong()).on_hover_text(place);
        if panel.editor.is_modified() {
            let hover = "the scene differs from the file";
            ui.label(RichText::new("modified").small().color(theme::AMBER)).on_hover_text(hover);
        }
    });
}

fn history(ui: &mut Ui, panel: &mut Panel<'_>) {
    let [undo, redo] = [(panel.editor.undoes(), "Ctrl+Z"), (panel.editor.redoes(), "Ctrl+Y")]
        .map(|(what, keys)| (what.is_some(), format!("{} ({keys})", what.unwrap_or("nothing"))));
    let is_file = panel.status.scene.is_some();
    let mut button = |ui: &mut Ui, is_possible: bool, name: &str, hover: String, request: Request| {
        if ui.add_enabled(is_possible, egui::Button::new(name)).on_hover_text(hover).clicked() {
            panel.ask(request);
        }
    };
    button(ui, undo.0, "Undo", undo.1, Request::Undo);
    button(ui, redo.0, "Redo", redo.1, Request::Redo);
    if is_file {
        let hover = "read the file again; can be undone (Insert)".to_owned();
        button(ui, true, "Reload", hover, Request::Reload);
    }
}

/// Saving under a new name is one click. Replacing a file, above all the opened one, is two, the second of which says
/// what will be replaced.
fn save(ui: &mut Ui, panel: &mut Panel<'_>) {
    let (name, written) = (format!("{}.txt", panel.status.name), panel.status.written.as_deref());
    let scene = panel.status.scene.as_deref().unwrap_or(Path::new(&name));
    let path = panel.state.save.path(Some(scene), written);
    let (has_name, is_taken) = (path.file_name().is_some(), is_taken(&path));
    if row(ui, "save as", "a file name", |ui| name_field(ui, panel, &path)) {
        return;
    }
    row(ui, "", "", |ui| {
        if !is_taken {
            if ui.add_enabled(has_name, egui::Button::new("Save")).clicked() {
                panel.save(path, false);
            }
        } else if !panel.state.save.is_armed {
            let replace = format!("Replace {}…", file_name(&path));
            panel.state.save.is_armed =
                ui.add_enabled(has_name, egui::Button::new(replace).truncate()).clicked();
        } else {
            confirm(ui, panel, path);
        }
    });
}

/// Tells whether the name was changed.
fn name_field(ui: &mut Ui, panel: &mut Panel<'_>, path: &Path) -> bool {
    let mut typed = path.to_string_lossy().into_owned();
    let field =
        TextEdit::singleline(&mut typed).font(egui::TextStyle::Monospace).desired_width(f32::INFINITY);
    let changed = ui.add(field).on_hover_text(path.display().to_string()).changed();
    if changed {
        panel.state.save.set(typed);
    }
    changed
}

fn confirm(ui: &mut Ui, panel: &mut Panel<'_>, path: PathBuf) {
    let button = egui::Button::new(RichText::new("Replace it").color(theme::RED));
    if ui.add(button).on_hover_text(path.display().to_string()).clicked() {
        panel.save(path, true);
    } else if ui.button("Keep it").clicked() {
        panel.state.save.is_armed = false;
    }
}

fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned()
}

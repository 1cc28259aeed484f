//! The traced picture: what it shows, and how well.

use core::ops::RangeInclusive;

use egui::{ProgressBar, Ui};

use crate::components::range::{MAX_GRID, MAX_LEVEL, MAX_PIXELS};
use crate::components::{Sampling, Snapshot};

use super::Panel;
use super::fields::{row, whole};
use super::status::Request;
use crate::components::Precision;
use crate::preview::Layout;

pub(super) fn show(ui: &mut Ui, panel: &mut Panel<'_>) {
    modes(ui, panel);
    settings(ui, panel);
    let status = panel.status;
    row(ui, "precision", "of every number that is traced", |ui| {
        for (precision, name) in [(Precision::F64, "f64"), (Precision::F32, "f32")] {
            if ui.selectable_label(status.precision == precision, name).clicked() {
                panel.ask(Request::SetPrecision(precision));
            }
        }
    });
    row(ui, "texture", "images on the checkerboard (space)", |ui| {
        let mut is_on = status.texture;
        if ui.checkbox(&mut is_on, "").changed() {
            panel.ask(Request::ToggleTexture);
        }
    });
    to_file(ui, panel);
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

fn settings(ui: &mut Ui, panel: &mut Panel<'_>) {
    let before = panel.world.get_resource::<Snapshot>().copied().unwrap_or_default();
    let mut snapshot = before;
    whole_row(ui, "pixels", "along each side of a picture in a file", &mut snapshot.pixels, 1..=MAX_PIXELS);
    let hover = "rays that may follow each other: 0 is black, 1 has no mirror image";
    whole_row(ui, "level", hover, &mut snapshot.level, 0..=MAX_LEVEL);
    if snapshot != before {
        panel.editor.change_setting(panel.world, snapshot);
    }
    let before = panel.world.get_resource::<Sampling>().copied().unwrap_or_default();
    let mut sampling = before;
    row(ui, "samples", "a pixel of a picture in a file: a regular grid with so many along each side", |ui| {
        whole(ui, &mut sampling.side, 1..=MAX_GRID);
        ui.weak(format!("² = {}", u64::from(sampling.side).pow(2)));
    });
    if sampling != before {
        panel.editor.change_setting(panel.world, sampling);
    }
}

fn whole_row(ui: &mut Ui, label: &str, hover: &str, value: &mut u32, range: RangeInclusive<u32>) {
    row(ui, label, hover, |ui| whole(ui, value, range));
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

//! What the last picture cost, and what it was made of.

use egui::{RichText, Ui};

use crate::effects::EffectSet;
use crate::systems::{Muted, Survey};

use super::Panel;
use super::digits::grouped;
use super::fields::row;

/// Rays, times and threads.
pub(super) fn figures(ui: &mut Ui, panel: &Panel<'_>) {
    let status = panel.status;
    let rays = status.counts.rays;
    let all = rays.total();
    amount(ui, "camera rays", "one a pixel and sample", rays.primary);
    amount(ui, "shadow rays", "towards lights", rays.shadow);
    amount(ui, "mirror rays", "off mirrors and glass", rays.mirror);
    amount(ui, "refracted rays", "into glass and out of it", rays.refracted);
    amount(ui, "all rays", "of the traced picture that is shown", all);
    let picture = match status.samples {
        0 => "none yet".to_owned(),
        samples => format!("{0} × {0}, {samples} samples", status.side),
    };
    text(ui, "picture", "pixels and samples a pixel of the traced picture that is shown", picture);
    text(ui, "traced in", "milliseconds for that picture", milliseconds(status.traced));
    text(ui, "frame", "milliseconds for the last frame of the window", milliseconds(status.frame));
    text(ui, "threads", "that trace", status.threads.to_string());
    if status.counts.non_finite > 0 {
        amount(
            ui,
            "not finite",
            "pixels whose light came out infinite; they are black",
            status.counts.non_finite,
        );
    }
}

/// Effects, with the rows that ask for them and a switch where an entity does, and tables.
pub(super) fn effects(ui: &mut Ui, panel: &mut Panel<'_>) {
    let survey = panel.world.get_resource::<Survey>().cloned().unwrap_or_default();
    let before = panel.world.get_resource::<Muted>().copied().unwrap_or_default();
    let mut muted = before;
    for count in &panel.status.effects {
        let hover = "rows that ask for it; the trace never touches an effect without any";
        if survey.entities(count.effect) == 0 {
            rows(ui, count.effect.name(), count.rows, hover);
            continue;
        }
        row(ui, &count.effect.name().replace('_', " "), hover, |ui| {
            let mut is_on = !muted.0.contains(count.effect);
            if ui.checkbox(&mut is_on, grouped(rows_of(count.rows))).changed() {
                muted.0 = if is_on {
                    muted.0.without(count.effect)
                } else {
                    muted.0.union(EffectSet::of(&[count.effect]))
                };
            }
        });
    }
    if muted != before {
        panel.editor.change_setting(panel.world, muted);
    }
    ui.add_space(3.0);
    for count in &panel.status.tables {
        rows(ui, count.table, count.rows, "rows of the table");
    }
}

fn rows(ui: &mut Ui, name: &str, count: usize, hover: &str) {
    let count = rows_of(count);
    let number = RichText::new(grouped(count)).monospace();
    row(ui, &name.replace('_', " "), hover, |ui| ui.label(if count == 0 { number.weak() } else { number }));
}

fn rows_of(count: usize) -> u64 {
    u64::try_from(count).unwrap_or(u64::MAX)
}

fn amount(ui: &mut Ui, label: &str, hover: &str, amount: u64) {
    text(ui, label, hover, grouped(amount));
}

fn text(ui: &mut Ui, label: &str, hover: &str, text: String) {
    row(ui, label, hover, |ui| ui.monospace(text));
}

fn milliseconds(value: f64) -> String {
    format!("{value:.1} ms")
}

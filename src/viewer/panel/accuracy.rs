//! Every knob that trades truth for time.

use bevy_ecs::prelude::*;
use egui::Ui;

use crate::components::range::{COEFFICIENT, MAX_GRID, MAX_LEVEL, MAX_LIGHT_SAMPLES, MAX_PIXELS};
use crate::components::{AreaLight, Checkerboard, Precision, TextureFilter, Textured};
use crate::study::{Preset, Setting};
use crate::viewer::editor::{accuracy, own_level};

use super::Panel;
use super::fields::{number, row, share_of_width, whole, whole_row};

/// What adaptive sampling is switched on with: half a level of 256 in every second pixel.
const THRESHOLD: f64 = 1.0 / 128.0;

pub(super) fn show(ui: &mut Ui, panel: &mut Panel<'_>) {
    let before = accuracy(panel.world);
    let mut setting = before;
    presets(ui, panel.world, &mut setting);
    whole_row(ui, "pixels", "along each side of a picture in a file", &mut setting.pixels, 1..=MAX_PIXELS);
    samples(ui, &mut setting);
    let hover = "rays that may follow each other: 0 is black, 1 has no mirror image";
    whole_row(ui, "level", hover, &mut setting.level, 0..=MAX_LEVEL);
    row(ui, "cutoff", "no ray is followed that carries no more than this share of a pixel's light", |ui| {
        let speed = (setting.cutoff / 50.0).max(0.0005);
        number(ui, &mut setting.cutoff, &COEFFICIENT, speed, share_of_width(ui, 3.0));
    });
    row(ui, "precision", "of every number that is traced", |ui| {
        let both = [(Precision::F64, "f64"), (Precision::F32, "f32")];
        choice(ui, &mut setting.precision, &both);
    });
    filters(ui, panel.world, &mut setting);
    if setting != before {
        panel.editor.change_accuracy(panel.world, &setting);
    }
}

/// Presets mean what they mean for the scene, however its level has been turned since.
fn presets(ui: &mut Ui, world: &World, setting: &mut Setting) {
    let scene = Setting { level: own_level(world).unwrap_or(setting.level), ..*setting };
    row(ui, "preset", "all knobs at once, from fast to true", |ui| {
        for preset in Preset::ALL {
            let meant = preset.of(scene);
            if ui.selectable_label(*setting == meant, preset.name()).clicked() {
                *setting = meant;
            }
        }
    });
}

fn samples(ui: &mut Ui, setting: &mut Setting) {
    row(ui, "samples", "a pixel of a picture in a file: a regular grid with so many along each side", |ui| {
        whole(ui, &mut setting.side, 1..=MAX_GRID);
        ui.weak(format!("² = {}", u64::from(setting.side).pow(2)));
    });
    let hover =
        "samples one after the other, in each pixel until its error is expected to be no more than this";
    row(ui, "adaptive", hover, |ui| {
        let mut is_on = setting.threshold.is_some();
        if ui.checkbox(&mut is_on, "").changed() {
            setting.threshold = is_on.then_some(THRESHOLD);
        }
        if let Some(threshold) = &mut setting.threshold {
            number(ui, threshold, &COEFFICIENT, (*threshold / 50.0).max(1e-5), share_of_width(ui, 3.0));
            ui.weak(format!("= {:.1} levels", *threshold * 255.0));
        }
    });
}

/// Only what the scene has something for.
fn filters(ui: &mut Ui, world: &mut World, setting: &mut Setting) {
    let mut boards = world.query_filtered::<Has<Textured>, With<Checkerboard>>();
    let (images, plain): (Vec<bool>, Vec<bool>) = boards.iter(world).partition(|&has_images| has_images);
    if !plain.is_empty() {
        let hover = "the mean of the cells that a pixel covers, instead of the one in its middle";
        row(ui, "cells", hover, |ui| ui.checkbox(&mut setting.checker_filter, "filtered"));
    }
    if !images.is_empty() {
        row(ui, "images", "how they are read", |ui| {
            use TextureFilter::{Bilinear, Mip, Nearest};
            let all = [(Some(Nearest), "nearest"), (Some(Bilinear), "bilinear"), (Some(Mip), "mip")];
            choice(ui, &mut setting.texture_filter, &all);
        });
    }
    let most = world.query::<&AreaLight>().iter(world).map(|light| light.samples).max();
    if let Some(most) = most {
        row(ui, "shadows", "rays towards each area light", |ui| {
            let mut samples = setting.light_samples.unwrap_or(most);
            whole(ui, &mut samples, 1..=MAX_LIGHT_SAMPLES);
            if samples != most {
                setting.light_samples = Some(samples);
            }
        });
    }
}

fn choice<V: PartialEq + Copy>(ui: &mut Ui, value: &mut V, all: &[(V, &str)]) {
    for (other, name) in all {
        if ui.selectable_label(*value == *other, *name).clicked() {
            *value = *other;
        }
    }
}

//! The strip at the lower edge of the scene: what the picture has cost, how good it is, and a slider from faster to truer.

use bevy_ecs::prelude::*;
use egui::{Area, Color32, Frame, Id, Label, Margin, Order, Rect, RichText, Sense, Slider, Ui, pos2, vec2};

use crate::study::{FrontPoint, Preset, Setting, error_share, false_color};
use crate::viewer::editor::{Editor, accuracy};
use crate::viewer::live::Shows;
use crate::viewer::steps::{is_at, nearest, steps};

use super::is_held;
use super::status::{Request, Status};

/// Width in points below which there is no strip, and below which it has no slider.
const LEAST: f32 = 440.0;
const WITH_SLIDER: f32 = 640.0;
const HEIGHT: f32 = 26.0;
/// Width of a heat map's scale, and its steps.
const SCALE: f32 = 128.0;
const STEPS: u8 = 64;

/// Shows the strip over the lower edge of what a root `Ui` has left.
pub(crate) fn show_strip(
    ui: &mut Ui,
    world: &mut World,
    editor: &mut Editor,
    status: &Status,
) -> Vec<Request> {
    let free = ui.available_rect_before_wrap();
    let mut requests = Vec::new();
    if !status.strip || free.width() < LEAST {
        return requests;
    }
    if !is_held(ui) {
        editor.end_gesture();
    }
    let area = Area::new(Id::unique("strip")).order(Order::Middle).constrain(false);
    area.fixed_pos(pos2(free.left(), free.bottom() - HEIGHT)).show(ui.ctx(), |ui| {
        let fill = ui.visuals().window_fill.gamma_multiply(0.8);
        let frame = Frame::new().fill(fill).inner_margin(Margin::symmetric(8, 2));
        frame.show(ui, |ui| {
            ui.set_width(free.width() - 16.0);
            ui.set_height(HEIGHT - 4.0);
            ui.horizontal_centered(|ui| {
                figures(ui, status);
                scale(ui, status);
                if free.width() >= WITH_SLIDER {
                    slider(ui, world, editor, status, &mut requests);
                }
            });
        });
    });
    requests
}

/// What the picture shown has cost, and its error.
fn figures(ui: &mut Ui, status: &Status) {
    if status.picture.is_none() {
        return;
    }
    let pixels = f64::from(status.side).powi(2).max(1.0);
    let rays = f64::from(u32::try_from(status.counts.rays.total()).unwrap_or(u32::MAX)) / pixels;
    text(ui, format!("{:.1} ms", status.traced), "of the trace of this picture");
    if status.picture != Some(Shows::Rays) {
        text(ui, format!("{rays:.2} rays/pixel"), "rays of all kinds");
    }
    match status.error {
        Some(error) => text(ui, error_in_words(error), &error_in_decibels(error)),
        None => text(ui, "error not known yet".into(), "estimated when all samples are there"),
    }
}

fn text(ui: &mut Ui, text: String, hover: &str) {
    ui.add(Label::new(RichText::new(text).small())).on_hover_text(hover);
}

/// A root mean squared error, 0 to 1, in levels of 8 bits.
pub(super) fn error_in_words(error: f64) -> String {
    match error * 255.0 {
        levels if levels < 0.05 => "error below 0.1 levels (estimated)".into(),
        levels if levels < 9.95 => format!("error about {levels:.1} levels (estimated)"),
        levels => format!("error about {levels:.0} levels (estimated)"),
    }
}

fn error_in_decibels(error: f64) -> String {
    let how =
        "root mean square, told by how the samples of pixels differ; nothing that no sample has met is in it";
    if error > 0.0 { format!("{:.0} dB; {how}", -20.0 * error.log10()) } else { how.to_owned() }
}

/// What the colours of a heat map stand for.
fn scale(ui: &mut Ui, status: &Status) {
    let (ends, share): (_, fn(f64) -> f64) = match status.picture {
        // Places on the bar are levels; their colours are those of the map.
        Some(Shows::Errors) => {
            (format!("{:.0} levels", status.most), |place| error_share(place * 64.0 / 255.0))
        }
        Some(Shows::Rays) => (format!("{:.0} rays/pixel", status.most), |place| place),
        Some(Shows::Picture) | None => return,
    };
    text(ui, "0".into(), "black");
    let (bar, _) = ui.allocate_exact_size(vec2(SCALE, 10.0), Sense::hover());
    let width = SCALE / f32::from(STEPS);
    for step in 0..STEPS {
        let [red, green, blue] = false_color(share(f64::from(step) / f64::from(STEPS - 1)));
        let left = bar.left() + f32::from(step) * width;
        let part = Rect::from_min_max(pos2(left, bar.top()), pos2(left + width, bar.bottom()));
        ui.painter().rect_filled(part, 0.0, Color32::from_rgb(red, green, blue));
    }
    text(ui, ends, "and more");
}

/// Moves along what is known of the scene's front; along the presets as long as nothing is.
fn slider(ui: &mut Ui, world: &mut World, editor: &mut Editor, status: &Status, requests: &mut Vec<Request>) {
    let now = accuracy(world);
    let steps = steps(world, now, &status.front.points);
    let before = nearest(&steps, &now);
    let mut place = before;
    ui.separator();
    ui.weak("faster");
    ui.spacing_mut().slider_width = 110.0;
    let most = steps.len().saturating_sub(1);
    ui.add(Slider::new(&mut place, 0..=most).show_value(false)).on_hover_text("of a picture in a file");
    ui.weak("truer");
    if place != before
        && let Some(setting) = steps.get(place)
    {
        editor.change_accuracy(world, setting);
    }
    let price = status.front.points.get(place).filter(|point| is_at(&point.setting, &accuracy(world)));
    match price {
        Some(point) => text(ui, price_in_words(point), "of a picture in a file, predicted from parts of it"),
        None => text(ui, name(&steps, place), "of a picture in a file"),
    }
    if status.front.is_under_way {
        ui.weak("measuring");
    } else if status.is_complete
        && ui.small_button("measure").on_hover_text("what accuracy costs here").clicked()
    {
        requests.push(Request::MeasureFront);
    }
}

fn name(steps: &[Setting], place: usize) -> String {
    let preset = Preset::ALL.get(place).filter(|_| steps.len() == Preset::ALL.len());
    preset.map_or_else(String::new, |preset| preset.name().to_owned())
}

fn price_in_words(point: &FrontPoint) -> String {
    let price = format!("about {:.0} ms", point.milliseconds);
    match point.psnr_db() {
        decibels if decibels.is_finite() => format!("{price}, {decibels:.0} dB (predicted)"),
        _ => format!("{price} (predicted)"),
    }
}

//! One row a value: its label, and what it is edited with. Every function tells whether the value changed.

use core::ops::RangeInclusive;

use egui::emath::Numeric;
use egui::{Align, DragValue, Id, Key, Layout, Slider, SliderClamping, Ui, vec2};
use glam::DVec3;

use crate::components::range::{COORDINATE, Range};

use super::digits::{exact, parse, short};
use super::name::bytes;

/// Width of the labels.
const LABEL: f32 = 76.0;
/// Width of a number beside a slider.
const NUMBER: f32 = 58.0;

/// A label, with more about it while the pointer rests there, and what belongs to it on its right.
pub(super) fn row<R>(ui: &mut Ui, label: &str, hover: &str, contents: impl FnOnce(&mut Ui) -> R) -> R {
    let whole = ui.horizontal(|ui| {
        let size = vec2(LABEL, ui.spacing().interact_size.y);
        ui.allocate_ui_with_layout(size, Layout::left_to_right(Align::Center), |ui| {
            ui.set_min_width(LABEL);
            ui.weak(label).on_hover_text(hover);
        });
        contents(ui)
    });
    whole.inner
}

/// A number that is dragged or typed. While it is typed all its digits are shown, else at most six.
pub(super) fn number(ui: &mut Ui, value: &mut f64, range: &Range, speed: f64, width: f32) -> bool {
    let before = value.to_bits();
    let is_typed = ui.memory(|memory| memory.has_focus(ui.next_auto_id()));
    let format = move |value, _| if is_typed { exact(value) } else { short(value) };
    let drag = drag_value(ui, width, |new| limit(value, new, range)).speed(speed);
    ui.add(drag.custom_formatter(format).custom_parser(parse));
    value.to_bits() != before
}

/// A whole number that is dragged or typed.
pub(super) fn whole(ui: &mut Ui, value: &mut u32, range: RangeInclusive<u32>) {
    let mut limited = |new: Option<f64>| {
        if let Some(new) = new {
            *value = u32::from_f64(new.round()).clamp(*range.start(), *range.end());
        }
        f64::from(*value)
    };
    let drag = drag_value(ui, NUMBER, &mut limited);
    ui.add(drag.speed(0.25).max_decimals(0).custom_parser(parse));
}

/// A whole number in a row of its own.
pub(super) fn whole_row(
    ui: &mut Ui,
    label: &str,
    hover: &str,
    value: &mut u32,
    range: RangeInclusive<u32>,
) -> bool {
    let before = *value;
    row(ui, label, hover, |ui| whole(ui, value, range));
    *value != before
}

/// A value that is not touched by being shown, whatever it is.
fn drag_value<'a>(ui: &Ui, width: f32, mut get_set: impl FnMut(Option<f64>) -> f64 + 'a) -> DragValue<'a> {
    let is_given_up = is_given_up(ui);
    DragValue::from_get_set(move |new| get_set(new.filter(|_| !is_given_up)))
        .min_size(vec2(width, ui.spacing().interact_size.y))
        .clip_text(true)
        .clamp_existing_to_range(false)
        // Half of a typed number is another number.
        .update_while_editing(false)
}

/// Where it is remembered when Escape was pressed last.
const ESCAPED: &str = "the last frame with Escape";

/// To be called once a frame, before any field. `egui` takes what was typed into a number when it has lost the
/// keyboard, and for two frames looks for that; after Escape it lets the text go in the first of them only.
pub(super) fn note_escape(ui: &Ui) {
    if ui.input(|input| input.key_pressed(Key::Escape)) {
        let frame = ui.ctx().cumulative_frame_nr();
        ui.data_mut(|data| data.insert_temp(Id::unique(ESCAPED), frame));
    }
}

fn is_given_up(ui: &Ui) -> bool {
    let escaped: Option<u64> = ui.data(|data| data.get_temp(Id::unique(ESCAPED)));
    escaped.is_some_and(|frame| ui.ctx().cumulative_frame_nr() <= frame + 1)
}

/// Sets a value to what is allowed and closest to a new one.
fn limit(value: &mut f64, new: Option<f64>, range: &Range) -> f64 {
    if let Some(allowed) = new.and_then(|new| range.nearest(new)) {
        *value = allowed;
    }
    *value
}

/// A number in a row of its own.
pub(super) fn number_row(
    ui: &mut Ui,
    label: &str,
    hover: &str,
    value: &mut f64,
    (range, speed): (&Range, f64),
) -> bool {
    row(ui, label, hover, |ui| number(ui, value, range, speed, ui.available_width()))
}

/// A length, dragged in proportion to itself.
pub(super) fn length_row(ui: &mut Ui, label: &str, hover: &str, value: &mut f64, range: &Range) -> bool {
    let speed = relative(*value);
    number_row(ui, label, hover, value, (range, speed))
}

/// A hundredth of a value a pixel.
pub(super) fn relative(value: f64) -> f64 {
    (value.abs() / 100.0).max(f64::MIN_POSITIVE)
}

/// A point or direction in world units.
pub(super) fn point_row(ui: &mut Ui, label: &str, hover: &str, point: &mut DVec3, speed: f64) -> bool {
    row(ui, label, hover, |ui| triple(ui, point, (&COORDINATE, speed)))
}

/// Three numbers beside each other.
pub(super) fn triple(ui: &mut Ui, values: &mut DVec3, (range, speed): (&Range, f64)) -> bool {
    let width = share_of_width(ui, 3.0);
    let mut number = |value: &mut f64| number(ui, value, range, speed, width);
    number(&mut values.x) | number(&mut values.y) | number(&mut values.z)
}

/// Width of one of so many equal parts of the rest of a row.
pub(super) fn share_of_width(ui: &Ui, parts: f32) -> f32 {
    ((ui.available_width() - (parts - 1.0) * ui.spacing().item_spacing.x) / parts).max(20.0)
}

/// A part of a whole, from 0 to 1.
pub(super) fn share_row(ui: &mut Ui, label: &str, hover: &str, value: &mut f64, range: &Range) -> bool {
    row(ui, label, hover, |ui| {
        let before = value.to_bits();
        ui.spacing_mut().slider_width = ui.available_width() - NUMBER - ui.spacing().item_spacing.x;
        // The slider never touches a value that it is not asked to change, whatever that value is.
        let slider = Slider::from_get_set(0.0..=1.0, |new| limit(value, new, range));
        ui.add(slider.show_value(false).clamping(SliderClamping::Edits));
        number(ui, value, range, 0.005, NUMBER);
        value.to_bits() != before
    })
}

/// A colour: a swatch that opens a picker, and its three numbers.
pub(super) fn color_row(ui: &mut Ui, label: &str, hover: &str, color: &mut DVec3, range: &Range) -> bool {
    row(ui, label, hover, |ui| pick(ui, color) | triple(ui, color, (range, 0.005)))
}

/// The picker knows 8 bits a channel. A channel that it leaves as it is keeps all its digits, and what is above 1.
fn pick(ui: &mut Ui, color: &mut DVec3) -> bool {
    let before = bytes(*color);
    let mut after = before;
    ui.color_edit_button_srgb(&mut after);
    let channels = color.as_mut().iter_mut().zip(before.into_iter().zip(after));
    for (channel, (before, after)) in channels {
        if before != after {
            *channel = f64::from(after) / 255.0;
        }
    }
    before != after
}

//! What is shown over the scene whether the panel is there or not: messages, and how far a picture for a file is.

use egui::{
    Align, Align2, Area, Context, Frame, Id, Label, Layout, Margin, Order, ProgressBar, RichText, ScrollArea,
    Stroke, Ui, vec2,
};

use super::messages::Message;
use super::status::{Request, Status};
use super::theme;

/// Most width and height of a message, in points.
const MOST: [f32; 2] = [560.0, 260.0];

/// Shows messages in the lower left corner. Nothing else covers the scene.
pub(crate) fn show_overlay(ctx: &Context, status: &Status) -> Vec<Request> {
    let mut requests = Vec::new();
    if status.messages.is_empty() && status.progress.is_none() {
        return requests;
    }
    let width = (ctx.content_rect().width() - 24.0).clamp(80.0, MOST[0]);
    let area = Area::new(Id::unique("messages"))
        .anchor(Align2::LEFT_BOTTOM, vec2(12.0, -12.0))
        .order(Order::Foreground);
    area.show(ctx, |ui| {
        ui.set_max_width(width);
        for (place, message) in status.messages.iter().enumerate() {
            if ui.push_id(message.about, |ui| show(ui, message)).inner {
                requests.push(Request::Dismiss(place));
            }
        }
        if let Some(progress) = status.progress
            && show_progress(ui, progress)
        {
            requests.push(Request::CancelTrace);
        }
    });
    requests
}

fn frame(ui: &Ui, line: egui::Color32) -> Frame {
    let fill = ui.visuals().window_fill.gamma_multiply(0.94);
    Frame::new()
        .fill(fill)
        .stroke(Stroke::new(1.0, line))
        .corner_radius(4)
        .inner_margin(Margin::symmetric(10, 7))
}

/// Tells whether the message is to go.
fn show(ui: &mut Ui, message: &Message) -> bool {
    let line = if message.is_error { theme::RED } else { ui.visuals().window_stroke.color };
    let framed = frame(ui, line).show(ui, |ui| {
        let is_dismissed = ui.horizontal(|ui| title(ui, message)).inner;
        if !message.detail.is_empty() {
            let area = ScrollArea::both().max_height(MOST[1]).auto_shrink([true, true]);
            area.show(ui, |ui| ui.add(Label::new(RichText::new(&message.detail).monospace()).extend()));
        }
        is_dismissed
    });
    framed.inner
}

fn title(ui: &mut Ui, message: &Message) -> bool {
    // The button first, from the right, so that the title gets what is left of the width.
    let text = RichText::new(&message.title);
    let text = if message.is_error { text.color(theme::RED) } else { text.strong() };
    let width = ui.available_width() - 30.0;
    ui.scope(|ui| {
        ui.set_max_width(width);
        ui.add(Label::new(text).wrap());
    });
    let button = |ui: &mut Ui| ui.small_button("×").on_hover_text("dismiss (Esc)").clicked();
    ui.with_layout(Layout::left_to_right(Align::Center), button).inner
}

/// Tells whether the picture is to be given up.
fn show_progress(ui: &mut Ui, progress: f32) -> bool {
    let framed = frame(ui, ui.visuals().window_stroke.color).show(ui, |ui| {
        let row = ui.horizontal(|ui| {
            ui.label("tracing");
            ui.add(ProgressBar::new(progress).desired_width(220.0).show_percentage());
            let is_cancelled = ui.small_button("×").on_hover_text("cancel").clicked();
            ui.weak("Esc cancels");
            is_cancelled
        });
        row.inner
    });
    framed.inner
}

//! Colours, letters and distances.

use core::num::NonZeroUsize;

use egui::{
    Color32, Context, CornerRadius, FontFamily, FontId, Margin, Stroke, Style, SurrenderFocusOn, TextStyle,
    Theme, Visuals, vec2,
};

/// Marks what differs from the file, and warnings.
pub(super) const AMBER: Color32 = Color32::from_rgb(224, 168, 92);
/// Marks what is wrong.
pub(super) const RED: Color32 = Color32::from_rgb(232, 110, 96);
/// Marks what is selected or under way.
const BLUE: Color32 = Color32::from_rgb(62, 92, 122);
const BACKGROUND: Color32 = Color32::from_rgb(23, 24, 27);
const RAISED: Color32 = Color32::from_rgb(40, 42, 46);
const SUNKEN: Color32 = Color32::from_rgb(15, 16, 18);
const LINE: Color32 = Color32::from_rgb(48, 50, 55);
const TEXT: Color32 = Color32::from_rgb(196, 198, 202);
const STRONG: Color32 = Color32::from_rgb(232, 233, 235);
const WEAK: Color32 = Color32::from_rgb(128, 132, 139);

/// Gives a context the look of the panel. To be called once.
pub(crate) fn apply(ctx: &Context) {
    ctx.set_theme(Theme::Dark);
    ctx.style_mut_of(Theme::Dark, dress);
    ctx.options_mut(|options| {
        // Those keys belong to the scene.
        options.zoom_with_keyboard = false;
        // What was typed counts before a click selects something else, and before a drag changes something else.
        options.input_options.surrender_focus_on = SurrenderFocusOn::Presses;
        // A frame that is laid out twice would take every click twice.
        options.max_passes = NonZeroUsize::MIN;
    });
}

fn dress(style: &mut Style) {
    use FontFamily::{Monospace, Proportional};
    style.text_styles = [
        (TextStyle::Small, FontId::new(11.0, Proportional)),
        (TextStyle::Body, FontId::new(13.0, Proportional)),
        (TextStyle::Button, FontId::new(13.0, Proportional)),
        (TextStyle::Heading, FontId::new(15.0, Proportional)),
        (TextStyle::Monospace, FontId::new(12.0, Monospace)),
    ]
    .into();
    style.drag_value_text_style = TextStyle::Monospace;
    style.animation_time = 0.08;
    style.interaction.selectable_labels = false;
    let spacing = &mut style.spacing;
    spacing.item_spacing = vec2(6.0, 5.0);
    spacing.button_padding = vec2(7.0, 2.0);
    spacing.interact_size = vec2(30.0, 20.0);
    spacing.indent = 16.0;
    spacing.tooltip_width = 300.0;
    spacing.menu_margin = Margin::same(8);
    style.visuals = visuals();
}

fn visuals() -> Visuals {
    let mut visuals = Visuals::dark();
    visuals.panel_fill = BACKGROUND;
    visuals.window_fill = BACKGROUND;
    visuals.window_stroke = Stroke::new(1.0, LINE);
    visuals.extreme_bg_color = SUNKEN;
    visuals.weak_text_color = Some(WEAK);
    visuals.error_fg_color = RED;
    visuals.warn_fg_color = AMBER;
    visuals.selection.bg_fill = BLUE;
    visuals.selection.stroke = Stroke::new(1.0, STRONG);
    visuals.indent_has_left_vline = false;
    visuals.slider_trailing_fill = true;
    let widgets = &mut visuals.widgets;
    widgets.noninteractive.bg_stroke = Stroke::new(1.0, LINE);
    widgets.noninteractive.fg_stroke = Stroke::new(1.0, TEXT);
    widgets.inactive.weak_bg_fill = RAISED;
    widgets.inactive.bg_fill = RAISED;
    widgets.inactive.fg_stroke = Stroke::new(1.0, TEXT);
    widgets.hovered.weak_bg_fill = Color32::from_rgb(52, 54, 59);
    widgets.hovered.bg_fill = Color32::from_rgb(62, 65, 70);
    widgets.hovered.bg_stroke = Stroke::new(1.0, Color32::from_rgb(86, 90, 97));
    widgets.hovered.fg_stroke = Stroke::new(1.0, STRONG);
    widgets.active.weak_bg_fill = BLUE;
    widgets.active.bg_fill = BLUE;
    widgets.active.bg_stroke = Stroke::new(1.0, Color32::from_rgb(110, 140, 170));
    widgets.active.fg_stroke = Stroke::new(1.0, STRONG);
    widgets.open.weak_bg_fill = RAISED;
    let all = [&mut widgets.inactive, &mut widgets.hovered, &mut widgets.active, &mut widgets.open];
    all.into_iter().for_each(|widget| widget.corner_radius = CornerRadius::same(3));
    visuals
}

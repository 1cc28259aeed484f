//! A screen without a window: events in, what can be read and clicked out.

use bevy_ecs::prelude::*;
use egui::accesskit::{Node, Role};
use egui::{Context, Event, FullOutput, Key, Modifiers, PointerButton, Pos2, RawInput, Rect, pos2, vec2};

use super::super::{PanelState, Request, Status, apply_theme, show, show_overlay, show_strip};
use crate::scene::{parse, spawn};
use crate::viewer::editor::Editor;

/// Panel, overlay, and everything that they work on.
pub(super) struct Screen {
    pub(super) ctx: Context,
    pub(super) world: World,
    pub(super) editor: Editor,
    pub(super) status: Status,
    pub(super) state: PanelState,
    pub(super) is_panel_open: bool,
    nodes: Vec<Node>,
    events: Vec<Event>,
    time: f64,
}

impl Screen {
    pub(super) fn new(world: World) -> Self {
        let ctx = Context::default();
        apply_theme(&ctx);
        ctx.enable_accesskit();
        // Nothing is still moving when the next event comes.
        ctx.all_styles_mut(|style| style.animation_time = 0.0);
        let mut screen = Self {
            ctx,
            world,
            editor: Editor::default(),
            status: Status::default(),
            state: PanelState::default(),
            is_panel_open: true,
            nodes: Vec::new(),
            events: Vec::new(),
            time: 0.0,
        };
        screen.settle();
        screen
    }

    pub(super) fn of_file(name: &str) -> Self {
        let path = format!("{}/scenes/{name}", env!("CARGO_MANIFEST_DIR"));
        let mut world = World::new();
        spawn(&mut world, &parse(&std::fs::read_to_string(path).unwrap()).unwrap().0);
        Self::new(world)
    }

    /// One frame, with its drawing.
    pub(super) fn draw(&mut self) -> (Vec<Request>, FullOutput) {
        self.time += 1.0 / 60.0;
        let input = RawInput {
            screen_rect: Some(Rect::from_min_size(Pos2::ZERO, vec2(1100.0, 1400.0))),
            time: Some(self.time),
            events: std::mem::take(&mut self.events),
            ..RawInput::default()
        };
        let mut requests = Vec::new();
        let mut output = self.ctx.clone().run_ui(input, |ui| {
            if self.is_panel_open {
                requests.extend(show(ui, &mut self.world, &mut self.editor, &self.status, &mut self.state));
            }
            requests.extend(show_strip(ui, &mut self.world, &mut self.editor, &self.status));
            requests.extend(show_overlay(ui.ctx(), &self.status));
        });
        let update = output.platform_output.accesskit_update.take().unwrap();
        self.nodes = update.nodes.into_iter().map(|(_, node)| node).collect();
        (requests, output)
    }

    /// One frame.
    pub(super) fn frame(&mut self) -> Vec<Request> {
        let (requests, output) = self.draw();
        output.drop_without_applying_deltas();
        requests
    }

    /// Frames in which nothing happens, until everything has its size.
    pub(super) fn settle(&mut self) -> Vec<Request> {
        (0..3).flat_map(|_| self.frame()).collect()
    }

    pub(super) fn event(&mut self, event: Event) -> Vec<Request> {
        self.events.push(event);
        self.frame()
    }

    /// Presses or releases the pointer's button where the pointer is.
    pub(super) fn button(&mut self, pos: Pos2, pressed: bool) -> Vec<Request> {
        let (button, modifiers) = (PointerButton::Primary, Modifiers::NONE);
        self.event(Event::PointerButton { pos, button, pressed, modifiers })
    }

    pub(super) fn press(&mut self, pos: Pos2) -> Vec<Request> {
        let mut requests = self.event(Event::PointerMoved(pos));
        requests.extend(self.button(pos, true));
        requests
    }

    pub(super) fn release(&mut self, pos: Pos2) -> Vec<Request> {
        self.button(pos, false)
    }

    /// Press, release, and a few frames more.
    pub(super) fn click(&mut self, pos: Pos2) -> Vec<Request> {
        let mut requests = self.press(pos);
        requests.extend(self.release(pos));
        // The next click is not the second of a double click.
        self.time += 1.0;
        requests.extend(self.settle());
        requests
    }

    pub(super) fn click_on(&mut self, text: &str) -> Vec<Request> {
        self.click(self.find(text).center())
    }

    /// Drags from a place over some pixels to the right, a few at a time.
    pub(super) fn drag(&mut self, from: Pos2, pixels: f32) {
        self.press(from);
        let mut at = from;
        for _ in 0..5 {
            at.x += pixels / 5.0;
            self.event(Event::PointerMoved(at));
        }
        self.release(at);
        self.time += 1.0;
        self.settle();
    }

    pub(super) fn key(&mut self, key: Key) -> Vec<Request> {
        let event = |pressed| Event::Key {
            key,
            physical_key: None,
            pressed,
            repeat: false,
            modifiers: Modifiers::NONE,
        };
        let mut requests = self.event(event(true));
        requests.extend(self.event(event(false)));
        requests
    }

    /// Types a text in place of what the focused field holds.
    pub(super) fn type_text(&mut self, text: &str) {
        let modifiers = Modifiers::COMMAND;
        self.event(Event::Key { key: Key::A, physical_key: None, pressed: true, repeat: false, modifiers });
        self.key(Key::Backspace);
        self.event(Event::Text(text.to_owned()));
    }

    pub(super) fn all_of(&self, text: &str) -> Vec<Rect> {
        self.nodes.iter().filter(|node| said(node) == text).filter_map(bounds).collect()
    }

    /// Whether there is something with exactly this text.
    pub(super) fn has(&self, text: &str) -> bool {
        !self.all_of(text).is_empty()
    }

    /// Where a text is; the uppermost if there are several.
    pub(super) fn find(&self, text: &str) -> Rect {
        let uppermost = self.all_of(text).into_iter().min_by(|a, b| a.top().total_cmp(&b.top()));
        uppermost.unwrap_or_else(|| panic!("no `{text}` among {:#?}", self.texts()))
    }

    /// The numbers in the row of a label, from left to right.
    pub(super) fn numbers(&self, label: &str) -> Vec<Rect> {
        self.right_of(label, |node| matches!(node.role(), Role::SpinButton | Role::TextInput))
    }

    /// The sliders in the row of a label.
    pub(super) fn sliders(&self, label: &str) -> Vec<Rect> {
        self.right_of(label, |node| node.role() == Role::Slider)
    }

    /// The switches in the row of a label.
    pub(super) fn switches(&self, label: &str) -> Vec<Rect> {
        self.right_of(label, |node| node.role() == Role::CheckBox)
    }

    fn right_of(&self, label: &str, is_it: impl Fn(&Node) -> bool) -> Vec<Rect> {
        let label = self.find(label);
        let nodes = self.nodes.iter().filter(|node| is_it(node)).filter_map(bounds);
        let mut row: Vec<Rect> =
            nodes.filter(|at| at.y_range().contains(label.center().y) && at.left() > label.left()).collect();
        row.sort_by(|a, b| a.left().total_cmp(&b.left()));
        row
    }

    /// Everything that can be read.
    pub(super) fn texts(&self) -> Vec<&str> {
        self.nodes.iter().map(said).filter(|text| !text.is_empty()).collect()
    }

    /// An entity by its name in the list.
    pub(super) fn first<C: Component>(&mut self) -> Entity {
        self.world.query_filtered::<Entity, With<C>>().iter(&self.world).next().unwrap()
    }
}

fn said(node: &Node) -> &str {
    node.label().or(node.value()).unwrap_or_default()
}

#[expect(clippy::cast_possible_truncation, reason = "places on a screen")]
fn bounds(node: &Node) -> Option<Rect> {
    let at = node.bounds()?;
    Some(Rect::from_min_max(pos2(at.x0 as f32, at.y0 as f32), pos2(at.x1 as f32, at.y1 as f32)))
}

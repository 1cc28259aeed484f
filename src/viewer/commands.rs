//! What keys and panel ask of the session.

use bevy_ecs::prelude::*;

use crate::components::{Checkerboard, Textured};
use crate::preview::Layout;

use super::command::Command;
use super::files::Occasion;
use super::live::Shows;
use super::panel::name_of;
use super::report::Happened;
use super::session::{Session, Switches};
use super::steps::Way;

/// What becomes of the window after a command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Then {
    /// It stays.
    Stay,
    /// It closes.
    Close,
}

impl Session {
    /// Does what a key or a button asks for.
    pub(super) fn command(&mut self, command: Command) -> Then {
        match command {
            Command::Camera(step) => self.ask([step]),
            Command::Reload => self.reload(Occasion::Asked),
            Command::Trace => self.trace(),
            Command::Cancel => self.cancel(),
            Command::ToggleTexture => self.toggle_texture(),
            Command::NextMode => self.set_mode(next(self.switches.mode)),
            Command::NextShows => self.set_shows(next_shows(self.switches.shows)),
            Command::ToggleStrip => self.switch("strip", |switches| &mut switches.strip),
            Command::Faster => self.step_accuracy(Way::Faster),
            Command::Truer => self.step_accuracy(Way::Truer),
            Command::TogglePanel => self.switch("panel", |switches| &mut switches.panel),
            Command::ToggleLights => self.switch("lights", |switches| &mut switches.lights),
            Command::ToggleAxes => self.switch("axes", |switches| &mut switches.axes),
            Command::Undo => self.undo(),
            Command::Redo => self.redo(),
            Command::Save => self.save_as_new(),
            Command::Duplicate => {
                self.editor.duplicate(&mut self.world);
            }
            Command::Delete => {
                self.editor.delete(&mut self.world);
            }
            Command::Quit => return Then::Close,
        }
        Then::Stay
    }

    /// Shows the preview, the traced picture, or both.
    pub(super) fn set_mode(&mut self, mode: Layout) {
        self.switches.mode = mode;
        let mode = match mode {
            Layout::Preview => "preview",
            Layout::Traced => "traced",
            Layout::Split => "split",
        };
        self.report.event(&Happened::Mode { mode });
    }

    /// Shows the traced picture itself, or a map of its errors or rays in false colours.
    pub(super) fn set_shows(&mut self, shows: Shows) {
        self.switches.shows = shows;
        if shows != Shows::Picture && self.switches.mode == Layout::Preview {
            self.set_mode(Layout::Traced);
        }
        for (what, on) in [("errors", shows == Shows::Errors), ("rays", shows == Shows::Rays)] {
            self.report.event(&Happened::Switched { what, on });
        }
    }

    /// Selects what shows at a pixel of the picture, or nothing.
    pub(super) fn select_at(&mut self, pixel: (u32, u32)) {
        let entity = self.entity_at(pixel);
        self.editor.select(entity);
        let object = entity.map(|entity| name_of(&self.world, entity));
        self.report.event(&Happened::Selected { object: object.as_deref() });
    }

    /// Says what could not be done, until it can be or the message is dismissed. Lines after the first are shown as
    /// they are.
    pub(super) fn refuse(&mut self, about: &'static str, message: &str) {
        self.report.event(&Happened::Failed { what: about, message });
        let (title, detail) = message.split_once('\n').unwrap_or((message, ""));
        self.messages.complain(about, title.to_owned(), detail.to_owned());
    }

    /// Says what was done, for a while.
    pub(super) fn tell(&mut self, about: &'static str, text: String) {
        self.messages.tell(about, text, self.now);
    }

    fn switch(&mut self, what: &str, of: impl Fn(&mut Switches) -> &mut bool) {
        let switch = of(&mut self.switches);
        *switch = !*switch;
        let on = *switch;
        self.report.event(&Happened::Switched { what, on });
    }

    /// Stops tracing; if nothing is traced, puts the newest message away.
    fn cancel(&mut self) {
        if self.snapshots.progress().is_some() {
            self.snapshots.cancel();
        } else {
            self.messages.dismiss_newest();
        }
    }
}

/// Edits by key.
impl Session {
    fn undo(&mut self) {
        if let Some(what) = self.editor.undo(&mut self.world) {
            self.report.event(&Happened::Undone { what });
        }
    }

    fn redo(&mut self) {
        if let Some(what) = self.editor.redo(&mut self.world) {
            self.report.event(&Happened::Redone { what });
        }
    }

    /// Tells of steps since the last time, by key or in the panel.
    pub(super) fn tell_edits(&mut self) {
        if let Some((number, what)) = self.editor.newest()
            && number > self.told_edit
        {
            self.told_edit = number;
            self.report.event(&Happened::Edited { what });
        }
    }
}

/// Texture.
impl Session {
    /// A World may bring images of its own: those are the ones to switch.
    pub(super) fn take_over_texture(&mut self, shows: bool) {
        let mut boards = self.world.query_filtered::<&Textured, With<Checkerboard>>();
        let own = boards.iter(&self.world).next().cloned();
        self.switches.texture = shows || own.is_some();
        if own.is_some() {
            self.textured = own;
        } else if shows {
            self.lay_texture();
        }
    }

    fn toggle_texture(&mut self) {
        if self.textured.is_none() {
            return self.refuse("texture", "this scene has no images for a checkerboard");
        }
        self.switch("texture", |switches| &mut switches.texture);
        self.lay_texture();
    }

    /// Boards that are new, or back again, show images as the switch says now.
    pub(super) fn dress_arrivals(&mut self) {
        if self.editor.arrivals() != self.arrivals {
            self.arrivals = self.editor.arrivals();
            self.lay_texture();
        }
    }

    /// Lays images on every checkerboard, or takes them away, as the switch says.
    pub(super) fn lay_texture(&mut self) {
        let Some(textured) = self.textured.clone() else { return };
        let mut query = self.world.query_filtered::<Entity, With<Checkerboard>>();
        let boards: Vec<Entity> = query.iter(&self.world).collect();
        for board in boards {
            let mut board = self.world.entity_mut(board);
            if self.switches.texture {
                board.insert(textured.clone());
            } else {
                board.remove::<Textured>();
            }
        }
    }
}

fn next(mode: Layout) -> Layout {
    match mode {
        Layout::Preview => Layout::Traced,
        Layout::Traced => Layout::Split,
        Layout::Split => Layout::Preview,
    }
}

fn next_shows(shows: Shows) -> Shows {
    match shows {
        Shows::Picture => Shows::Errors,
        Shows::Errors => Shows::Rays,
        Shows::Rays => Shows::Picture,
    }
}

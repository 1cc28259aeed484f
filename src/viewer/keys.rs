//! Keys to commands. [`KEYS`] is the one table: it maps key events, fills the panel's help and is the README's table.
//!
//! The window library's types end here: what comes out is a [`Command`] and a [`KeyId`].

mod event;

use winit::keyboard::{Key, ModifiersState, NamedKey, PhysicalKey};

use crate::components::CameraMove;

use super::command::Command;
use event::cap;

pub(super) use event::{KeyId, read, wheel_lines};

/// A row of the table.
pub(super) struct KeyRow {
    /// The keys, as they are shown.
    pub(super) keys: &'static str,
    /// What they do, in the same order.
    pub(super) does: &'static str,
    bindings: &'static [Binding],
}

/// A key, what must be held down with it, and what it asks for.
struct Binding {
    cap: Cap,
    chord: Chord,
    command: Command,
}

/// What is on a key.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Cap {
    /// A digit or a small letter.
    Sign(char),
    Named(NamedKey),
}

use Cap::{Named, Sign};

/// Which modifiers belong to a binding.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Chord {
    /// Any of shift and ctrl: they set the speed.
    Speed,
    /// Not ctrl.
    Plain,
    /// Ctrl without shift.
    Ctrl,
    /// Both.
    CtrlShift,
}

/// Length of a step in units, and its angle in degrees.
pub(super) const STEP: f64 = 5.0;
/// How many times as far a step goes with shift.
const FAST: f64 = 5.0;
/// How many times as far a step goes with ctrl.
const FINE: f64 = 0.1;

const fn step(cap: Cap, step: CameraMove) -> Binding {
    Binding { cap, chord: Chord::Speed, command: Command::Camera(step) }
}

const fn plain(cap: Cap, command: Command) -> Binding {
    Binding { cap, chord: Chord::Plain, command }
}

const fn ctrl(sign: char, command: Command) -> Binding {
    Binding { cap: Sign(sign), chord: Chord::Ctrl, command }
}

const fn row(keys: &'static str, does: &'static str, bindings: &'static [Binding]) -> KeyRow {
    KeyRow { keys, does, bindings }
}

/// Every key of the window, and what the mouse does, which has no binding.
pub(super) const KEYS: &[KeyRow] = &[
    row(
        "up / down",
        "forward / back, along l",
        &[
            step(Named(NamedKey::ArrowUp), CameraMove::Forward(STEP)),
            step(Named(NamedKey::ArrowDown), CameraMove::Forward(-STEP)),
        ],
    ),
    row(
        "right / left",
        "to the right / left, along r",
        &[
            step(Named(NamedKey::ArrowRight), CameraMove::Right(STEP)),
            step(Named(NamedKey::ArrowLeft), CameraMove::Right(-STEP)),
        ],
    ),
    row(
        "page up / page down",
        "up / down, along u",
        &[
            step(Named(NamedKey::PageUp), CameraMove::Up(STEP)),
            step(Named(NamedKey::PageDown), CameraMove::Up(-STEP)),
        ],
    ),
    row(
        "1 / 2",
        "turn left / right, about u",
        &[step(Sign('1'), CameraMove::Turn(STEP)), step(Sign('2'), CameraMove::Turn(-STEP))],
    ),
    row(
        "3 / 4",
        "look up / down, about r",
        &[step(Sign('3'), CameraMove::Pitch(STEP)), step(Sign('4'), CameraMove::Pitch(-STEP))],
    ),
    row(
        "5 / 6",
        "tilt the picture counter-clockwise / clockwise, about l",
        &[step(Sign('5'), CameraMove::Tilt(STEP)), step(Sign('6'), CameraMove::Tilt(-STEP))],
    ),
    row(
        "w / s",
        "raise / lower the eye, which keeps looking at the same point",
        &[step(Sign('w'), CameraMove::Raise(STEP)), step(Sign('s'), CameraMove::Raise(-STEP))],
    ),
    row("home", "back to where the camera started", &[step(Named(NamedKey::Home), CameraMove::Home)]),
    row("wheel", "forward / back", &[]),
    row("shift / ctrl with these", "5 times / a tenth as far", &[]),
    row("drag", "look around; a level horizon stays level", &[]),
    row("0", "trace this view and write it as a BMP", &[plain(Sign('0'), Command::Trace)]),
    row("esc", "stop tracing, or close a message", &[plain(Named(NamedKey::Escape), Command::Cancel)]),
    row("t", "preview, traced picture, or both", &[plain(Sign('t'), Command::NextMode)]),
    row(
        "h",
        "the traced picture, its estimated errors, or its rays per pixel",
        &[plain(Sign('h'), Command::NextShows)],
    ),
    row("i", "strip of figures on / off", &[plain(Sign('i'), Command::ToggleStrip)]),
    row(
        "f / g",
        "faster / truer: one step along what accuracy costs here",
        &[plain(Sign('f'), Command::Faster), plain(Sign('g'), Command::Truer)],
    ),
    row("space", "texture on / off", &[plain(Named(NamedKey::Space), Command::ToggleTexture)]),
    row(
        "l / x",
        "lights / axes on / off",
        &[plain(Sign('l'), Command::ToggleLights), plain(Sign('x'), Command::ToggleAxes)],
    ),
    row("F1", "panel on / off", &[plain(Named(NamedKey::F1), Command::TogglePanel)]),
    row("click", "select", &[]),
    row(
        "ctrl+d / delete",
        "duplicate / delete what is selected",
        &[ctrl('d', Command::Duplicate), plain(Named(NamedKey::Delete), Command::Delete)],
    ),
    row(
        "ctrl+z / ctrl+y",
        "undo / redo; ctrl+shift+z, too, is redo",
        &[
            ctrl('z', Command::Undo),
            ctrl('y', Command::Redo),
            Binding { cap: Sign('z'), chord: Chord::CtrlShift, command: Command::Redo },
        ],
    ),
    row("insert", "read the scene file again", &[plain(Named(NamedKey::Insert), Command::Reload)]),
    row("F2", "save the scene under a new name", &[plain(Named(NamedKey::F2), Command::Save)]),
    row("ctrl+q", "quit", &[ctrl('q', Command::Quit)]),
];

/// The table for the panel: keys, and what they do.
pub(super) fn help() -> Vec<(String, String)> {
    KEYS.iter().map(|row| (row.keys.to_owned(), row.does.to_owned())).collect()
}

/// The modifier keys that are held down.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Modifiers {
    pub(super) shift: bool,
    pub(super) ctrl: bool,
    /// Alt or the system's own key: such chords are the desktop's.
    pub(super) other: bool,
}

impl From<ModifiersState> for Modifiers {
    fn from(state: ModifiersState) -> Self {
        let other = state.alt_key() || state.super_key();
        Self { shift: state.shift_key(), ctrl: state.control_key(), other }
    }
}

impl Modifiers {
    /// How many times as far the camera's steps go.
    pub(super) fn speed(self) -> f64 {
        let fast = if self.shift { FAST } else { 1.0 };
        let fine = if self.ctrl { FINE } else { 1.0 };
        fast * fine
    }

    fn fit(self, chord: Chord) -> bool {
        !self.other
            && match chord {
                Chord::Speed => true,
                Chord::Plain => !self.ctrl,
                Chord::Ctrl => self.ctrl && !self.shift,
                Chord::CtrlShift => self.ctrl && self.shift,
            }
    }
}

/// What a key (as it is without modifiers) asks for with these modifiers.
fn command(key: &Key, place: PhysicalKey, modifiers: Modifiers) -> Option<Command> {
    let cap = cap(key, place)?;
    let mut bindings = KEYS.iter().flat_map(|row| row.bindings);
    bindings.find(|binding| binding.cap == cap && modifiers.fit(binding.chord)).map(|binding| binding.command)
}

#[cfg(test)]
mod tests;

//! What the window says on standard output, for programs that drive it.

use std::io::{self, Write};
use std::path::Path;

use serde::Serialize;

use crate::components::CameraPose;

/// Lines for standard output; none once it is closed.
#[derive(Debug)]
pub(super) struct Report {
    camera: bool,
    events: bool,
    closed: bool,
    pose: Option<CameraPose>,
}

/// What happened. Written as one line of JSON if asked for.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "event", rename_all = "snake_case")]
pub(super) enum Happened<'a> {
    /// The first frame was shown, in a window of this many pixels, with a square picture in its middle.
    Ready { width: u32, height: u32, side: u32 },
    /// The window has another size.
    Resized { width: u32, height: u32, side: u32 },
    /// The window shows something else.
    Mode { mode: &'a str },
    /// A switch was turned.
    Switched { what: &'a str, on: bool },
    /// An object was selected, or none.
    Selected { object: Option<&'a str> },
    /// The World was edited.
    Edited { what: &'a str },
    /// An edit was taken back.
    Undone { what: &'a str },
    /// An edit was made again.
    Redone { what: &'a str },
    /// The scene was written.
    Saved { path: &'a Path },
    /// The scene was read again; `changed` tells whether it says anything else than the World.
    Reloaded { path: &'a Path, changed: bool },
    /// A picture is being traced for a file.
    Tracing { pixels: u32 },
    /// It was given up.
    Cancelled,
    /// A picture traced for the window is complete with this many samples a pixel.
    Picture { side: u32, samples: u32, is_final: bool, hash: &'a str },
    /// A picture in false colours for the window is complete; its scale goes to this number.
    HeatMap { what: &'a str, side: u32, most: f64 },
    /// What accuracy costs has been measured, with so many settings to choose from.
    Front { settings: usize },
    /// Another accuracy was chosen by key: the flags of `render` that make the same.
    Accuracy { flags: &'a str },
    /// Something could not be done.
    Failed { what: &'a str, message: &'a str },
}

/// A camera pose as one line of JSON.
#[derive(Serialize)]
struct CameraLine {
    pos: [f64; 3],
    l: [f64; 3],
    r: [f64; 3],
    u: [f64; 3],
}

impl Report {
    /// Tells of the camera, and of events, as asked.
    pub(super) fn new(camera: bool, events: bool) -> Self {
        Self { camera, events, closed: false, pose: None }
    }

    /// Tells where the camera is if that is not where it was.
    pub(super) fn camera(&mut self, pose: &CameraPose) {
        if self.camera && self.pose != Some(*pose) {
            self.pose = Some(*pose);
            let CameraPose { position, l, r, u } = pose;
            let [pos, l, r, u] = [position, l, r, u].map(|vector| vector.to_array());
            self.json(&CameraLine { pos, l, r, u });
        }
    }

    /// Tells of an event.
    pub(super) fn event(&mut self, happened: &Happened<'_>) {
        if self.events {
            self.json(happened);
        }
    }

    /// Whether anybody hears of events.
    pub(super) fn has_events(&self) -> bool {
        self.events
    }

    /// A line in words, told in any case.
    pub(super) fn line(&mut self, text: &str) {
        let mut output = io::stdout().lock();
        if !self.closed && writeln!(output, "{text}").and_then(|()| output.flush()).is_err() {
            // Whoever listened has gone; the window stays.
            self.closed = true;
        }
    }

    fn json(&mut self, value: &impl Serialize) {
        if let Ok(text) = serde_json::to_string(value) {
            self.line(&text);
        }
    }
}

/// FNV-1a, 64 bits, of a picture's bytes in hexadecimal: enough to tell whether two pictures are the same
/// (G. Fowler, L. C. Noll, K.-P. Vo, <https://datatracker.ietf.org/doc/html/rfc9923>).
pub(super) fn hash(bytes: &[u8]) -> String {
    const OFFSET: u64 = 0xcbf2_9ce4_8422_2325;
    const PRIME: u64 = 0x0000_0100_0000_01b3;
    let hash = bytes.iter().fold(OFFSET, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(PRIME));
    format!("{hash:016x}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hash_is_the_published_one() {
        // Test vectors of the authors.
        assert_eq!(hash(b""), "cbf29ce484222325");
        assert_eq!(hash(b"a"), "af63dc4c8601ec8c");
        assert_eq!(hash(b"foobar"), "85944171f73967e8");
    }

    #[test]
    fn an_event_is_one_flat_object() {
        let line = serde_json::to_string(&Happened::Switched { what: "texture", on: true }).unwrap();
        assert_eq!(line, r#"{"event":"switched","what":"texture","on":true}"#);
    }
}

//! What the panel shows of the program, and what it asks of it: plain data.

use std::path::PathBuf;

use crate::preview::Layout;
use crate::trace::{Counts, EffectCount, TableCount};

use super::messages::Message;
use crate::viewer::fronts::Front;
use crate::viewer::live::Shows;

/// What the program does at present. The World itself is not part of it: the panel looks there on its own.
#[derive(Clone, Debug, Default)]
pub(crate) struct Status {
    /// The opened file; none for a scene in code.
    pub(crate) scene: Option<PathBuf>,
    /// What the scene is called.
    pub(crate) name: String,
    /// What the window shows.
    pub(crate) mode: Layout,
    /// What is to be shown of a traced picture.
    pub(crate) shows: Shows,
    /// What is shown of the present one; nothing while there is none.
    pub(crate) picture: Option<Shows>,
    /// Root mean squared error of the picture that is shown, 0 to 1, as it is estimated; nothing while it is not.
    pub(crate) error: Option<f64>,
    /// Where the scale of its false colours ends.
    pub(crate) most: f64,
    /// Whether it has all its samples.
    pub(crate) is_complete: bool,
    /// What accuracy costs on this scene.
    pub(crate) front: Front,
    /// Whether the strip is shown.
    pub(crate) strip: bool,
    /// Whether the checkerboard shows images.
    pub(crate) texture: bool,
    /// Threads that trace.
    pub(crate) threads: usize,
    /// Samples a pixel of the traced picture that is shown; 0 if none is.
    pub(crate) samples: u32,
    /// Pixels along each side of it.
    pub(crate) side: u32,
    /// What was counted while it was traced.
    pub(crate) counts: Counts,
    /// How long it took in milliseconds.
    pub(crate) traced: f64,
    /// How long the last frame of the window took in milliseconds.
    pub(crate) frame: f64,
    /// Effects, with the rows that ask for them.
    pub(crate) effects: Vec<EffectCount>,
    /// Tables, with their rows.
    pub(crate) tables: Vec<TableCount>,
    /// How much of a picture for a file is done, 0 to 1; none while there is none to trace.
    pub(crate) progress: Option<f32>,
    /// The file that was written last.
    pub(crate) written: Option<PathBuf>,
    /// What is wrong with the World.
    pub(crate) problems: Vec<String>,
    /// Keys, and what they do.
    pub(crate) keys: Vec<(String, String)>,
    /// What the user is to be told, oldest first.
    pub(crate) messages: Vec<Message>,
}

/// What only the program can do. Edits of the World are made at once and not asked for.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Request {
    /// Write the scene.
    Save {
        /// The file.
        path: PathBuf,
        /// Whether it may replace one that is there. If not and there is one, that is an error.
        overwrite: bool,
    },
    /// Read the opened file again.
    Reload,
    /// Take the newest step back.
    Undo,
    /// Make the step again that was taken back last.
    Redo,
    /// Trace the view to a file.
    Trace,
    /// Give that up.
    CancelTrace,
    /// Show something else.
    SetMode(Layout),
    /// Show something else of the traced picture.
    SetShows(Shows),
    /// Measure again what accuracy costs.
    MeasureFront,
    /// Switch the images of the checkerboard on or off.
    ToggleTexture,
    /// Take a message away: its place in [`Status::messages`].
    Dismiss(usize),
}

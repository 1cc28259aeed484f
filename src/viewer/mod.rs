//! The window: the live preview, pictures traced beside it, and a panel to edit what is seen.
//!
//! ```text
//! keys, mouse ─→ Command ─→ Session ─→ CameraInput, edits ─→ World ─→ tables ─→ traced in the background ─┐
//!                             (no window in it)               └─→ DrawList ─→ preview ────────────────────┴─→ window
//! ```
//!
//! Types of the window's crates end early: those of winit in `keys` and the event loop, GL contexts in `context`
//! and [`headless`], egui in the panel. This room and the command line are the only ones with a clock.

mod app;
mod command;
mod commands;
mod context;
mod editor;
mod files;
mod fronts;
pub mod headless;
mod held;
mod keys;
mod live;
mod pace;
mod panel;
mod pointer;
mod refine;
mod render_command;
mod report;
mod scene_file;
mod screen;
mod selection;
mod session;
mod snapshot;
mod status;
mod steps;
#[cfg(test)]
mod test_views;
mod traced_view;
mod watch;

use std::ffi::OsString;
use std::io;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

use bevy_ecs::prelude::*;
use bevy_ecs::schedule::IntoScheduleConfigs;
use bevy_ecs::system::ScheduleSystem;
use thiserror::Error;

use crate::components::{Precision, Textured};
use crate::systems::WorkersError;

use context::ContextError;

pub use render_command::RenderCommand;

/// A window on a World, for a program to set up and [`run`](Self::run).
///
/// ```no_run
/// use archetrace::components::FrameTime;
/// use archetrace::viewer::Viewer;
/// use bevy_ecs::prelude::*;
///
/// fn report_time(time: Res<FrameTime>) {
///     assert!(time.step >= 0.0);
/// }
///
/// let mut world = World::new();
/// // Spawn a camera, objects and lights; then:
/// Viewer::new("my scene", world).add_systems(report_time).run()?;
/// # Ok::<(), archetrace::viewer::ViewerError>(())
/// ```
pub struct Viewer {
    world: World,
    name: String,
    file: Option<PathBuf>,
    systems: Schedule,
    has_systems: bool,
    options: ViewerOptions,
}

/// How a window behaves and what it tells.
#[derive(Clone, Debug, Default)]
pub struct ViewerOptions {
    /// Folder for pictures; the current one if empty.
    pub out: PathBuf,
    /// Precision to begin with.
    pub precision: Precision,
    /// Threads that trace; one per processor if not said.
    pub threads: Option<NonZeroUsize>,
    /// Images that the texture switch lays on the checkerboard, unless the World brings its own.
    pub textured: Option<Textured>,
    /// Arguments of the command line that the images came from, for the command that repeats a picture.
    pub texture_arguments: Vec<OsString>,
    /// Whether the images lie there at the start.
    pub shows_texture: bool,
    /// One line of JSON on standard output for each pose of the camera.
    pub print_camera: bool,
    /// One line of JSON on standard output for each thing that happens.
    pub print_events: bool,
}

/// Why there is no window, or none any more.
#[derive(Debug, Error)]
pub enum ViewerError {
    /// There is no display to open a window on, or it does not take part.
    #[error("cannot open a window: {0} (`archetrace render` and `archetrace preview` need no display)")]
    NoDisplay(String),
    /// The window has no usable GL context.
    #[error("{0}")]
    Context(String),
    /// No threads to trace with.
    #[error(transparent)]
    Workers(#[from] WorkersError),
    /// No thread for the live trace.
    #[error("cannot start a thread: {0}")]
    Thread(io::Error),
}

impl From<ContextError> for ViewerError {
    fn from(error: ContextError) -> Self {
        Self::Context(error.to_string())
    }
}

impl Viewer {
    /// A window on a World that a program has built. The name goes into the title and the names of pictures.
    pub fn new(name: impl Into<String>, world: World) -> Self {
        Self {
            world,
            name: name.into(),
            file: None,
            systems: Schedule::default(),
            has_systems: false,
            options: ViewerOptions::default(),
        }
    }

    /// A window on a World that was spawned from a scene file, which is watched for changes.
    pub fn of_file(file: &Path, world: World) -> Self {
        let name =
            file.file_stem().map_or_else(|| "scene".into(), |stem| stem.to_string_lossy().into_owned());
        Self { file: Some(file.to_owned()), ..Self::new(name, world) }
    }

    /// Systems that run before each frame is extracted. With any, frames follow each other all the time.
    #[must_use]
    pub fn add_systems<M>(mut self, systems: impl IntoScheduleConfigs<ScheduleSystem, M>) -> Self {
        self.systems.add_systems(systems);
        self.has_systems = true;
        self
    }

    /// Other options than the usual ones.
    #[must_use]
    pub fn with_options(self, options: ViewerOptions) -> Self {
        Self { options, ..self }
    }

    /// Opens the window and stays until it is closed. A process can do this once, from its main thread.
    pub fn run(self) -> Result<(), ViewerError> {
        app::run(self)
    }
}

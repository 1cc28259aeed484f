//! The command line: arguments in, files and an exit status out.
//!
//! This is the only room that speaks to the terminal and listens to signals.

mod accuracy_args;
mod args;
mod check;
mod cost;
mod effects;
mod instructions;
mod load;
#[cfg(feature = "viewer")]
mod preview;
mod render;
mod selfcheck;
mod stats;
mod stop;
#[cfg(feature = "viewer")]
mod view;
mod write;

use std::io::{self, Write};
use std::process::ExitCode;

use thiserror::Error;

use crate::image_file::ImageFileError;
use crate::scene::{DescribeError, SceneError};
use crate::systems::{FrameError, WorkersError};
use crate::whole_file::WriteError;

use args::{Args, Command};

pub use effects::effects_report;

/// Runs the program on the arguments of the process. Status 0: done; 1: it could not be done, and standard error
/// says why; 2: the arguments make no sense.
pub fn run() -> ExitCode {
    let outcome = match Args::of_process() {
        Command::Render(args) => render::render(&args),
        #[cfg(feature = "viewer")]
        Command::Preview(args) => preview::preview(&args),
        Command::Check(args) => check::check(&args),
        Command::Effects(args) => effects::effects(&args),
        Command::Cost(args) => cost::cost(&args),
        Command::Write(args) => write::write(&args),
        Command::Selfcheck(args) => selfcheck::selfcheck(&args),
        #[cfg(feature = "viewer")]
        Command::View(args) => view::view(&args),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        // Whoever read our output has enough.
        Err(CliError::Output(error)) if error.kind() == io::ErrorKind::BrokenPipe => ExitCode::SUCCESS,
        Err(error) => {
            say(&error.report());
            ExitCode::FAILURE
        }
    }
}

/// Why a command failed.
#[derive(Debug, Error)]
enum CliError {
    #[error(transparent)]
    Scene(#[from] SceneError),
    #[error(transparent)]
    Image(#[from] ImageFileError),
    #[error(transparent)]
    Write(#[from] WriteError),
    #[error(transparent)]
    Frame(#[from] FrameError),
    #[error("--look and --up must have a direction")]
    NoDirection,
    #[error(transparent)]
    Describe(#[from] DescribeError),
    #[error(transparent)]
    Workers(#[from] WorkersError),
    #[cfg(feature = "viewer")]
    #[error(transparent)]
    Viewer(#[from] crate::viewer::ViewerError),
    #[error("cannot write to standard output: {0}")]
    Output(io::Error),
    #[error("cannot listen for Ctrl-C: {0}")]
    Signal(#[from] ctrlc::Error),
    #[error("cannot draw the chart")]
    Chart,
    #[error("cannot count instructions: {0}")]
    Instructions(String),
    #[error("cannot make the folder {0}: {1}")]
    Folder(String, io::Error),
    #[error("cannot write the table: {0}")]
    Table(#[from] csv::Error),
    #[error("cannot encode statistics: {0}")]
    Stats(#[from] serde_json::Error),
    #[cfg(feature = "viewer")]
    #[error(transparent)]
    Headless(#[from] crate::viewer::headless::HeadlessError),
    #[cfg(feature = "viewer")]
    #[error(transparent)]
    Gl(#[from] crate::preview::gl::GlError),
    #[error("this build gives wrong answers on this machine, see the lines that say BAD")]
    Selfcheck,
    #[error("interrupted; {0} was not written")]
    Interrupted(String),
}

impl CliError {
    /// The message, which starts with `error:`. Scene diagnostics do by themselves.
    fn report(&self) -> String {
        match self {
            Self::Scene(SceneError::Malformed(shown)) => shown.clone(),
            other => format!("error: {other}"),
        }
    }
}

/// One line or more to standard error. If even that fails, there is nobody to tell.
fn say(text: &str) {
    let _ = writeln!(io::stderr().lock(), "{text}");
}

/// Text to standard output.
fn print(text: &str) -> Result<(), CliError> {
    let mut output = io::stdout().lock();
    output.write_all(text.as_bytes()).and_then(|()| output.flush()).map_err(CliError::Output)
}

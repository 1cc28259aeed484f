//! Reading scene files.

use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use thiserror::Error;

use super::problem::printable;
use super::{Description, Problem, parse};

/// Most bytes of a scene file: room for two million objects.
pub const MAX_BYTES: u64 = 1 << 28;

/// The text of a scene file with its name for messages.
#[derive(Clone, Debug)]
pub struct Source {
    name: String,
    text: String,
}

/// Why a scene file cannot be used.
#[derive(Debug, Error)]
pub enum SceneError {
    /// The file cannot be read.
    #[error("cannot read {path}: {error}")]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// Why.
        error: io::Error,
    },
    /// It is a directory, a pipe or a device.
    #[error("cannot read {0}: not a regular file")]
    NotAFile(PathBuf),
    /// It is too large.
    #[error("cannot read {0}: larger than {MAX_BYTES} bytes")]
    TooLarge(PathBuf),
    /// It breaks the grammar or holds values that are not allowed. The text says where.
    #[error("{}", .0.trim_end())]
    Malformed(String),
}

/// A scene that can be used, with what its author should know all the same.
#[derive(Clone, Debug)]
pub struct Loaded {
    /// The scene.
    pub description: Description,
    /// Warnings, each ready to be shown.
    pub warnings: Vec<String>,
}

impl Source {
    /// A text that does not come from a file, with a name to stand for one.
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Self {
        Self { name: name.into(), text: text.into() }
    }

    /// Reads a regular file of at most [`MAX_BYTES`]. Bytes that are not UTF-8 are replaced: the prose after the
    /// last number may be in any encoding.
    pub fn read(path: &Path) -> Result<Self, SceneError> {
        let unreadable = |error| SceneError::Unreadable { path: path.to_owned(), error };
        // Asked before opening: opening a pipe would wait for its writer.
        let metadata = path.metadata().map_err(unreadable)?;
        if !metadata.is_file() {
            return Err(SceneError::NotAFile(path.to_owned()));
        }
        if metadata.len() > MAX_BYTES {
            return Err(SceneError::TooLarge(path.to_owned()));
        }
        // Not longer than MAX_BYTES, but it may grow while it is read.
        let mut bytes = Vec::with_capacity(usize::try_from(metadata.len()).unwrap_or(0));
        let file = File::open(path).map_err(unreadable)?;
        let length = file.take(MAX_BYTES + 1).read_to_end(&mut bytes).map_err(unreadable)?;
        if length as u64 > MAX_BYTES {
            return Err(SceneError::TooLarge(path.to_owned()));
        }
        let text = String::from_utf8(bytes)
            .unwrap_or_else(|error| String::from_utf8_lossy(error.as_bytes()).into_owned());
        Ok(Self::new(printable(&path.display().to_string()), text))
    }

    /// Parses the text. All problems that could be found are in the error.
    pub fn load(&self) -> Result<Loaded, SceneError> {
        match parse(&self.text) {
            Ok((description, warnings)) => {
                let warnings = warnings.iter().map(|warning| self.show(warning)).collect();
                Ok(Loaded { description, warnings })
            }
            Err(problems) => {
                let shown: Vec<String> = problems.iter().map(|problem| self.show(problem)).collect();
                Err(SceneError::Malformed(shown.join("\n\n")))
            }
        }
    }

    fn show(&self, problem: &Problem) -> String {
        problem.render(&self.name, &self.text).trim_end().to_owned()
    }
}

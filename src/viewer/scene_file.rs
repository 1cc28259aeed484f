//! Where a World came from, and where what comes from it goes.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use bevy_ecs::prelude::*;

use crate::scene::{Description, SceneError, Source, describe, spawn};

use super::ViewerOptions;
use super::panel::unused_name;

/// The scene's file, and names for files that come from it.
#[derive(Debug)]
pub(super) struct SceneFile {
    /// Name for the title and for pictures.
    pub(super) name: String,
    /// The file, unless a program built the World.
    pub(super) path: Option<PathBuf>,
    /// The file that the World was last read from or saved to.
    pub(super) held_by: Option<PathBuf>,
    /// Folder for pictures.
    pub(super) out: PathBuf,
    /// Arguments of `render` that lay the images of the texture switch.
    pub(super) texture_arguments: Vec<OsString>,
    read: Option<Description>,
}

/// What a file says.
pub(super) struct Read {
    /// The scene.
    pub(super) description: Description,
    /// Whether it said something else when it was read before.
    pub(super) is_new: bool,
}

impl SceneFile {
    /// Names for a World and, if it has one, its file.
    pub(super) fn new(name: String, path: Option<PathBuf>, options: &ViewerOptions) -> Self {
        let mut file = Self {
            name,
            held_by: path.clone(),
            path,
            out: options.out.clone(),
            texture_arguments: options.texture_arguments.clone(),
            read: None,
        };
        if let Some(path) = file.path.clone() {
            // The World has been spawned from it just now; whatever is wrong with it since then, the watch will tell.
            let _ = file.read_again(&path);
        }
        file
    }

    /// Reads the file.
    pub(super) fn read_again(&mut self, path: &Path) -> Result<Read, SceneError> {
        let description = as_spawned(Source::read(path)?.load()?.description);
        let is_new = self.read.as_ref() != Some(&description);
        self.read = Some(description.clone());
        Ok(Read { description, is_new })
    }

    /// A name for the edited scene that is not in use.
    pub(super) fn edited_name(&self) -> PathBuf {
        let path = self.path.clone().unwrap_or_else(|| format!("{}.txt", self.name).into());
        unused_name(Some(&path))
    }
}

/// What the World says that a description becomes: an effect that shows nothing is not kept, and would otherwise pass
/// for a difference.
fn as_spawned(description: Description) -> Description {
    let mut world = World::new();
    spawn(&mut world, &description);
    describe(&mut world).unwrap_or(description)
}

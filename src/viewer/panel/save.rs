//! Which file a scene is saved to.

use std::path::{Path, PathBuf};

/// A name beside the scene's file that is not taken yet: `NAME-edited.txt`, then `NAME-edited-2.txt`, and so on. For a
/// scene without a file, in the current folder.
pub(crate) fn unused_name(scene: Option<&Path>) -> PathBuf {
    let stem = scene.and_then(Path::file_stem).unwrap_or("scene".as_ref());
    let name = |ending: &str| {
        let mut name = stem.to_owned();
        name.push(ending);
        scene.map_or_else(|| PathBuf::from(&name), |scene| scene.with_file_name(&name))
    };
    let numbered = (2_u32..).map(|number| name(&format!("-edited-{number}.txt")));
    let mut names = core::iter::once(name("-edited.txt")).chain(numbered);
    names.find(|path| !is_taken(path)).unwrap_or_else(|| name("-edited.txt"))
}

/// Whether there is something at a path. What cannot be looked at is taken for there.
pub(super) fn is_taken(path: &Path) -> bool {
    path.try_exists().unwrap_or(true)
}

/// The name that the user is about to save under.
#[derive(Debug, Default)]
pub(super) struct SaveName {
    /// What was typed; until then the name is an unused one.
    typed: Option<String>,
    unused: Option<(Seen, PathBuf)>,
    /// Whether the user has said once that the file may be replaced.
    pub(super) is_armed: bool,
}

/// Files that an unused name depends on: the scene, and what was written last.
type Seen = [Option<PathBuf>; 2];

impl SaveName {
    /// The file as things stand.
    pub(super) fn path(&mut self, scene: Option<&Path>, written: Option<&Path>) -> PathBuf {
        if let Some(typed) = &self.typed {
            return PathBuf::from(typed);
        }
        let seen = [scene, written].map(|path| path.map(Path::to_owned));
        match &self.unused {
            Some((before, path)) if *before == seen => path.clone(),
            _ => {
                let path = unused_name(scene);
                self.unused = Some((seen, path.clone()));
                path
            }
        }
    }

    /// Another name. What was said about the old one does not count for it.
    pub(super) fn set(&mut self, typed: String) {
        *self = Self { typed: Some(typed), unused: None, is_armed: false };
    }

    /// The scene is being saved under this name; from now on it stays in the field.
    pub(super) fn keep(&mut self, path: &Path) {
        self.is_armed = false;
        // A name that is no text cannot be edited as text either.
        self.typed = path.to_str().map(str::to_owned);
    }
}

//! Files of a session: the scene that is read and saved, pictures that are written.

use std::path::{Path, PathBuf};

use crate::components::{CameraPose, Snapshot};
use crate::effects::EffectSet;
use crate::scene::{DescribeError, describe};
use crate::study::{Preset, Setting};
use crate::systems::Muted;
use crate::whole_file::{WriteError, write_new, write_whole};

use super::editor::{Traced, accuracy};
use super::render_command::RenderCommand;
use super::report::Happened;
use super::session::Session;
use super::snapshot::{Outcome, SnapshotRequest};

/// Why the file is read again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Occasion {
    /// Somebody asked for it: edits go, even if the file is what it was.
    Asked,
    /// It may have changed.
    Changed,
}

/// What a picture was traced from, for the command line that repeats it.
pub(super) struct Recipe {
    scene: PathBuf,
    pose: CameraPose,
    setting: Option<Setting>,
    muted: EffectSet,
    texture: Vec<std::ffi::OsString>,
    is_edited: bool,
}

impl Session {
    /// Reads the scene file again. The camera stays where it is, and the step can be undone. If the file is bad, the
    /// World stays as it is and the reader's message is shown.
    pub(super) fn reload(&mut self, occasion: Occasion) {
        let Some(path) = self.scene.path.clone() else {
            if occasion == Occasion::Asked {
                self.refuse("reload", "a program built this scene: there is no file to read again");
            }
            return;
        };
        let read = match self.scene.read_again(&path) {
            Ok(read) => read,
            Err(error) => return self.refuse("reload", &error.to_string()),
        };
        self.messages.mend("reload");
        let differs = describe(&mut self.world).ok().as_ref() != Some(&read.description);
        let changed = differs && (read.is_new || occasion == Occasion::Asked);
        if changed {
            self.editor.replace_scene(&mut self.world, &read.description);
            self.lay_texture();
        }
        if changed || !differs {
            self.editor.mark_saved();
            self.scene.held_by = Some(path.clone());
        }
        self.report.event(&Happened::Reloaded { path: &path, changed });
    }

    /// Writes the World as a scene file under a name that is not in use.
    pub(super) fn save_as_new(&mut self) {
        self.save(&self.scene.edited_name(), false);
    }

    /// Writes the World as a scene file. Only one that `replaces` takes the place of a file that is there.
    pub(super) fn save(&mut self, path: &Path, replaces: bool) {
        let saved = self.described().and_then(|text| {
            write(path, text.as_bytes(), replaces)
                .map(|()| path.to_owned())
                .map_err(|error| error.to_string())
        });
        self.tell_saved(saved);
    }

    fn described(&mut self) -> Result<String, String> {
        let description =
            describe(&mut self.world).map_err(|error: DescribeError| format!("cannot save: {error}"))?;
        Ok(description.to_string())
    }

    fn tell_saved(&mut self, saved: Result<PathBuf, String>) {
        match saved {
            Ok(path) => {
                self.editor.mark_saved();
                self.scene.held_by = Some(path.clone());
                self.tell("save", format!("saved {}", path.display()));
                self.report.event(&Happened::Saved { path: &path });
            }
            Err(message) => self.refuse("save", &message),
        }
    }

    /// Traces the view as it stands, at the scene's own size, to the next free file.
    pub(super) fn trace(&mut self) {
        self.settle();
        let Some(view) = self.view() else {
            let problems = self.problems().join("\n");
            return self.refuse("trace", &problems);
        };
        let Snapshot { pixels, .. } = *self.world.resource();
        let recipe = self.recipe_of(view.pose);
        let request = SnapshotRequest {
            view,
            pixels,
            samples: self.samples(),
            folder: self.scene.out.clone(),
            stem: self.scene.name.clone().into(),
        };
        match self.snapshots.start(request) {
            Ok(()) => {
                self.messages.mend("trace");
                self.recipe = recipe;
                self.report.event(&Happened::Tracing { pixels });
            }
            Err(reason) => self.refuse("trace", &reason.to_string()),
        }
    }

    fn recipe_of(&mut self, pose: CameraPose) -> Option<Recipe> {
        let setting = accuracy(&mut self.world);
        let is_chosen = self.world.resource::<Traced>().is_chosen();
        Some(Recipe {
            scene: self.scene.held_by.clone()?,
            pose,
            setting: Some(setting).filter(|_| is_chosen || setting != Preset::Assignment.of(setting)),
            muted: self.world.resource::<Muted>().0,
            texture: if self.switches.texture { self.scene.texture_arguments.clone() } else { Vec::new() },
            is_edited: self.editor.is_modified(),
        })
    }

    /// Tells of a picture that has been written, or not.
    pub(super) fn collect_snapshot(&mut self) {
        match self.snapshots.finished() {
            None => {}
            Some(Outcome::Written(path)) => self.tell_written(&path),
            Some(Outcome::Cancelled) => {
                self.report.event(&Happened::Cancelled);
                self.tell("trace", "stopped; nothing was written".into());
            }
            Some(Outcome::Failed(reason)) => self.refuse("trace", &reason),
        }
    }

    fn tell_written(&mut self, path: &Path) {
        let written = format!("wrote {}", path.display());
        self.report.line(&written);
        if let Some(recipe) = self.recipe.take() {
            if recipe.is_edited {
                self.report
                    .line("# the scene has edits that are not in its file; saved, they take its place here:");
            }
            self.report.line(&recipe.command(path));
        }
        self.tell("trace", written);
        self.written = Some(path.to_owned());
    }
}

impl Recipe {
    fn command(&self, output: &Path) -> String {
        let Self { scene, pose, texture, setting, muted, .. } = self;
        let (setting, muted) = (*setting, *muted);
        RenderCommand { scene, output, pose, setting, muted, texture }.to_string()
    }
}

fn write(path: &Path, bytes: &[u8], replaces: bool) -> Result<(), WriteError> {
    if replaces {
        return write_whole(path, bytes);
    }
    let folder = path.parent().unwrap_or(Path::new(""));
    let name = path.file_name().map(ToOwned::to_owned);
    write_new(folder, name, bytes).map(drop)
}

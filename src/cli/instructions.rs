//! Instructions of a frame, counted by valgrind.

use std::env;
use std::io;
use std::path::Path;
use std::process::{Command, Stdio};

use tempfile::TempDir;

use crate::effects::Effect;
use crate::study::{Ablation, Setting};

use super::CliError;
use super::args::{EffectsArgs, PictureArgs};

/// Instructions a pixel that each present effect adds.
pub(super) struct Instructions(Vec<(Effect, i64)>);

/// Two sizes are counted and subtracted, so that what is done once a process falls out.
const SIZES: [u32; 2] = [32, 96];

impl Instructions {
    /// Renders the scene under `valgrind --tool=callgrind` with all its effects and without each of them.
    pub(super) fn measure(
        args: &EffectsArgs,
        setting: Setting,
        ablation: &Ablation,
    ) -> Result<Self, CliError> {
        let counter = Counter::new(&args.scene, &args.picture)?;
        let whole = counter.per_pixel(setting, None)?;
        let present = ablation.effects.iter().filter(|price| price.is_present());
        let added = present.map(|price| {
            let effect = price.count.effect;
            Ok((effect, whole - counter.per_pixel(setting, Some(effect))?))
        });
        Ok(Self(added.collect::<Result<_, CliError>>()?))
    }

    /// Instructions a pixel that an effect adds; nothing for one that is absent.
    pub(super) fn of(&self, effect: Effect) -> Option<i64> {
        self.0.iter().find(|entry| entry.0 == effect).map(|entry| entry.1)
    }
}

/// Some machines' C libraries copy and clear kilobytes by an instruction that valgrind counts once a byte; not with this.
const VECTOR_COPIES: &str =
    "glibc.cpu.x86_rep_movsb_threshold=1073741824:glibc.cpu.x86_rep_stosb_threshold=1073741824";

/// Renders a scene under `valgrind --tool=callgrind`.
pub(super) struct Counter<'a> {
    scene: &'a Path,
    picture: &'a PictureArgs,
    folder: TempDir,
}

impl<'a> Counter<'a> {
    /// For pictures of a scene, with the camera and the images of these arguments.
    pub(super) fn new(scene: &'a Path, picture: &'a PictureArgs) -> Result<Self, CliError> {
        Ok(Self { scene, picture, folder: tempfile::tempdir().map_err(|error| failed(&error))? })
    }

    /// Instructions a pixel with this setting, its size aside.
    pub(super) fn per_pixel(&self, setting: Setting, without: Option<Effect>) -> Result<i64, CliError> {
        let [small, large] = SIZES.map(|size| self.count(Setting { pixels: size, ..setting }, without));
        let pixels = i64::from(SIZES[1] * SIZES[1] - SIZES[0] * SIZES[0]);
        Ok((large? - small?) / pixels)
    }

    fn count(&self, setting: Setting, without: Option<Effect>) -> Result<i64, CliError> {
        let mut command = Command::new("valgrind");
        command.args(["--tool=callgrind", "--callgrind-out-file=/dev/null"]);
        command.env("GLIBC_TUNABLES", VECTOR_COPIES);
        command.arg(env::current_exe().map_err(|error| failed(&error))?);
        command.arg("render").arg(self.scene).arg("-o").arg(self.folder.path().join("frame.bmp"));
        command.args(["--threads", "1"]).args(setting.flags().split_whitespace());
        if let Some(effect) = without {
            command.args(["--without", effect.name()]);
        }
        add_picture(&mut command, self.picture);
        let output = command.stdin(Stdio::null()).output().map_err(|error| failed(&error))?;
        let report = String::from_utf8_lossy(&output.stderr);
        let collected =
            report.lines().find_map(|line| line.split_once("Collected : ")?.1.trim().parse().ok());
        collected
            .filter(|_| output.status.success())
            .ok_or_else(|| CliError::Instructions(report.trim().to_owned()))
    }
}

/// The flags that say what is traced, other than accuracy and threads.
fn add_picture(command: &mut Command, picture: &PictureArgs) {
    let camera = &picture.camera;
    for (flag, point) in [("--eye", camera.eye), ("--look", camera.look), ("--up", camera.up)] {
        command.arg(format!("{flag}={},{},{}", point.x, point.y, point.z));
    }
    let images = &picture.images;
    if images.texture {
        command.arg("--texture");
    }
    for (flag, image) in [("--white", &images.white), ("--black", &images.black)] {
        if let Some(image) = image {
            command.arg(flag).arg(image);
        }
    }
}

fn failed(error: &io::Error) -> CliError {
    CliError::Instructions(format!("valgrind: {error}"))
}

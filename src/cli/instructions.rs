//! Instructions of a frame, counted by valgrind.

use std::env;
use std::io;
use std::path::Path;
use std::process::{Command, Stdio};

use crate::effects::Effect;
use crate::study::Ablation;

use super::CliError;
use super::args::{EffectsArgs, PictureArgs, Precision};

/// Instructions a pixel that each present effect adds.
pub(super) struct Instructions(Vec<(Effect, i64)>);

/// Two sizes are counted and subtracted, so that what is done once a process falls out.
const SIZES: [i64; 2] = [32, 96];

impl Instructions {
    /// Renders the scene under `valgrind --tool=callgrind` with all its effects and without each of them.
    pub(super) fn measure(args: &EffectsArgs, ablation: &Ablation) -> Result<Self, CliError> {
        let folder = tempfile::tempdir().map_err(|error| failed(&error))?;
        let whole = per_pixel(args, None, folder.path())?;
        let present = ablation.effects.iter().filter(|price| price.is_present());
        let added = present.map(|price| {
            let effect = price.count.effect;
            Ok((effect, whole - per_pixel(args, Some(effect), folder.path())?))
        });
        Ok(Self(added.collect::<Result<_, CliError>>()?))
    }

    /// Instructions a pixel that an effect adds; nothing for one that is absent.
    pub(super) fn of(&self, effect: Effect) -> Option<i64> {
        self.0.iter().find(|entry| entry.0 == effect).map(|entry| entry.1)
    }
}

fn per_pixel(args: &EffectsArgs, without: Option<Effect>, folder: &Path) -> Result<i64, CliError> {
    let [small, large] = SIZES.map(|size| count(args, without, size, folder));
    let pixels = SIZES[1] * SIZES[1] - SIZES[0] * SIZES[0];
    Ok((large? - small?) / pixels)
}

fn count(args: &EffectsArgs, without: Option<Effect>, size: i64, folder: &Path) -> Result<i64, CliError> {
    let mut command = Command::new("valgrind");
    command.args(["--tool=callgrind", "--callgrind-out-file=/dev/null"]);
    command.arg(env::current_exe().map_err(|error| failed(&error))?);
    command.arg("render").arg(&args.scene).arg("-o").arg(folder.join("frame.bmp"));
    command.args(["--threads", "1", "--size", &size.to_string()]);
    if let Some(effect) = without {
        command.args(["--without", effect.name()]);
    }
    add_picture(&mut command, &args.picture);
    let output = command.stdin(Stdio::null()).output().map_err(|error| failed(&error))?;
    let report = String::from_utf8_lossy(&output.stderr);
    let collected = report.lines().find_map(|line| line.split_once("Collected : ")?.1.trim().parse().ok());
    collected
        .filter(|_| output.status.success())
        .ok_or_else(|| CliError::Instructions(report.trim().to_owned()))
}

/// The flags that say what is traced, other than size and threads.
fn add_picture(command: &mut Command, picture: &PictureArgs) {
    let camera = &picture.camera;
    for (flag, point) in [("--eye", camera.eye), ("--look", camera.look), ("--up", camera.up)] {
        command.arg(format!("{flag}={},{},{}", point.x, point.y, point.z));
    }
    if let Some(level) = picture.level {
        command.args(["--level", &level.to_string()]);
    }
    command.args(["--samples", &picture.samples.side.pow(2).to_string()]);
    command.args(["--precision", if picture.precision == Precision::F64 { "f64" } else { "f32" }]);
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

//! From a scene file to a World.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use bevy_ecs::prelude::*;

use crate::components::{CameraPose, Checkerboard, Precision, Texture, Textured};
use crate::image_file::{ImageFileError, decode_texture, load_texture};
use crate::scene::{Source, spawn};
use crate::study::Setting;

use super::args::{CameraArgs, ImageArgs, PictureArgs};
use super::{CliError, say};

/// Reads and spawns a scene; warnings go to standard error. Returns how many there were.
pub(super) fn load_world(path: &Path, world: &mut World) -> Result<usize, CliError> {
    let loaded = Source::read(path)?.load()?;
    for warning in &loaded.warnings {
        say(warning);
    }
    spawn(world, &loaded.description);
    Ok(loaded.warnings.len())
}

/// Reads and spawns a scene, and puts what the command line says over what the scene says. Returns the accuracy that it
/// is to be traced with.
pub(super) fn load_picture(scene: &Path, args: &PictureArgs, world: &mut World) -> Result<Setting, CliError> {
    load_world(scene, world)?;
    lay_texture(&args.images, scene, world)?;
    aim(&args.camera, world)?;
    let own = Setting::of(world, Precision::F64);
    let setting = args.accuracy.setting(Setting { pixels: args.size.unwrap_or(own.pixels), ..own });
    setting.apply(world);
    Ok(setting)
}

/// Images for the checkerboard: the ones named, else those beside the scene, else the built-in ones.
pub(super) fn find_images(args: &ImageArgs, scene: &Path) -> Result<Textured, CliError> {
    let find =
        |named: &Option<PathBuf>, name, built_in| find_texture(scene, named.as_deref(), name, built_in);
    Ok(Textured {
        white: Arc::new(find(&args.white, "texture_w.bmp", BUILT_IN_WHITE)?),
        black: Arc::new(find(&args.black, "texture_b.bmp", BUILT_IN_BLACK)?),
    })
}

/// Lays images on the checkerboard if that is asked for, see [`find_images`].
pub(super) fn lay_texture(args: &ImageArgs, scene: &Path, world: &mut World) -> Result<(), CliError> {
    if !args.texture {
        return Ok(());
    }
    let textured = find_images(args, scene)?;
    let boards: Vec<Entity> = world.query_filtered::<Entity, With<Checkerboard>>().iter(world).collect();
    for board in boards {
        world.entity_mut(board).insert(textured.clone());
    }
    Ok(())
}

const BUILT_IN_WHITE: &[u8] = include_bytes!("../../scenes/texture_w.bmp");
const BUILT_IN_BLACK: &[u8] = include_bytes!("../../scenes/texture_b.bmp");

fn find_texture(
    scene: &Path,
    named: Option<&Path>,
    name: &str,
    built_in: &[u8],
) -> Result<Texture, ImageFileError> {
    let beside = scene.with_file_name(name);
    match named {
        Some(path) => load_texture(path),
        None if beside.exists() => load_texture(&beside),
        None => decode_texture(built_in).ok_or(ImageFileError::Empty(name.into())),
    }
}

/// Puts the camera where the command line says.
pub(super) fn aim(args: &CameraArgs, world: &mut World) -> Result<(), CliError> {
    let pose = CameraPose::looking(args.eye, args.look, args.up).ok_or(CliError::NoDirection)?;
    for mut camera in world.query::<&mut CameraPose>().iter_mut(world) {
        *camera = pose;
    }
    Ok(())
}

//! From a scene file to a World.

use std::path::Path;
use std::sync::Arc;

use bevy_ecs::prelude::*;

use crate::components::{Checkerboard, Texture, Textured};
use crate::image_file::{ImageFileError, decode_texture, load_texture};
use crate::scene::{Source, spawn};

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

/// Lays images on the checkerboard: the ones named, else those beside the scene, else the built-in ones.
pub(super) fn lay_texture(
    world: &mut World,
    scene: &Path,
    white: Option<&Path>,
    black: Option<&Path>,
) -> Result<(), CliError> {
    let textured = Textured {
        white: Arc::new(find_texture(scene, white, "texture_w.bmp", BUILT_IN_WHITE)?),
        black: Arc::new(find_texture(scene, black, "texture_b.bmp", BUILT_IN_BLACK)?),
    };
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

//! `archetrace write`

use bevy_ecs::prelude::*;

use crate::scene::describe;
use crate::whole_file::write_whole;

use super::args::WriteArgs;
use super::load::load_world;
use super::{CliError, print};

/// Spawns a scene and writes the World back as a scene file.
pub(super) fn write(args: &WriteArgs) -> Result<(), CliError> {
    let mut world = World::new();
    load_world(&args.scene, &mut world)?;
    let text = describe(&mut world)?.to_string();
    match &args.output {
        Some(path) => Ok(write_whole(path, text.as_bytes())?),
        None => print(&text),
    }
}

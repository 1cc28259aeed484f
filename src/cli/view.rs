//! `archetrace view`

use bevy_ecs::prelude::*;

use crate::viewer::{Viewer, ViewerOptions};

use super::CliError;
use super::args::ViewArgs;
use super::load::{aim, find_images, load_world};

/// Opens a window on a scene file and stays until it is closed.
pub(super) fn view(args: &ViewArgs) -> Result<(), CliError> {
    let mut world = World::new();
    load_world(&args.scene, &mut world)?;
    aim(&args.camera, &mut world)?;
    let images = &args.images;
    let options = ViewerOptions {
        out: args.out.clone().unwrap_or_default(),
        precision: args.precision.into(),
        threads: args.threads,
        textured: Some(find_images(images, &args.scene)?),
        texture_arguments: images.arguments(),
        shows_texture: images.texture,
        print_camera: args.print_camera,
        print_events: args.print_events,
    };
    Ok(Viewer::of_file(&args.scene, world).with_options(options).run()?)
}

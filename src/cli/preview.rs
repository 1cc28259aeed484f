//! `archetrace preview`

use bevy_ecs::prelude::*;

use crate::components::{CameraPose, Lens, Snapshot};
use crate::image_file::encode_rgb8;
use crate::preview::PreviewStyle;
use crate::systems::{Drawn, FrameError, WorldProblem, list_schedule};
use crate::viewer::headless::Headless;
use crate::whole_file::{check_writable, write_whole};

use super::args::PreviewArgs;
use super::load::{aim, lay_texture, load_world};
use super::{CliError, say};

/// Draws the preview of a scene file off screen into a picture file.
pub(super) fn preview(args: &PreviewArgs) -> Result<(), CliError> {
    // What would make the work useless is asked before it.
    check_writable(&args.output)?;
    let mut world = World::new();
    load_world(&args.scene, &mut world)?;
    lay_texture(&args.images, &args.scene, &mut world)?;
    aim(&args.camera, &mut world)?;
    let side = args.size.unwrap_or(world.resource::<Snapshot>().pixels);
    let picture = draw(&mut world, &style(args), side)?;
    write_whole(&args.output, &encode_rgb8(side, picture, &args.output)?)?;
    Ok(())
}

fn style(args: &PreviewArgs) -> PreviewStyle {
    let usual = PreviewStyle { lights: args.lights, axes: args.axes, ..PreviewStyle::default() };
    if args.plain { PreviewStyle { samples: 1, ..usual } } else { usual }
}

fn draw(world: &mut World, style: &PreviewStyle, side: u32) -> Result<Vec<u8>, CliError> {
    let mut cameras = world.query::<(&CameraPose, &Lens)>();
    let found = cameras.iter(world).len();
    let camera = cameras.single(world).map(|(pose, lens)| (*pose, *lens));
    let (pose, lens) = camera.map_err(|_| FrameError::World(vec![WorldProblem::Cameras { found }]))?;
    world.init_resource::<Drawn>();
    list_schedule().run(world);
    let list = &world.resource::<Drawn>().0;
    if list.left_out() > 0 {
        say(&format!(
            "warning: {} objects or lights are too large, small or far to be drawn",
            list.left_out()
        ));
    }
    let mut headless = Headless::new()?;
    let renderer = headless.renderer()?;
    renderer.draw(list, &pose, &lens, style, side)?;
    Ok(renderer.read())
}

//! Own colours, by the preview and by the trace.

use archetrace::components::{Ambient, CameraPose, Color, Diffuse, Gloss, Lens, Mirror, Sampling, Snapshot};
use bevy_ecs::prelude::*;

use super::canvas::{Canvas, PLAIN, Shot};
use super::support::picture::Picture;
use super::support::tracing::trace;

/// Leaves objects nothing but their own colour, and the trace no light to look for.
fn strip(world: &mut World) {
    let objects: Vec<Entity> = world.query_filtered::<Entity, With<Color>>().iter(world).collect();
    for object in objects {
        world.entity_mut(object).remove::<(Gloss, Mirror)>().insert((Ambient(1.0), Diffuse(0.0)));
    }
}

/// The own colours that the trace finds, in 8 bits. The World has a camera for it afterwards.
pub(crate) fn traced_colors(world: &mut World, (pose, lens): (&CameraPose, &Lens), side: usize) -> Shot {
    strip(world);
    let cameras: Vec<Entity> = world.query_filtered::<Entity, With<CameraPose>>().iter(world).collect();
    cameras.into_iter().for_each(|camera| world.entity_mut(camera).despawn());
    world.spawn((*pose, *lens));
    world.insert_resource(Snapshot { pixels: side as u32, level: 1 });
    world.insert_resource(Sampling::default());
    let picture: Picture = trace::<f64>(world).picture;
    Shot { side, pixels: picture.levels() }
}

/// Draws and traces one view. Wherever the trace finds one colour within two pixels, the preview must show it exactly.
/// Returns the share of pixels that could be compared.
#[track_caller]
pub(crate) fn assert_same_colors(
    name: &str,
    world: &mut World,
    camera: (&CameraPose, &Lens),
    side: usize,
) -> f64 {
    let style = archetrace::preview::PreviewStyle { background: [0.0; 3], ..PLAIN };
    let drawn = Canvas::new().draw(world, camera, &style, side);
    let traced = traced_colors(world, camera, side);
    let mut compared = 0;
    for (column, row) in (2..side - 2).flat_map(|column| (2..side - 2).map(move |row| (column, row))) {
        let here = traced.at(column, row);
        let mut around = (column - 2..=column + 2).flat_map(|x| (row - 2..=row + 2).map(move |y| (x, y)));
        if around.all(|(x, y)| traced.at(x, y) == here) {
            compared += 1;
            assert_eq!(drawn.at(column, row), here, "{name}: column {column}, row {row}");
        }
    }
    f64::from(compared) / (side * side) as f64
}

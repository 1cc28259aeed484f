//! Draws a World off screen.

use archetrace::components::{CameraPose, Lens};
use archetrace::preview::{DrawList, PreviewStyle};
use archetrace::systems::{Drawn, list_schedule};
use archetrace::viewer::headless::Headless;

use bevy_ecs::prelude::*;

/// Nothing but objects, one sample a pixel, before a colour that no object has.
pub(crate) const PLAIN: PreviewStyle =
    PreviewStyle { background: [0.0, 1.0, 0.0], lights: false, axes: false, samples: 1 };

/// 8-bit red, green, blue of a square picture, top row first.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Shot {
    pub(crate) side: usize,
    pub(crate) pixels: Vec<[u8; 3]>,
}

impl Shot {
    pub(crate) fn at(&self, column: usize, row: usize) -> [u8; 3] {
        self.pixels[row * self.side + column]
    }

    pub(crate) fn count(&self, is_counted: impl Fn([u8; 3]) -> bool) -> usize {
        self.pixels.iter().filter(|&&pixel| is_counted(pixel)).count()
    }
}

/// A renderer of its own.
pub(crate) struct Canvas(Headless);

impl Canvas {
    pub(crate) fn new() -> Self {
        Self(Headless::new().unwrap_or_else(|error| panic!("{error}")))
    }

    /// What a camera sees of a World.
    pub(crate) fn draw(
        &mut self,
        world: &mut World,
        camera: (&CameraPose, &Lens),
        style: &PreviewStyle,
        side: usize,
    ) -> Shot {
        world.init_resource::<Drawn>();
        list_schedule().run(world);
        self.draw_list(&world.resource::<Drawn>().0, camera, style, side)
    }

    /// What a camera sees of a list.
    pub(crate) fn draw_list(
        &mut self,
        list: &DrawList,
        (pose, lens): (&CameraPose, &Lens),
        style: &PreviewStyle,
        side: usize,
    ) -> Shot {
        let renderer = self.0.renderer().unwrap();
        renderer.draw(list, pose, lens, style, side as u32).unwrap();
        let bytes = renderer.read();
        assert_eq!(bytes.len(), 3 * side * side);
        Shot { side, pixels: bytes.as_chunks::<3>().0.to_vec() }
    }

    /// Buffers filled so far.
    pub(crate) fn fills(&mut self) -> u64 {
        self.0.renderer().unwrap().fills()
    }
}

/// One picture of a World that is not drawn again.
pub(crate) fn draw_once(
    world: &mut World,
    camera: (&CameraPose, &Lens),
    style: &PreviewStyle,
    side: usize,
) -> Shot {
    Canvas::new().draw(world, camera, style, side)
}

//! Checkerboards: all of the picture is asked for each, ray by ray.

use std::sync::Arc;

use glow::Context;

use super::error::GlError;
use super::program::{Program, Value};
use super::screen::Screen;
use super::sources;
use super::texture::Texture;
use crate::components;
use crate::preview::draw_list::Board;
use crate::preview::rows::narrow;
use crate::preview::view::View;

/// The program, and images that boards carried in the last picture.
pub(super) struct Boards {
    gl: Arc<Context>,
    program: Program,
    images: Vec<(Arc<components::Texture>, Texture)>,
}

impl Boards {
    pub(super) fn new(gl: &Arc<Context>) -> Result<Self, GlError> {
        let program = Program::new(gl, "the checkerboard's program", sources::SCREEN, &sources::board())?;
        Ok(Self { gl: gl.clone(), program, images: Vec::new() })
    }

    /// Loads images that are new and forgets those that no board has any more. Returns how many were loaded.
    pub(super) fn load(&mut self, boards: &[Board]) -> Result<u64, GlError> {
        let used = |image: &Arc<components::Texture>| images(boards).any(|other| Arc::ptr_eq(image, other));
        self.images.retain(|(image, _)| used(image));
        let mut loaded = 0;
        for image in images(boards) {
            if self.image(image).is_none() {
                self.images.push((image.clone(), Texture::tile(&self.gl, image)?));
                loaded += 1;
            }
        }
        Ok(loaded)
    }

    /// Draws one board into a picture of so many samples a pixel.
    pub(super) fn draw(&self, board: &Board, view: &View, samples: i32, screen: &Screen) {
        let program = &self.program;
        program.bind();
        program.set("height", Value::Vec2(board.height));
        program.set("phase", Value::Vec2(view.phase(board.origin, board.cell)));
        program.set("density", Value::Float(narrow(1.0 / board.cell)));
        program.set("spread", Value::Float(narrow(1.0 / f64::from(samples).sqrt())));
        let [red, green, blue, _] = board.tint;
        program.set("tint", Value::Vec3([red, green, blue]));
        let textured = board.textured.as_ref();
        let both = textured.and_then(|both| Some((self.image(&both.white)?, self.image(&both.black)?)));
        if let Some((white, black)) = both {
            black.bind(1);
            white.bind(0);
            program.set("white_image", Value::Int(0));
            program.set("black_image", Value::Int(1));
        }
        program.set("textured", Value::Int(both.is_some().into()));
        screen.cover();
    }

    fn image(&self, image: &Arc<components::Texture>) -> Option<&Texture> {
        self.images.iter().find(|(known, _)| Arc::ptr_eq(known, image)).map(|(_, texture)| texture)
    }
}

fn images(boards: &[Board]) -> impl Iterator<Item = &Arc<components::Texture>> {
    let textured = boards.iter().filter_map(|board| board.textured.as_ref());
    textured.flat_map(|textured| [&textured.white, &textured.black])
}

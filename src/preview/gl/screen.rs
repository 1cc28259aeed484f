//! The finished pictures, copied into the window.
#![expect(unsafe_code, reason = "every function of GL is foreign")]

use std::sync::Arc;

use glow::{Context, HasContext};

use super::error::GlError;
use super::program::{Program, Value};
use super::sources;
use super::texture::Texture;
use crate::preview::Layout;

/// What is around the square of the picture.
const SURROUND: [f32; 4] = [0.07, 0.07, 0.08, 1.0];

/// A way to cover a whole target, and the programs that show pictures.
pub(super) struct Screen {
    gl: Arc<Context>,
    program: Program,
    /// For most pictures: without the quotients by which others are scaled, which take a processor that draws in
    /// software longer than a whole traced picture.
    plain: Program,
    /// Holds nothing: GL 3.3 draws from no array without one.
    array: glow::VertexArray,
}

impl Screen {
    pub(super) fn new(gl: &Arc<Context>) -> Result<Self, GlError> {
        let program = Program::new(gl, "the window's program", sources::SCREEN, sources::PRESENT)?;
        let plain = Program::new(gl, "the program of plain pictures", sources::SCREEN, sources::PLAIN)?;
        // SAFETY: the context is current, as `load_context` demands.
        let array = unsafe { gl.create_vertex_array() };
        let array = array.map_err(|reason| GlError::Object { what: "vertex array", reason })?;
        Ok(Self { gl: gl.clone(), program, plain, array })
    }

    /// Runs the bound program for every pixel of the target.
    pub(super) fn cover(&self) {
        // SAFETY: the context is current, and the array is alive and read by nobody.
        unsafe {
            self.gl.bind_vertex_array(Some(self.array));
            self.gl.draw_arrays(glow::TRIANGLES, 0, 3);
            self.gl.bind_vertex_array(None);
        }
    }

    /// Shows the pictures that there are in the middle of a window of this size.
    pub(super) fn show(
        &self,
        [width, height]: [i32; 2],
        layout: Layout,
        preview: Option<&Texture>,
        traced: Option<&Texture>,
    ) {
        let square = width.min(height);
        let corner = [(width - square) / 2, (height - square) / 2];
        // SAFETY: the context is current; all that is set here is undone or harmless.
        unsafe {
            self.gl.viewport(0, 0, width, height);
            let [red, green, blue, alpha] = SURROUND;
            self.gl.clear_color(red, green, blue, alpha);
            self.gl.clear(glow::COLOR_BUFFER_BIT);
        }
        // Where only one of both is there, it takes the whole square.
        match (layout, preview, traced) {
            (Layout::Preview, Some(preview), _) | (_, Some(preview), None) => {
                self.take_one(preview, Rows::BottomFirst, corner, square);
            }
            (Layout::Split, Some(preview), Some(traced)) => {
                self.take_both([preview, traced], corner, square, square / 2);
            }
            (_, _, Some(traced)) => self.take_one(traced, Rows::TopFirst, corner, square),
            (_, None, None) => return,
        }
        // SAFETY: the context is current.
        unsafe { self.gl.viewport(corner[0], corner[1], square, square) };
        self.cover();
        // SAFETY: the context is current. Whoever draws next starts from the whole window.
        unsafe { self.gl.viewport(0, 0, width, height) };
    }
}

/// The order of a picture's rows.
#[derive(Clone, Copy, PartialEq)]
enum Rows {
    TopFirst,
    BottomFirst,
}

impl Screen {
    /// Binds a program that shows one picture.
    fn take_one(&self, picture: &Texture, rows: Rows, corner: [i32; 2], square: i32) {
        if picture.size() != [square; 2] {
            let split = if rows == Rows::TopFirst { 0 } else { square };
            return self.take_both([picture; 2], corner, square, split);
        }
        let [first, next] = if rows == Rows::TopFirst { [square - 1, -1] } else { [0, 1] };
        picture.bind(0);
        self.plain.bind();
        self.plain.set("picture", Value::Int(0));
        self.plain.set("corner", Value::Ints(corner));
        self.plain.set("first", Value::Int(first));
        self.plain.set("next", Value::Int(next));
    }

    /// Binds the program that shows the columns of a preview, and from `split` on those of a traced picture.
    fn take_both(&self, [preview, traced]: [&Texture; 2], corner: [i32; 2], square: i32, split: i32) {
        traced.bind(1);
        preview.bind(0);
        self.program.bind();
        self.program.set("preview", Value::Int(0));
        self.program.set("traced", Value::Int(1));
        self.program.set("corner", Value::Ints(corner));
        self.program.set("square", Value::Int(square));
        self.program.set("split", Value::Int(split));
        self.program.set("divided", Value::Int((1..square).contains(&split).into()));
    }
}

impl Drop for Screen {
    fn drop(&mut self) {
        // SAFETY: the context is current, and nothing else deletes the array.
        unsafe { self.gl.delete_vertex_array(self.array) }
    }
}

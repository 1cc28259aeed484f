//! Instanced drawing from rows of numbers.
#![expect(unsafe_code, reason = "every function of GL is foreign")]

use core::ops::Range;
use std::sync::Arc;

use glow::{Context, HasContext};

use super::error::{GlError, check};
use crate::preview::rows::Rows;

/// A buffer with one row an instance, `N` vertex attributes of four floats each, and how they are read.
pub(super) struct Instances<const N: usize> {
    gl: Arc<Context>,
    array: glow::VertexArray,
    buffer: glow::Buffer,
    filled_from: Rows<N>,
}

impl<const N: usize> Instances<N> {
    /// An empty buffer.
    pub(super) fn new(gl: &Arc<Context>) -> Result<Self, GlError> {
        // SAFETY: the context is current, as `load_context` demands.
        unsafe {
            let array = gl
                .create_vertex_array()
                .map_err(|reason| GlError::Object { what: "vertex array", reason })?;
            let buffer = gl.create_buffer().map_err(|reason| {
                gl.delete_vertex_array(array);
                GlError::Object { what: "buffer", reason }
            })?;
            gl.bind_vertex_array(Some(array));
            for location in 0..size::<N>(1) {
                gl.enable_vertex_attrib_array(location.unsigned_abs());
                gl.vertex_attrib_divisor(location.unsigned_abs(), 1);
            }
            gl.bind_vertex_array(None);
            Ok(Self { gl: gl.clone(), array, buffer, filled_from: Rows::default() })
        }
    }

    /// Fills the buffer, unless it holds the same rows already. Returns whether it was filled.
    pub(super) fn fill(&mut self, rows: &Rows<N>) -> Result<bool, GlError> {
        if self.filled_from.is(rows) {
            return Ok(false);
        }
        // Should it fail, nothing may be read from it.
        self.filled_from = Rows::default();
        // SAFETY: the context is current, and the buffer is alive.
        unsafe {
            self.gl.bind_buffer(glow::ARRAY_BUFFER, Some(self.buffer));
            self.gl.buffer_data_u8_slice(glow::ARRAY_BUFFER, &rows.to_bytes(), glow::STATIC_DRAW);
            self.gl.bind_buffer(glow::ARRAY_BUFFER, None);
        }
        check(&self.gl)?;
        self.filled_from = rows.clone();
        Ok(true)
    }

    /// Rows in the buffer.
    pub(super) fn all(&self) -> Range<usize> {
        0..self.filled_from.len()
    }

    /// Draws a strip of `vertices` for each of some rows, in their order.
    pub(super) fn draw(&self, vertices: i32, rows: Range<usize>) {
        let count = i32::try_from(rows.len()).unwrap_or(i32::MAX);
        if count == 0 {
            return;
        }
        let (floats, stride) = (4, size::<N>(16));
        // SAFETY: the context is current, and array and buffer are alive. The attributes stay within the buffer, which
        // holds all rows: GL reads `count` of them from the first one on.
        unsafe {
            self.gl.bind_vertex_array(Some(self.array));
            self.gl.bind_buffer(glow::ARRAY_BUFFER, Some(self.buffer));
            let first = i32::try_from(rows.start).unwrap_or(i32::MAX).saturating_mul(stride);
            for location in 0..size::<N>(1) {
                // GL 3.3 knows no first instance; the attributes start there instead.
                let offset = first.saturating_add(16 * location);
                self.gl.vertex_attrib_pointer_f32(
                    location.unsigned_abs(),
                    floats,
                    glow::FLOAT,
                    false,
                    stride,
                    offset,
                );
            }
            self.gl.draw_arrays_instanced(glow::TRIANGLE_STRIP, 0, vertices, count);
            self.gl.bind_buffer(glow::ARRAY_BUFFER, None);
            self.gl.bind_vertex_array(None);
        }
    }
}

/// `N` things of this many bytes, as GL counts.
fn size<const N: usize>(bytes: usize) -> i32 {
    i32::try_from(N * bytes).unwrap_or(i32::MAX)
}

impl<const N: usize> Drop for Instances<N> {
    fn drop(&mut self) {
        // SAFETY: the context is current, and nothing else deletes them.
        unsafe {
            self.gl.delete_vertex_array(self.array);
            self.gl.delete_buffer(self.buffer);
        }
    }
}

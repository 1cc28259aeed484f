//! Images in GL's memory.
#![expect(unsafe_code, reason = "every function of GL is foreign")]

use std::cell::Cell;
use std::sync::Arc;

use glow::{Context, HasContext};

use super::error::{GlError, check};
use crate::components;

/// A texture of 8 bits a channel.
pub(super) struct Texture {
    gl: Arc<Context>,
    texture: glow::Texture,
    size: Cell<[i32; 2]>,
}

impl Texture {
    /// A square picture to draw into, or to be filled by [`Texture::fill`].
    pub(super) fn empty(gl: &Arc<Context>, side: i32) -> Result<Self, GlError> {
        let this = Self::new(gl)?;
        this.upload(side, side, None);
        this.parameter(glow::TEXTURE_MAX_LEVEL, 0);
        this.parameter(glow::TEXTURE_MIN_FILTER, glow::NEAREST);
        this.parameter(glow::TEXTURE_MAG_FILTER, glow::NEAREST);
        Ok(this)
    }

    /// The image on the cells of a checkerboard: near by as its texels are, farther away as their means. One that is
    /// too large for GL is halved until it fits.
    pub(super) fn tile(gl: &Arc<Context>, image: &components::Texture) -> Result<Self, GlError> {
        // SAFETY: the context is current, as `load_context` demands.
        let most = unsafe { gl.get_parameter_i32(glow::MAX_TEXTURE_SIZE) }.unsigned_abs().max(64);
        let (width, height, texels) = fitting(image, most);
        let this = Self::new(gl)?;
        this.upload(signed(width), signed(height), Some(&texels));
        this.parameter(glow::TEXTURE_MIN_FILTER, glow::LINEAR_MIPMAP_LINEAR);
        this.parameter(glow::TEXTURE_MAG_FILTER, glow::NEAREST);
        this.parameter(glow::TEXTURE_WRAP_S, glow::CLAMP_TO_EDGE);
        this.parameter(glow::TEXTURE_WRAP_T, glow::CLAMP_TO_EDGE);
        // SAFETY: the context is current, and `new` left the texture bound.
        unsafe { gl.generate_mipmap(glow::TEXTURE_2D) };
        check(gl)?;
        Ok(this)
    }

    /// An unfilled texture, bound to the first unit.
    fn new(gl: &Arc<Context>) -> Result<Self, GlError> {
        // SAFETY: the context is current.
        let texture = unsafe { gl.create_texture() };
        let texture = texture.map_err(|reason| GlError::Object { what: "texture", reason })?;
        let this = Self { gl: gl.clone(), texture, size: Cell::default() };
        this.bind(0);
        Ok(this)
    }

    /// Makes it the texture of a unit.
    pub(super) fn bind(&self, unit: u32) {
        // SAFETY: the context is current, and the texture is alive. A sampler object of somebody else's would overrule
        // the texture's own parameters.
        unsafe {
            self.gl.active_texture(glow::TEXTURE0 + unit);
            self.gl.bind_texture(glow::TEXTURE_2D, Some(self.texture));
            self.gl.bind_sampler(unit, None);
        }
    }

    /// Width and height in texels.
    pub(super) fn size(&self) -> [i32; 2] {
        self.size.get()
    }

    pub(super) fn name(&self) -> glow::Texture {
        self.texture
    }

    /// Replaces the image: red, green, blue, `width * height` times, or black. It must be bound to the active unit.
    pub(super) fn upload(&self, width: i32, height: i32, rgb: Option<&[u8]>) {
        let (target, format) = (glow::TEXTURE_2D, glow::RGBA8.cast_signed());
        let pixels = glow::PixelUnpackData::Slice(rgb);
        self.size.set([width, height]);
        // SAFETY: the context is current, and rows follow each other without gaps, as set here, so that GL reads no byte
        // beyond the slice.
        unsafe {
            self.gl.bind_buffer(glow::PIXEL_UNPACK_BUFFER, None);
            self.gl.pixel_store_i32(glow::UNPACK_ALIGNMENT, 1);
            self.gl.pixel_store_i32(glow::UNPACK_ROW_LENGTH, 0);
            self.gl.pixel_store_i32(glow::UNPACK_SKIP_ROWS, 0);
            self.gl.pixel_store_i32(glow::UNPACK_SKIP_PIXELS, 0);
            self.gl.tex_image_2d(target, 0, format, width, height, 0, glow::RGB, glow::UNSIGNED_BYTE, pixels);
            self.gl.pixel_store_i32(glow::UNPACK_ALIGNMENT, 4);
        }
    }

    fn parameter(&self, name: u32, value: u32) {
        // SAFETY: the context is current, and the texture bound.
        unsafe { self.gl.tex_parameter_i32(glow::TEXTURE_2D, name, value.cast_signed()) }
    }
}

impl Drop for Texture {
    fn drop(&mut self) {
        // SAFETY: the context is current, and nothing else deletes the texture.
        unsafe { self.gl.delete_texture(self.texture) }
    }
}

fn signed(size: u32) -> i32 {
    i32::try_from(size).unwrap_or(i32::MAX)
}

/// Width, height and bytes of an image of at most `most` texels a side: every second texel is dropped until it fits.
fn fitting(image: &components::Texture, most: u32) -> (u32, u32, Vec<u8>) {
    let longest = image.width().max(image.height());
    let step = longest.div_ceil(most).next_power_of_two();
    let (width, height) = (image.width().div_ceil(step), image.height().div_ceil(step));
    let rows = (0..height).flat_map(|row| (0..width).map(move |column| (column * step, row * step)));
    (width, height, rows.flat_map(|(column, row)| image.texel(column, row)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_image_that_fits_stays_and_a_larger_one_is_halved() {
        let texels = (0..12).map(|at| [at, at, at]).collect();
        let image = components::Texture::new(4, 3, texels).unwrap();
        let (width, height, bytes) = fitting(&image, 4);
        assert_eq!((width, height, bytes.len()), (4, 3, 36));
        let (width, height, bytes) = fitting(&image, 3);
        assert_eq!((width, height), (2, 2));
        assert_eq!(bytes, [[0, 0, 0], [2, 2, 2], [8, 8, 8], [10, 10, 10]].as_flattened());
    }
}

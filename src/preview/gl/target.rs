//! Where the preview is drawn: a square of its own, several samples a pixel where GL has them.
#![expect(unsafe_code, reason = "every function of GL is foreign")]

use std::sync::Arc;

use glow::{Context, HasContext};

use super::error::{GlError, check};
use super::texture::Texture;

/// A square picture in GL's memory.
pub(super) struct Target {
    /// The finished picture, bottom row first.
    pub(super) picture: Texture,
    finished: Framebuffer,
    /// Color and depth with several samples, to be resolved into `finished`.
    sampled: Option<Framebuffer>,
    side: i32,
    asked: (u32, u32),
    samples: i32,
}

impl Target {
    /// A picture of `side` by `side` pixels with that many samples each, or as many as there are.
    pub(super) fn new(gl: &Arc<Context>, side: u32, samples: u32) -> Result<Self, GlError> {
        let limit = |name: u32| parameter(gl, name);
        let most = limit(glow::MAX_RENDERBUFFER_SIZE).min(limit(glow::MAX_TEXTURE_SIZE));
        let pixels = i32::try_from(side).ok().filter(|side| (1..=most).contains(side));
        let pixels = pixels.ok_or(GlError::Size { side, most: most.unsigned_abs() })?;
        let count = i32::try_from(samples).unwrap_or(i32::MAX).min(limit(glow::MAX_SAMPLES));

        let picture = Texture::empty(gl, pixels)?;
        let finished = Framebuffer::new(gl)?.with_picture(&picture);
        let sampled = if count > 1 {
            let sampled = Framebuffer::new(gl)?
                .with_plane(glow::COLOR_ATTACHMENT0, glow::RGBA8, pixels, count)?
                .with_plane(glow::DEPTH_ATTACHMENT, glow::DEPTH_COMPONENT32F, pixels, count)?;
            Some(sampled.complete()?)
        } else {
            None
        };
        let finished = match &sampled {
            Some(_) => finished,
            None => finished.with_plane(glow::DEPTH_ATTACHMENT, glow::DEPTH_COMPONENT32F, pixels, 0)?,
        };
        let finished = finished.complete()?;
        check(gl)?;
        Ok(Self { picture, finished, sampled, side: pixels, asked: (side, samples), samples: count.max(1) })
    }

    /// Whether it is what [`Target::new`] would make.
    pub(super) fn suits(&self, side: u32, samples: u32) -> bool {
        self.asked == (side, samples)
    }

    /// Samples that a pixel really has.
    pub(super) fn samples(&self) -> i32 {
        self.samples
    }

    /// Pixels along each side, as GL counts.
    pub(super) fn side(&self) -> i32 {
        self.side
    }

    /// What follows is drawn here.
    pub(super) fn bind(&self) {
        self.sampled.as_ref().unwrap_or(&self.finished).bind(glow::FRAMEBUFFER);
    }

    /// Makes one colour of the samples of each pixel.
    pub(super) fn finish(&self) {
        let Some(sampled) = &self.sampled else { return };
        sampled.bind(glow::READ_FRAMEBUFFER);
        self.finished.bind(glow::DRAW_FRAMEBUFFER);
        let (gl, side) = (&sampled.gl, self.side);
        // SAFETY: the context is current, and both buffers have this size.
        unsafe {
            gl.blit_framebuffer(0, 0, side, side, 0, 0, side, side, glow::COLOR_BUFFER_BIT, glow::NEAREST);
        }
    }

    /// The finished picture: red, green, blue, top row first.
    pub(super) fn read(&self) -> Vec<u8> {
        let side = usize::try_from(self.side).unwrap_or(0);
        let mut pixels = vec![0; side * side * 4];
        self.finished.bind(glow::READ_FRAMEBUFFER);
        let gl = &self.finished.gl;
        // SAFETY: the context is current, the slice holds four bytes for each pixel, and rows of such pixels have no gaps
        // at any alignment.
        unsafe {
            gl.bind_buffer(glow::PIXEL_PACK_BUFFER, None);
            gl.pixel_store_i32(glow::PACK_ROW_LENGTH, 0);
            gl.pixel_store_i32(glow::PACK_SKIP_PIXELS, 0);
            gl.pixel_store_i32(glow::PACK_SKIP_ROWS, 0);
            let slice = glow::PixelPackData::Slice(Some(&mut pixels));
            gl.read_pixels(0, 0, self.side, self.side, glow::RGBA, glow::UNSIGNED_BYTE, slice);
            gl.bind_framebuffer(glow::FRAMEBUFFER, None);
        }
        let rows = pixels.chunks_exact(side * 4).rev();
        rows.flat_map(|row| row.chunks_exact(4).flat_map(|pixel| &pixel[..3])).copied().collect()
    }
}

fn parameter(gl: &Context, name: u32) -> i32 {
    // SAFETY: the context is current.
    unsafe { gl.get_parameter_i32(name) }
}

/// A framebuffer and the planes of pixels that it owns.
struct Framebuffer {
    gl: Arc<Context>,
    framebuffer: glow::Framebuffer,
    planes: Vec<glow::Renderbuffer>,
}

impl Framebuffer {
    fn new(gl: &Arc<Context>) -> Result<Self, GlError> {
        // SAFETY: the context is current.
        let framebuffer = unsafe { gl.create_framebuffer() };
        let framebuffer = framebuffer.map_err(|reason| GlError::Object { what: "framebuffer", reason })?;
        Ok(Self { gl: gl.clone(), framebuffer, planes: Vec::new() })
    }

    fn bind(&self, target: u32) {
        // SAFETY: the context is current, and the framebuffer is alive.
        unsafe { self.gl.bind_framebuffer(target, Some(self.framebuffer)) }
    }

    /// Draws into a texture, which must outlive it.
    fn with_picture(self, picture: &Texture) -> Self {
        self.bind(glow::FRAMEBUFFER);
        let (point, target) = (glow::COLOR_ATTACHMENT0, glow::TEXTURE_2D);
        // SAFETY: the context is current, and the framebuffer bound.
        unsafe {
            self.gl.framebuffer_texture_2d(glow::FRAMEBUFFER, point, target, Some(picture.name()), 0);
        }
        self
    }

    /// Adds a plane of pixels of its own.
    fn with_plane(mut self, point: u32, format: u32, side: i32, samples: i32) -> Result<Self, GlError> {
        self.bind(glow::FRAMEBUFFER);
        let (gl, kind) = (&self.gl, glow::RENDERBUFFER);
        // SAFETY: the context is current, and the framebuffer bound.
        unsafe {
            let plane = gl.create_renderbuffer();
            let plane = plane.map_err(|reason| GlError::Object { what: "plane of pixels", reason })?;
            self.planes.push(plane);
            gl.bind_renderbuffer(kind, Some(plane));
            gl.renderbuffer_storage_multisample(kind, samples, format, side, side);
            gl.bind_renderbuffer(kind, None);
            gl.framebuffer_renderbuffer(glow::FRAMEBUFFER, point, kind, Some(plane));
        }
        Ok(self)
    }

    /// Itself, if GL can draw into it.
    fn complete(self) -> Result<Self, GlError> {
        self.bind(glow::FRAMEBUFFER);
        // SAFETY: the context is current, and the framebuffer bound.
        let status = unsafe { self.gl.check_framebuffer_status(glow::FRAMEBUFFER) };
        match status {
            glow::FRAMEBUFFER_COMPLETE => Ok(self),
            code => Err(GlError::Object { what: "framebuffer", reason: format!("status {code:#06x}") }),
        }
    }
}

impl Drop for Framebuffer {
    fn drop(&mut self) {
        // SAFETY: the context is current, and nothing else deletes them.
        unsafe {
            self.gl.delete_framebuffer(self.framebuffer);
            for &plane in &self.planes {
                self.gl.delete_renderbuffer(plane);
            }
        }
    }
}

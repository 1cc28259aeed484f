//! The switches of GL: all that a picture depends on is set before it, because others draw with the same context.
#![expect(unsafe_code, reason = "every function of GL is foreign")]

use glow::{Context, HasContext};

/// Ready to draw bodies into the bound framebuffer of `side` by `side` pixels, cleared.
///
/// Depth is near by depth: 1 at the near plane, towards 0 at infinity, where floats are densest.
pub(super) fn begin(gl: &Context, side: i32, [red, green, blue]: [f32; 3]) {
    flat(gl);
    // SAFETY: the context is current, as `load_context` demands.
    unsafe {
        gl.viewport(0, 0, side, side);
        gl.enable(glow::DEPTH_TEST);
        gl.depth_func(glow::GREATER);
        gl.depth_mask(true);
        gl.depth_range_f32(0.0, 1.0);
        gl.enable(glow::MULTISAMPLE);
        gl.cull_face(glow::FRONT);
        gl.front_face(glow::CCW);
        gl.clear_color(red, green, blue, 1.0);
        gl.clear_depth_f32(0.0);
        gl.clear(glow::COLOR_BUFFER_BIT | glow::DEPTH_BUFFER_BIT);
    }
}

/// No depth, no blending, no clipping: pixels arrive as they are.
pub(super) fn flat(gl: &Context) {
    const SWITCHES: [u32; 10] = [
        glow::BLEND,
        glow::SCISSOR_TEST,
        glow::CULL_FACE,
        glow::DEPTH_TEST,
        glow::STENCIL_TEST,
        glow::FRAMEBUFFER_SRGB,
        glow::COLOR_LOGIC_OP,
        glow::RASTERIZER_DISCARD,
        glow::SAMPLE_ALPHA_TO_COVERAGE,
        glow::DITHER,
    ];
    // SAFETY: the context is current.
    unsafe {
        for switch in SWITCHES {
            gl.disable(switch);
        }
        gl.color_mask(true, true, true, true);
        gl.polygon_mode(glow::FRONT_AND_BACK, glow::FILL);
    }
}

/// Whether only the far sides of boxes are drawn: each pixel of them once, also from inside.
pub(super) fn cull_fronts(gl: &Context, culled: bool) {
    // SAFETY: the context is current.
    unsafe {
        if culled {
            gl.enable(glow::CULL_FACE);
        } else {
            gl.disable(glow::CULL_FACE);
        }
    }
}

/// After the last body.
pub(super) fn end(gl: &Context) {
    // SAFETY: the context is current. GL's own way is put back for those who only ever switch the depth test on.
    unsafe {
        gl.disable(glow::DEPTH_TEST);
        gl.depth_func(glow::LESS);
        gl.clear_depth_f32(1.0);
        gl.cull_face(glow::BACK);
    }
}

/// Unbinds everything of ours; what follows goes to the window.
pub(super) fn leave(gl: &Context) {
    // SAFETY: the context is current.
    unsafe {
        gl.use_program(None);
        gl.bind_vertex_array(None);
        gl.bind_buffer(glow::ARRAY_BUFFER, None);
        gl.bind_buffer(glow::UNIFORM_BUFFER, None);
        for unit in [1, 0] {
            gl.active_texture(glow::TEXTURE0 + unit);
            gl.bind_texture(glow::TEXTURE_2D, None);
        }
        gl.bind_framebuffer(glow::FRAMEBUFFER, None);
    }
}

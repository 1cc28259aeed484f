//! Shader programs and the uniform block that all of them share.
#![expect(unsafe_code, reason = "every function of GL is foreign")]

use std::sync::Arc;

use glow::{Context, HasContext};

use super::error::GlError;

/// The binding point of the uniform block `View`.
const VIEW_BINDING: u32 = 0;

/// A linked program. Uniforms that the compiler dropped are skipped silently.
pub(super) struct Program {
    gl: Arc<Context>,
    program: glow::Program,
}

impl Program {
    /// Compiles and links `vertex` and `fragment`; `what` names the program in messages.
    pub(super) fn new(
        gl: &Arc<Context>,
        what: &'static str,
        vertex: &str,
        fragment: &str,
    ) -> Result<Self, GlError> {
        let refused = |log: String| GlError::Shader { what, log: log.trim().to_owned() };
        // SAFETY: the context is current, as `load_context` demands; every name is made here.
        unsafe {
            let program = gl.create_program().map_err(refused)?;
            let this = Self { gl: gl.clone(), program };
            for (kind, source) in [(glow::VERTEX_SHADER, vertex), (glow::FRAGMENT_SHADER, fragment)] {
                let shader = gl.create_shader(kind).map_err(refused)?;
                gl.shader_source(shader, source);
                gl.compile_shader(shader);
                gl.attach_shader(program, shader);
                // It lives on as long as the program does.
                gl.delete_shader(shader);
                if !gl.get_shader_compile_status(shader) {
                    return Err(refused(gl.get_shader_info_log(shader)));
                }
            }
            gl.link_program(program);
            if !gl.get_program_link_status(program) {
                return Err(refused(gl.get_program_info_log(program)));
            }
            if let Some(block) = gl.get_uniform_block_index(program, "View") {
                gl.uniform_block_binding(program, block, VIEW_BINDING);
            }
            Ok(this)
        }
    }

    /// What follows is drawn by this program.
    pub(super) fn bind(&self) {
        // SAFETY: the context is current, and the program is alive.
        unsafe { self.gl.use_program(Some(self.program)) }
    }

    /// Sets a uniform of the program, which must be bound.
    pub(super) fn set(&self, name: &str, value: Value) {
        // SAFETY: the context is current, and the program is alive.
        unsafe {
            let location = self.gl.get_uniform_location(self.program, name);
            let location = location.as_ref();
            match value {
                Value::Int(value) => self.gl.uniform_1_i32(location, value),
                Value::Ints([x, y]) => self.gl.uniform_2_i32(location, x, y),
                Value::Float(value) => self.gl.uniform_1_f32(location, value),
                Value::Vec2([x, y]) => self.gl.uniform_2_f32(location, x, y),
                Value::Vec3([x, y, z]) => self.gl.uniform_3_f32(location, x, y, z),
            }
        }
    }
}

impl Drop for Program {
    fn drop(&mut self) {
        // SAFETY: the context is current, and nothing else deletes the program.
        unsafe { self.gl.delete_program(self.program) }
    }
}

/// The value of a uniform; truth values and image units are whole numbers.
#[derive(Clone, Copy, Debug)]
pub(super) enum Value {
    Int(i32),
    Ints([i32; 2]),
    Float(f32),
    Vec2([f32; 2]),
    Vec3([f32; 3]),
}

/// The buffer behind the uniform block `View`.
pub(super) struct ViewBlock {
    gl: Arc<Context>,
    buffer: glow::Buffer,
}

impl ViewBlock {
    pub(super) fn new(gl: &Arc<Context>) -> Result<Self, GlError> {
        // SAFETY: the context is current.
        let buffer = unsafe { gl.create_buffer() };
        let buffer = buffer.map_err(|reason| GlError::Object { what: "buffer", reason })?;
        Ok(Self { gl: gl.clone(), buffer })
    }

    /// Fills it and makes it the block of every program.
    pub(super) fn fill(&self, bytes: &[u8]) {
        // SAFETY: the context is current, and the buffer is alive.
        unsafe {
            self.gl.bind_buffer_base(glow::UNIFORM_BUFFER, VIEW_BINDING, Some(self.buffer));
            self.gl.buffer_data_u8_slice(glow::UNIFORM_BUFFER, bytes, glow::DYNAMIC_DRAW);
        }
    }
}

impl Drop for ViewBlock {
    fn drop(&mut self) {
        // SAFETY: the context is current, and nothing else deletes the buffer.
        unsafe { self.gl.delete_buffer(self.buffer) }
    }
}

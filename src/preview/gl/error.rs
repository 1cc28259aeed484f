//! What can go wrong in GL.
#![expect(unsafe_code, reason = "every function of GL is foreign")]

use glow::{Context, HasContext};
use thiserror::Error;

/// Why GL cannot draw.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum GlError {
    /// The context is too old, or not of desktop GL.
    #[error("OpenGL 3.3 is needed, and this is {0}: `archetrace render` needs no OpenGL")]
    Version(String),
    /// The driver refuses a shader of ours, with its own words.
    #[error("the driver's OpenGL cannot compile {what}: {log}")]
    Shader {
        /// The program it belongs to.
        what: &'static str,
        /// The driver's report.
        log: String,
    },
    /// An object could not be made.
    #[error("OpenGL has no room for another {what}: {reason}")]
    Object {
        /// What was to be made.
        what: &'static str,
        /// The driver's report.
        reason: String,
    },
    /// The picture is larger than GL can draw.
    #[error("OpenGL cannot draw {side} x {side} pixels (the most here is {most})")]
    Size {
        /// Pixels asked for along each side.
        side: u32,
        /// Pixels that GL has.
        most: u32,
    },
    /// The driver took the context away, or has no memory left; a new context may do.
    #[error("the OpenGL context was lost")]
    Lost,
    /// GL reported an error while drawing.
    #[error("OpenGL failed with error {0:#06x}")]
    Failed(u32),
}

/// What GL complained about since the last look.
pub(super) fn check(gl: &Context) -> Result<(), GlError> {
    // SAFETY: the context is current, as `load_context` demands.
    match unsafe { gl.get_error() } {
        glow::NO_ERROR => Ok(()),
        glow::CONTEXT_LOST | glow::OUT_OF_MEMORY => Err(GlError::Lost),
        code => Err(GlError::Failed(code)),
    }
}

/// Forgets complaints about what others did with the same context.
pub(super) fn forget(gl: &Context) {
    // A lost context may complain without end.
    for _ in 0..16 {
        if check(gl).is_ok() {
            return;
        }
    }
}

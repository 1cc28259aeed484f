//! The preview, drawn off screen: against the trace ray by ray, where paper has the answer, and as a command.
//!
//! Every test draws with OpenGL through EGL and fails where there is none.
#![cfg(feature = "viewer")]
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::print_stdout,
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    reason = "a test fails by panicking, says its figures, and counts pixels in floating point"
)]

mod agreement;
mod board;
mod buffers;
mod cameras;
mod canvas;
mod colors;
mod command;
mod extremes;
mod maps;
#[allow(dead_code, reason = "shared with tests that use more of it")]
#[path = "../cli/program.rs"]
mod program;
mod samples;
mod signs;
#[path = "../support/mod.rs"]
mod support;
mod ties;

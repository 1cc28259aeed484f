//! From a World to its tables and pictures: what is extracted, when, and what is refused.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    reason = "a test fails by panicking, and counts pixels in floating point"
)]

mod control_camera;
mod describe;
mod edits;
mod effect_columns;
mod effects;
mod extraction;
mod frames;
mod hard_messages;
mod levels;
mod problems;
mod pulse;
#[path = "../support/mod.rs"]
mod support;
mod units;

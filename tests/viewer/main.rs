//! The window as its users meet it: a real one on a display of its own (Xvfb), keys and mouse by xdotool.
//!
//! What the window does is read from its standard output, never guessed from the time that has passed.
#![cfg(feature = "viewer")]
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "a test that cannot go on should say so and stop"
)]

mod accuracy;
mod closing;
mod display;
mod edits;
mod examples;
mod keys;
mod lines;
mod live;
mod mouse;
mod panel;
mod picture;
#[allow(dead_code, reason = "shared with tests that use more of it")]
#[path = "../cli/program.rs"]
mod program;
mod refusals;
mod reload;
mod scenes;
mod sizes;
mod snapshots;
mod window;

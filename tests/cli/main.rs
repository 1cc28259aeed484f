//! The program as its users meet it: arguments, files, streams, signals and exit statuses.
//!
//! Status 0: done. 1: it could not be done, and standard error says why. 2: the arguments make no sense.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "a test that cannot go on should say so and stop"
)]

mod accuracy;
mod arguments;
mod check;
mod cost;
mod effects;
mod interrupt;
#[path = "../scenes/mutant.rs"]
mod mutant;
mod mutants;
mod outputs;
mod pictures;
mod program;
#[allow(
    dead_code,
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    reason = "shared with tests that use more of it; numbers below 2^53 lose nothing"
)]
#[path = "../support/random.rs"]
mod random;
#[cfg(feature = "viewer")]
mod render_command;
mod scene_files;
mod selfcheck;
mod stats;
mod streams;
mod textures;
mod threads;
mod write;

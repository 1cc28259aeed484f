//! Scene files: what is read, what is refused and where, and that nothing is lost on the way back.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "a test that cannot go on should say so and stop"
)]

mod hostile;
mod layout;
mod long;
mod mutant;
mod mutations;
mod numbers;
mod places;
#[allow(
    dead_code,
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    reason = "shared with tests that use more of it; numbers below 2^53 lose nothing"
)]
#[path = "../support/random.rs"]
mod random;
mod repository;
mod round_trip;
mod sample;
mod textures;
mod world;

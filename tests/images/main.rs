//! Whole pictures: against a second renderer, under changes that must not show, and where paper has the answer.
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

mod adaptive;
mod agreement;
mod closed_forms;
mod crowds;
mod gallery;
mod hard;
mod metamorphic;
mod naive;
mod paths;
mod samples;
mod scales;
mod streams;
#[path = "../support/mod.rs"]
mod support;
mod transforms;

//! The price list as files: CSV, JSON, a drawing, and the page as a browser shows it.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "a test that cannot go on should say so and stop"
)]

mod browser;
mod page;
mod sample;
mod similarity;
mod tables;

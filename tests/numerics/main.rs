//! Every kernel against exact arithmetic: hard cases by their id, random rays by the hundred thousand, and a bound
//! with a reason for each figure.
//!
//! `cargo test --test numerics -- --nocapture` prints the worst errors and the sizes of the bands.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::panic,
    clippy::print_stdout,
    clippy::unwrap_used,
    reason = "tests: a panic is a failure, --nocapture shows measured figures, and counts are small"
)]

mod almost_along;
mod camera;
mod camera_moves;
mod camera_raise;
mod checker;
mod checker_filter;
mod compensated;
mod cube;
mod disk;
mod exit;
mod exponential;
mod falloff;
mod glass;
mod gloss;
mod lens;
mod mirror;
mod oracle;
mod oracle_itself;
mod plane;
mod precision;
mod pyramid;
mod pyramid_edges;
mod selfcheck;
mod shown;
mod sphere;
mod spot;
mod srgb;
mod straight;
mod texel;
mod textbook;
mod texture_filter;
mod worst;

//! What kind of picture is asked for.

use bevy_ecs::prelude::*;

/// Size and depth of the traced picture.
#[derive(Resource, Clone, Copy, Debug, PartialEq, Eq)]
pub struct Snapshot {
    /// Pixels along each side, 1 to [`MAX_PIXELS`](super::range::MAX_PIXELS).
    pub pixels: u32,
    /// Rays that may follow each other, 0 to [`MAX_LEVEL`](super::range::MAX_LEVEL): 0 is black, 1 shows no
    /// mirror image, each more adds one bounce.
    pub level: u32,
}

impl Default for Snapshot {
    fn default() -> Self {
        Self { pixels: 768, level: 3 }
    }
}

/// Floating-point precision of the tables and of every kernel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Precision {
    /// Double.
    #[default]
    F64,
    /// Single.
    F32,
}

/// How often each pixel is sampled: on a regular grid of `side` by `side` points, 1 to
/// [`MAX_GRID`](super::range::MAX_GRID). One is the pixel's centre alone.
#[derive(Resource, Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sampling {
    /// Sample points along each side of a pixel.
    pub side: u32,
}

impl Default for Sampling {
    fn default() -> Self {
        Self { side: 1 }
    }
}

/// Samples only where they matter. As a resource of the World it asks for the points of [`Sampling`] one after the
/// other, and each pixel stops where its error is expected to be small enough.
#[derive(Resource, Clone, Copy, Debug, PartialEq)]
pub struct Adaptive {
    /// Expected error of a pixel, 0 to 1, at which it gets no more samples.
    pub threshold: f64,
}

/// Rays not worth following. As a resource of the World it ends paths through mirrors and glass early.
#[derive(Resource, Clone, Copy, Debug, PartialEq)]
pub struct Cutoff(
    /// Share of the light in a pixel, 0 to 1: a ray that carries no more is not traced.
    pub f64,
);

/// The time of the frame, for systems that move things. The window sets it before each frame; a program without one
/// sets it itself.
#[derive(Resource, Clone, Copy, Debug, Default, PartialEq)]
pub struct FrameTime {
    /// Seconds since the first frame.
    pub seconds: f64,
    /// Seconds since the frame before.
    pub step: f64,
}

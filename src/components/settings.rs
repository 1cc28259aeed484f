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

//! Thirty-two rays at once.
//!
//! A block of 8 x 4 pixels, or any other thirty-two, is traced together: one shape or one light against all its rays, in
//! loops over lanes that a compiler turns into vector instructions of whatever width there is. Each lane does what
//! [`radiance`] does for one ray, by the same operations in the same order, so a picture is the same to the bit on every
//! path. A lane that has nothing to do reaches nothing: its reach is below 0, and the rest of it is what it was before.
//!
//! [`radiance`]: super::radiance()

#![expect(
    clippy::needless_range_loop,
    reason = "a loop over lanes indexes them all: that is the form compilers turn into vector instructions"
)]

mod beam;
mod block;
mod bounds;
mod bundle;
mod closest;
mod lanes;
mod lights;
mod occlusion;
mod parties;
mod path;
mod stream;
mod surface;
mod trees;

pub(super) use block::{BLOCK, Block, Scratch};
pub(super) use bounds::Bounds;
pub(super) use lanes::LANES;
pub(super) use stream::{closest_hits, occlusions};
pub(super) use trees::TreeScratch;

use super::kernel::has;

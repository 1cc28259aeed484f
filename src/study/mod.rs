//! What accuracy and effects cost: measured on the user's own scene, never guessed.
//!
//! Frames are traced again and again, in turns, so that a busy machine disturbs every setting alike. The clock is an
//! argument: figures that do not depend on it (rays, rows, bytes, pictures) are the same on every run.

mod ablation;
mod bars;
mod difference;
mod spread;
#[cfg(test)]
mod tests;

pub use ablation::{Ablation, EffectPrice, Removal, ablate};
pub use bars::draw_bars;
pub use difference::Difference;
pub use spread::Spread;

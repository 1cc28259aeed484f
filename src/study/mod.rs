//! What accuracy and effects cost: measured on the user's own scene, never guessed.
//!
//! Frames are traced again and again, in turns, so that a busy machine disturbs every setting alike. The clock is an
//! argument: figures that do not depend on it (rays, rows, bytes, pictures) are the same on every run.

mod ablation;
mod bars;
mod care;
mod cells;
mod chooser;
mod cost;
mod difference;
mod heat;
mod lab;
mod preset;
mod setting;
mod similarity;
mod spread;
#[cfg(test)]
mod tests;

pub use ablation::{Ablation, EffectPrice, Removal, ablate};
pub use bars::draw_bars;
pub use care::price_of_care;
pub use chooser::{Choice, Chooser, FrontPoint, Wish, choose};
pub use cost::{
    AdaptiveGain, CareRow, CostReport, CostRow, EffectRow, HeatMap, KnobStep, Machine, NextSixDb,
    PagePicture, PictureEntry, Reference, Sweep, SweepPlan, Watch, adaptive_gains, cost_csv, cost_json,
    cost_page, draw_front, front_of_rows, knob_steps, next_6_db, sweep,
};
pub use difference::Difference;
pub use heat::{ERROR_LEVELS, error_colors, error_map, error_share, false_color, false_colors};
pub use lab::{Glimpse, Lab, Shot, Windows};
pub use preset::Preset;
pub use setting::{Knobs, Setting};
pub use similarity::mean_ssim;
pub use spread::Spread;

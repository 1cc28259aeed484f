//! The price list: every knob of accuracy swept, its time measured, its error against a reference of known floor.

mod front;
mod page;
mod plan;
mod report;
mod sweep;
mod table;

pub use front::{adaptive_gains, front_of_rows, knob_steps, next_6_db};
pub use page::{HeatMap, PagePicture, cost_page, draw_front};
pub use report::{
    AdaptiveGain, CareRow, CostReport, CostRow, EffectRow, KnobStep, Machine, NextSixDb, PictureEntry,
    Reference,
};
pub use sweep::{Sweep, SweepPlan, Watch, sweep};
pub use table::{cost_csv, cost_json};

//! The price list: every knob of accuracy swept, its time measured, its error against a reference of known floor.

mod page;
mod report;
mod table;

pub use page::{HeatMap, PagePicture, cost_page, draw_front};
pub use report::{
    CareRow, CostReport, CostRow, EffectRow, KnobStep, Machine, NextSixDb, PictureEntry, Reference,
};
pub use table::{cost_csv, cost_json};

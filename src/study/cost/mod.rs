//! The price list: every knob of accuracy swept, its time measured, its error against a reference of known floor.

mod report;

pub use report::{
    CareRow, CostReport, CostRow, EffectRow, KnobStep, Machine, NextSixDb, PictureEntry, Reference,
};

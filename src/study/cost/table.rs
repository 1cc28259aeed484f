//! A price list for programs: CSV and JSON.

use super::{CostReport, CostRow};

/// A column and what a row has there.
type Column = (&'static str, fn(&CostRow) -> String);

/// The columns of [`cost_csv`]. Numbers have as many digits as it takes to read the same number back; what is not there is
/// empty.
const COLUMNS: [Column; 29] = [
    ("setting", |row| row.setting.clone()),
    ("samples", |row| row.samples.to_string()),
    ("level", |row| row.knobs.level.to_string()),
    ("precision", |row| row.knobs.precision.to_owned()),
    ("filter", |row| row.knobs.filter.clone()),
    ("ms_min", |row| row.milliseconds.min.to_string()),
    ("ms_median", |row| row.milliseconds.median.to_string()),
    ("ms_iqr", |row| row.milliseconds.iqr.to_string()),
    ("rays", |row| row.rays.to_string()),
    ("rmse", |row| row.rmse.to_string()),
    ("psnr_db", |row| row.psnr_db.to_string()),
    ("worst_level", |row| row.worst_level.to_string()),
    ("over1", |row| row.over1.to_string()),
    ("over8", |row| row.over8.to_string()),
    ("ssim", |row| row.ssim.to_string()),
    ("at_floor", |row| row.at_floor.to_string()),
    ("alone_rmse", |row| or_empty(row.alone_rmse)),
    ("knob", |row| row.knob.to_owned()),
    ("side", |row| row.knobs.side.to_string()),
    ("threshold", |row| or_empty(row.knobs.threshold)),
    ("cutoff", |row| row.knobs.cutoff.to_string()),
    ("light_samples", |row| or_empty(row.knobs.light_samples)),
    ("pixels", |row| row.knobs.pixels.to_string()),
    ("primary", |row| row.primary.to_string()),
    ("shadow", |row| row.shadow.to_string()),
    ("mirror", |row| row.mirror.to_string()),
    ("refracted", |row| row.refracted.to_string()),
    ("instructions", |row| or_empty(row.instructions)),
    ("flags", |row| row.flags.clone()),
];

fn or_empty(value: Option<impl ToString>) -> String {
    value.map_or_else(String::new, |value| value.to_string())
}

/// The rows as CSV with a header, `assignment` first, a line for each setting. What is infinite is `inf`.
pub fn cost_csv(report: &CostReport) -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(COLUMNS.map(|(name, _)| name))?;
    for row in &report.rows {
        writer.write_record(COLUMNS.map(|(_, value)| value(row)))?;
    }
    let bytes = writer.into_inner().map_err(|error| error.into_error())?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// The whole report as JSON. What is infinite is `null`: the decibels of equal pictures.
pub fn cost_json(report: &CostReport) -> Result<String, serde_json::Error> {
    let mut text = serde_json::to_string_pretty(report)?;
    text.push('\n');
    Ok(text)
}

//! Every setting with its numbers.

use maud::{Markup, html};

use super::plot::row_id;
use super::section;
use super::words::{count, number, percent};
use crate::study::{CostReport, CostRow};

/// The columns: as `cost.csv` calls them, as people do.
const COLUMNS: [(&str, &str); 15] = [
    ("ms_median", "ms"),
    ("ms_min", "least ms"),
    ("ms_iqr", "spread of ms"),
    ("psnr_db", "dB"),
    ("rmse", "RMSE"),
    ("worst_level", "worst, levels"),
    ("over1", "pixels off by > 1 level"),
    ("over8", "pixels off by > 8 levels"),
    ("ssim", "SSIM"),
    ("rays", "rays"),
    ("samples", "samples a pixel"),
    ("level", "level"),
    ("precision", "precision"),
    ("filter", "filter"),
    ("flags", "flags of render"),
];

/// The table of all settings.
pub(super) fn rows(report: &CostReport) -> Markup {
    let content = html! {
        p {
            "All that was measured; " code { "cost.csv" } " has the same rows with all digits and columns. "
            "\u{2020} marks pictures as close to the truth as can be told. \u{2605} marks the settings worth choosing."
        }
        div.wide.tall tabindex="0" role="region" aria-label="All settings" {
            table.all {
                caption { "All settings" }
                thead {
                    tr {
                        th scope="col" data-column="setting" { "setting" }
                        @for (column, words) in COLUMNS { th scope="col" data-column=(column) { (words) } }
                    }
                }
                tbody {
                    @for (number, row) in report.rows.iter().enumerate() {
                        (one(row, number, report.front.contains(&number)))
                    }
                }
            }
        }
    };
    section("rows", "All settings", &content)
}

fn one(row: &CostRow, at: usize, is_best: bool) -> Markup {
    html! {
        tr id=(row_id(at)) data-setting=(row.setting) class=[(row.setting == "assignment").then_some("present")] {
            th scope="row" {
                (row.setting)
                @if is_best { span.sign title="no setting is both faster and truer" { " \u{2605}" } }
            }
            td { (number(row.milliseconds.median)) }
            td { (number(row.milliseconds.min)) }
            td { (number(row.milliseconds.iqr)) }
            td { (number(row.psnr_db)) @if row.at_floor { span.sign title="as close as can be told" { "\u{2020}" } } }
            td { (number(row.rmse)) }
            td { (count(row.worst_level.into())) }
            td { (percent(row.over1)) }
            td { (percent(row.over8)) }
            td { (number(row.ssim)) }
            td { (count(row.rays)) }
            td { (number(row.samples)) }
            td { (count(row.knobs.level.into())) }
            td.words { (row.knobs.precision) }
            td.words { (row.knobs.filter) }
            td.words { code { (row.flags) } }
        }
    }
}

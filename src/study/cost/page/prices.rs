//! The price list proper: decibels, knobs, numerical care, effects.

use maud::{Markup, html};

use super::section;
use super::words::{count, number, percent, signed, signed_count};
use crate::study::{CostReport, EffectRow, KnobStep};

/// A table with a caption that scrolls by itself where the window is narrow.
fn table(caption: &str, heads: &[&str], body: &Markup) -> Markup {
    html! {
        div.wide tabindex="0" role="region" aria-label=(caption) {
            table {
                caption { (caption) }
                thead { tr { @for head in heads { th scope="col" { (head) } } } }
                tbody { (body) }
            }
        }
    }
}

/// What half of the error costs, again and again.
pub(super) fn next_6_db(report: &CostReport) -> Markup {
    if report.next_6_db.is_empty() {
        return html! {};
    }
    let body = html! {
        @for step in &report.next_6_db {
            tr {
                th scope="row" { (step.from) }
                td { (number(step.from_db)) }
                td.words { (step.to) }
                td { (number(step.to_db)) }
                td { strong { (signed(step.milliseconds)) } }
                td { (signed_count(step.rays)) }
            }
        }
    };
    let heads = ["from", "dB", "to", "dB", "ms more", "rays more"];
    let content = html! {
        p { "Half of the error is 6 dB less of it. This is what each half costs, by the cheapest setting that gets there." }
        (table("What the next 6 dB cost", &heads, &body))
    };
    section("next", "The next 6 dB", &content)
}

/// Each knob one step from the present setting.
pub(super) fn knob_steps(report: &CostReport) -> Markup {
    if report.steps.is_empty() {
        return html! {};
    }
    let body = html! {
        @for step in &report.steps {
            tr {
                th scope="row" { (step.knob.replace('_', " ")) }
                td.words { (step.to) }
                td.words { (step.direction) }
                td { (signed(step.milliseconds)) }
                td { (signed_count(step.rays)) }
                td { (signed(step.decibels)) }
                td { (per_decibel(step)) }
                td.words { @if step.changes_model { "another model" } @else { "closer or coarser" } }
            }
        }
    };
    let heads =
        ["knob", "to", "meant to be", "ms more", "rays more", "dB more", "ms for each dB", "it computes"];
    let content = html! {
        p {
            "What is different if a single knob of the present setting is turned by one step. Most knobs compute the same "
            "picture closer or coarser. One marked as " em { "another model" } " computes something else \u{2014} the mean of "
            "what a pixel covers instead of one point of it, say \u{2014} and its decibels tell how much closer that is here, "
            "not that it must be so elsewhere."
        }
        (table("Each knob one step away from the present setting", &heads, &body))
    };
    section("knobs", "Each knob by itself", &content)
}

/// Milliseconds for a decibel, where something is bought for something.
fn per_decibel(step: &KnobStep) -> Markup {
    let (paid, bought) = (step.milliseconds, step.decibels);
    match (paid > 0.0, bought > 0.0) {
        (true, true) => number(paid / bought),
        (false, false) if bought < 0.0 => html! { (number(paid / bought)) " saved" },
        (true, false) => html! { "buys nothing" },
        _ => html! { "free" },
    }
}

/// What numerical care costs and buys.
pub(super) fn care(report: &CostReport) -> Markup {
    if report.care.is_empty() {
        return html! {};
    }
    let counted = report.care.iter().any(|row| row.instructions.is_some());
    let body = html! {
        @for row in &report.care {
            tr {
                th scope="row" { (row.way) }
                td { (number(row.nanoseconds)) }
                @if counted { td { @if let Some(instructions) = row.instructions { (number(instructions)) } } }
                td { (number(row.worst_far)) }
                td { (number(row.worst_near)) }
                td { (percent(row.self_hits)) }
            }
        }
    };
    let heads: Vec<&str> = [
        Some("way to compute"),
        Some("ns a ray"),
        counted.then_some("instructions a ray"),
        Some("worst error, small sphere far away"),
        Some("worst error, huge sphere underfoot"),
        Some("rays that hit what they leave"),
    ]
    .into_iter()
    .flatten()
    .collect();
    let content = html! {
        p {
            "The same rays computed in more and less careful ways. Errors are relative, of the distance to what is hit, the "
            "largest of all rays tried. A ray that meets the surface that it just left paints a speck that is not there."
        }
        (table("What numerical care costs and buys", &heads, &body))
    };
    section("care", "Numerical care", &content)
}

/// What each effect of the scene costs.
pub(super) fn effects(report: &CostReport) -> Markup {
    if report.effects.is_empty() {
        return html! {};
    }
    let most = report.effects.iter().map(|row| row.milliseconds.median.abs()).fold(0.0, f64::max);
    let body = html! {
        @for row in report.effects.iter().filter(|row| row.present) {
            tr {
                th scope="row" { (name(row)) }
                td { (signed(row.milliseconds.median)) }
                td.bar-cell { (bar(row.milliseconds.median, most)) }
                td { (signed_count(row.rays)) }
                td { (count(row.rows as u64)) }
                td { (count(row.bytes as u64)) }
                td { (number(row.rmse)) }
            }
        }
    };
    let heads = ["effect", "ms more", "", "rays more", "rows", "bytes", "change of the picture (RMSE)"];
    let absent: Vec<String> = report.effects.iter().filter(|row| !row.present).map(name).collect();
    let content = html! {
        p { "What each effect adds to the frame: the frame with it, less the frame without." }
        (table("What the effects of the scene add", &heads, &body))
        @if !absent.is_empty() {
            p { "Absent, and therefore free \u{2014} no row, no byte, no ray: " (absent.join(", ")) "." }
        }
    };
    section("effects", "Effects of the scene", &content)
}

fn name(row: &EffectRow) -> String {
    row.effect.replace('_', " ")
}

/// A bar as long as its share; what is saved has another colour.
fn bar(value: f64, most: f64) -> Markup {
    let share = if most > 0.0 { 100.0 * value.abs() / most } else { 0.0 };
    html! { span.bar.saved[value < 0.0] style={"width:" (format!("{share:.1}")) "%"} aria-hidden="true" {} }
}

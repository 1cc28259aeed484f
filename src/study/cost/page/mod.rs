//! A price list for people: one page that needs nothing beside it.

mod axis;
mod labels;
mod pictures;
mod plot;
mod prices;
mod rows;
mod words;

use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::{CostReport, CostRow};

pub use pictures::{HeatMap, PagePicture};
pub use plot::draw_front;

use prices::{adaptive, care, effects, knob_steps, next_6_db};
use words::{number, short};

/// Nothing but what is in the page may be shown, so a reader's browser asks nobody.
const POLICY: &str = "default-src 'none'; img-src data:; style-src 'unsafe-inline'";

/// The report as an HTML document with its pictures inside. It runs no script and loads nothing.
pub fn cost_page(report: &CostReport, shown: &[PagePicture]) -> String {
    let title = format!("What accuracy costs: {}", report.scene);
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta http-equiv="Content-Security-Policy" content=(POLICY);
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                title { (title) }
                style { (PreEscaped(include_str!("page.css"))) }
            }
            body {
                header {
                    h1 { "What accuracy costs" }
                    p.scene { "Scene " code { (report.scene) } ", measured by archetrace " (report.version) }
                    (notice(report))
                    (headline(report))
                    (contents(report, shown))
                }
                main {
                    (plot_section(report))
                    (next_6_db(report))
                    (knob_steps(report))
                    (adaptive(report))
                    (pictures::pictures(report, shown))
                    (care(report))
                    (effects(report))
                    (rows::rows(report))
                    (method(report))
                }
            }
        }
    };
    page.into_string()
}

/// A part of the page with its heading and an id to lead to.
fn section(id: &str, heading: &str, content: &Markup) -> Markup {
    html! {
        section id=(id) aria-labelledby={(id) "-heading"} {
            h2 id={(id) "-heading"} { (heading) }
            (content)
        }
    }
}

fn notice(report: &CostReport) -> Markup {
    html! {
        @if report.interrupted {
            p.notice { "The measurement was interrupted: settings are missing, and times rest on fewer rounds." }
        }
        @if report.quick {
            p.notice { "This is the quick version: small pictures, few settings, few rounds. Times are rough." }
        }
    }
}

/// What is known after one sentence.
fn headline(report: &CostReport) -> Markup {
    let floor = &report.reference;
    let samples: u32 = floor.sides.iter().map(|side| side * side).sum();
    html! {
        @if let Some(row) = report.rows.iter().find(|row| row.setting == "assignment") {
            p.headline {
                "Unless told otherwise, " code { "render" } " takes " strong { (number(row.milliseconds.median)) " ms" }
                " for this picture of " (report.pixels) " by " (report.pixels) " pixels, and is "
                strong { (number(row.psnr_db)) " dB" } " from the truth: " (typical(row)) "." (half_of(report, row))
            }
        }
        p {
            "The truth is itself computed, from " (samples) " samples in each pixel, and known to "
            strong { (number(floor.floor_psnr_db)) " dB" }
            ". That is the floor: a setting that reaches it is as close as can be told, and nothing is claimed beyond."
        }
    }
}

/// The cheapest way to half of the error, if there is one.
fn half_of(report: &CostReport, row: &CostRow) -> Markup {
    let mut front = report.front.iter().filter_map(|&number| report.rows.get(number));
    let half = front.find(|other| other.psnr_db >= row.psnr_db + 6.0);
    html! {
        @if let Some(half) = half {
            " Half of that error costs " (number(half.milliseconds.median)) " ms in all, by " em { (half.setting) } "."
        }
    }
}

fn typical(row: &CostRow) -> Markup {
    html! {
        "a colour channel is typically off by " (short(row.rmse * 255.0)) " of 255 levels, and "
        (short(row.over8 * 100.0)) "\u{202f}% of the pixels by more than 8"
    }
}

fn contents(report: &CostReport, shown: &[PagePicture]) -> Markup {
    let entries = [
        ("plot", "Time against error", true),
        ("next", "The next 6 dB", !report.next_6_db.is_empty()),
        ("knobs", "Each knob by itself", !report.steps.is_empty()),
        ("adaptive", "Adaptive samples", !report.adaptive.is_empty()),
        ("pictures", "Pictures", !shown.is_empty()),
        ("care", "Numerical care", !report.care.is_empty()),
        ("effects", "Effects of the scene", !report.effects.is_empty()),
        ("rows", "All settings", true),
        ("method", "How it was measured", true),
    ];
    html! {
        nav aria-label="Contents" {
            @for (id, words, _) in entries.into_iter().filter(|entry| entry.2) { a href={"#" (id)} { (words) } " " }
        }
    }
}

fn plot_section(report: &CostReport) -> Markup {
    let content = html! {
        p {
            "Every point is a setting: the further left the faster, the higher the truer. Six decibels more are half the error. "
            "The line joins the settings worth choosing; of every other one, some setting on the line is at least as fast "
            "and at least as true. A point tells its numbers when pointed at, and leads to its row below."
        }
        div.wide tabindex="0" role="region" aria-label="Plot of time against error" { (plot::front(report)) }
    };
    section("plot", "Time against error", &content)
}

fn method(report: &CostReport) -> Markup {
    let (machine, reference) = (&report.machine, &report.reference);
    let content = html! {
        dl {
            dt { "Command" } dd { code { (report.command) } }
            dt { "Machine" }
            dd { (machine.processor) ", " (machine.threads) " threads, " (machine.system) ", " (machine.simd) }
            dt { "Program" } dd { "archetrace " (report.version) }
            dt { "Scene" } dd { (report.scene) ", hash " code { (report.scene_hash) } ", seed " (report.seed) }
            dt { "Times" }
            dd {
                "Of the trace alone, in milliseconds: the median of " (report.rounds)
                @if report.rounds == 1 { " round" } @else { " rounds" }
                ". In each round every setting had its turn, so that a busy moment of the machine meets them all. The spread is "
                "between the quarter of the rounds from below and the quarter from above."
            }
            dt { "Truth" }
            dd {
                "The mean of two pictures, of " (reference.sides[0]) " by " (reference.sides[0]) " and "
                (reference.sides[1]) " by " (reference.sides[1]) " samples in each pixel: grids that share no point but the "
                "middle. Up to " (reference.level) " rays follow each other"
                @if reference.cutoff > 0.0 { ", as long as they carry more than " (short(reference.cutoff)) " of the light" }
                ". It took " (number(reference.milliseconds)) " ms."
            }
            dt { "Floor" }
            dd {
                "How far the two are apart: " (number(reference.floor_rmse)) " (RMSE), "
                (number(reference.floor_psnr_db)) " dB, at worst " (reference.floor_worst_level) " levels."
            }
            dt { "Error" }
            dd {
                "RMSE is the root of the mean squared difference of all channels, where 1 is black against white. In "
                "decibels it is \u{2212}20 log\u{2081}\u{2080} RMSE. SSIM is structural similarity of luma, 1 for pictures that look alike."
            }
        }
    };
    section("method", "How it was measured", &content)
}

//! Pictures of some settings, each with its error and its rays, one at a time.

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use maud::{Markup, html};

use super::section;
use super::words::{number, short};
use crate::study::{CostReport, CostRow, ERROR_LEVELS, error_share, false_color};

/// Numbers of each pixel in false colours.
#[derive(Clone, Debug)]
pub struct HeatMap {
    /// The picture, a PNG.
    pub png: Vec<u8>,
    /// The number that has the brightest colour.
    pub most: f64,
}

/// What one setting gives.
#[derive(Clone, Debug)]
pub struct PagePicture {
    /// Name of the setting, or `reference`.
    pub setting: String,
    /// The picture, a PNG.
    pub picture: Vec<u8>,
    /// The error of each pixel, a PNG by [`error_colors`](crate::study::error_colors); nothing for the reference.
    pub error: Option<Vec<u8>>,
    /// The rays of each pixel by [`false_colors`](crate::study::false_colors).
    pub rays: Option<HeatMap>,
}

/// The pictures, one chosen by a button. A page without scripts can do that: what follows the button that is pressed is shown.
pub(super) fn pictures(report: &CostReport, shown: &[PagePicture]) -> Markup {
    if shown.is_empty() {
        return html! {};
    }
    let content = html! {
        p { "Choose a setting. Its picture is shown beside where it is wrong and where its rays went." }
        fieldset.switch {
            legend { "Setting" }
            @for (at, entry) in shown.iter().enumerate() {
                input type="radio" name="picture" id={"picture-" (at)} checked[at == 0];
                label for={"picture-" (at)} { (entry.setting) }
                (panel(report, entry))
            }
        }
    };
    section("pictures", "Pictures", &content)
}

fn panel(report: &CostReport, entry: &PagePicture) -> Markup {
    let row = report.rows.iter().find(|row| row.setting == entry.setting);
    let name = &entry.setting;
    html! {
        div.panel data-setting=(name) {
            p { strong { (name) } @if let Some(row) = row { ": " (facts(row)) } @else { ": what the others are compared with" } }
            (figure(&entry.picture, &format!("The picture at {name}"), &html! { "the picture" }))
            @if let Some(error) = &entry.error {
                (figure(error, &format!("Error of each pixel at {name}"), &error_scale()))
            }
            @if let Some(rays) = &entry.rays {
                (figure(&rays.png, &format!("Rays of each pixel at {name}"), &ray_scale(rays.most)))
            }
        }
    }
}

fn facts(row: &CostRow) -> Markup {
    html! { (number(row.milliseconds.median)) " ms, " (number(row.psnr_db)) " dB, at worst " (row.worst_level) " levels off" }
}

fn figure(png: &[u8], words: &str, caption: &Markup) -> Markup {
    html! {
        figure {
            img src={"data:image/png;base64," (BASE64_STANDARD.encode(png))} alt=(words);
            figcaption { (caption) }
        }
    }
}

fn error_scale() -> Markup {
    let ticks = [0.0, 1.0, 4.0, 16.0, ERROR_LEVELS];
    scale("error in levels of 255", &ticks.map(|levels| (error_share(levels / 255.0), short(levels))))
}

fn ray_scale(most: f64) -> Markup {
    scale("rays of the pixel", &[0.0, 0.5, 1.0].map(|share| (share, short(share * most))))
}

/// A strip of all colours with numbers below.
fn scale(words: &str, ticks: &[(f64, String)]) -> Markup {
    let stops: Vec<String> = (0..=8)
        .map(|stop| {
            let [red, green, blue] = false_color(f64::from(stop) / 8.0);
            format!("#{red:02x}{green:02x}{blue:02x}")
        })
        .collect();
    html! {
        (words)
        span.scale style={"background:linear-gradient(90deg," (stops.join(",")) ")"} aria-hidden="true" {}
        span.ticks {
            @for (share, text) in ticks {
                span style={"left:" (format!("{:.1}", share * 100.0)) "%"} { (text) }
            }
        }
    }
}

//! Time against error: every setting a point, the front a line, the floor a line.

use maud::{Markup, PreEscaped, html};

use super::axis::{Axis, even_ticks, log_ticks};
use super::labels::{Area, Labels, width};
use super::words::short;
use crate::study::{CostReport, CostRow};

const WIDTH: f64 = 960.0;
const HEIGHT: f64 = 560.0;
const LEFT: f64 = 66.0;
const TOP: f64 = 44.0;
const RIGHT: f64 = WIDTH - 72.0;
const BOTTOM: f64 = HEIGHT - 58.0;
/// Levels of a channel in 8 bits.
const LEVELS: f64 = 255.0;

/// Time against error of all settings as an SVG document.
pub fn draw_front(report: &CostReport) -> String {
    Plot::new(report).svg(false).into_string()
}

/// The same inside a page, where every point leads to its row of the table.
pub(super) fn front(report: &CostReport) -> Markup {
    Plot::new(report).svg(true)
}

/// The id of a row of the table.
pub(super) fn row_id(number: usize) -> String {
    format!("row-{number}")
}

/// What a point stands for.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Other,
    Best,
    Preset,
    Assignment,
}

impl Kind {
    fn class(self) -> &'static str {
        match self {
            Self::Other => "other",
            Self::Best => "best",
            Self::Preset => "preset",
            Self::Assignment => "assignment",
        }
    }

    /// In the middle of (0, 0).
    fn outline(self) -> &'static str {
        match self {
            Self::Other => "M-4.5 0a4.5 4.5 0 1 0 9 0a4.5 4.5 0 1 0 -9 0z",
            Self::Best => "M-5 0a5 5 0 1 0 10 0a5 5 0 1 0 -10 0z",
            Self::Preset => "M-5.5 -5.5h11v11h-11z",
            Self::Assignment => "M0 -8.5l8.5 8.5l-8.5 8.5l-8.5 -8.5z",
        }
    }
}

struct Plot<'a> {
    report: &'a CostReport,
    /// Decimal logarithm of milliseconds.
    time: Axis,
    decibels: Axis,
    /// The shortest time above 0, for clocks that did not move.
    shortest: f64,
}

impl<'a> Plot<'a> {
    fn new(report: &'a CostReport) -> Self {
        let times = || report.rows.iter().map(|row| row.milliseconds.median);
        let shortest = times().filter(|&time| time > 0.0).fold(f64::INFINITY, f64::min);
        let shortest = if shortest.is_finite() { shortest } else { 1.0 };
        let longest = times().fold(shortest, f64::max);
        let finite = |number: &f64| number.is_finite();
        let floor = Some(report.reference.floor_psnr_db).filter(finite);
        let heights = || report.rows.iter().map(|row| row.psnr_db).filter(finite).chain(floor);
        let lowest = heights().fold(f64::INFINITY, f64::min);
        let lowest = if lowest.is_finite() { lowest } else { 0.0 };
        let highest = heights().fold(lowest, f64::max);
        let time = [(shortest / 1.5).log10(), (longest * 1.8).log10()];
        Self {
            report,
            time: Axis { range: time, ends: [LEFT, RIGHT] },
            decibels: Axis { range: [lowest - 2.0, highest + 4.0], ends: [BOTTOM, TOP] },
            shortest,
        }
    }

    fn x(&self, milliseconds: f64) -> f64 {
        self.time.place(milliseconds.max(self.shortest).log10())
    }

    fn point(&self, row: &CostRow) -> [f64; 2] {
        [self.x(row.milliseconds.median), self.decibels.place(row.psnr_db)]
    }

    fn kind(&self, number: usize) -> Kind {
        let row = &self.report.rows[number];
        match () {
            () if row.setting == "assignment" => Kind::Assignment,
            () if row.knob == "preset" => Kind::Preset,
            () if self.report.front.contains(&number) => Kind::Best,
            () => Kind::Other,
        }
    }

    fn svg(&self, is_linked: bool) -> Markup {
        html! {
            svg.plot xmlns=[(!is_linked).then_some("http://www.w3.org/2000/svg")] role="img"
                aria-label="Time against error: one point for each setting"
                viewBox={"0 0 " (WIDTH) " " (HEIGHT)} {
                style { (PreEscaped(include_str!("plot.css"))) }
                rect.paper width=(WIDTH) height=(HEIGHT) {}
                (self.floor_area())
                (self.time_axis())
                (self.decibel_axis())
                (self.level_axis())
                (self.floor_line())
                path.front d=(self.front_path()) {}
                @for row in &self.report.rows { (self.spread(row)) }
                @for number in self.drawing_order() { (self.mark(number, is_linked)) }
                @for label in self.labels().placed {
                    text.name text-anchor=(label.anchor) x=(px(label.at[0])) y=(px(label.at[1])) { (label.text) }
                }
                (legend())
            }
        }
    }

    /// What is important lies above the rest.
    fn drawing_order(&self) -> Vec<usize> {
        let of = |kind| (0..self.report.rows.len()).filter(move |&number| self.kind(number) == kind);
        [Kind::Other, Kind::Best, Kind::Preset, Kind::Assignment].into_iter().flat_map(of).collect()
    }

    fn time_axis(&self) -> Markup {
        let [least, most] = self.time.range.map(|power| 10.0_f64.powf(power));
        html! {
            @for tick in log_ticks(least, most) {
                @let x = px(self.x_of_tick(tick));
                line.grid x1=(x) x2=(x) y1=(TOP) y2=(BOTTOM) {}
                text x=(x) y=(BOTTOM + 18.0) text-anchor="middle" { (plain(tick)) }
            }
            text x=((LEFT + RIGHT) / 2.0) y=(BOTTOM + 42.0) text-anchor="middle" {
                "milliseconds for the picture (each line to the right takes longer)"
            }
        }
    }

    fn x_of_tick(&self, milliseconds: f64) -> f64 {
        self.time.place(milliseconds.log10())
    }

    fn decibel_axis(&self) -> Markup {
        let [least, most] = self.decibels.range;
        html! {
            @for tick in even_ticks(least, most) {
                @let y = self.decibels.place(tick);
                line.grid x1=(LEFT) x2=(RIGHT) y1=(px(y)) y2=(px(y)) {}
                text x=(LEFT - 8.0) y=(px(y + 4.0)) text-anchor="end" { (plain(tick)) }
            }
            (upright(16.0, "decibels: truer is higher"))
        }
    }

    /// The same error in levels, on the other side.
    fn level_axis(&self) -> Markup {
        let [most, least] = self.decibels.range.map(|decibels| LEVELS * 10.0_f64.powf(-decibels / 20.0));
        html! {
            @for tick in log_ticks(least, most) {
                @let y = self.decibels.place(-20.0 * (tick / LEVELS).log10());
                line.grid x1=(RIGHT) x2=(RIGHT + 5.0) y1=(px(y)) y2=(px(y)) {}
                text x=(RIGHT + 8.0) y=(px(y + 4.0)) { (plain(tick)) }
            }
            (upright(WIDTH - 10.0, "typical error in levels of 255 (RMSE)"))
        }
    }

    fn floor_area(&self) -> Markup {
        let y = self.decibels.place(self.report.reference.floor_psnr_db);
        html! { rect.beyond x=(LEFT) y=(TOP) width=(RIGHT - LEFT) height=(px(y - TOP)) {} }
    }

    fn floor_line(&self) -> Markup {
        let y = px(self.decibels.place(self.report.reference.floor_psnr_db));
        html! {
            line.floor x1=(LEFT) x2=(RIGHT) y1=(y) y2=(y) {}
            text.floor-name x=(LEFT + 6.0) y=(px(self.floor_name_line())) { (self.floor_name()) }
        }
    }

    fn floor_name_line(&self) -> f64 {
        self.decibels.place(self.report.reference.floor_psnr_db) - 6.0
    }

    fn floor_name(&self) -> String {
        let floor = self.report.reference.floor_psnr_db;
        format!("floor, {} dB: the truth is not known better, nothing is claimed beyond", short(floor))
    }

    /// Corners of the stairs: with so much time, no setting is truer.
    fn stairs(&self) -> Vec<[f64; 2]> {
        let mut corners: Vec<[f64; 2]> = Vec::new();
        for row in self.report.front.iter().filter_map(|&number| self.report.rows.get(number)) {
            let [x, y] = self.point(row);
            corners.extend(corners.last().map(|&[_, before]| [x, before]));
            corners.push([x, y]);
        }
        corners.extend(corners.last().map(|&[_, y]| [RIGHT, y]));
        corners
    }

    fn front_path(&self) -> String {
        let corners = self.stairs();
        let words = corners.iter().zip("ML".chars().chain(std::iter::repeat('L')));
        words.map(|(&[x, y], word)| format!("{word}{} {}", px(x), px(y))).collect()
    }

    /// Half of the measured times lay within this line.
    fn spread(&self, row: &CostRow) -> Markup {
        let y = px(self.decibels.place(row.psnr_db));
        let half = row.milliseconds.iqr / 2.0;
        let [x1, x2] = [-half, half].map(|half| px(self.x(row.milliseconds.median + half)));
        html! { line.spread x1=(x1) x2=(x2) y1=(y) y2=(y) {} }
    }

    fn mark(&self, number: usize, is_linked: bool) -> Markup {
        let row = &self.report.rows[number];
        let [x, y] = self.point(row).map(px);
        let kind = self.kind(number);
        let mark = html! {
            path class={"mark " (kind.class())} d=(kind.outline()) transform={"translate(" (x) " " (y) ")"} {
                title { (describe(row)) }
            }
        };
        match is_linked {
            true => html! { a href={"#" (row_id(number))} aria-label=(row.setting) { (mark) } },
            false => mark,
        }
    }

    fn labels(&self) -> Labels {
        let rows = &self.report.rows;
        let mut taken: Vec<Area> = rows.iter().map(|row| Area::around(self.point(row), 5.0)).collect();
        taken.extend(self.stairs().windows(2).map(|ends| Area::along(ends[0], ends[1])));
        let floor = self.floor_name_line();
        taken.push(Area([LEFT, floor - 12.0, LEFT + 6.0 + width(&self.floor_name()), floor + 4.0]));
        let bounds = Area([LEFT + 2.0, TOP + 2.0, RIGHT - 2.0, BOTTOM - 2.0]);
        let mut labels = Labels { bounds, taken, placed: Vec::new() };
        for number in self.drawing_order().into_iter().rev() {
            if self.kind(number) != Kind::Other {
                labels.add(&rows[number].setting, self.point(&rows[number]));
            }
        }
        labels
    }
}

fn describe(row: &CostRow) -> String {
    let error = short(row.rmse * LEVELS);
    format!(
        "{}: {} ms, {} dB (typical error {error} levels, the worst {}), {} rays{}",
        row.setting,
        short(row.milliseconds.median),
        short(row.psnr_db),
        row.worst_level,
        row.rays,
        if row.at_floor { "; as close as can be told" } else { "" }
    )
}

fn legend() -> Markup {
    let entries = [
        (Kind::Assignment, "what render does unless told otherwise", 0.0),
        (Kind::Preset, "other presets", 268.0),
        (Kind::Best, "no setting is both faster and truer", 380.0),
        (Kind::Other, "other settings", 620.0),
    ];
    html! {
        @for (kind, words, left) in entries {
            path class=(kind.class()) d=(kind.outline()) transform={"translate(" (LEFT + left + 8.0) " 20)"} {}
            text x=(LEFT + left + 22.0) y="24" { (words) }
        }
    }
}

fn upright(x: f64, words: &str) -> Markup {
    let y = (TOP + BOTTOM) / 2.0;
    html! { text text-anchor="middle" transform={"translate(" (x) " " (y) ") rotate(-90)"} { (words) } }
}

/// A tick's number, which is a round one.
fn plain(tick: f64) -> String {
    format!("{}", (tick * 1e9).round() / 1e9)
}

fn px(place: f64) -> String {
    format!("{place:.1}")
}

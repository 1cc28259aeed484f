//! A report as a small scene gives it, made by hand.

use archetrace::film::Film;
use archetrace::image_file::{encode, encode_rgb8};
use archetrace::study::{
    AdaptiveGain, CareRow, CostReport, CostRow, EffectRow, HeatMap, KnobStep, Knobs, Machine, NextSixDb,
    PagePicture, PictureEntry, Reference, Spread, error_colors, error_map, false_colors,
};

/// Decibels of the floor.
const FLOOR: f64 = 51.25;

/// Name, knob, flags, side, level, precision, filter, milliseconds, decibels.
type Measured = (&'static str, &'static str, &'static str, u32, u32, &'static str, &'static str, f64, f64);

const MEASURED: [Measured; 16] = [
    ("assignment", "preset", "", 1, 4, "f64", "none", 38.2, 26.6),
    ("draft", "preset", "--preset draft", 1, 1, "f32", "none", 14.7, 22.9),
    ("fine", "preset", "--preset fine", 4, 6, "f64", "checker", 655.0, 45.1),
    ("reference", "preset", "--preset reference", 16, 8, "f64", "checker", 9800.0, FLOOR),
    ("samples 4", "samples", "--samples 4", 2, 4, "f64", "none", 151.0, 34.7),
    ("samples 9", "samples", "--samples 9", 3, 4, "f64", "none", 340.0, 37.1),
    ("samples 16", "samples", "--samples 16", 4, 4, "f64", "none", 602.0, 38.9),
    ("samples 64", "samples", "--samples 64", 8, 4, "f64", "none", 2410.0, 44.7),
    ("level 1", "level", "--level 1", 1, 1, "f64", "none", 21.9, 23.0),
    ("level 8", "level", "--level 8", 1, 8, "f64", "none", 40.1, 26.6),
    ("f32", "precision", "--precision f32", 1, 4, "f32", "none", 26.3, 26.5),
    ("checker filter", "checker_filter", "--checker-filter", 1, 4, "f64", "checker", 39.5, 31.9),
    (
        "samples 4, checker filter",
        "grid",
        "--samples 4 --checker-filter",
        2,
        4,
        "f64",
        "checker",
        157.0,
        38.7,
    ),
    (
        "samples 64, checker filter",
        "grid",
        "--samples 64 --checker-filter",
        8,
        4,
        "f64",
        "checker",
        2520.0,
        50.9,
    ),
    ("adaptive 0.02", "adaptive", "--samples 64 --adaptive 0.02", 8, 4, "f64", "none", 410.0, 43.8),
    ("cutoff \"1/255\" <&>", "cutoff", "--cutoff 0.0039", 1, 4, "f64", "none", 36.9, 26.59),
];

/// Rows that no other row beats, the fastest first.
const FRONT: [usize; 9] = [1, 8, 10, 11, 12, 14, 2, 13, 3];

pub(crate) fn sample_report() -> CostReport {
    CostReport {
        version: "0.1.0",
        machine: Machine {
            processor: "Example 9000".to_owned(),
            threads: 2,
            system: "linux x86_64".to_owned(),
            simd: "AVX2".to_owned(),
        },
        scene: "scenes/still_life.txt".to_owned(),
        scene_hash: "cbf29ce484222325".to_owned(),
        seed: 0,
        command: "archetrace cost scenes/still_life.txt -o out".to_owned(),
        quick: false,
        interrupted: false,
        pixels: 48,
        rounds: 5,
        reference: Reference {
            sides: [17, 19],
            level: 12,
            cutoff: 0.0,
            floor_rmse: rmse(FLOOR),
            floor_psnr_db: FLOOR,
            floor_worst_level: 9,
            milliseconds: 24_800.0,
        },
        rows: MEASURED.map(row).to_vec(),
        front: FRONT.to_vec(),
        next_6_db: vec![
            step(22.9, "draft", 31.9, "checker filter", 24.8, 70_000),
            step(31.9, "checker filter", 38.7, "samples 4, checker filter", 117.5, 284_000),
            step(38.7, "samples 4, checker filter", 45.1, "fine", 498.0, 1_140_000),
        ],
        steps: vec![
            knob("samples", "truer", "samples 4", 112.8, 284_000, 8.1, false),
            knob("level", "faster", "level 1", -16.3, -30_000, -3.6, false),
            knob("level", "truer", "level 8", 1.9, 1200, 0.0, false),
            knob("precision", "faster", "f32", -11.9, -12, -0.1, false),
            knob("checker filter", "truer", "checker filter", 1.3, 0, 5.3, true),
        ],
        adaptive: vec![
            AdaptiveGain { setting: "adaptive 0.02".to_owned(), gain: Some(3.125) },
            AdaptiveGain { setting: "adaptive 0.001".to_owned(), gain: None },
        ],
        care: vec![
            care("f64, textbook", 41.0, Some(512.0), [2.1e-8, 7.3e-2], 0.127),
            care("f64, careful", 44.5, Some(590.0), [3.5e-16, 4.1e-16], 0.0),
            care("f32, careful", 30.1, Some(402.0), [2.6e-7, 2.1e-7], 0.0),
        ],
        effects: vec![
            effect("mirror", 16.3, 31_000),
            effect("spot_cone", -2.4, -2079),
            effect("fog", 0.0, 0),
        ],
        pictures: vec![],
    }
}

fn rmse(decibels: f64) -> f64 {
    10.0_f64.powf(-decibels / 20.0)
}

fn row((setting, knob, flags, side, level, precision, filter, milliseconds, decibels): Measured) -> CostRow {
    let samples = f64::from(side * side);
    let primary = u64::from(side * side) * 48 * 48;
    CostRow {
        setting: setting.to_owned(),
        knob,
        flags: flags.to_owned(),
        knobs: Knobs {
            side,
            threshold: (knob == "adaptive").then_some(0.02),
            level,
            cutoff: if knob == "cutoff" { 1.0 / 255.0 } else { 0.0 },
            precision,
            filter: filter.to_owned(),
            light_samples: None,
            pixels: 48,
        },
        samples,
        milliseconds: Spread { min: milliseconds * 0.94, median: milliseconds, iqr: milliseconds * 0.06 },
        rays: primary * 4,
        primary,
        shadow: primary * 2,
        mirror: primary,
        refracted: 0,
        instructions: (side == 1).then_some(7010.0),
        rmse: rmse(decibels),
        psnr_db: decibels,
        at_floor: decibels >= FLOOR,
        worst_level: 145,
        over1: 0.31,
        over8: 0.127,
        ssim: 0.987,
        alone_rmse: (knob == "samples").then_some(rmse(decibels) * 0.9),
    }
}

fn step(from_db: f64, from: &str, to_db: f64, to: &str, milliseconds: f64, rays: i64) -> NextSixDb {
    NextSixDb { from_db, from: from.to_owned(), to_db, to: to.to_owned(), milliseconds, rays }
}

fn knob(
    knob: &'static str,
    direction: &'static str,
    to: &str,
    milliseconds: f64,
    rays: i64,
    decibels: f64,
    changes_model: bool,
) -> KnobStep {
    KnobStep { knob, direction, to: to.to_owned(), milliseconds, rays, decibels, changes_model }
}

fn care(
    way: &'static str,
    nanoseconds: f64,
    instructions: Option<f64>,
    worst: [f64; 2],
    self_hits: f64,
) -> CareRow {
    CareRow { way, nanoseconds, instructions, worst_far: worst[0], worst_near: worst[1], self_hits }
}

fn effect(effect: &'static str, median: f64, rays: i64) -> EffectRow {
    let present = median != 0.0;
    let (rows, bytes, rmse) = if present { (2, 96, 0.031) } else { (0, 0, 0.0) };
    let milliseconds = Spread { min: median, median, iqr: median.abs() / 10.0 };
    EffectRow { effect, present, milliseconds, rays, rows, bytes, rmse }
}

/// The truth and two settings, with pictures that are easy to tell apart.
pub(crate) fn sample_pictures() -> Vec<PagePicture> {
    let reference = disk(24.0);
    ["truth", "assignment", "samples 64"]
        .into_iter()
        .zip([reference.clone(), disk(20.0), disk(23.5)])
        .map(|(setting, film)| {
            let errors = error_map(&film, &reference).unwrap();
            let rays: Vec<f64> = film.pixels().iter().map(|pixel| 1.0 + 7.0 * pixel[0]).collect();
            PagePicture {
                setting: setting.to_owned(),
                picture: encode(&film, "x.png".as_ref()).unwrap(),
                error: (setting != "truth").then(|| png(error_colors(&errors))),
                rays: Some(HeatMap { png: png(false_colors(&rays, 8.0)), most: 8.0 }),
            }
        })
        .collect()
}

fn png(rgb: Vec<u8>) -> Vec<u8> {
    encode_rgb8(48, rgb, "x.png".as_ref()).unwrap()
}

fn disk(radius: f64) -> Film {
    let mut film = Film::new(48).unwrap();
    for (y, row) in (0_u32..).zip(film.pixels_mut().chunks_mut(48)) {
        for (x, pixel) in (0_u32..).zip(row) {
            let [x, y] = [x, y].map(|place| f64::from(place) - 23.5);
            let inside = (radius - x.hypot(y)).clamp(0.0, 1.0);
            *pixel = [inside, 0.6 * inside, 0.2 + 0.1 * inside];
        }
    }
    film
}

/// Entries of a folder with these pictures.
pub(crate) fn entries() -> Vec<PictureEntry> {
    let entry = |setting: &str, error: Option<&str>| PictureEntry {
        setting: setting.to_owned(),
        picture: format!("{setting}.png"),
        error: error.map(str::to_owned),
        rays: None,
    };
    vec![entry("truth", None), entry("assignment", Some("assignment-error.png"))]
}

//! The page in a browser: its numbers, its switch, its looks, and that it asks nobody for anything.

use std::collections::BTreeSet;
use std::sync::LazyLock;

use archetrace::study::{cost_csv, cost_page};
use image::RgbImage;
use serde_json::{Value, json};

use crate::browser::Opened;
use crate::sample::{sample_pictures, sample_report};

fn page() -> String {
    cost_page(&sample_report(), &sample_pictures())
}

/// One look serves all tests.
static FOUND: LazyLock<Value> = LazyLock::new(|| Opened::new(&page()).look());

fn list(name: &str) -> &'static [Value] {
    FOUND[name].as_array().unwrap_or_else(|| panic!("{name}: {:?}", FOUND.as_object().unwrap().keys()))
}

fn words(value: &Value) -> &str {
    value.as_str().unwrap()
}

#[test]
fn the_table_has_the_numbers_of_the_csv() {
    let text = cost_csv(&sample_report()).unwrap();
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let header = reader.headers().unwrap().clone();
    let records: Vec<csv::StringRecord> = reader.records().map(|record| record.unwrap()).collect();
    assert_eq!(list("rows").len(), records.len());
    for (row, record) in list("rows").iter().zip(&records) {
        let cells = row.as_array().unwrap();
        assert!(cells.len() > 12, "{row}");
        for cell in cells {
            let column = words(&cell["column"]);
            let at = header.iter().position(|name| name == column).unwrap_or_else(|| panic!("{cell}"));
            assert_eq!(words(&cell["value"]), &record[at], "{}: {column}", &record[0]);
            is_rounded(words(&cell["text"]), &record[at]);
        }
    }
}

/// What people read is what programs read, in three digits.
fn is_rounded(text: &str, exact: &str) {
    let Ok(exact) = exact.parse::<f64>() else { return };
    let is_percent = text.contains('%');
    let digits = text.replace(['\u{202f}', '%', '+'], "").replace('\u{2212}', "-");
    let shown: f64 = digits.parse().unwrap_or_else(|_| panic!("{text}"));
    let shown = if is_percent { shown / 100.0 } else { shown };
    assert!((shown - exact).abs() <= 0.05 * exact.abs(), "{text} {exact}");
}

#[test]
fn every_number_of_the_report_is_somewhere() {
    let numbers: BTreeSet<&str> = list("numbers").iter().map(words).collect();
    let report = sample_report();
    let steps = report.steps.iter().flat_map(|step| [step.milliseconds, step.decibels]);
    let next = report.next_6_db.iter().flat_map(|step| [step.from_db, step.to_db, step.milliseconds]);
    let care =
        report.care.iter().flat_map(|row| [row.nanoseconds, row.worst_far, row.worst_near, row.self_hits]);
    let effects = report.effects.iter().filter(|row| row.present).map(|row| row.milliseconds.median);
    for number in steps.chain(next).chain(care).chain(effects) {
        assert!(numbers.contains(number.to_string().as_str()), "{number}");
    }
    let text = words(&FOUND["text"]);
    let machine = &report.machine;
    for words in [&report.command, &report.scene_hash, &report.scene, &machine.processor, &machine.simd] {
        assert!(text.contains(words), "{words}");
    }
    assert!(text.contains("another model") && text.contains("17 by 17 and 19 by 19"), "{text}");
    // The effect that is absent is said to be free.
    assert!(text.contains("no ray: fog."), "{text}");
}

#[test]
fn the_headline_is_what_render_does_by_default() {
    let text = words(&FOUND["text"]);
    assert!(text.contains("render takes 38.2 ms"), "{text}");
    assert!(
        text.contains("26.6 dB from the truth: a colour channel is typically off by 11.9 of 255 levels"),
        "{text}"
    );
    assert!(text.contains("known to 51.2 dB"), "{text}");
}

#[test]
fn every_button_shows_its_setting_and_nothing_else() {
    let expected: Vec<Value> = ["assignment", "samples 64", "reference"]
        .map(|setting| json!({ "pressed": setting, "shown": [setting] }))
        .to_vec();
    assert_eq!(list("pressed"), expected);
}

#[test]
fn every_point_says_its_setting_and_leads_to_its_row() {
    let named: BTreeSet<&str> = list("points").iter().map(|point| words(&point["label"])).collect();
    let report = sample_report();
    assert_eq!(named, report.rows.iter().map(|row| row.setting.as_str()).collect());
    for point in list("points") {
        assert!(words(&point["title"]).starts_with(words(&point["label"])), "{point}");
    }
    assert_eq!(list("dangling"), &[] as &[Value]);
    let ids: BTreeSet<&str> = list("ids").iter().map(words).collect();
    assert_eq!(ids.len(), list("ids").len());
}

#[test]
fn no_name_covers_another_and_none_is_cut() {
    assert_eq!(list("overlapping"), &[] as &[Value]);
    assert_eq!(list("cut"), &[] as &[Value]);
}

#[test]
fn windows_of_every_width_are_wide_enough() {
    assert_eq!(list("tooWide"), &[] as &[Value]);
}

#[test]
fn who_cannot_see_is_told_as_well() {
    assert_eq!((&FOUND["nameless"], &FOUND["headless"]), (&json!(0), &json!(0)));
    assert_eq!(list("pictures").len(), 8);
    for picture in list("pictures") {
        assert_eq!(
            (&picture["side"], &picture["from"]),
            (&json!(48), &json!("data:image/png;")),
            "{picture}"
        );
        assert!(words(&picture["alt"]).contains(" at "), "{picture}");
    }
}

#[test]
fn nothing_is_asked_of_anybody() {
    let page = page();
    assert!(!page.contains("://") && !page.contains("@import") && !page.contains("url("));
    assert!(page.contains("default-src &#39;none&#39;") || page.contains("default-src 'none'"));
    assert_eq!((list("requests"), &FOUND["scripts"]), (&[] as &[Value], &json!(0)));
}

#[test]
fn names_are_no_markup() {
    let mut report = sample_report();
    report.scene = "<script>alert(1)</script>".to_owned();
    report.rows[0].setting = "\"><img src=x>".to_owned();
    let page = cost_page(&report, &[]);
    assert!(!page.contains("<script") && !page.contains("<img"), "{page}");
}

#[test]
fn a_report_of_nothing_is_a_page_as_well() {
    let mut report = sample_report();
    report.rows.clear();
    report.front.clear();
    report.next_6_db.clear();
    report.steps.clear();
    report.care.clear();
    report.effects.clear();
    report.interrupted = true;
    let found = Opened::new(&cost_page(&report, &[])).look();
    assert_eq!((&found["rows"], &found["dangling"]), (&json!([]), &json!([])));
    assert!(words(&found["text"]).contains("was interrupted"), "{found}");
}

/// Colours that a picture has, and its mean brightness, 0 to 255.
fn seen(picture: &RgbImage) -> (usize, f64) {
    let colours: BTreeSet<[u8; 3]> = picture.pixels().map(|pixel| pixel.0).collect();
    let sum: f64 = picture.pixels().map(|pixel| f64::from(pixel.0[1])).sum();
    (colours.len(), sum / f64::from(picture.width() * picture.height()))
}

#[test]
fn it_is_seen_in_both_schemes() {
    let opened = Opened::new(&page());
    let [light, dark] =
        [false, true].map(|is_dark| seen(&opened.screenshot("cost.html", [1000, 1400], is_dark)));
    assert!(light.0 > 100 && dark.0 > 100, "{light:?} {dark:?}");
    assert!(light.1 > 200.0 && dark.1 < 80.0, "{light:?} {dark:?}");
}

#[test]
fn another_setting_is_another_sight() {
    let opened = Opened::new(&page());
    let [first, second] =
        ["look.html#0", "look.html#1"].map(|page| opened.screenshot(page, [1100, 900], false));
    let differing = first.pixels().zip(second.pixels()).filter(|(a, b)| a != b).count();
    assert!(differing > 5000, "{differing}");
}

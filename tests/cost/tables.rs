//! CSV and JSON against what is promised of them.

use std::collections::BTreeSet;

use archetrace::study::{CostReport, cost_csv, cost_json, draw_front};
use serde_json::{Value, json};

use crate::sample::{entries, sample_report};

/// The columns that programs may rely on, in this order.
const PROMISED: &str = "setting,samples,level,precision,filter,ms_min,ms_median,ms_iqr,rays,rmse,psnr_db,worst_level,over1,over8";

fn records(report: &CostReport) -> Vec<csv::StringRecord> {
    let text = cost_csv(report).unwrap();
    csv::Reader::from_reader(text.as_bytes()).records().map(|record| record.unwrap()).collect()
}

#[test]
fn the_columns_are_those_promised_and_no_name_is_twice() {
    let text = cost_csv(&sample_report()).unwrap();
    let header = text.lines().next().unwrap();
    assert!(header.starts_with(PROMISED), "{header}");
    let names: BTreeSet<&str> = header.split(',').collect();
    assert_eq!(names.len(), header.split(',').count());
}

#[test]
fn every_number_reads_back_to_the_same_value() {
    let mut report = sample_report();
    report.rows[1].rmse = 0.1 + 0.2;
    report.rows[2].psnr_db = f64::INFINITY;
    report.rows[3].rmse = f64::MIN_POSITIVE;
    report.rows[4].rays = u64::MAX;
    let records = records(&report);
    assert_eq!(records.len(), report.rows.len());
    for (record, row) in records.iter().zip(&report.rows) {
        assert_eq!(&record[0], row.setting);
        let numbers: Vec<f64> =
            [1, 2, 5, 6, 7, 9, 10, 11, 12, 13].map(|at| record[at].parse().unwrap()).to_vec();
        let spread = row.milliseconds;
        let expected = [
            row.samples,
            row.knobs.level.into(),
            spread.min,
            spread.median,
            spread.iqr,
            row.rmse,
            row.psnr_db,
            row.worst_level.into(),
            row.over1,
            row.over8,
        ];
        assert_eq!(numbers, expected, "{}", row.setting);
        assert_eq!((&record[3], &record[4]), (row.knobs.precision, row.knobs.filter.as_str()));
        assert_eq!(record[8].parse(), Ok(row.rays));
    }
    assert_eq!(&records[2][10], "inf");
}

#[test]
fn what_is_not_there_is_empty() {
    let text = cost_csv(&sample_report()).unwrap();
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let header = reader.headers().unwrap().clone();
    let rows: Vec<csv::StringRecord> = reader.records().map(|record| record.unwrap()).collect();
    let of = |setting: &str, column: &str| {
        let at = header.iter().position(|name| name == column).unwrap();
        rows.iter().find(|row| &row[0] == setting).unwrap()[at].to_owned()
    };
    assert_eq!(
        (of("assignment", "threshold"), of("adaptive 0.02", "threshold")),
        (String::new(), "0.02".into())
    );
    assert_eq!(
        (of("assignment", "alone_rmse"), of("assignment", "at_floor")),
        (String::new(), "false".into())
    );
    assert_eq!((of("reference", "at_floor"), of("fine", "flags")), ("true".into(), "--preset fine".into()));
}

/// Whether the schema that the tests keep takes this.
fn problems(json: &Value) -> Vec<String> {
    let schema: Value = serde_json::from_str(include_str!("cost.schema.json")).unwrap();
    let validator = jsonschema::draft202012::new(&schema).unwrap();
    validator.iter_errors(json).map(|error| format!("{}: {error}", error.instance_path())).collect()
}

fn parsed(report: &CostReport) -> Value {
    serde_json::from_str(&cost_json(report).unwrap()).unwrap()
}

#[test]
fn json_is_as_the_schema_says() {
    let mut report = sample_report();
    report.pictures = entries();
    assert_eq!(problems(&parsed(&report)), Vec::<String>::new());
    // Equal pictures: infinitely many decibels.
    report.rows[0].psnr_db = f64::INFINITY;
    report.reference.floor_psnr_db = f64::INFINITY;
    report.steps[0].decibels = f64::NAN;
    let json = parsed(&report);
    assert_eq!(problems(&json), Vec::<String>::new());
    assert_eq!((&json["rows"][0]["psnr_db"], &json["rows"][1]["psnr_db"]), (&Value::Null, &json!(22.9)));
}

#[test]
fn the_schema_finds_what_is_wrong() {
    let good = parsed(&sample_report());
    let wrong = [
        ("/rows/0/rmse", json!(1.5)),
        ("/rows/0/over1", json!(-0.1)),
        ("/rows/0/precision", json!("f16")),
        ("/rows/0/milliseconds/min", Value::Null),
        ("/rows/0/setting", json!("")),
        ("/scene_hash", json!("12")),
        ("/reference/sides", json!([17])),
        ("/front/0", json!(-1)),
        ("/machine/threads", json!(0)),
        ("/effects/0/milliseconds", json!(3.0)),
    ];
    for (place, value) in wrong {
        let mut json = good.clone();
        *json.pointer_mut(place).unwrap() = value;
        assert_eq!(problems(&json).len(), 1, "{place}: {:?}", problems(&json));
    }
    let mut json = good.clone();
    json.as_object_mut().unwrap().remove("machine");
    assert_eq!(problems(&json).len(), 1);
}

#[test]
fn a_drawing_needs_no_page() {
    let svg = draw_front(&sample_report());
    assert!(svg.starts_with("<svg") && svg.contains("xmlns=\"http://www.w3.org/2000/svg\""), "{svg}");
    assert!(svg.contains("assignment") && svg.contains("floor, 51.2 dB"), "{svg}");
    assert_eq!(svg.matches("<title>").count(), sample_report().rows.len());
    // No number was lost on the way, and no name is taken for markup.
    assert!(!svg.contains("NaN") && !svg.contains("inf") && svg.contains("&lt;&amp;&gt;"), "{svg}");
}

#[test]
fn drawings_of_little_or_nothing_have_no_holes() {
    let mut report = sample_report();
    report.reference.floor_psnr_db = f64::INFINITY;
    report.rows.truncate(1);
    report.rows[0].psnr_db = f64::INFINITY;
    report.rows[0].milliseconds = archetrace::study::Spread::default();
    report.front = vec![0];
    let one = draw_front(&report);
    report.rows.clear();
    let none = draw_front(&report);
    for svg in [one, none] {
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
    }
}

//! The `--stats` file.

use serde_json::Value;

use crate::program::{Folder, SCENE};

fn stats(folder: &Folder, arguments: &str) -> Value {
    folder.run(&format!("render scene.txt -o out.bmp --stats out.json {arguments}")).quiet();
    serde_json::from_slice(&folder.read("out.json")).unwrap()
}

fn keys(value: &Value) -> Vec<&str> {
    value.as_object().unwrap().keys().map(String::as_str).collect()
}

#[test]
fn every_key_is_there_with_its_type() {
    let stats = stats(&Folder::with_scene(), "--threads 2");
    let mut found = keys(&stats);
    found.sort_unstable();
    assert_eq!(
        found,
        [
            "effects",
            "level",
            "mean_samples",
            "non_finite",
            "phases_ms",
            "pixels",
            "precision",
            "rays",
            "rows",
            "samples",
            "setting",
            "threads",
            "version"
        ]
    );
    for phase in ["load", "choose", "extract", "build", "trace", "write"] {
        let time = stats["phases_ms"][phase].as_f64();
        assert!(time.is_some_and(|time| (0.0..20_000.0).contains(&time)), "{phase}: {stats}");
    }
    assert!(stats["phases_ms"]["trace"].as_f64() > Some(0.0));
    for kind in ["primary", "shadow", "mirror"] {
        assert!(stats["rays"][kind].as_u64() > Some(0), "{kind}: {stats}");
    }
    assert!(stats["rows"].as_object().unwrap().values().all(Value::is_u64), "{stats}");
    assert_eq!(stats["version"], env!("CARGO_PKG_VERSION"));
    assert_eq!(stats["threads"], 2);
    assert_eq!(stats["precision"], "f64");
    assert_eq!(stats["pixels"], 32 * 32);
    assert_eq!(stats["samples"], 1);
    assert_eq!(stats["mean_samples"], 1.0);
    assert_eq!(stats["level"], 3);
    assert_eq!(stats["non_finite"], 0);
}

#[test]
fn rows_are_counted_by_table() {
    let stats = stats(&Folder::with_scene(), "--texture");
    for (table, rows) in [
        ("spheres", 1),
        ("cubes", 1),
        ("pyramids", 1),
        ("checkerboards", 1),
        ("lights", 2),
        ("gloss", 1),
        ("mirror", 3),
        ("falloff", 1),
        ("spot_cone", 1),
        ("texture", 1),
    ] {
        assert_eq!(stats["rows"][table], rows, "{table}: {stats}");
    }
}

#[test]
fn effects_in_use_are_listed_and_no_others() {
    let folder = Folder::with_scene();
    assert_eq!(stats(&folder, "")["effects"], serde_json::json!(["gloss", "mirror", "falloff", "spot_cone"]));
    assert_eq!(
        stats(&folder, "--texture")["effects"],
        serde_json::json!(["gloss", "mirror", "texture", "falloff", "spot_cone"])
    );
    folder.put(
        "scene.txt",
        "1 1000 60 1 3 8  10 0.5 0.5 0  1 sphere 0 0 30 20 1 1 1 0.5 0.5 0 0 9  1 0 0 90 0  0",
    );
    assert_eq!(stats(&folder, "")["effects"], serde_json::json!([]));
}

#[test]
fn rays_are_counted() {
    let folder = Folder::with_scene();
    for size in [1, 7, 33] {
        let stats = stats(&folder, &format!("--size {size}"));
        assert_eq!(stats["pixels"], size * size);
        assert_eq!(stats["rays"]["primary"], stats["pixels"], "{stats}");
    }
    let sampled = stats(&folder, "--size 7 --samples 9");
    assert_eq!((&sampled["pixels"], &sampled["samples"]), (&49.into(), &9.into()));
    assert_eq!(sampled["rays"]["primary"], 9 * 49);
    let flat = stats(&folder, "--level 1");
    assert_eq!(flat["rays"]["mirror"], 0);
    assert_eq!(flat["level"], 1);
    let deeper = stats(&folder, "--level 2");
    assert!(deeper["rays"]["mirror"].as_u64() > Some(0));
    assert!(deeper["rays"]["shadow"].as_u64() > flat["rays"]["shadow"].as_u64());
}

#[test]
fn counts_do_not_depend_on_the_number_of_threads() {
    let folder = Folder::with_scene();
    let one = stats(&folder, "--threads 1");
    let three = stats(&folder, "--threads 3");
    assert_eq!(one["rays"], three["rays"]);
    assert_eq!(one["rows"], three["rows"]);
    assert_eq!((&one["threads"], &three["threads"]), (&1.into(), &3.into()));
}

#[test]
fn the_precision_is_told() {
    let folder = Folder::with_scene();
    assert_eq!(stats(&folder, "--precision f32")["precision"], "f32");
    assert_eq!(stats(&folder, "--precision f64")["precision"], "f64");
}

#[test]
fn statistics_change_no_picture() {
    let folder = Folder::with_scene();
    stats(&folder, "");
    assert_eq!(folder.read("out.bmp"), folder.render(""));
    assert_eq!(folder.read("scene.txt"), SCENE.as_bytes());
}

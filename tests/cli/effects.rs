//! `archetrace effects`, and what can be done to effects when rendering.

use std::collections::BTreeMap;

use archetrace::cli::effects_report;
use archetrace::components::{CameraPose, Fog, Lens, Mirror, Position, Snapshot, Sphere};
use archetrace::effects::Effect;
use archetrace::systems::{Workers, prepare};
use bevy_ecs::prelude::World;
use glam::DVec3;
use serde_json::Value;

use crate::program::{Folder, SCENE};

/// A scene with spheres on a board under a plain light: no effect at all.
const PLAIN: &str = "\
1 1000  60 1
3
32
10  0.4 0.6 0
2
sphere   10  20 15  12     1 0.4 0.2    0.4 0.6 0 0  0
sphere  -10  20 15   5     0.3 0.4 1    0.4 0.6 0 0  0
1
60 -70 100  0
0
";

fn report(folder: &Folder, arguments: &str) -> Vec<Value> {
    let text = folder.run(&format!("effects scene.txt --json --rounds 1 {arguments}")).quiet();
    serde_json::from_str::<Value>(&text).unwrap().as_array().unwrap().clone()
}

fn by_name(report: &[Value]) -> BTreeMap<&str, &Value> {
    report.iter().map(|row| (row["effect"].as_str().unwrap(), row)).collect()
}

fn rays(folder: &Folder, arguments: &str) -> i64 {
    folder.run(&format!("render scene.txt -o out.bmp --stats out.json {arguments}")).quiet();
    let stats: Value = serde_json::from_slice(&folder.read("out.json")).unwrap();
    stats["rays"].as_object().unwrap().values().map(|rays| rays.as_i64().unwrap()).sum()
}

#[test]
fn every_effect_is_listed_once_in_the_same_order() {
    let report = report(&Folder::with_scene(), "");
    let names: Vec<&str> = report.iter().map(|row| row["effect"].as_str().unwrap()).collect();
    assert_eq!(names, Effect::ALL.map(Effect::name));
}

#[test]
fn what_is_present_is_said_with_who_asked_and_what_it_adds() {
    let folder = Folder::with_scene();
    let report = report(&folder, "");
    let effects = by_name(&report);
    for (effect, entities) in [("gloss", 1), ("mirror", 3), ("falloff", 1), ("spot_cone", 1)] {
        let row = effects[effect];
        assert_eq!((&row["present"], &row["entities"]), (&true.into(), &entities.into()), "{effect}");
        assert_eq!(row["rows"], entities, "{effect}");
        assert!(row["bytes"].as_u64() > Some(0), "{effect}");
        assert!(row["systems"].as_u64() > Some(0), "{effect}");
        assert!(row["without"]["rmse"].as_f64() > Some(0.0), "{effect}: {row}");
        assert_eq!(row["carriers"].as_array().unwrap().len(), entities, "{effect}");
        let without = rays(&folder, &format!("--without {effect}"));
        assert_eq!(row["rays"], rays(&folder, "") - without, "{effect}");
    }
    assert!(effects["mirror"]["rays"].as_i64() > Some(0));
    assert_eq!(effects["gloss"]["rays"], 0);
    assert!(effects["spot_cone"]["rays"].as_i64() < Some(0), "a cone saves shadow rays");
}

#[test]
fn what_is_absent_has_nothing_anywhere() {
    let folder = Folder::with_scene();
    folder.put("scene.txt", PLAIN);
    for row in report(&folder, "") {
        assert_eq!(row["present"], false, "{row}");
        for count in ["entities", "rays", "rows", "bytes", "systems"] {
            assert_eq!(row[count], 0, "{count}: {row}");
        }
        for tried in ["milliseconds", "instructions", "without"] {
            assert_eq!(row[tried], Value::Null, "{tried}: {row}");
        }
    }
}

#[test]
fn in_words_absent_effects_come_with_their_counts() {
    let folder = Folder::with_scene();
    folder.put("scene.txt", PLAIN);
    let text = folder.run("effects scene.txt --rounds 1").quiet();
    assert!(text.starts_with("frame "), "{text}");
    for effect in Effect::ALL {
        let name = effect.name().replace('_', " ");
        let line = text.lines().find(|line| line.trim_start().starts_with(&name)).unwrap();
        assert_eq!(line.split_whitespace().filter(|word| *word == "0").count(), 5, "{line}");
    }
}

#[test]
fn a_texture_is_an_effect_too() {
    let folder = Folder::with_scene();
    let plain = report(&folder, "");
    assert_eq!(by_name(&plain)["texture"]["present"], false);
    let textured = report(&folder, "--texture");
    assert_eq!(by_name(&textured)["texture"]["rows"], 1);
}

#[test]
fn the_bars_are_drawn() {
    let folder = Folder::with_scene();
    folder.run("effects scene.txt --rounds 2 --chart bars.svg").quiet();
    let svg = String::from_utf8(folder.read("bars.svg")).unwrap();
    assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"), "{svg}");
    for name in ["gloss", "mirror", "falloff", "spot cone", "milliseconds"] {
        assert!(svg.contains(name), "{name}: {svg}");
    }
    assert!(!svg.contains("texture"), "absent: {svg}");
}

#[test]
fn without_an_effect_is_as_if_nobody_had_asked() {
    let folder = Folder::with_scene();
    folder.run("render scene.txt -o without.bmp --without mirror --without falloff").quiet();
    let same = SCENE
        .replace("0.2 0.5 0.3\n", "0.2 0.5 0\n")
        .replace("0.2 0.4 0.3 0.1  20", "0.2 0.4 0.3 0  20")
        .replace("0.2 0.6 0 0.2  1", "0.2 0.6 0 0  1")
        .replace("0.00001", "0");
    folder.put("same.txt", &same);
    let code = folder.run("render same.txt -o same.bmp").code;
    assert_eq!(code, Some(0));
    assert!(folder.read("without.bmp") == folder.read("same.bmp"));
    folder.run("render scene.txt -o with.bmp").quiet();
    assert!(folder.read("without.bmp") != folder.read("with.bmp"));
}

#[test]
fn an_unknown_effect_is_refused_with_the_known_ones() {
    let run = Folder::with_scene().run("render scene.txt -o out.bmp --without shine");
    assert_eq!(run.code, Some(2));
    assert!(run.stderr.contains("gloss") && run.stderr.contains("spot_cone"), "{}", run.stderr);
}

#[test]
fn the_kernel_with_every_effect_writes_the_same_bytes() {
    let folder = Folder::with_scene();
    let scenes = std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/scenes")).unwrap();
    let mut tried = 0;
    for scene in scenes.map(|entry| entry.unwrap().path()) {
        if scene.extension().is_none_or(|extension| extension != "txt") {
            continue;
        }
        let scene = scene.to_str().unwrap();
        for precision in ["f64", "f32"] {
            let render = |output: &str, flag: &str| {
                let precision = format!("--precision={precision}");
                let words = ["render", scene, "-o", output, "--size", "48", &precision];
                let run = folder.run_list(
                    &words.into_iter().chain((!flag.is_empty()).then_some(flag)).collect::<Vec<_>>(),
                );
                assert_eq!(run.code, Some(0), "{scene}: {run:?}");
                folder.read(output)
            };
            assert!(render("a.bmp", "") == render("b.bmp", "--all-effects"), "{scene}, {precision}");
        }
        tried += 1;
    }
    assert!(tried >= 15, "{tried} scenes");
}

#[test]
fn a_world_built_in_code_is_reported_on_as_well() {
    let mut world = World::new();
    world.spawn((CameraPose::default(), Lens { near: 1.0, far: 1000.0, fovy: 60.0, aspect: 1.0 }));
    world.spawn((Sphere { radius: 20.0 }, Position::new(0.0, 0.0, 50.0), Mirror(0.5)));
    world.spawn(Fog { density: 0.01, color: DVec3::ONE });
    world.insert_resource(Snapshot { pixels: 16, level: 3 });
    prepare::<f32>(&mut world, Workers::new(None).unwrap());
    let report = effects_report::<f32>(&mut world, 1).unwrap();
    assert!(report.contains("\nfog\n  asked for by  entity\n"), "{report}");
    assert!(report.contains("\nmirror\n  asked for by  sphere at 0 0 50\n"), "{report}");
    world.spawn(Fog { density: 0.01, color: DVec3::ONE });
    assert!(effects_report::<f32>(&mut world, 1).is_err(), "there are two");
}

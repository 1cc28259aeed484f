//! The scenes of this repository: the good ones are clean, the bad ones fail exactly as written down.

use std::fs;
use std::path::{Path, PathBuf};

use archetrace::scene::Source;
use assert_cmd::Command;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Files of a folder of the repository with this ending, by their path from the root.
fn files(folder: &str, ending: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(root().join(folder)).unwrap();
    let names = entries.map(|entry| Path::new(folder).join(entry.unwrap().file_name()));
    let mut files: Vec<PathBuf> =
        names.filter(|path| path.extension().is_some_and(|found| found == ending)).collect();
    files.sort();
    files
}

fn check(scene: &Path) -> std::process::Output {
    Command::new(env!("CARGO_BIN_EXE_archetrace"))
        .current_dir(root())
        .arg("check")
        .arg(scene)
        .output()
        .unwrap()
}

/// Scenes that show what a warning is about, with the number of their warnings.
const WARNED: [(&str, usize); 1] = [("scenes/unbalanced.txt", 3)];

#[test]
fn every_scene_is_read_without_a_warning() {
    let scenes = files("scenes", "txt");
    assert!(scenes.len() > 10, "only {scenes:?}");
    assert!(scenes.contains(&PathBuf::from("scenes/official.txt")));
    for scene in scenes.iter().filter(|scene| warnings_of(scene) == 0) {
        let loaded = Source::read(&root().join(scene)).unwrap().load();
        let loaded = loaded.unwrap_or_else(|error| panic!("{error}"));
        assert!(loaded.warnings.is_empty(), "{}", loaded.warnings.join("\n"));
        let output = check(scene);
        let said = String::from_utf8(output.stdout).unwrap();
        assert_eq!(output.status.code(), Some(0), "{}", scene.display());
        assert_eq!(String::from_utf8_lossy(&output.stderr), "", "{}", scene.display());
        assert!(said.starts_with(&format!("{}: ok\n", scene.display())), "{said}");
    }
}

fn warnings_of(scene: &Path) -> usize {
    let warned = WARNED.iter().find(|(path, _)| Path::new(path) == scene);
    warned.map_or(0, |&(_, count)| count)
}

#[test]
fn a_scene_about_warnings_is_read_with_exactly_those() {
    for (scene, count) in WARNED {
        let output = check(Path::new(scene));
        let said = String::from_utf8(output.stdout).unwrap();
        let warned = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(0), "{scene}");
        assert_eq!(warned.matches("warning: ").count(), count, "{warned}");
        assert_eq!(warned.matches(&format!("{scene}:")).count(), count, "{warned}");
        assert!(said.starts_with(&format!("{scene}: ok, {count} warnings\n")), "{said}");
    }
}

#[test]
fn every_bad_scene_gives_exactly_the_error_beside_it() {
    let scenes = files("scenes/bad", "txt");
    assert!(scenes.len() >= 20, "only {} bad scenes", scenes.len());
    for scene in &scenes {
        let expected = fs::read_to_string(root().join(scene.with_extension("err")))
            .unwrap_or_else(|error| panic!("no .err beside {}: {error}", scene.display()));
        let output = check(scene);
        assert_eq!(String::from_utf8_lossy(&output.stderr), expected, "{}", scene.display());
        assert_eq!(output.status.code(), Some(1), "{}", scene.display());
        assert!(output.stdout.is_empty(), "{}", scene.display());
        let place = format!("{}:", scene.display());
        assert!(expected.contains(&place), "{} names no place", scene.display());
    }
    for error in files("scenes/bad", "err") {
        assert!(scenes.contains(&error.with_extension("txt")), "no scene beside {}", error.display());
    }
}

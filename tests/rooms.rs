//! The house keeps its walls: which room may name which crate, which other room, the file system, a clock, a tolerance.
//!
//! [`ROOMS`] is the table. The sources are read as text, so a name that does not compile is found as well.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that cannot go on should say so and stop")]

#[path = "rooms/rust_text.rs"]
mod rust_text;
#[path = "rooms/scanner.rs"]
mod scanner;

use std::fs;
use std::path::{Path, PathBuf};

use rust_text::{Kind, Token, code_only, paths, tokens};

/// A room: a folder or a file, and everything from outside that may be named in it.
struct Room {
    place: &'static str,
    /// Outside crates, each with the files that may name it.
    crates: &'static [(&'static str, Files)],
    /// Other rooms of this crate, by module name.
    rooms: &'static [&'static str],
    /// What else is not for everyone, each with the files that may have it.
    may: &'static [(Right, Files)],
}

/// Files of a room.
#[derive(Clone, Copy)]
enum Files {
    All,
    Only(&'static [&'static str]),
}

use Files::{All, Only};

/// What is kept in few places although no crate is needed for it.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Right {
    /// `std::fs` and `std::path`.
    FileSystem,
    /// `std::time`.
    Clock,
    /// Positive numbers up to 0.001, and `EPSILON`.
    Tolerance,
}

use Right::{Clock, FileSystem, Tolerance};

const ROOMS: &[Room] = &[
    Room { place: "src/lib.rs", crates: &[], rooms: &[], may: &[] },
    Room { place: "src/main.rs", crates: &[], rooms: &["cli"], may: &[] },
    Room {
        place: "src/components",
        crates: &[("bevy_ecs", All), ("glam", All)],
        rooms: &["geometry"],
        may: &[(Tolerance, Only(&["range.rs"]))],
    },
    Room {
        place: "src/geometry",
        crates: &[("glam", All), ("libm", Only(&["basis.rs", "unit.rs"]))],
        rooms: &[],
        may: &[(Tolerance, All)],
    },
    Room {
        place: "src/effects",
        crates: &[("glam", All), ("libm", Only(&["disk.rs", "spot_cone.rs", "srgb.rs", "mip_chain.rs"]))],
        rooms: &["components", "geometry"],
        may: &[],
    },
    Room {
        place: "src/scene",
        crates: &[
            ("glam", All),
            ("thiserror", All),
            ("codespan_reporting", Only(&["problem.rs"])),
            ("unicode_width", Only(&["problem.rs"])),
            ("bevy_ecs", Only(&["spawn.rs"])),
            ("rayon", Only(&["ahead.rs"])),
        ],
        rooms: &["components"],
        may: &[(FileSystem, Only(&["source.rs"])), (Tolerance, All)],
    },
    Room {
        place: "src/trace",
        crates: &[("libm", Only(&["camera.rs", "camera_effects.rs"]))],
        rooms: &["components", "effects", "geometry", "film"],
        may: &[],
    },
    Room {
        place: "src/selfcheck",
        crates: &[("glam", All), ("libm", Only(&["random.rs"]))],
        rooms: &["components", "effects", "film", "geometry", "trace"],
        may: &[(Tolerance, All)],
    },
    Room { place: "src/film.rs", crates: &[("rayon", All)], rooms: &["effects", "large_pages"], may: &[] },
    Room { place: "src/large_pages.rs", crates: &[("rustix", All)], rooms: &[], may: &[] },
    Room {
        place: "src/image_file.rs",
        crates: &[("image", All), ("thiserror", All)],
        rooms: &["components", "film", "whole_file"],
        may: &[(FileSystem, All)],
    },
    Room {
        place: "src/whole_file.rs",
        crates: &[("tempfile", All), ("thiserror", All)],
        rooms: &[],
        may: &[(FileSystem, All)],
    },
    Room {
        place: "systems",
        crates: &[("bevy_ecs", All), ("glam", All), ("rayon", All), ("thiserror", All)],
        rooms: &["components", "effects", "geometry", "trace", "film", "preview"],
        may: &[],
    },
    Room {
        place: "src/study",
        crates: &[
            ("bevy_ecs", All),
            ("glam", Only(&["tests.rs"])),
            ("plotters", Only(&["bars.rs"])),
            ("colorous", Only(&["heat.rs"])),
            ("csv", Only(&["table.rs"])),
            ("maud", Only(&["mod.rs", "pictures.rs", "plot.rs", "prices.rs", "rows.rs", "words.rs"])),
            ("base64", Only(&["pictures.rs"])),
            ("serde", All),
            ("serde_json", Only(&["table.rs"])),
        ],
        rooms: &["components", "effects", "film", "geometry", "selfcheck", "systems", "trace"],
        may: &[(Tolerance, Only(&["care.rs", "cells.rs", "chooser.rs"]))],
    },
    Room {
        place: "src/cli",
        crates: &[
            ("bevy_ecs", All),
            ("glam", All),
            ("thiserror", All),
            ("clap", All),
            ("csv", Only(&["mod.rs"])),
            ("indicatif", All),
            ("ctrlc", All),
            ("serde", All),
            ("serde_json", All),
            ("tempfile", Only(&["instructions.rs"])),
        ],
        rooms: &[
            "components",
            "effects",
            "film",
            "geometry",
            "image_file",
            "preview",
            "scene",
            "selfcheck",
            "study",
            "systems",
            "trace",
            "viewer",
            "whole_file",
        ],
        may: &[(FileSystem, All), (Clock, All), (Tolerance, All)],
    },
    // A room within the next one: what it has leads nowhere else.
    Room {
        place: "src/preview/gl",
        crates: &[("glow", All), ("glam", All), ("thiserror", All)],
        rooms: &["components", "preview"],
        may: &[(Tolerance, All)],
    },
    Room {
        place: "src/preview",
        crates: &[("glam", All)],
        rooms: &["components", "geometry"],
        may: &[(Tolerance, All)],
    },
    Room {
        place: "src/viewer",
        crates: &[
            ("winit", Only(&["app.rs", "context.rs", "event.rs", "keys.rs", "screen.rs", "tests.rs"])),
            ("glutin", Only(&["context.rs", "headless.rs"])),
            ("glutin_winit", Only(&["context.rs"])),
            ("raw_window_handle", Only(&["context.rs"])),
            ("egui", All),
            ("egui_winit", Only(&["screen.rs"])),
            ("egui_glow", Only(&["screen.rs"])),
            ("notify", Only(&["watch.rs"])),
            ("serde", Only(&["report.rs"])),
            ("serde_json", Only(&["report.rs"])),
            ("tempfile", Only(&["tests.rs", "watch.rs"])),
            ("bevy_ecs", All),
            ("glam", All),
            ("thiserror", All),
        ],
        rooms: &[
            "components",
            "effects",
            "film",
            "geometry",
            "image_file",
            "preview",
            "scene",
            "study",
            "systems",
            "trace",
            "whole_file",
        ],
        may: &[(FileSystem, All), (Clock, All), (Tolerance, All)],
    },
];

/// Crates of the window. Scenes in code do without them, whatever else they use.
const WINDOW_CRATES: [&str; 8] =
    ["glow", "glutin", "glutin_winit", "raw_window_handle", "winit", "egui", "egui_winit", "egui_glow"];

impl Files {
    fn has(self, name: &str) -> bool {
        match self {
            All => true,
            Only(names) => names.contains(&name),
        }
    }

    fn words(self) -> String {
        match self {
            All => String::new(),
            Only(names) => format!(" (in {} only)", names.join(", ")),
        }
    }
}

impl Room {
    fn holds(&self, file: &str) -> bool {
        file == self.place || file.strip_prefix(self.place).is_some_and(|rest| rest.starts_with('/'))
    }

    /// The name that the rest of the crate knows the room by.
    fn module(&self) -> &'static str {
        self.place.trim_start_matches("src/").trim_end_matches(".rs")
    }

    fn may(&self, right: Right, name: &str) -> bool {
        self.may.iter().any(|&(granted, files)| granted == right && files.has(name))
    }

    fn allowed_crates(&self) -> String {
        let named = self.crates.iter().map(|(name, files)| format!("{name}{}", files.words()));
        or_nothing(named.collect::<Vec<_>>().join(", "))
    }
}

fn or_nothing(list: String) -> String {
    if list.is_empty() { "none".into() } else { list }
}

/// What is wrong with one file: `file:line: what, and what is allowed`.
fn judge(file: &str, text: &str, known_crates: &[String]) -> Vec<String> {
    let Some(room) = ROOMS.iter().find(|room| room.holds(file)) else {
        return vec![format!("{file}:1: belongs to no room of the table in tests/rooms.rs")];
    };
    let name = file.rsplit('/').next().unwrap();
    let code = code_only(text);
    let tokens = tokens(&code);
    let mut findings = Vec::new();
    for (line, path) in paths(&tokens) {
        let first = path[0].as_str();
        if known_crates.iter().any(|known| known == first) && !allows(room, first, name) {
            findings.push(format!(
                "{file}:{line}: names the crate {first}; {} may name: {}",
                room.place,
                room.allowed_crates()
            ));
        }
        if let Some(other) = other_room(file, &path)
            && other != room.module()
            && !room.rooms.contains(&other.as_str())
        {
            findings.push(format!(
                "{file}:{line}: names crate::{other}; of the other rooms {} may name: {}",
                room.place,
                or_nothing(room.rooms.join(", "))
            ));
        }
        if let Some(right) = needs(&path)
            && !room.may(right, name)
        {
            findings.push(format!(
                "{file}:{line}: names {}; {} has no right to {right:?} here",
                path.join("::"),
                room.place
            ));
        }
    }
    if !room.may(Tolerance, name) {
        findings.extend(tolerances(&tokens).into_iter().map(|(line, text)| {
            format!("{file}:{line}: {text} looks like a tolerance; {} has none", room.place)
        }));
    }
    findings
}

fn allows(room: &Room, krate: &str, file_name: &str) -> bool {
    room.crates.iter().any(|&(allowed, files)| allowed == krate && files.has(file_name))
}

/// The room that a path inside the crate leads to, if it leaves the file's own module.
fn other_room(file: &str, path: &[String]) -> Option<String> {
    let mut module: Vec<&str> = file
        .trim_start_matches("src/")
        .trim_end_matches(".rs")
        .trim_end_matches("/mod")
        .split('/')
        .filter(|part| !matches!(*part, "lib" | "main"))
        .collect();
    let mut rest = path;
    match rest[0].as_str() {
        "crate" | "archetrace" => module.clear(),
        "super" => {
            while rest.first().is_some_and(|part| part == "super") {
                module.pop();
                rest = &rest[1..];
            }
            let room = module.first().map(ToString::to_string);
            return room.or_else(|| rest.first().cloned()).filter(|name| is_room(name));
        }
        _ => return None,
    }
    // `use crate::*` names every room at once.
    rest.get(1).filter(|name| is_room(name) || *name == "*").cloned()
}

fn is_room(name: &str) -> bool {
    ROOMS.iter().any(|room| room.module() == name)
}

fn needs(path: &[String]) -> Option<Right> {
    match (path[0].as_str(), path.get(1)?.as_str()) {
        ("std", "fs" | "path") => Some(FileSystem),
        ("std", "time") => Some(Clock),
        _ => None,
    }
}

fn tolerances(tokens: &[Token<'_>]) -> Vec<(usize, String)> {
    let suspicious = |token: &&Token<'_>| match token.kind {
        Kind::Number => value(token.text).is_some_and(|value| value > 0.0 && value <= 1e-3),
        Kind::Word => token.text.to_ascii_uppercase().contains("EPSILON"),
        Kind::Sign => false,
    };
    let found = tokens.iter().filter(suspicious);
    found.map(|token| (token.line, token.text.to_owned())).collect()
}

/// The value of a decimal literal.
fn value(literal: &str) -> Option<f64> {
    let plain = literal.replace('_', "");
    let plain = plain.trim_end_matches("f64").trim_end_matches("f32");
    plain.parse().ok()
}

/// The crates that a Cargo.toml depends on, as code names them.
fn dependencies(manifest: &str, is_section: impl Fn(&str) -> bool) -> Vec<String> {
    let mut names = Vec::new();
    let mut inside = false;
    for line in manifest.lines().map(str::trim) {
        if let Some(section) = line.strip_prefix('[').and_then(|line| line.split(']').next()) {
            inside = is_section(section);
            // [dependencies.name]
            if let Some((table, name)) = section.rsplit_once('.')
                && is_section(table)
            {
                names.push(name.to_owned());
            }
        } else if let Some((name, _)) = line.split_once('=')
            && inside
            && !line.starts_with('#')
        {
            let name = name.split('.').next().unwrap();
            names.push(name.trim().trim_matches('"').to_owned());
        }
    }
    names.into_iter().map(|name| name.replace('-', "_")).collect()
}

fn is_dependency_section(section: &str) -> bool {
    section == "dependencies" || (section.starts_with("target.") && section.ends_with(".dependencies"))
}

fn is_any_dependency_section(section: &str) -> bool {
    section.ends_with("dependencies")
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn manifest() -> String {
    fs::read_to_string(root().join("Cargo.toml")).unwrap()
}

/// Every Rust file below a folder of the repository, by its path from there.
fn rust_files(folder: &str) -> Vec<String> {
    let mut files = Vec::new();
    let mut folders = vec![PathBuf::from(folder)];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(root().join(&folder)).unwrap() {
            let entry = entry.unwrap();
            let path = folder.join(entry.file_name());
            if entry.file_type().unwrap().is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|ending| ending == "rs") {
                files.push(path.to_str().unwrap().to_owned());
            }
        }
    }
    files.sort();
    files
}

fn read(file: &str) -> String {
    fs::read_to_string(root().join(file)).unwrap()
}

/// Every crate that anything in the table or in Cargo.toml is about.
fn known_crates() -> Vec<String> {
    let in_table = ROOMS.iter().flat_map(|room| room.crates).map(|(name, _)| (*name).to_owned());
    let mut known = dependencies(&manifest(), is_any_dependency_section);
    known.extend(in_table);
    known.sort();
    known.dedup();
    known
}

#[test]
fn every_room_names_only_what_it_may() {
    let known = known_crates();
    let files: Vec<String> = ["src", "systems"].into_iter().flat_map(rust_files).collect();
    assert!(files.len() > 40, "only {} files were found", files.len());
    let findings: Vec<String> = files.iter().flat_map(|file| judge(file, &read(file), &known)).collect();
    assert!(findings.is_empty(), "\n{}", findings.join("\n"));
}

#[test]
fn scenes_in_code_name_no_window() {
    let files = rust_files("scenes");
    assert!(!files.is_empty());
    for file in files {
        let code = code_only(&read(&file));
        for (line, path) in paths(&tokens(&code)) {
            assert!(!WINDOW_CRATES.contains(&path[0].as_str()), "{file}:{line}: names {}", path.join("::"));
        }
    }
}

#[test]
fn every_dependency_has_a_room() {
    let dependencies = dependencies(&manifest(), is_dependency_section);
    assert!(dependencies.len() > 10, "found only {dependencies:?}");
    for name in dependencies {
        let is_at_home = |room: &Room| room.crates.iter().any(|(known, _)| *known == name);
        assert!(
            ROOMS.iter().any(is_at_home),
            "Cargo.toml: the dependency {name} has no room in the table of tests/rooms.rs"
        );
    }
}

#[test]
fn every_crate_of_the_table_is_a_dependency_or_of_the_window() {
    let dependencies = dependencies(&manifest(), is_dependency_section);
    for (name, _) in ROOMS.iter().flat_map(|room| room.crates) {
        assert!(
            dependencies.iter().any(|known| known == name) || WINDOW_CRATES.contains(name),
            "tests/rooms.rs gives a room to {name}, which Cargo.toml does not have"
        );
    }
}

#[test]
fn every_room_of_the_library_is_in_the_table() {
    let code = code_only(&read("src/lib.rs"));
    let tokens = tokens(&code);
    let modules: Vec<&str> = tokens
        .windows(3)
        .filter(|window| window[0].text == "mod" && window[2].text == ";")
        .map(|window| window[1].text)
        .collect();
    assert!(modules.contains(&"systems"), "{modules:?}");
    for module in modules {
        assert!(is_room(module), "src/lib.rs: mod {module} has no room");
    }
}

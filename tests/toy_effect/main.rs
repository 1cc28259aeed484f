//! README's "Adding an effect", done as it says: its code is put into a copy of the sources, which is compiled, and a program
//! (`rim.rs`, beside this file) tests what comes of it.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A step of the walk-through.
struct Step {
    /// The file that it names.
    path: String,
    code: String,
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The code blocks, each with the path that the text before it names last.
fn steps(readme: &str) -> Vec<Step> {
    let (_, rest) = readme.split_once("<!-- walk-through -->").unwrap();
    let (text, _) = rest.split_once("<!-- end of walk-through -->").unwrap();
    let mut steps = Vec::new();
    let mut path = String::new();
    for (number, part) in text.split("```").enumerate() {
        match part.strip_prefix("rust\n") {
            Some(code) if number % 2 == 1 => steps.push(Step { path: path.clone(), code: code.to_owned() }),
            _ => {
                let mut quoted = part.split('`').skip(1).step_by(2);
                path = quoted.find(|word| word.starts_with("src/")).unwrap_or_default().to_owned();
            }
        }
    }
    steps
}

/// Copies a folder.
fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap() {
        let entry = entry.unwrap();
        let place = to.join(entry.file_name());
        if entry.file_type().unwrap().is_dir() {
            copy(&entry.path(), &place);
        } else {
            fs::copy(entry.path(), place).unwrap();
        }
    }
}

/// Puts text after the first line of a file that contains a mark.
fn insert_after(file: &Path, mark: &str, text: &str) {
    let before = fs::read_to_string(file).unwrap();
    let at = before.find(mark).unwrap_or_else(|| panic!("{} has no `{mark}`", file.display()));
    let end = at + before[at..].find('\n').unwrap() + 1;
    fs::write(file, format!("{}{text}{}", &before[..end], &before[end..])).unwrap();
}

/// The sources as they would be with the effect.
fn with_the_effect(place: &Path) -> PathBuf {
    let tree = place.join("tree");
    if tree.exists() {
        fs::remove_dir_all(&tree).unwrap();
    }
    for folder in ["src", "systems", "scenes", "benches", "tests"] {
        copy(&root().join(folder), &tree.join(folder));
    }
    for file in ["Cargo.toml", "Cargo.lock", "README.md"] {
        fs::copy(root().join(file), tree.join(file)).unwrap();
    }

    let steps = steps(&fs::read_to_string(root().join("README.md")).unwrap());
    let [component, effect, survey, shade] = steps.as_slice() else { panic!("not four steps") };
    for (step, named, row) in [(component, "Rim", "components"), (effect, "RimRow", "effects")] {
        assert_eq!(step.path, format!("src/{row}/rim.rs"));
        fs::write(tree.join(&step.path), &step.code).unwrap();
        let list = tree.join("src").join(row).join("mod.rs");
        let all = fs::read_to_string(&list).unwrap();
        fs::write(&list, format!("{all}\nmod rim;\npub use rim::{named};\n")).unwrap();
    }
    assert_eq!([&survey.path, &shade.path], ["src/effects/survey.rs", "src/trace/radiance.rs"]);
    insert_after(&tree.join(&survey.path), "surfaces {\n", &survey.code);
    insert_after(&tree.join(&shade.path), "lighting.shade(", &shade.code);

    let programs = tree.join("src/bin");
    fs::create_dir(&programs).unwrap();
    fs::copy(root().join("tests/toy_effect/rim.rs"), programs.join("rim.rs")).unwrap();
    tree
}

#[test]
fn an_effect_is_added_as_readme_says() {
    let place = Path::new(env!("CARGO_TARGET_TMPDIR")).join("toy_effect");
    let tree = with_the_effect(&place);
    let mut cargo = Command::new(env!("CARGO"));
    // The crates that it needs are there; a few numbers are soon computed without much optimisation.
    let package = "profile.dev.package.archetrace";
    cargo
        .current_dir(tree)
        .args(["run", "--quiet", "--offline", "--locked", "--no-default-features", "--bin", "rim"])
        .args(["--config", &format!("{package}.opt-level=0"), "--config", &format!("{package}.debug=false")])
        .arg("--target-dir")
        .arg(place.join("target"))
        .env_remove("ARCHETRACE_WITHOUT");
    let output = cargo.output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

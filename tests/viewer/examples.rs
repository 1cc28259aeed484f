//! Scenes in code open in the same window.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::program::{Folder, PROGRAM};
use crate::window::{Window, without_surroundings};

/// An example, which cargo builds for `cargo test`; for `cargo test --test viewer` alone only on request.
fn example(name: &str) -> PathBuf {
    let path = Path::new(PROGRAM).with_file_name("examples").join(name);
    assert!(path.exists(), "{} is not there: cargo build --examples", path.display());
    path
}

fn command(folder: &Folder, name: &str) -> Command {
    without_surroundings(folder, &example(name))
}

/// Opens an example; it is told to tell nothing.
#[track_caller]
fn open(folder: &Folder, name: &str) -> Window {
    Window::silent(&mut command(folder, name))
}

#[test]
fn a_scene_in_code_is_traced_by_key_to_what_it_writes_by_itself() {
    let folder = Folder::empty();
    assert!(command(&folder, "still_life").arg("alone.bmp").status().unwrap().success());
    let mut window = open(&folder, "still_life");
    window.key("0");
    let path = window.words("wrote ");
    assert!(folder.read(&path) == folder.read("alone.bmp"));
    // There is no file to read again.
    window.key("Insert 1 Home 0");
    let again = window.words("wrote ");
    assert!(folder.read(&again) == folder.read("alone.bmp"), "home is where its own camera stood");
    window.close();
}

#[test]
fn systems_of_a_scene_move_it_while_it_is_looked_at() {
    let folder = Folder::empty();
    let window = open(&folder, "orbit");
    let (_, _, first) = window.display.pixels(window.id);
    window.shows("something that moves", |_, _, pixels| pixels != first);
    let (_, _, second) = window.display.pixels(window.id);
    window.shows("that it goes on", |_, _, pixels| pixels != first && pixels != second);
    window.close();
    assert!(folder.names().is_empty());
}

#[test]
fn a_thousand_spheres_open_as_well() {
    let folder = Folder::empty();
    let window = open(&folder, "thousand_spheres");
    window.shows("many colours", |_, _, pixels| {
        pixels.chunks(3).collect::<std::collections::BTreeSet<_>>().len() > 100
    });
    window.close();
}

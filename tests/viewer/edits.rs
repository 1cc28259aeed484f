//! Edits by key: what is deleted or duplicated, taken back, and saved. The opened file stays as it is.

use crate::lines::START;
use crate::mouse::{SKY, at, select};
use crate::picture::Picture;
use crate::program::Folder;
use crate::scenes::folder;
use crate::window::Window;

/// Words of a scene, which is what it says.
pub(crate) fn words(text: &str) -> Vec<String> {
    let lines = text.lines().map(|line| line.split('#').next().unwrap());
    lines.flat_map(str::split_whitespace).map(str::to_owned).collect()
}

fn read(folder: &Folder, file: &str) -> String {
    String::from_utf8(folder.read(file)).unwrap()
}

/// Presses F2; the file that was written, which is a scene.
#[track_caller]
fn save(window: &mut Window, folder: &Folder) -> String {
    window.key("F2");
    let path = window.event("saved")["path"].as_str().unwrap().to_owned();
    folder.run_list(&["check", &path]).quiet();
    path
}

#[track_caller]
fn edit(window: &mut Window, key: &str, event: &str, what: &str) {
    window.key(key);
    assert_eq!(window.event(event)["what"], what, "{key}");
}

/// The window shows what `archetrace preview` draws of a scene.
#[track_caller]
fn shows_scene(window: &Window, folder: &Folder, scene: &str) {
    folder.run(&format!("preview {scene} -o preview.png --lights --axes")).quiet();
    let picture = Picture::read(&folder.read("preview.png")).rgb;
    window.shows(&format!("what is in {scene}"), |_, _, pixels| pixels == picture);
}

#[test]
fn an_unedited_scene_is_saved_as_what_it_is() {
    let folder = folder(200);
    let opened = folder.read("scene.txt");
    let mut window = Window::open(&folder, "scene.txt");
    assert_eq!(save(&mut window, &folder), "scene-edited.txt");
    assert_eq!(save(&mut window, &folder), "scene-edited-2.txt");
    window.close();
    let picture = folder.render("");
    for saved in ["scene-edited.txt", "scene-edited-2.txt"] {
        folder.run(&format!("render {saved} -o again.bmp")).quiet();
        assert!(folder.read("again.bmp") == picture, "{saved}");
        assert!(folder.read(saved) == folder.run("write scene.txt").quiet().into_bytes());
    }
    assert!(folder.read("scene.txt") == opened);
}

#[test]
fn what_is_deleted_is_gone_and_comes_back() {
    let folder = folder(200);
    let opened = folder.read("scene.txt");
    let mut window = Window::open(&folder, "scene.txt");
    // Nothing is selected, nothing done: nothing to delete or to take back.
    window.key("Delete ctrl+d ctrl+z ctrl+y ctrl+shift+z");

    select(&mut window, at("sphere"));
    edit(&mut window, "Delete", "edited", "delete");
    let without = save(&mut window, &folder);
    select(&mut window, SKY);
    shows_scene(&window, &folder, &without);
    assert!(!words(&read(&folder, &without)).contains(&"sphere".to_owned()));
    assert_ne!(select(&mut window, at("sphere")), "sphere 1");

    edit(&mut window, "ctrl+z", "undone", "delete");
    edit(&mut window, "ctrl+y", "redone", "delete");
    edit(&mut window, "ctrl+z", "undone", "delete");
    edit(&mut window, "ctrl+shift+z", "redone", "delete");
    edit(&mut window, "ctrl+z", "undone", "delete");
    let back = save(&mut window, &folder);
    select(&mut window, SKY);
    shows_scene(&window, &folder, "scene.txt");
    assert_eq!(window.pose, START, "edits leave the camera where it is");
    window.close();

    assert_eq!([without.as_str(), back.as_str()], ["scene-edited.txt", "scene-edited-2.txt"]);
    assert!(folder.read(&back) == folder.run("write scene.txt").quiet().into_bytes());
    assert!(folder.read("scene.txt") == opened);
}

#[test]
fn a_duplicate_is_one_more_and_is_selected() {
    let folder = folder(200);
    let mut window = Window::open(&folder, "scene.txt");
    select(&mut window, at("cube"));
    edit(&mut window, "ctrl+d", "edited", "duplicate");
    let two = save(&mut window, &folder);
    let cubes = |file: &str| words(&read(&folder, file)).iter().filter(|word| *word == "cube").count();
    assert_eq!((cubes("scene.txt"), cubes(&two)), (1, 2));
    edit(&mut window, "Delete", "edited", "delete");
    edit(&mut window, "ctrl+z", "undone", "delete");
    edit(&mut window, "ctrl+z", "undone", "duplicate");
    let one = save(&mut window, &folder);
    assert!(words(&read(&folder, &one)) == words(&folder.run("write scene.txt").quiet()));
    window.close();
}

#[test]
fn the_line_that_repeats_a_picture_says_when_the_scene_is_not_in_a_file() {
    let folder = folder(64);
    let mut window = Window::open(&folder, "scene.txt");
    window.resize(200, 200);
    window.event("resized");
    select(&mut window, at("sphere"));
    edit(&mut window, "Delete", "edited", "delete");
    window.key("0");
    window.words("wrote ");
    window.words("# the scene has edits");
    window.words("archetrace render ");

    let saved = save(&mut window, &folder);
    window.key("0");
    let path = window.words("wrote ");
    let command = window.words("archetrace render ");
    window.close();
    assert!(folder.read(&path) == folder.read("scene-001.bmp"));
    // Now there is a file with this scene: the line is about that one.
    let again = command.replacen(&path, "again.bmp", 1);
    folder.bash(&format!("\"$P\" render {again}")).quiet();
    assert!(folder.read("again.bmp") == folder.read(&path), "{command}, although {saved} holds what is seen");
}

#[test]
fn an_edit_is_in_the_picture_that_is_asked_for_at_once() {
    let folder = folder(200);
    let mut window = Window::open(&folder, "scene.txt");
    select(&mut window, at("sphere"));
    window.signal("STOP");
    window.key("Delete 0 ctrl+z");
    window.signal("CONT");
    let path = window.words("wrote ");
    window.words("# the scene has edits");
    edit(&mut window, "ctrl+y", "redone", "delete");
    let without = save(&mut window, &folder);
    window.close();
    folder.run(&format!("render {without} -o without.bmp")).quiet();
    assert!(folder.read(&path) == folder.read("without.bmp"));
}

#[test]
fn edits_are_traced_live() {
    let folder = folder(200);
    let mut window = Window::open(&folder, "scene.txt");
    window.key("t");
    let hash = |file: &str| {
        folder.run(&format!("render {file} -o rendered.bmp --samples 9")).quiet();
        Picture::read(&folder.read("rendered.bmp")).hash()
    };
    let is_final = |hash: String| {
        move |picture: &serde_json::Value| picture["is_final"] == true && picture["hash"] == hash
    };
    window.event_where("picture", is_final(hash("scene.txt")));
    select(&mut window, at("pyramid"));
    edit(&mut window, "Delete", "edited", "delete");
    let without = save(&mut window, &folder);
    window.event_where("picture", is_final(hash(&without)));
    edit(&mut window, "ctrl+z", "undone", "delete");
    window.event_where("picture", is_final(hash("scene.txt")));
    window.close();
}

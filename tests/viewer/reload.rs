//! The scene file changes on disk: the window follows, and keeps its camera.

use std::fs;

use serde_json::Value;

use crate::lines::START;
use crate::mouse::{at, select};
use crate::program::Folder;
use crate::scenes::{folder, scene};
use crate::window::Window;

/// The scene with a sphere of another radius.
fn with_radius(radius: &str) -> String {
    let text = scene(64);
    let changed = text.replacen("10  20 15  12", &format!("10  20 15  {radius}"), 1);
    assert_ne!(changed, text);
    changed
}

fn write_in_place(folder: &Folder, text: &str) {
    folder.put("scene.txt", text);
}

fn replace(folder: &Folder, text: &str) {
    folder.put(".scene.txt.new", text);
    fs::rename(folder.path(".scene.txt.new"), folder.path("scene.txt")).unwrap();
}

/// The next reload that found something new.
#[track_caller]
fn reloaded(window: &mut Window) -> Value {
    window.event_where("reloaded", |event| event["changed"] == true)
}

/// Key 0 writes the bytes that `render` writes of the scene file as it is.
#[track_caller]
fn traces_the_file(window: &mut Window, folder: &Folder) {
    let written = trace(window, folder);
    assert!(written == folder.render(&window.pose.flags()));
}

#[track_caller]
fn trace(window: &mut Window, folder: &Folder) -> Vec<u8> {
    window.key("0");
    let path = window.words("wrote ");
    folder.read(&path)
}

/// The next key goes on from where the camera was.
#[track_caller]
fn kept_the_camera(window: &mut Window) {
    let [x, y, z] = window.pose.pos;
    assert_eq!(window.step("Right").pos, [x + 5.0, y, z]);
}

#[test]
fn the_window_follows_the_file_and_keeps_its_camera() {
    let folder = folder(64);
    let mut window = Window::open(&folder, "scene.txt");
    window.step("Up");
    let before = trace(&mut window, &folder);
    write_in_place(&folder, &with_radius("18"));
    assert_eq!(reloaded(&mut window)["path"], "scene.txt");
    kept_the_camera(&mut window);
    window.step("Left");
    assert_eq!(window.pose.pos, [0.0, -145.0, 50.0]);
    traces_the_file(&mut window, &folder);
    assert!(folder.read("scene-002.bmp") != before);

    // As editors do that write another file and give it the name.
    for radius in ["9", "21"] {
        replace(&folder, &with_radius(radius));
        reloaded(&mut window);
        traces_the_file(&mut window, &folder);
    }
    kept_the_camera(&mut window);
    window.close();
}

#[test]
fn a_bad_file_is_told_with_its_place_and_the_last_good_scene_stays() {
    let folder = folder(64);
    let mut window = Window::open(&folder, "scene.txt");
    let good = trace(&mut window, &folder);
    for write in [write_in_place, replace] {
        write(&folder, &with_radius("-12"));
        let failed = window.event("failed");
        let message = failed["message"].as_str().unwrap();
        assert_eq!(failed["what"], "reload");
        assert!(message.starts_with("error: the sphere's radius is `-12`"), "{message}");
        assert!(message.contains("--> scene.txt:6:21"), "{message}");
        assert!(trace(&mut window, &folder) == good, "the last good scene is still there");
        kept_the_camera(&mut window);
        window.step("Home");

        write(&folder, &with_radius("12.5"));
        reloaded(&mut window);
        traces_the_file(&mut window, &folder);
        write(&folder, &scene(64));
        reloaded(&mut window);
        assert!(trace(&mut window, &folder) == good);
    }
    window.close();
}

#[test]
fn a_file_that_is_gone_is_told_and_may_come_back() {
    let folder = folder(64);
    let mut window = Window::open(&folder, "scene.txt");
    let good = trace(&mut window, &folder);
    fs::remove_file(folder.path("scene.txt")).unwrap();
    let failed = window.event("failed");
    assert!(failed["message"].as_str().unwrap().contains("scene.txt"), "{failed}");
    assert!(trace(&mut window, &folder) == good);
    write_in_place(&folder, &with_radius("7"));
    reloaded(&mut window);
    traces_the_file(&mut window, &folder);
    window.close();
}

#[test]
fn a_touch_loses_no_edit_and_insert_does() {
    let folder = folder(200);
    let mut window = Window::open(&folder, "scene.txt");
    select(&mut window, at("sphere"));
    window.key("Delete");
    window.event("edited");
    let edited = trace(&mut window, &folder);
    write_in_place(&folder, &scene(200));
    assert_eq!(window.event("reloaded")["changed"], false);
    assert!(trace(&mut window, &folder) == edited, "the edit is still there");

    window.key("Insert");
    reloaded(&mut window);
    traces_the_file(&mut window, &folder);
    // Reading again is a step like any other.
    window.key("ctrl+z");
    window.event("undone");
    assert!(trace(&mut window, &folder) == edited);
    window.key("ctrl+z");
    assert_eq!(window.event("undone")["what"], "delete");
    traces_the_file(&mut window, &folder);
    assert_eq!(window.pose, START);
    window.close();
}

#[test]
fn texture_stays_on_when_the_file_is_read_again() {
    let folder = folder(64);
    let mut window = Window::open(&folder, "scene.txt --texture");
    write_in_place(&folder, &with_radius("18"));
    reloaded(&mut window);
    assert!(trace(&mut window, &folder) == folder.render("--texture"));
    window.key("space");
    assert_eq!(window.event("switched")["on"], false);
    traces_the_file(&mut window, &folder);
    window.close();
}

#[test]
fn the_live_picture_follows_the_file() {
    let folder = folder(64);
    let mut window = Window::open(&folder, "scene.txt");
    window.key("t");
    window.event("mode");
    write_in_place(&folder, &with_radius("18"));
    reloaded(&mut window);
    let expected = crate::picture::Picture::rendered(&folder, "--samples 9").hash();
    window.event_where("picture", |picture| picture["is_final"] == true && picture["hash"] == expected);
    window.close();
}

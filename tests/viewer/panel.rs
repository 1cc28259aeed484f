//! The panel, by hand: values are dragged and typed. What a field does is the panel's own tests' business; here it is
//! whether mouse and keyboard reach it, and it alone.

use std::thread;
use std::time::Duration;

use serde_json::Value;

use crate::edits::words;
use crate::mouse::{at, select};
use crate::picture::Picture;
use crate::program::Folder;
use crate::scenes::folder;
use crate::window::Window;

/// Width and height of the window, and of the picture in it while the panel is open.
const SIZE: (u32, u32) = (720, 900);
/// A column of the panel that goes through the fields of numbers.
const FIELDS: u32 = 560;

/// Opens a window with an open panel, and selects the sphere.
#[track_caller]
fn open(folder: &Folder) -> Window {
    let mut window = Window::open(folder, "scene.txt");
    select(&mut window, at("sphere"));
    window.resize(SIZE.0, SIZE.1);
    window.event("resized");
    window.key("F1");
    assert_eq!(window.event("switched")["on"], true);
    window
}

/// Turns the wheel over the scene and waits for the camera, twice: then the frame of the first time is over, and all
/// that came before it has been dealt with. A key would not do for that, as a field may have the keyboard.
#[track_caller]
fn settle(window: &mut Window) {
    window.point((20, 700));
    for _ in 0..2 {
        let [x, y, z] = window.pose.pos;
        window.display.xdotool("click 4");
        // Two lines of the wheel, see `mouse::wheel`.
        while window.camera().pos != [x, y + 10.0, z] {}
    }
}

/// Drags sideways from every few rows of the panel until that edits what is asked for; the row.
#[track_caller]
fn find_by_dragging(window: &mut Window, component: &str) -> u32 {
    // A drag that begins and ends within one frame is none. Frames of a busy machine may be long.
    for pause in [25, 100, 400].map(Duration::from_millis) {
        for row in (250..650).step_by(9) {
            drag_sideways(window, row, pause);
            settle(window);
            let edits = window.unasked();
            window.forget();
            if edits.iter().any(|line| line.event("edited").is_some_and(|edit| edit["what"] == component)) {
                return row;
            }
        }
    }
    panic!("no row of the panel edits a {component}\n{}", window.tell());
}

fn drag_sideways(window: &Window, row: u32, pause: Duration) {
    window.point((FIELDS, row));
    window.display.xdotool("mousedown 1");
    for column in [FIELDS + 15, FIELDS + 30] {
        thread::sleep(pause);
        window.point((column, row));
    }
    thread::sleep(pause);
    window.display.xdotool("mouseup 1");
}

#[track_caller]
fn saved(window: &mut Window, folder: &Folder) -> String {
    window.key("F2");
    let path = window.event("saved")["path"].as_str().unwrap().to_owned();
    String::from_utf8(folder.read(&path)).unwrap()
}

#[test]
fn a_value_is_dragged_and_typed_and_taken_back() {
    let folder = folder(200);
    let original = folder.run("write scene.txt").quiet();
    let mut window = open(&folder);
    let row = find_by_dragging(&mut window, "Sphere");
    assert_ne!(saved(&mut window, &folder), original, "the sphere has another radius");
    while saved(&mut window, &folder) != original {
        window.key("ctrl+z");
        window.event("undone");
    }
    window.forget();

    window.click((FIELDS, row));
    settle(&mut window);
    // Keys that would turn the camera, trace, raise the eye, delete and more, were it not for the field.
    window.key("ctrl+a 3 0 1 period 5 w BackSpace Delete Left Right Home End Return");
    assert_eq!(window.event("edited")["what"], "Sphere", "{}", window.tell());
    let pose = window.pose;
    assert_eq!(window.step("Up").pos[1], pose.pos[1] + 5.0, "now keys are the camera's again");
    assert_eq!(window.unasked(), [], "while they were the field's nothing else happened");
    let typed = saved(&mut window, &folder);
    assert_eq!(words(&typed.replacen("301.5", "12", 1)), words(&original));
    window.key("ctrl+z");
    assert_eq!(window.event("undone")["what"], "Sphere");
    assert_eq!(saved(&mut window, &folder), original);
    window.close();
    assert!(!folder.names().iter().any(|name| name.ends_with(".bmp")), "0 has traced nothing");
}

#[test]
fn the_wheel_and_clicks_over_the_panel_are_the_panels() {
    let folder = folder(200);
    let mut window = open(&folder);
    window.point((FIELDS, 400));
    window.display.xdotool("click 4 click 1");
    settle(&mut window);
    assert_eq!(window.unasked(), []);
    // A click on the scene takes the keyboard back from whatever field had it.
    assert_ne!(select(&mut window, (195, 600)), Value::Null);
    settle(&mut window);
    window.step("Right");
    window.close();
}

#[test]
fn the_panel_comes_and_goes_and_the_picture_makes_way() {
    let folder = folder(200);
    let mut window = Window::open(&folder, "scene.txt");
    window.resize(700, 500);
    window.event("resized");
    window.key("t");
    let final_side = |window: &mut Window, holds: fn(u64) -> bool| {
        let picture = window.event_where("picture", |picture| {
            picture["is_final"] == true && picture["side"].as_u64().is_some_and(holds)
        });
        let expected = Picture::rendered(&folder, &format!("--size {} --samples 9", picture["side"]));
        assert_eq!(picture["hash"], expected.hash());
    };
    final_side(&mut window, |side| side == 500);
    window.key("F1");
    assert_eq!(window.event("switched")["on"], true);
    final_side(&mut window, |side| (200..450).contains(&side));
    window.key("F1");
    assert_eq!(window.event("switched")["on"], false);
    final_side(&mut window, |side| side == 500);
    window.close();
}

#[test]
fn a_window_that_the_panel_fills_shows_the_panel() {
    let folder = folder(200);
    let mut window = Window::open(&folder, "scene.txt");
    let (_, _, scene) = window.display.pixels(window.id);
    window.key("F1");
    window.event("switched");
    window.shows("the panel", |_, _, pixels| {
        let changed = pixels.iter().zip(&scene).filter(|(a, b)| a != b).count();
        changed > scene.len() / 2
    });
    window.key("F1");
    window.event("switched");
    window.step("Up");
    window.step("Down");
    window.shows("the scene again", |_, _, pixels| pixels == scene);
    window.close();
}

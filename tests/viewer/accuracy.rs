//! Accuracy by hand: the strip's slider moves it, the traced picture and the file follow, and both are what `render` makes
//! with the flags that are printed.

use std::fs;
use std::thread;
use std::time::Duration;

use crate::picture::Picture;
use crate::program::Folder;
use crate::scenes::folder;
use crate::window::Window;

/// Width and height of the window: wide enough for the strip's slider.
const SIZE: (u32, u32) = (900, 300);
/// A row through the strip.
const STRIP: u32 = SIZE.1 - 13;

#[track_caller]
fn open(folder: &Folder) -> Window {
    let mut window = Window::open(folder, "scene.txt");
    window.resize(SIZE.0, SIZE.1);
    window.event("resized");
    window.key("t");
    window.event("mode");
    window.event_where("picture", |picture| picture["is_final"] == true);
    window
}

/// The flags of accuracy that key 0 prints with its picture, which it removes after it was found to be the one that
/// `render` writes with them.
#[track_caller]
fn flags(window: &mut Window, folder: &Folder) -> String {
    window.key("0");
    window.event("tracing");
    let path = window.words("wrote ");
    let command = window.words("archetrace render ");
    folder.bash(&format!("\"$P\" render {}", command.replacen(&path, "again.bmp", 1))).quiet();
    assert!(folder.read(&path) == folder.read("again.bmp"), "{command}");
    fs::remove_file(folder.path(&path)).unwrap();
    command.split_once(" --samples").map_or(String::new(), |(_, flags)| format!("--samples{flags}"))
}

/// A click that takes several frames: one that begins and ends within a frame moves no slider.
fn press(at: (u32, u32), window: &Window) {
    window.point(at);
    for action in ["mousedown 1", "mouseup 1"] {
        window.display.xdotool(action);
        thread::sleep(Duration::from_millis(400));
    }
}

/// Clicks along the strip until that chooses a setting that something holds for; its flags.
#[track_caller]
fn choose(window: &mut Window, folder: &Folder, holds: impl Fn(&str) -> bool) -> String {
    for column in (340..520).step_by(12) {
        window.forget();
        press((column, STRIP), window);
        // The click has been dealt with when the wheel over the scene has turned the camera, and back.
        for button in [4, 5] {
            window.point((450, 100));
            window.display.xdotool(&format!("click {button}"));
            window.camera();
        }
        let edits = window.unasked();
        if edits.iter().any(|line| line.event("edited").is_some_and(|edit| edit["what"] == "Accuracy")) {
            let flags = flags(window, folder);
            if holds(&flags) {
                return flags;
            }
        }
    }
    panic!("nothing like that on the strip\n{}", window.tell());
}

#[test]
fn what_the_slider_chooses_is_in_the_window_and_in_the_file() {
    let folder = folder(60);
    let mut window = open(&folder);
    assert_eq!(flags(&mut window, &folder), "", "nothing has been chosen");
    let flags = choose(&mut window, &folder, |flags| {
        ["--adaptive", "--cutoff"].into_iter().all(|flag| flags.contains(flag))
    });
    // The picture in the window is the same, but for its size.
    let flags = flags.split_once(" --size").unwrap().0;
    window.forget();
    window.step("Up");
    let pose = window.pose.flags();
    let expected = Picture::rendered(&folder, &format!("--size {} {flags} {pose}", SIZE.1));
    window
        .event_where("picture", |picture| picture["is_final"] == true && picture["hash"] == expected.hash());
    window.key("ctrl+z");
    assert_eq!(window.event("undone")["what"], "Accuracy");
    window.close();
}

#[test]
fn maps_of_errors_and_rays_come_and_go() {
    let folder = folder(200);
    let mut window = Window::open(&folder, "scene.txt");
    window.key("h");
    assert_eq!(window.event("mode")["mode"], "traced", "a map is of the traced picture");
    let map = window.event("heat_map");
    assert_eq!((map["what"].as_str(), map["side"].as_u64()), (Some("errors"), Some(200)));
    window.key("h");
    let map = window.event("heat_map");
    assert_eq!(map["what"], "rays");
    assert!(map["most"].as_f64().unwrap() > 9.0, "nine samples, and rays towards lights: {map}");
    window.key("h");
    let expected = Picture::rendered(&folder, "--samples 9");
    window.event_where("picture", |picture| picture["hash"] == expected.hash());
    window.shows("the picture", |_, _, pixels| pixels == expected.rgb);
    window.close();
}

#[test]
fn the_strip_is_over_wide_windows_and_can_be_put_away() {
    let folder = folder(60);
    let mut window = open(&folder);
    let expected = Picture::rendered(&folder, &format!("--size {} --samples 9", SIZE.1)).rgb;
    let left = (SIZE.0 - SIZE.1) / 2;
    let row = |pixels: &[u8], row: u32| {
        let start = usize::try_from(3 * (row * SIZE.0 + left)).unwrap();
        pixels[start..start + usize::try_from(3 * SIZE.1).unwrap()].to_vec()
    };
    let picture_row = |row: u32| {
        let width = usize::try_from(3 * SIZE.1).unwrap();
        expected[usize::try_from(row).unwrap() * width..][..width].to_vec()
    };
    window.shows("the strip", |_, _, pixels| {
        row(pixels, 100) == picture_row(100) && row(pixels, STRIP) != picture_row(STRIP)
    });
    window.key("i");
    assert_eq!(window.event("switched")["on"], false);
    window
        .shows("the picture alone", |_, _, pixels| (0..SIZE.1).all(|at| row(pixels, at) == picture_row(at)));
    window.close();
}

//! The strip and the maps in false colours, in the real window.

use crate::picture::Picture;
use crate::program::Folder;
use crate::scenes::folder;
use crate::window::Window;

/// Width and height of the window: wide enough for the strip.
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
fn keys_go_along_the_front_that_was_measured_and_the_picture_is_that_of_its_flags() {
    let folder = folder(48);
    let mut window = Window::open(&folder, "scene.txt");
    window.key("t");
    window.event("mode");
    let settings = window.event("front")["settings"].as_u64().unwrap();
    assert!(settings > 2, "a front of {settings} settings");
    for key in ["g", "g", "f"] {
        window.key(key);
        let chosen = window.event("accuracy");
        let expected = Picture::rendered(&folder, chosen["flags"].as_str().unwrap());
        window.event_where("picture", |picture| {
            picture["is_final"] == true && picture["hash"] == expected.hash()
        });
    }
    for _ in 0..3 {
        window.key("ctrl+z");
        window.event("undone");
    }
    let expected = Picture::rendered(&folder, "--samples 9");
    window.event_where("picture", |picture| picture["hash"] == expected.hash());
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

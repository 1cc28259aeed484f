//! Windows of other sizes than the scene asks for.

use serde_json::{Value, json};

use crate::picture::Picture;
use crate::scenes::folder;
use crate::window::Window;

#[track_caller]
fn resize(window: &mut Window, width: u32, height: u32) {
    window.resize(width, height);
    let side = width.min(height);
    let expected = json!({"event": "resized", "width": width, "height": height, "side": side});
    window.event_where("resized", |event| *event == expected);
}

fn hash_of(side: u32) -> impl Fn(&Value) -> bool {
    move |picture| picture["is_final"] == true && picture["side"] == side
}

#[test]
fn the_window_is_as_large_as_the_picture() {
    for pixels in [1, 33, 300] {
        let folder = folder(pixels);
        let window = Window::open(&folder, "scene.txt");
        window.shows("its size", |width, height, _| u32::from(width) == pixels && width == height);
        window.close();
    }
}

#[test]
fn a_picture_that_is_too_large_for_a_screen_gets_a_smaller_window() {
    let folder = folder(8192);
    let window = Window::open(&folder, "scene.txt");
    window.shows("its size", |width, height, _| (width, height) == (1024, 1024));
    window.close();
}

#[test]
fn the_traced_picture_follows_the_window() {
    let folder = folder(100);
    let mut window = Window::open(&folder, "scene.txt");
    window.key("t");
    window.event("mode");
    for (width, height) in [(160, 120), (64, 190), (1, 1), (300, 2), (77, 77), (100, 100)] {
        resize(&mut window, width, height);
        let side = width.min(height);
        let expected = Picture::rendered(&folder, &format!("--size {side} --samples 9"));
        let picture = window.event_where("picture", hash_of(side));
        assert_eq!(picture["hash"], expected.hash(), "{width} x {height}");
        let middle = [(width - side) / 2, (height - side) / 2];
        window.shows("the picture in its middle", |w, h, pixels| {
            (u32::from(w), u32::from(h)) == (width, height)
                && cut(pixels, width, middle, side) == expected.rgb
        });
    }
    window.close();
}

/// A square of a picture.
fn cut(pixels: &[u8], width: u32, [left, top]: [u32; 2], side: u32) -> Vec<u8> {
    let index = |row: u32, column: u32| 3 * usize::try_from((top + row) * width + left + column).unwrap();
    (0..side).flat_map(|row| &pixels[index(row, 0)..index(row, side)]).copied().collect()
}

#[test]
fn a_storm_of_sizes_ends_with_the_last_one() {
    let folder = folder(100);
    let mut window = Window::open(&folder, "scene.txt");
    window.key("t t");
    window.event("mode");
    for step in 0..30 {
        window.resize(40 + step * 17 % 400, 30 + step * 29 % 300);
    }
    resize(&mut window, 210, 140);
    let expected = Picture::rendered(&folder, "--size 140 --samples 9");
    window.event_where("picture", |picture| hash_of(140)(picture) && picture["hash"] == expected.hash());
    window.step("Up");
    window.close();
}

#[test]
fn twice_as_many_pixels_a_point_are_told_as_pixels() {
    let folder = folder(100);
    let mut command = crate::window::program(&folder);
    command.env("WINIT_X11_SCALE_FACTOR", "2");
    let mut window = Window::open_with(&["scene.txt"], &mut command);
    window.shows("its size", |width, height, _| (width, height) == (100, 100));
    window.key("t");
    let expected = Picture::rendered(&folder, "--samples 9");
    window.event_where("picture", |picture| hash_of(100)(picture) && picture["hash"] == expected.hash());
    window.close();
}

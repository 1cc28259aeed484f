//! Key t: the traced picture in the window. When it is complete it is what `render` writes, to the bit.

use serde_json::Value;

use crate::picture::Picture;
use crate::program::Folder;
use crate::scenes::{folder, slow_folder};
use crate::window::Window;

/// Samples a pixel of the last picture.
const SAMPLES: u64 = 9;

fn is_first(picture: &Value) -> bool {
    picture["samples"] == 1 && picture["is_final"] == false
}

fn is_last(picture: &Value) -> bool {
    picture["is_final"] == true
}

#[track_caller]
fn set_mode(window: &mut Window, mode: &str) {
    window.key("t");
    assert_eq!(window.event("mode")["mode"], mode);
}

/// Waits for the complete picture that `render` writes with these arguments.
#[track_caller]
fn check(window: &mut Window, folder: &Folder, side: u32, arguments: &str) {
    let last = Picture::rendered(folder, &format!("--size {side} --samples {SAMPLES} {arguments}"));
    let is_it = |picture: &Value| is_last(picture) && picture["hash"] == last.hash();
    let picture = window.event_where("picture", is_it);
    assert_eq!((picture["side"].as_u64(), picture["samples"].as_u64()), (Some(side.into()), Some(SAMPLES)));
}

#[test]
fn the_first_whole_picture_is_already_what_render_writes() {
    // Each of its nine samples takes seconds, so that none is overtaken by the next before the window has seen it.
    let folder = slow_folder();
    let mut window = Window::open(&folder, "scene.txt");
    window.resize(120, 120);
    window.event("resized");
    set_mode(&mut window, "traced");
    let first = Picture::rendered(&folder, "--size 120");
    let picture = window.event_where("picture", is_first);
    assert_eq!((picture["side"].as_u64(), picture["hash"].as_str()), (Some(120), Some(&*first.hash())));
    window.shows("it", |_, _, pixels| pixels == first.rgb);
    window.close();
}

#[test]
fn preview_traced_picture_both_and_back() {
    let folder = folder(96);
    let mut window = Window::open(&folder, "scene.txt");
    assert_eq!(window.unasked(), [], "nothing is traced that is not seen");
    set_mode(&mut window, "traced");
    check(&mut window, &folder, 96, "");
    let traced = Picture::rendered(&folder, "--samples 9").rgb;
    window.shows("the traced picture", |_, _, pixels| pixels == traced);

    set_mode(&mut window, "split");
    window.shows("the preview on one side", |_, _, pixels| {
        let same = pixels.iter().zip(&traced).filter(|(a, b)| a == b).count();
        pixels != traced && same >= traced.len() / 2
    });
    set_mode(&mut window, "preview");
    window.forget();
    window.step("Up");
    assert_eq!(window.unasked(), [], "nothing is traced any more");
    set_mode(&mut window, "traced");
    let flags = window.pose.flags();
    check(&mut window, &folder, 96, &flags);
    window.close();
}

#[test]
fn every_camera_has_its_own_picture() {
    let folder = folder(96);
    let mut window = Window::open(&folder, "scene.txt");
    set_mode(&mut window, "traced");
    for key in ["Up", "shift+1", "ctrl+w", "5", "Home"] {
        let flags = window.step(key).flags();
        check(&mut window, &folder, 96, &flags);
    }
    window.close();
}

#[test]
fn it_starts_again_with_the_camera_and_only_the_last_view_stays() {
    let folder = folder(400);
    let mut window = Window::open(&folder, "scene.txt");
    set_mode(&mut window, "traced");
    window.key("Up Up 1 Up 3 Right 1 Down 5 w");
    // The last of them raises the eye.
    while window.pose.pos[2] <= 54.0 {
        window.camera();
    }
    let flags = window.pose.flags();
    let last = Picture::rendered(&folder, &format!("--samples 9 {flags}"));
    window.event_where("picture", |picture| is_last(picture) && picture["hash"] == last.hash());
    window.shows("the last view", |_, _, pixels| pixels == last.rgb);
    window.close();
}

#[test]
fn texture_and_precision_are_those_of_the_window() {
    let folder = folder(96);
    let mut window = Window::open(&folder, "scene.txt --precision f32");
    set_mode(&mut window, "traced");
    check(&mut window, &folder, 96, "--precision f32");
    for arguments in ["--texture --precision f32", "--precision f32"] {
        window.key("space");
        window.event("switched");
        check(&mut window, &folder, 96, arguments);
    }
    window.close();
}

#[test]
fn the_preview_in_the_window_is_the_one_that_is_drawn_without() {
    let folder = folder(128);
    let mut window = Window::open(&folder, "scene.txt");
    window.step("shift+1");
    let preview = |arguments: &str| {
        let flags = window.pose.flags();
        folder.run(&format!("preview scene.txt -o preview.png {flags} {arguments}")).quiet();
        Picture::read(&folder.read("preview.png")).rgb
    };
    let (all, lights, none) = (preview("--lights --axes"), preview("--lights"), preview(""));
    let textured = preview("--texture");
    window.shows("lights and axes", |_, _, pixels| pixels == all);
    window.key("x");
    window.shows("lights", |_, _, pixels| pixels == lights);
    window.key("l");
    window.shows("the scene alone", |_, _, pixels| pixels == none);
    window.key("space");
    window.shows("texture", |_, _, pixels| pixels == textured);
    window.close();
}

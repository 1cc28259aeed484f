//! Giving up and closing while pictures are traced: at once, and without a trace on the disk.

use std::time::{Duration, Instant};

use crate::display::PATIENCE;
use crate::scenes::{folder, slow_folder};
use crate::window::{Window, program};

/// What is soon for a slow machine. The pictures that are given up would take minutes.
const SOON: Duration = Duration::from_secs(15);

#[test]
fn escape_gives_a_picture_up() {
    let folder = slow_folder();
    let mut window = Window::open(&folder, "scene.txt");
    for _ in 0..2 {
        window.key("0");
        assert_eq!(window.event("tracing")["pixels"], 1500);
        // One at a time.
        window.key("0");
        let refusal = window.event("failed");
        assert_eq!(refusal["what"], "trace");
        assert!(refusal["message"].as_str().unwrap().contains("already"), "{refusal}");
        // The window answers while a picture is traced.
        window.step("Up");
        let pressed = Instant::now();
        window.key("Escape");
        window.event("cancelled");
        assert!(pressed.elapsed() < SOON, "{:?}", pressed.elapsed());
    }
    window.close();
    assert_eq!(folder.names(), ["scene.txt"]);
}

/// The window is asked to close while a picture is traced for a file and another one for the window.
#[track_caller]
fn close_while_tracing(close: impl FnOnce(&Window)) {
    let folder = slow_folder();
    let mut window = Window::open(&folder, "scene.txt");
    window.key("t");
    assert_eq!(window.event("mode")["mode"], "traced");
    window.key("0");
    window.event("tracing");
    close(&window);
    window.ends_well(SOON);
    assert_eq!(folder.names(), ["scene.txt"]);
}

#[test]
fn the_cross_in_the_title_bar_closes_while_pictures_are_traced() {
    close_while_tracing(|window| window.display.ask_to_close(window.id));
}

#[test]
fn ctrl_q_closes_while_pictures_are_traced() {
    close_while_tracing(|window| window.key("ctrl+q"));
}

#[test]
fn a_window_whose_display_goes_away_ends() {
    let folder = slow_folder();
    let mut window = Window::open(&folder, "scene.txt");
    window.key("0");
    window.event("tracing");
    window.display.stop();
    let status = window.ends_within(SOON);
    assert_ne!(status.code(), Some(0), "{}", window.tell());
    assert_eq!(folder.names(), ["scene.txt"]);
}

#[test]
fn nobody_has_to_listen() {
    let folder = folder(32);
    let mut window = Window::open(&folder, "scene.txt");
    window.deaf();
    window.key("Up t 0");
    let deadline = Instant::now() + PATIENCE;
    while !folder.path("scene-001.bmp").exists() {
        assert!(Instant::now() < deadline, "{:?}", folder.names());
        std::thread::sleep(Duration::from_millis(20));
    }
    window.close();
}

#[test]
fn nothing_is_said_unless_asked_for() {
    let folder = folder(32);
    let mut window = Window::silent(program(&folder).args(["view", "scene.txt"]));
    window.key("Up 1 t l 0");
    assert_eq!(window.words("wrote "), "scene-001.bmp");
    window.words("archetrace render ");
    assert_eq!(window.unasked(), []);
    window.close();
}

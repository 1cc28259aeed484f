//! The mouse: a click selects what shows under it, a drag looks around, the wheel goes forward.

use serde_json::Value;

use crate::lines::{Pose, START};
use crate::scenes::folder;
use crate::window::Window;

/// Where the camera at its start sees a point, in a picture of so many pixels: half a field of view is 30 degrees.
fn seen_from_start([x, y, z]: [f64; 3], side: u32) -> (u32, u32) {
    let half = f64::from(side) / 2.0;
    let depth = (y + 150.0) * 30.0_f64.to_radians().tan();
    let pixel = |offset: f64| format!("{:.0}", half + half * offset / depth).parse().unwrap();
    (pixel(x), pixel(50.0 - z))
}

/// Points of the objects of the scene that nothing hides, and what they belong to.
const POINTS: [(&str, [f64; 3]); 4] = [
    ("sphere", [10.0, 8.0, 15.0]),
    ("cube", [-21.0, 0.0, 9.0]),
    ("pyramid", [0.0, -45.0, 10.0]),
    ("checkerboard", [30.0, -60.0, 0.0]),
];
pub(crate) const SKY: (u32, u32) = (150, 20);

/// Where an object of this kind shows in a window of 200 pixels with the camera at its start.
pub(crate) fn at(kind: &str) -> (u32, u32) {
    let (_, point) = POINTS.into_iter().find(|(known, _)| *known == kind).unwrap();
    seen_from_start(point, 200)
}

#[track_caller]
pub(crate) fn select(window: &mut Window, at: (u32, u32)) -> Value {
    window.click(at);
    window.event("selected")["object"].clone()
}

#[test]
fn a_click_selects_what_shows_there() {
    let folder = folder(200);
    let mut window = Window::open(&folder, "scene.txt");
    for (kind, point) in POINTS {
        let object = select(&mut window, seen_from_start(point, 200));
        assert!(object.as_str().is_some_and(|name| name.contains(kind)), "{object} is not the {kind}");
        assert_eq!(select(&mut window, SKY), Value::Null);
    }
    window.step("2");
    let hit = select(&mut window, at("sphere"));
    assert_eq!(
        hit.as_str().map(|name| name.contains("sphere")),
        Some(false),
        "the sphere has moved away: {hit}"
    );
    window.close();
}

#[test]
fn with_twice_as_many_pixels_a_point_the_window_is_as_large_and_a_click_selects_the_same() {
    let folder = folder(200);
    let mut command = crate::window::program(&folder);
    command.env("WINIT_X11_SCALE_FACTOR", "2");
    let mut window = Window::open_with(&["scene.txt"], &mut command);
    for (kind, point) in POINTS {
        let object = select(&mut window, seen_from_start(point, 200));
        assert!(object.as_str().is_some_and(|name| name.contains(kind)), "{object} is not the {kind}");
    }
    assert_eq!(select(&mut window, SKY), Value::Null);
    window.close();
}

/// Drags from one pixel to another, over pixels in between.
fn drag(window: &Window, from: (u32, u32), over: &[(u32, u32)]) {
    window.point(from);
    window.display.xdotool("mousedown 1");
    for &to in over {
        window.point(to);
    }
    window.display.xdotool("mouseup 1");
}

/// The camera at its start, turned to the left about z and then up about its own r, in degrees.
fn turned(left: f64, up: f64) -> Pose {
    let ((sa, ca), (sb, cb)) = (left.to_radians().sin_cos(), up.to_radians().sin_cos());
    let (l, r, u) = ([-sa * cb, ca * cb, sb], [ca, sa, 0.0], [sa * sb, -ca * sb, cb]);
    Pose { l, r, u, ..START }
}

fn apart(a: &Pose, b: &Pose) -> f64 {
    let numbers = |pose: &Pose| [pose.pos, pose.l, pose.r, pose.u].concat();
    numbers(a).iter().zip(numbers(b)).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

#[test]
fn a_drag_looks_around_and_selects_nothing() {
    let folder = folder(200);
    let mut window = Window::open(&folder, "scene.txt");
    drag(&window, (60, 100), &[(70, 100), (90, 104), (120, 110), (140, 120)]);
    // The picture follows: 80 pixels of 200 to the right, 20 down, of a field of view of 60 degrees.
    let expected = turned(24.0, 6.0);
    let deadline = std::time::Instant::now() + crate::display::PATIENCE;
    while apart(&window.camera(), &expected) > 1e-14 {
        assert!(std::time::Instant::now() < deadline, "{:?}, not {expected:?}", window.pose);
    }
    assert_eq!(window.pose.r[2], 0.0, "the horizon stays level");
    window.point((10, 10));
    assert_eq!(window.step("Home"), START, "a button that is up drags nothing");
    assert_eq!(window.unasked(), [], "a drag selects nothing");

    // A hand that shakes still clicks.
    let (x, y) = at("sphere");
    drag(&window, (x, y), &[(x + 2, y - 2)]);
    window.event("selected");
    assert_eq!(window.unasked(), []);
    window.close();
}

/// Turns the wheel by a notch, and waits for the camera to be where that leads. To a server without smooth scrolling a
/// notch is a button that goes down and up, and winit 0.30 makes a line of the wheel out of either, so it is two here
/// (rust-windowing/winit#4386).
#[track_caller]
fn wheel(window: &mut Window, button: &str, y: f64) {
    window.display.xdotool(&format!("click {button}"));
    while window.camera().pos != [0.0, y, 50.0] {}
}

#[test]
fn the_wheel_goes_forward_and_back() {
    let folder = folder(200);
    let mut window = Window::open(&folder, "scene.txt");
    window.point((100, 100));
    wheel(&mut window, "4", -140.0);
    wheel(&mut window, "5", -150.0);
    window.display.xdotool("keydown shift");
    wheel(&mut window, "4", -100.0);
    window.display.xdotool("keyup shift keydown ctrl");
    wheel(&mut window, "5", -101.0);
    window.display.xdotool("keyup ctrl");
    window.close();
}

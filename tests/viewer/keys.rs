//! Every key that moves the camera, against the table in words: README, "Keys".

use std::time::{Duration, Instant};

use glam::{DQuat, DVec3};

use crate::lines::{Pose, START};
use crate::scenes::folder;
use crate::window::Window;

/// What a key does to the camera.
#[derive(Clone, Copy, Debug)]
enum Does {
    /// Units along `l`, `r` or `u`.
    Moves(Axis, f64),
    /// Degrees: the first axis turns towards the second, the third stays.
    Turns([Axis; 3], f64),
    /// Units along the world's z; the eye keeps looking at the same point.
    Raises(f64),
}

#[derive(Clone, Copy, Debug)]
enum Axis {
    L,
    R,
    U,
}

use Axis::{L, R, U};
use Does::{Moves, Raises, Turns};

/// The table. Left is away from r; a picture that tilts counter-clockwise has its u tip towards r.
const KEYS: [(&str, Does); 14] = [
    ("Up", Moves(L, 5.0)),
    ("Down", Moves(L, -5.0)),
    ("Right", Moves(R, 5.0)),
    ("Left", Moves(R, -5.0)),
    ("Prior", Moves(U, 5.0)),
    ("Next", Moves(U, -5.0)),
    ("1", Turns([R, L, U], 5.0)),
    ("2", Turns([R, L, U], -5.0)),
    ("3", Turns([L, U, R], 5.0)),
    ("4", Turns([L, U, R], -5.0)),
    ("5", Turns([U, R, L], 5.0)),
    ("6", Turns([U, R, L], -5.0)),
    ("w", Raises(5.0)),
    ("s", Raises(-5.0)),
];

/// Keys with modifiers, and how many times as far they go.
const SPEEDS: [(&str, f64); 4] = [("", 1.0), ("shift+", 5.0), ("ctrl+", 0.1), ("ctrl+shift+", 0.5)];

/// What the camera is, and how far ahead the point lies that it keeps looking at while it is raised.
#[derive(Clone, Copy, Debug)]
struct View {
    pose: Pose,
    reference: f64,
}

const AT_START: View = View { pose: START, reference: 150.0 };

impl View {
    fn axis(&self, axis: Axis) -> [f64; 3] {
        match axis {
            L => self.pose.l,
            R => self.pose.r,
            U => self.pose.u,
        }
    }

    /// Where a key leads that was pressed here, after it has led to `seen`. Moves are exact; turns are computed in
    /// another way than the program's, and agree within a few units in the last place.
    #[track_caller]
    fn check(self, key: &str, does: Does, factor: f64, seen: Pose) -> Self {
        match does {
            Moves(axis, units) => self.check_move(key, axis, units * factor, seen),
            Turns(axes, degrees) => self.check_turn(key, axes, degrees * factor, seen),
            Raises(units) => self.check_raise(key, units * factor, seen),
        }
    }

    #[track_caller]
    fn check_move(self, key: &str, axis: Axis, units: f64, seen: Pose) -> Self {
        let along = self.axis(axis);
        let pos = [0, 1, 2].map(|i| self.pose.pos[i] + units * along[i]);
        let expected = Pose { pos, ..self.pose };
        assert_eq!(seen.bits(), expected.bits(), "{key}: {seen:?}, not {expected:?}");
        Self { pose: seen, ..self }
    }

    #[track_caller]
    fn check_turn(self, key: &str, [a, b, about]: [Axis; 3], degrees: f64, seen: Pose) -> Self {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        let (from, to) = (self.axis(a), self.axis(b));
        let first = [0, 1, 2].map(|i| from[i] * cosine + to[i] * sine);
        let second = [0, 1, 2].map(|i| to[i] * cosine - from[i] * sine);
        let turned = Self { pose: seen, ..self };
        near(key, turned.axis(a), first);
        near(key, turned.axis(b), second);
        let kept = (turned.axis(about), seen.pos);
        assert_eq!(kept, (self.axis(about), self.pose.pos), "{key} turns about {about:?}: {seen:?}");
        turned
    }

    #[track_caller]
    fn check_raise(self, key: &str, units: f64, seen: Pose) -> Self {
        let [x, y, z] = self.pose.pos;
        assert_eq!(seen.pos, [x, y, z + units], "{key}");
        let l = DVec3::from(self.pose.l);
        let sight = l * self.reference - DVec3::Z * units;
        let rotation = DQuat::from_rotation_arc(l, sight.normalize());
        near(key, seen.l, sight.normalize().into());
        near(key, seen.r, (rotation * DVec3::from(self.pose.r)).into());
        near(key, seen.u, (rotation * DVec3::from(self.pose.u)).into());
        Self { pose: seen, reference: sight.length() }
    }
}

/// Directions that differ by what rounding explains, and not more.
#[track_caller]
fn near(key: &str, seen: [f64; 3], expected: [f64; 3]) {
    let apart = DVec3::from(seen).distance(expected.into());
    assert!(apart <= 4.0 * f64::EPSILON, "{key}: {seen:?}, not {expected:?}");
}

/// Presses every key at every speed; each of them is one step.
#[track_caller]
fn press_every_key(window: &mut Window, mut view: View) {
    for (modifiers, factor) in SPEEDS {
        for (key, does) in KEYS {
            let key = format!("{modifiers}{key}");
            let seen = window.step(&key);
            view = view.check(&key, does, factor, seen);
        }
    }
}

#[test]
fn every_key_does_what_the_table_says_from_the_start() {
    let folder = folder(32);
    let mut window = Window::open(&folder, "scene.txt");
    assert_eq!(window.pose.bits(), START.bits());
    press_every_key(&mut window, AT_START);
    assert_eq!(window.step("Home").bits(), START.bits(), "home is where it started, to the bit");
    // Home has put the reference point back as well.
    let raised = window.step("w");
    AT_START.check("w after home", Raises(5.0), 1.0, raised);
    assert_eq!(window.unasked(), [], "one pose a press, and nothing else");
    window.close();
}

#[test]
fn every_key_does_what_the_table_says_from_an_odd_view() {
    let folder = folder(32);
    let mut window =
        Window::open(&folder, "scene.txt --eye=-70.3,-91.7,33.1 --look=0.6,0.71,-0.37 --up=0.2,0.1,0.9");
    let view = View { pose: window.pose, ..AT_START };
    press_every_key(&mut window, view);
    window.close();
}

#[test]
fn keys_act_in_the_order_of_their_presses() {
    let folder = folder(32);
    let mut window = Window::open(&folder, "scene.txt");
    window.key("1 Up");
    let turned_first = settled(&mut window, |pose| pose.pos != START.pos);
    let ahead = |l: [f64; 3]| [0, 1, 2].map(|i| START.pos[i] + 5.0 * l[i]);
    assert_eq!(turned_first.pos, ahead(turned_first.l));
    window.step("Home");
    window.key("Up 1");
    let moved_first = settled(&mut window, |pose| pose.l != START.l);
    assert_eq!(moved_first.pos, ahead(START.l));
    assert_eq!(moved_first.l, turned_first.l);
    window.close();
}

/// The first pose that something holds for.
#[track_caller]
fn settled(window: &mut Window, holds: impl Fn(&Pose) -> bool) -> Pose {
    loop {
        let pose = window.camera();
        if holds(&pose) {
            return pose;
        }
    }
}

#[test]
fn a_press_is_one_step_no_more_and_no_less() {
    let folder = folder(32);
    let mut window = Window::open(&folder, "scene.txt");
    for press in 1..=20 {
        let seen = window.step("Up");
        assert_eq!(seen.pos, [0.0, -150.0 + 5.0 * f64::from(press), 50.0]);
    }
    // As fast as can be: poses may come together, steps may not get lost.
    window.key(&"Down ".repeat(20));
    let back = settled(&mut window, |pose| pose.pos[1] <= -150.0);
    assert_eq!(back.bits(), START.bits());
    stands(&mut window);
    window.close();
}

/// The camera is where it was last seen, and stays there: the next thing that moves it is a key that moves it now.
#[track_caller]
fn stands(window: &mut Window) {
    let View { pose, reference } = View { pose: window.pose, ..AT_START };
    let seen = window.step("Right");
    View { pose, reference }.check("Right, to see that nothing else moves", Moves(R, 5.0), 1.0, seen);
}

#[test]
fn a_busy_machine_makes_no_long_press_of_a_short_one() {
    let folder = folder(32);
    let mut window = Window::open(&folder, "scene.txt");
    window.display.xdotool("keydown Up");
    assert_eq!(window.camera().pos, [0.0, -145.0, 50.0]);
    window.signal("STOP");
    window.display.xdotool("keyup Up");
    std::thread::sleep(Duration::from_millis(700));
    window.signal("CONT");
    stands(&mut window);
    window.close();
}

#[test]
fn a_key_that_stays_down_moves_on_smoothly_and_stops_with_it() {
    let folder = folder(32);
    let mut window = Window::open(&folder, "scene.txt");
    let before_down = Instant::now();
    window.display.xdotool("keydown Up");
    assert_eq!(window.camera().pos, [0.0, -145.0, 50.0], "a step at once");
    let down = Instant::now();
    let mut poses = Vec::new();
    while down.elapsed() < Duration::from_millis(1200) {
        poses.push(window.camera());
    }
    let before_up = Instant::now();
    window.display.xdotool("keyup Up");
    window.display.xdotool("key Right");
    let last = settled(&mut window, |pose| pose.pos[0] != 0.0);
    let up = Instant::now();

    assert_eq!(last.pos[0], 5.0);
    assert!(poses.is_sorted_by(|a, b| a.pos[1] < b.pos[1]), "{poses:?}");
    assert!(poses.len() > 5, "only {} poses in a second", poses.len());
    // 12 steps a second from 0.3 s on. The window has seen the key go down and up between these moments.
    let way = |long: Duration| 5.0 + 60.0 * (long.as_secs_f64() - 0.3);
    let [least, most] = [way(before_up - down), way(up - before_down)];
    let seen = last.pos[1] + 150.0;
    assert!((least..=most).contains(&seen), "{seen} is not between {least} and {most}");
    stands(&mut window);
    window.close();
}

#[test]
fn keys_stop_with_the_focus_and_do_not_come_back_with_it() {
    let folder = folder(32);
    let mut window = Window::open(&folder, "scene.txt");
    window.display.xdotool("keydown Up");
    window.camera();
    window.display.take_focus_away();
    window.focus();
    window.forget();
    // Still down. What it did before the focus went is over; a pose is due only if it moves on.
    window.key("x");
    window.event("switched");
    let seen = window.step("Home");
    assert_eq!(seen.bits(), START.bits());
    stands(&mut window);
    window.close();
}

#[test]
fn a_key_that_was_pressed_elsewhere_asks_this_window_for_nothing() {
    let folder = folder(32);
    let mut window = Window::open(&folder, "scene.txt");
    for key in ["x", "Up", "0", "ctrl+q"] {
        window.display.take_focus_away();
        let down = key.replace('+', " keydown ");
        window.display.xdotool(&format!("keydown {down}"));
        window.focus();
        let up = key.replace('+', " keyup ");
        window.display.xdotool(&format!("keyup {up}"));
        window.key("l");
        window.event_where("switched", |event| event["what"] == "lights");
    }
    stands(&mut window);
    assert_eq!(window.unasked(), []);
    window.close();
}

#[test]
fn the_number_pad_and_capital_letters() {
    let folder = folder(32);
    let mut window = Window::open(&folder, "scene.txt");
    let mut view = AT_START;
    // Without Num Lock: keys by their codes, since xdotool turns Num Lock on to find a digit.
    let pad = [(80, "Up"), (88, "Down"), (85, "Right"), (83, "Left"), (81, "Prior"), (89, "Next")];
    for (code, name) in pad {
        let (_, does) = KEYS.into_iter().find(|(key, _)| *key == name).unwrap();
        let seen = window.step(&code.to_string());
        view = view.check(&format!("{name} on the number pad"), does, 1.0, seen);
    }
    window.key("79");
    window.key("Num_Lock");
    for (code, digit) in [(87, "1"), (88, "2"), (89, "3"), (83, "4"), (84, "5"), (85, "6")] {
        let (_, does) = KEYS.into_iter().find(|(key, _)| *key == digit).unwrap();
        let seen = window.step(&code.to_string());
        view = view.check(&format!("{digit} on the number pad"), does, 1.0, seen);
    }
    window.key("Num_Lock");
    // Shift makes a capital, and makes it faster; Caps Lock makes a capital only.
    let seen = window.step("W");
    view = view.check("W", Raises(5.0), 5.0, seen);
    window.key("Caps_Lock");
    let seen = window.step("w");
    view.check("w with Caps Lock", Raises(5.0), 1.0, seen);
    window.close();
}

#[test]
fn switches_switch_once_a_press_however_long_it_is() {
    let folder = folder(32);
    let mut window = Window::open(&folder, "scene.txt");
    let switched = |window: &mut Window| {
        let event = window.event("switched");
        (event["what"].as_str().unwrap().to_owned(), event["on"].as_bool().unwrap())
    };
    for (key, what, at_start) in
        [("space", "texture", false), ("l", "lights", true), ("x", "axes", true), ("F1", "panel", false)]
    {
        for on in [!at_start, at_start] {
            window.key(key);
            assert_eq!(switched(&mut window), (what.to_owned(), on));
        }
    }
    // Longer than the server waits before it repeats a key.
    window.display.xdotool("keydown x");
    std::thread::sleep(Duration::from_millis(1200));
    window.display.xdotool("keyup x");
    window.key("l");
    assert_eq!(switched(&mut window), ("axes".into(), false));
    assert_eq!(switched(&mut window), ("lights".into(), false));
    window.close();
}

#[test]
fn insert_reads_the_file_again_and_leaves_the_camera() {
    let folder = folder(32);
    let mut window = Window::open(&folder, "scene.txt");
    window.step("Up");
    window.key("Insert");
    let event = window.event("reloaded");
    assert_eq!((event["path"].as_str(), event["changed"].as_bool()), (Some("scene.txt"), Some(false)));
    stands(&mut window);
    window.close();
}

use bevy_ecs::world::World;
use glam::DVec3;
use winit::dpi::PhysicalPosition;
use winit::event::MouseScrollDelta;
use winit::keyboard::{KeyCode, NativeKey, NativeKeyCode};

use super::event::PLACES;
use super::*;
use crate::components::{CameraInput, CameraPose, Lens};
use crate::systems::control_schedule;
use crate::viewer::held::{DELAY, RATE};

const NONE: Modifiers = Modifiers { shift: false, ctrl: false, other: false };
const SHIFT: Modifiers = Modifiers { shift: true, ..NONE };
const CTRL: Modifiers = Modifiers { ctrl: true, ..NONE };
const BOTH: Modifiers = Modifiers { shift: true, ctrl: true, other: false };
const NOWHERE: PhysicalKey = PhysicalKey::Unidentified(NativeKeyCode::Unidentified);

fn sign(text: &str) -> Key {
    Key::Character(text.into())
}

/// What a key with this sign asks for, wherever it is.
fn typed(text: &str, modifiers: Modifiers) -> Option<Command> {
    command(&sign(text), NOWHERE, modifiers)
}

fn named(name: NamedKey, modifiers: Modifiers) -> Option<Command> {
    command(&Key::Named(name), NOWHERE, modifiers)
}

/// A pose whose three directions have no zero component.
fn start() -> CameraPose {
    let position = DVec3::new(3.0, -20.0, 7.5);
    CameraPose::looking(position, DVec3::new(1.0, 2.0, -0.5), DVec3::new(0.2, 0.3, 1.0)).unwrap()
}

/// The pose after one press of a key, by way of the schedule.
fn pressed(key: &Key) -> CameraPose {
    let Some(Command::Camera(step)) = command(key, NOWHERE, NONE) else { panic!("{key:?} moves no camera") };
    let mut world = World::new();
    let lens = Lens { near: 1.0, far: 1000.0, fovy: 60.0, aspect: 1.0 };
    let camera = world.spawn((start(), lens)).id();
    world.insert_resource(CameraInput(vec![step]));
    control_schedule().run(&mut world);
    *world.get::<CameraPose>(camera).unwrap()
}

/// Where the table has the camera after a press.
fn is_at(key: &Key, position: DVec3, [l, r, u]: [DVec3; 3]) {
    let found = pressed(key);
    assert_eq!(found.position, position, "{key:?}");
    for (found, expected) in [found.l, found.r, found.u].into_iter().zip([l, r, u]) {
        assert!(found.distance(expected) <= 4.0 * f64::EPSILON, "{key:?}: {found:?} {expected:?}");
    }
}

#[test]
fn keys_that_move_go_five_units_along_an_axis_to_the_bit() {
    let CameraPose { position, l, r, u } = start();
    for (name, away) in [
        (NamedKey::ArrowUp, 5.0 * l),
        (NamedKey::ArrowDown, -5.0 * l),
        (NamedKey::ArrowRight, 5.0 * r),
        (NamedKey::ArrowLeft, -5.0 * r),
        (NamedKey::PageUp, 5.0 * u),
        (NamedKey::PageDown, -5.0 * u),
    ] {
        assert_eq!(
            pressed(&Key::Named(name)),
            CameraPose { position: position + away, ..start() },
            "{name:?}"
        );
    }
}

#[test]
fn digits_turn_by_five_degrees_about_one_axis() {
    let CameraPose { position, l, r, u } = start();
    let (sine, cosine) = 5.0_f64.to_radians().sin_cos();
    for (digits, sine) in [(["1", "3", "5"], sine), (["2", "4", "6"], -sine)] {
        let [turn, look, tilt] = digits.map(sign);
        is_at(&turn, position, [l * cosine - r * sine, r * cosine + l * sine, u]);
        is_at(&look, position, [l * cosine + u * sine, r, u * cosine - l * sine]);
        is_at(&tilt, position, [l, r * cosine - u * sine, u * cosine + r * sine]);
    }
}

#[test]
fn w_and_s_move_the_eye_along_z_and_keep_the_point_150_units_ahead() {
    for (key, height) in [("w", 5.0), ("s", -5.0)] {
        let raised = pressed(&sign(key));
        let point = start().position + 150.0 * start().l;
        assert_eq!(raised.position, start().position + DVec3::Z * height);
        assert!(raised.l.distance((point - raised.position).normalize()) <= 4.0 * f64::EPSILON);
        assert!(raised.r.cross(raised.l).distance(raised.u) <= 4.0 * f64::EPSILON);
        // The smallest rotation turns about what is perpendicular to both looks.
        let axis = start().l.cross(raised.l).normalize();
        for (before, after) in [(start().r, raised.r), (start().u, raised.u)] {
            assert!((before.dot(axis) - after.dot(axis)).abs() <= 1e-14, "{key}");
        }
    }
}

#[test]
fn home_goes_back_to_the_start() {
    assert_eq!(pressed(&Key::Named(NamedKey::Home)), CameraPose::default());
}

#[test]
fn every_camera_key_of_the_table_is_tested_here() {
    let moves = |binding: &&Binding| matches!(binding.command, Command::Camera(_));
    assert_eq!(KEYS.iter().flat_map(|row| row.bindings).filter(moves).count(), 6 + 6 + 2 + 1);
}

#[test]
fn commands_have_their_keys() {
    for (name, expected) in [
        (NamedKey::Insert, Command::Reload),
        (NamedKey::Escape, Command::Cancel),
        (NamedKey::Space, Command::ToggleTexture),
        (NamedKey::F1, Command::TogglePanel),
        (NamedKey::F2, Command::Save),
        (NamedKey::Delete, Command::Delete),
    ] {
        assert_eq!(named(name, NONE), Some(expected));
    }
    for (key, expected) in [
        ("0", Command::Trace),
        ("t", Command::NextMode),
        ("l", Command::ToggleLights),
        ("x", Command::ToggleAxes),
    ] {
        assert_eq!(typed(key, NONE), Some(expected));
        assert_eq!(typed(key, SHIFT), Some(expected));
        assert_eq!(typed(key, CTRL), None, "ctrl+{key} is something else");
    }
}

#[test]
fn chords_need_their_modifiers() {
    for (key, modifiers, expected) in [
        ("z", CTRL, Some(Command::Undo)),
        ("z", BOTH, Some(Command::Redo)),
        ("y", CTRL, Some(Command::Redo)),
        ("d", CTRL, Some(Command::Duplicate)),
        ("q", CTRL, Some(Command::Quit)),
        ("q", BOTH, None),
        ("z", NONE, None),
        ("y", SHIFT, None),
        ("d", NONE, None),
        ("q", NONE, None),
    ] {
        assert_eq!(typed(key, modifiers), expected, "{key} {modifiers:?}");
    }
}

#[test]
fn shift_and_ctrl_set_the_speed_and_leave_the_step() {
    for modifiers in [NONE, SHIFT, CTRL, BOTH] {
        assert_eq!(typed("w", modifiers), Some(Command::Camera(CameraMove::Raise(5.0))));
        assert_eq!(typed("1", modifiers), Some(Command::Camera(CameraMove::Turn(5.0))));
    }
    assert_eq!([NONE, SHIFT, CTRL, BOTH].map(Modifiers::speed), [1.0, 5.0, 0.1, 0.5]);
}

#[test]
fn chords_with_alt_or_the_systems_key_are_the_desktops() {
    let state = |flags: ModifiersState| Modifiers::from(flags);
    assert_eq!(state(ModifiersState::SHIFT | ModifiersState::CONTROL), BOTH);
    for other in [ModifiersState::ALT, ModifiersState::SUPER] {
        assert_eq!(typed("0", state(other)), None);
        assert_eq!(named(NamedKey::ArrowLeft, state(other)), None);
        assert_eq!(typed("q", state(other | ModifiersState::CONTROL)), None);
    }
}

#[test]
fn letters_count_in_either_case() {
    assert_eq!(typed("W", NONE), typed("w", NONE));
    assert_eq!(typed("Z", CTRL), Some(Command::Undo));
}

#[test]
fn layouts_that_hide_digits_behind_shift_have_them_all_the_same() {
    // French, Czech and Arabic rows of digits.
    for (text, place, digit) in [
        ("&", KeyCode::Digit1, "1"),
        ("é", KeyCode::Digit2, "2"),
        ("à", KeyCode::Digit0, "0"),
        ("+", KeyCode::Digit1, "1"),
        ("\u{665}", KeyCode::Digit5, "5"),
    ] {
        assert_eq!(command(&sign(text), place.into(), NONE), typed(digit, NONE), "{text}");
        assert!(typed(digit, NONE).is_some());
    }
    // A digit that is there counts, wherever it is; signs elsewhere mean nothing.
    assert_eq!(command(&sign("3"), KeyCode::Digit4.into(), NONE), typed("3", NONE));
    assert_eq!(command(&sign("&"), KeyCode::KeyQ.into(), NONE), None);
    assert_eq!(command(&sign("7"), KeyCode::Digit5.into(), NONE), None);
}

#[test]
fn letters_go_by_what_is_on_the_key_and_by_place_only_without_latin_ones() {
    // German: y and z are swapped. French: w is where z is.
    assert_eq!(command(&sign("z"), KeyCode::KeyY.into(), CTRL), Some(Command::Undo));
    assert_eq!(command(&sign("z"), KeyCode::KeyW.into(), NONE), None);
    assert_eq!(command(&sign("w"), KeyCode::KeyZ.into(), NONE), typed("w", NONE));
    // Bépo has an é in the place of w, and a w of its own.
    assert_eq!(command(&sign("é"), KeyCode::KeyW.into(), NONE), None);
    // Russian and Greek.
    assert_eq!(command(&sign("ц"), KeyCode::KeyW.into(), NONE), typed("w", NONE));
    assert_eq!(command(&sign("я"), KeyCode::KeyZ.into(), CTRL), Some(Command::Undo));
    assert_eq!(command(&sign("σ"), KeyCode::KeyS.into(), NONE), typed("s", NONE));
}

#[test]
fn the_number_pad_has_digits_or_arrows_as_num_lock_says() {
    assert_eq!(command(&sign("5"), KeyCode::Numpad5.into(), NONE), typed("5", NONE));
    let arrow = command(&Key::Named(NamedKey::ArrowUp), KeyCode::Numpad8.into(), NONE);
    assert_eq!(arrow, Some(Command::Camera(CameraMove::Forward(5.0))));
}

#[test]
fn other_keys_ask_for_nothing() {
    for key in
        [sign(""), sign("a"), sign("\u{1}"), Key::Dead(Some('^')), Key::Unidentified(NativeKey::Xkb(9))]
    {
        assert_eq!(command(&key, KeyCode::KeyA.into(), NONE), None, "{key:?}");
    }
    assert_eq!(named(NamedKey::Enter, NONE), None);
}

#[test]
fn no_two_bindings_answer_to_the_same_keys() {
    let bindings: Vec<&Binding> = KEYS.iter().flat_map(|row| row.bindings).collect();
    for modifiers in [NONE, SHIFT, CTRL, BOTH] {
        for (index, first) in bindings.iter().enumerate() {
            for second in &bindings[..index] {
                let both = modifiers.fit(first.chord) && modifiers.fit(second.chord);
                assert!(!(both && first.cap == second.cap), "{:?} {modifiers:?}", first.cap);
            }
        }
    }
}

#[test]
fn every_letter_and_digit_of_the_table_has_its_place_on_a_plain_keyboard() {
    for binding in KEYS.iter().flat_map(|row| row.bindings) {
        if let Sign(sign) = binding.cap {
            assert!(PLACES.iter().any(|&(_, there)| there == sign), "{sign}");
        }
    }
}

#[test]
fn a_key_is_told_from_every_other_by_its_place() {
    let mut places: Vec<PhysicalKey> = PLACES.iter().map(|&(code, _)| code.into()).collect();
    places.extend([KeyCode::Numpad1, KeyCode::F35, KeyCode::ArrowUp].map(PhysicalKey::from));
    places.extend([0, 1, 255].map(|code| PhysicalKey::Unidentified(NativeKeyCode::Xkb(code))));
    places.push(NOWHERE);
    let ids: Vec<KeyId> = places.into_iter().map(KeyId::from).collect();
    for (index, id) in ids.iter().enumerate() {
        assert!(!ids[..index].contains(id), "{id:?}");
    }
}

#[test]
fn the_wheel_counts_lines_and_a_touchpad_pixels() {
    assert_eq!(wheel_lines(MouseScrollDelta::LineDelta(9.0, -2.0)), -2.0);
    assert_eq!(wheel_lines(MouseScrollDelta::PixelDelta(PhysicalPosition::new(9.0, 100.0))), 2.5);
}

/// The README's section: the table, and what a press is.
fn section() -> String {
    let mut text = String::from("| key | does |\n|---|---|\n");
    for (keys, does) in help() {
        text += &format!("| {keys} | {does} |\n");
    }
    let delay = DELAY.as_secs_f64();
    text += &format!(
        "\nA press is one step: {STEP} units or {STEP} degrees. A key that stays down moves on after "
    );
    text += &format!("{delay} s, {RATE} steps a second.\n");
    text
}

#[test]
fn the_readme_has_this_table() {
    let readme = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/README.md")).unwrap();
    let between =
        readme.split_once("<!-- keys -->\n").and_then(|(_, rest)| rest.split_once("<!-- end of keys -->"));
    let (found, _) = between.expect("README.md has both marks");
    assert_eq!(found, section(), "README.md and src/viewer/keys.rs differ; the right one is\n{}", section());
}

#[test]
fn the_words_of_the_table_have_its_numbers() {
    let words = format!("{FAST} times / a tenth as far");
    assert!(help().contains(&("shift / ctrl with these".into(), words)));
    assert_eq!(FINE, 0.1);
}

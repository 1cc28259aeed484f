//! Events of the window library to what the table knows: keys by what is on them, and wheel lines.

use winit::event::{ElementState, KeyEvent, MouseScrollDelta};
use winit::keyboard::{Key, KeyCode, KeyLocation, NativeKeyCode, PhysicalKey};
use winit::platform::modifier_supplement::KeyEventExtModifierSupplement;

use super::{Cap, Command, Modifiers, Named, Sign, command};

/// A key by its place on the keyboard: the same when it is let go, whatever modifiers came or went meanwhile.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct KeyId(pub(crate) u64);

impl From<PhysicalKey> for KeyId {
    fn from(place: PhysicalKey) -> Self {
        /// Above every known code.
        const NATIVE: u64 = 1 << 32;
        Self(match place {
            PhysicalKey::Code(code) => code as u64,
            PhysicalKey::Unidentified(NativeKeyCode::Android(code) | NativeKeyCode::Xkb(code)) => {
                NATIVE | u64::from(code)
            }
            PhysicalKey::Unidentified(NativeKeyCode::MacOS(code) | NativeKeyCode::Windows(code)) => {
                NATIVE | u64::from(code)
            }
            PhysicalKey::Unidentified(NativeKeyCode::Unidentified) => u64::MAX,
        })
    }
}

/// A key that went down or up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct KeyStroke {
    /// Which one.
    pub(crate) key: KeyId,
    /// Down, or up.
    pub(crate) down: bool,
    /// Said again by the system because the key is still down.
    pub(crate) again: bool,
    /// What it asks for, if anything.
    pub(crate) command: Option<Command>,
}

/// Reads a key event.
pub(crate) fn read(event: &KeyEvent, modifiers: Modifiers) -> KeyStroke {
    // Without modifiers, so that 1 is 1 with shift as well. The number pad needs one, Num Lock, to have digits.
    let key = match event.location {
        KeyLocation::Numpad => event.logical_key.clone(),
        _ => event.key_without_modifiers(),
    };
    KeyStroke {
        key: event.physical_key.into(),
        down: event.state == ElementState::Pressed,
        again: event.repeat,
        command: command(&key, event.physical_key, modifiers),
    }
}

/// What is on a key; where the layout hides digits behind shift, or has no Latin letters, what a plain keyboard has in
/// the same place.
pub(super) fn cap(key: &Key, place: PhysicalKey) -> Option<Cap> {
    match key {
        Key::Named(name) => Some(Named(*name)),
        Key::Character(text) => {
            let sign = text.chars().next()?.to_ascii_lowercase();
            let there =
                PLACES.iter().find(|(code, _)| place == PhysicalKey::Code(*code)).map(|(_, sign)| *sign);
            let stands_in = |plain: &char| is_foreign(sign) || is_punctuation(sign) && plain.is_ascii_digit();
            Some(Sign(there.filter(stands_in).unwrap_or(sign)))
        }
        _ => None,
    }
}

/// Of another script than Latin.
fn is_foreign(sign: char) -> bool {
    sign >= '\u{370}'
}

/// Neither a Latin letter that a binding may name nor a digit.
fn is_punctuation(sign: char) -> bool {
    !sign.is_ascii_alphanumeric()
}

/// Digits and the table's letters on a plain keyboard.
pub(super) const PLACES: [(KeyCode, char); 23] = [
    (KeyCode::Digit0, '0'),
    (KeyCode::Digit1, '1'),
    (KeyCode::Digit2, '2'),
    (KeyCode::Digit3, '3'),
    (KeyCode::Digit4, '4'),
    (KeyCode::Digit5, '5'),
    (KeyCode::Digit6, '6'),
    (KeyCode::Digit7, '7'),
    (KeyCode::Digit8, '8'),
    (KeyCode::Digit9, '9'),
    (KeyCode::KeyD, 'd'),
    (KeyCode::KeyF, 'f'),
    (KeyCode::KeyG, 'g'),
    (KeyCode::KeyH, 'h'),
    (KeyCode::KeyI, 'i'),
    (KeyCode::KeyL, 'l'),
    (KeyCode::KeyQ, 'q'),
    (KeyCode::KeyS, 's'),
    (KeyCode::KeyT, 't'),
    (KeyCode::KeyW, 'w'),
    (KeyCode::KeyX, 'x'),
    (KeyCode::KeyY, 'y'),
    (KeyCode::KeyZ, 'z'),
];

/// Lines that the wheel was turned away from the hand, or a touchpad's pixels as lines.
pub(crate) fn wheel_lines(delta: MouseScrollDelta) -> f64 {
    /// As much as common toolkits scroll by one notch.
    const PIXELS_PER_LINE: f64 = 40.0;
    match delta {
        MouseScrollDelta::LineDelta(_, lines) => f64::from(lines),
        MouseScrollDelta::PixelDelta(pixels) => pixels.y / PIXELS_PER_LINE,
    }
}

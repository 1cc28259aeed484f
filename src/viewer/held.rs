//! Keys held down, and the mouse, to moves of the camera. Times are arguments, counted from any start.
//!
//! A press is one step at once. A key that stays down moves the camera on after [`DELAY`], by elapsed time: once it
//! has begun, what has been handed out up to any moment is the same however often it was asked for.

use core::time::Duration;

use crate::components::{CameraMove, Lens};

use super::keys::{KeyId, STEP};

/// How long a key is down before it moves on.
pub(super) const DELAY: Duration = Duration::from_millis(300);
/// Steps a second from then on.
pub(super) const RATE: f64 = 12.0;

/// The camera keys that are down.
#[derive(Debug)]
pub(super) struct Held {
    keys: Vec<HeldKey>,
    speed: f64,
}

#[derive(Debug)]
struct HeldKey {
    key: KeyId,
    step: CameraMove,
    /// Up to when it has moved the camera, or from when on it will.
    moved: Duration,
    /// Whether it has.
    goes_on: bool,
}

impl Default for Held {
    fn default() -> Self {
        Self { keys: Vec::new(), speed: 1.0 }
    }
}

impl Held {
    /// A key went down: its first step. `None` if it is down already, as when the system repeats it.
    pub(super) fn press(&mut self, key: KeyId, step: CameraMove, now: Duration) -> Option<CameraMove> {
        if self.keys.iter().any(|held| held.key == key) {
            return None;
        }
        self.keys.push(HeldKey { key, step, moved: now.saturating_add(DELAY), goes_on: false });
        Some(times(step, self.speed))
    }

    /// A key went up: what it has moved since the last time. Nothing if it has not begun to: when it went up is known
    /// only by when that is heard of, and a busy moment must not make a long press of a short one.
    pub(super) fn release(&mut self, key: KeyId, now: Duration) -> Option<CameraMove> {
        let index = self.keys.iter().position(|held| held.key == key)?;
        let mut held = self.keys.remove(index);
        if held.goes_on { held.motion(now, self.speed) } else { None }
    }

    /// What all keys have moved since the last time, in the order in which they went down.
    pub(super) fn advance(&mut self, now: Duration) -> Vec<CameraMove> {
        self.keys.iter_mut().filter_map(|held| held.motion(now, self.speed)).collect()
    }

    /// Another speed from now on, and what was moved at the old one.
    pub(super) fn set_speed(&mut self, speed: f64, now: Duration) -> Vec<CameraMove> {
        let moves = self.advance(now);
        self.speed = speed;
        moves
    }

    /// Forgets every key: the focus went elsewhere, and no release will be heard of.
    pub(super) fn clear(&mut self) {
        self.keys.clear();
    }

    /// From when on the camera moves by itself, be it past or to come; `None` if no key makes it.
    pub(super) fn moves_from(&self) -> Option<Duration> {
        self.keys.iter().filter(|held| goes_on(held.step)).map(|held| held.moved).min()
    }

    /// The wheel was turned by some lines, away from the hand: forward.
    pub(super) fn wheel(&self, lines: f64) -> CameraMove {
        times(CameraMove::Forward(STEP), self.speed * lines)
    }
}

impl HeldKey {
    fn motion(&mut self, now: Duration, speed: f64) -> Option<CameraMove> {
        let elapsed = now.checked_sub(self.moved).filter(|elapsed| !elapsed.is_zero())?;
        self.moved = now;
        self.goes_on = true;
        goes_on(self.step).then(|| times(self.step, speed * RATE * elapsed.as_secs_f64()))
    }
}

/// The pointer was dragged by pixels to the right and down over a picture of `side` by `side`. The picture follows: by
/// a whole field of view from edge to edge, and by about as much as the pointer in between.
///
/// The camera turns about the world's z and about its own `r`, so a level horizon stays level.
pub(super) fn drag(right: f64, down: f64, lens: &Lens, side: f64) -> [CameraMove; 2] {
    [CameraMove::Heading(right * lens.fovx() / side), CameraMove::Pitch(down * lens.fovy / side)]
}

/// A move some times as far.
fn times(step: CameraMove, factor: f64) -> CameraMove {
    match step {
        CameraMove::Forward(distance) => CameraMove::Forward(distance * factor),
        CameraMove::Right(distance) => CameraMove::Right(distance * factor),
        CameraMove::Up(distance) => CameraMove::Up(distance * factor),
        CameraMove::Turn(degrees) => CameraMove::Turn(degrees * factor),
        CameraMove::Heading(degrees) => CameraMove::Heading(degrees * factor),
        CameraMove::Pitch(degrees) => CameraMove::Pitch(degrees * factor),
        CameraMove::Tilt(degrees) => CameraMove::Tilt(degrees * factor),
        CameraMove::Raise(height) => CameraMove::Raise(height * factor),
        CameraMove::Home => CameraMove::Home,
    }
}

/// Whether a move can be made bit by bit.
fn goes_on(step: CameraMove) -> bool {
    step != CameraMove::Home
}

#[cfg(test)]
mod tests {
    use super::*;

    const KEY: KeyId = KeyId(7);
    const OTHER: KeyId = KeyId(8);
    const FORWARD: CameraMove = CameraMove::Forward(STEP);

    fn at(milliseconds: u64) -> Duration {
        Duration::from_millis(milliseconds)
    }

    /// Sum of moves that are all forward.
    fn forward(moves: impl IntoIterator<Item = CameraMove>) -> f64 {
        let distance = |asked| match asked {
            CameraMove::Forward(distance) => distance,
            other => panic!("{other:?} is not forward"),
        };
        moves.into_iter().map(distance).sum()
    }

    #[test]
    fn a_press_is_one_step_at_once_and_no_more_when_it_is_short() {
        let mut held = Held::default();
        assert_eq!(held.press(KEY, FORWARD, at(1000)), Some(FORWARD));
        for now in [1000, 1016, 1299, 1300] {
            assert_eq!(held.advance(at(now)), []);
        }
        assert_eq!(held.release(KEY, at(1300)), None);
        assert_eq!(held.advance(at(9000)), []);
    }

    #[test]
    fn repeats_of_the_system_are_no_presses() {
        let mut held = Held::default();
        held.press(KEY, FORWARD, at(0));
        for now in [250, 283, 316] {
            assert_eq!(held.press(KEY, FORWARD, at(now)), None);
        }
        assert_eq!(held.advance(at(1300)), [CameraMove::Forward(12.0 * STEP)]);
        held.release(KEY, at(1300));
        assert_eq!(held.press(KEY, FORWARD, at(1400)), Some(FORWARD));
    }

    #[test]
    fn held_down_it_moves_on_at_twelve_steps_a_second() {
        let mut held = Held::default();
        held.press(KEY, CameraMove::Turn(-STEP), at(0));
        assert_eq!(held.moves_from(), Some(at(300)));
        assert_eq!(held.advance(at(800)), [CameraMove::Turn(-30.0)]);
        assert_eq!(held.moves_from(), Some(at(800)));
        assert_eq!(held.advance(at(800)), []);
        assert_eq!(held.release(KEY, at(1050)), Some(CameraMove::Turn(-15.0)));
        assert_eq!(held.moves_from(), None);
    }

    /// Numbers below a bound, the same on every run (splitmix64).
    fn numbers(mut state: u64) -> impl FnMut(u64) -> u64 {
        move |bound| {
            state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let mixed = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            (mixed ^ (mixed >> 31)) % bound
        }
    }

    /// A key goes down and up (microseconds), with frames in between: how far it went, and in how many moves.
    fn way(down: u64, up: u64, frames: impl IntoIterator<Item = u64>) -> (f64, u32) {
        let at = Duration::from_micros;
        let mut held = Held::default();
        let mut moves = vec![held.press(KEY, FORWARD, at(down)).unwrap()];
        for frame in frames {
            moves.extend(held.advance(at(frame)));
        }
        moves.extend(held.release(KEY, at(up)));
        let count = u32::try_from(moves.len()).unwrap();
        (forward(moves), count)
    }

    #[test]
    fn the_way_does_not_depend_on_the_frames() {
        for seed in 0..2_000 {
            let mut number = numbers(seed);
            let (down, long) = (number(1_000_000), number(3_000_000));
            let up = down + long;
            let mut frames: Vec<u64> = (0..number(200)).map(|_| number(up + 1)).collect();
            // One frame at least sees the key move on.
            frames.extend((long > 300_000).then_some(down + 300_001));
            frames.sort_unstable();
            let (found, moves) = way(down, up, frames);
            let seconds = Duration::from_micros(long.saturating_sub(300_000)).as_secs_f64();
            let expected = 5.0 + 5.0 * 12.0 * seconds;
            // Each frame rounds its share in three steps, and the sum once.
            let rounding = f64::from(2 * moves) * f64::EPSILON * expected;
            assert!((found - expected).abs() <= rounding, "seed {seed}: {found} instead of {expected}");
        }
    }

    #[test]
    fn let_go_before_a_frame_saw_it_move_on_it_is_one_step() {
        assert_eq!(way(0, 2_000_000, []), (STEP, 1));
        assert_eq!(way(0, 2_000_000, [100_000, 300_000]), (STEP, 1));
        assert_eq!(way(0, 1_300_000, [800_000]), (13.0 * STEP, 3));
    }

    #[test]
    fn a_second_is_twelve_steps_at_every_frame_rate() {
        for rate in [1, 7, 24, 60, 144, 1000] {
            let frames = (1..=rate).map(|frame| 300_000 + frame * 1_000_000 / rate);
            let (found, _) = way(0, 1_300_000, frames);
            assert!((found - 65.0).abs() <= 1e-12, "{rate} frames a second: {found}");
        }
    }

    #[test]
    fn several_keys_move_side_by_side_in_the_order_of_their_presses() {
        let mut held = Held::default();
        held.press(KEY, FORWARD, at(0));
        held.press(OTHER, CameraMove::Pitch(STEP), at(250));
        assert_eq!(held.moves_from(), Some(at(300)));
        assert_eq!(held.advance(at(800)), [CameraMove::Forward(30.0), CameraMove::Pitch(15.0)]);
        assert_eq!(held.release(KEY, at(800)), None);
        assert_eq!(held.advance(at(1050)), [CameraMove::Pitch(15.0)]);
    }

    #[test]
    fn the_speed_is_the_one_of_the_moment() {
        let mut held = Held::default();
        assert_eq!(held.set_speed(5.0, at(0)), []);
        assert_eq!(held.press(KEY, FORWARD, at(0)), Some(CameraMove::Forward(25.0)));
        assert_eq!(held.set_speed(1.0, at(800)), [CameraMove::Forward(150.0)]);
        assert_eq!(held.set_speed(0.1, at(1300)), [CameraMove::Forward(30.0)]);
        assert!((forward(held.advance(at(1800))) - 3.0).abs() <= 4.0 * f64::EPSILON);
        assert_eq!(held.wheel(2.0), CameraMove::Forward(1.0));
        assert_eq!(held.press(OTHER, CameraMove::Raise(-STEP), at(1800)), Some(CameraMove::Raise(-0.5)));
    }

    #[test]
    fn home_is_done_once_however_long_it_is_held() {
        let mut held = Held::default();
        held.set_speed(5.0, at(0));
        assert_eq!(held.press(KEY, CameraMove::Home, at(0)), Some(CameraMove::Home));
        assert_eq!(held.moves_from(), None);
        assert_eq!(held.press(KEY, CameraMove::Home, at(400)), None);
        assert_eq!(held.advance(at(900)), []);
        assert_eq!(held.release(KEY, at(1000)), None);
    }

    #[test]
    fn cleared_nothing_moves_on_and_a_late_release_is_no_news() {
        let mut held = Held::default();
        held.press(KEY, FORWARD, at(0));
        held.clear();
        assert_eq!(held.moves_from(), None);
        assert_eq!(held.advance(at(5000)), []);
        assert_eq!(held.release(KEY, at(5000)), None);
        assert_eq!(held.press(KEY, FORWARD, at(6000)), Some(FORWARD));
    }

    #[test]
    fn a_clock_that_stands_or_goes_back_moves_nothing() {
        let mut held = Held::default();
        held.press(KEY, FORWARD, at(1000));
        held.advance(at(2000));
        assert_eq!(held.advance(at(1500)), []);
        assert_eq!(held.advance(at(2000)), []);
        assert_eq!(held.advance(at(2250)), [CameraMove::Forward(15.0)]);
        held.press(OTHER, FORWARD, Duration::MAX);
    }

    #[test]
    fn the_picture_follows_the_pointer() {
        let lens = Lens { near: 1.0, far: 1000.0, fovy: 60.0, aspect: 0.5 };
        // To the right edge from the left one: what was at the left is at the right.
        assert_eq!(drag(800.0, 0.0, &lens, 800.0), [CameraMove::Heading(30.0), CameraMove::Pitch(0.0)]);
        assert_eq!(drag(0.0, -400.0, &lens, 800.0), [CameraMove::Heading(0.0), CameraMove::Pitch(-30.0)]);
    }

    #[test]
    fn the_wheel_goes_forward_by_lines() {
        let mut held = Held::default();
        assert_eq!(held.wheel(1.0), FORWARD);
        assert_eq!(held.wheel(-2.5), CameraMove::Forward(-12.5));
        held.set_speed(5.0, at(0));
        assert_eq!(held.wheel(1.0), CameraMove::Forward(25.0));
    }
}

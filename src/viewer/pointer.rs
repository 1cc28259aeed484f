//! The mouse: a drag looks around, a click selects.

/// Pixels that a pressed pointer may move and still have clicked.
const CLICK_RADIUS: f64 = 4.0;

/// Where the pointer is and what its button does.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Pointer {
    at: (f64, f64),
    press: Option<Press>,
}

#[derive(Clone, Copy, Debug)]
struct Press {
    start: (f64, f64),
    is_drag: bool,
}

impl Pointer {
    /// Where it is, in pixels from the window's left upper corner.
    pub(super) fn at(&self) -> (f64, f64) {
        self.at
    }

    /// The pointer moved to a position in pixels. Returns by how much, if that looks around.
    pub(super) fn moved(&mut self, to: (f64, f64)) -> Option<(f64, f64)> {
        let from = std::mem::replace(&mut self.at, to);
        let press = self.press.as_mut()?;
        if press.is_drag {
            return Some((to.0 - from.0, to.1 - from.1));
        }
        let (dx, dy) = (to.0 - press.start.0, to.1 - press.start.1);
        press.is_drag = dx.hypot(dy) > CLICK_RADIUS;
        press.is_drag.then_some((dx, dy))
    }

    /// The button went down over the scene.
    pub(super) fn pressed(&mut self) {
        self.press = Some(Press { start: self.at, is_drag: false });
    }

    /// The button went up. Returns where, if that was a click.
    pub(super) fn released(&mut self) -> Option<(f64, f64)> {
        let press = self.press.take()?;
        (!press.is_drag).then_some(self.at)
    }

    /// The button no longer counts, as when the window lost the focus.
    pub(super) fn cancel(&mut self) {
        self.press = None;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_press_that_hardly_moves_is_a_click() {
        let mut pointer = Pointer::default();
        pointer.moved((10.0, 10.0));
        pointer.pressed();
        assert_eq!(pointer.moved((12.0, 13.0)), None);
        assert_eq!(pointer.released(), Some((12.0, 13.0)));
        assert_eq!(pointer.released(), None);
    }

    #[test]
    fn a_drag_tells_every_pixel_once_and_is_no_click() {
        let mut pointer = Pointer::default();
        pointer.moved((10.0, 10.0));
        pointer.pressed();
        assert_eq!(pointer.moved((13.0, 10.0)), None);
        assert_eq!(pointer.moved((20.0, 10.0)), Some((10.0, 0.0)));
        assert_eq!(pointer.moved((20.0, 7.0)), Some((0.0, -3.0)));
        assert_eq!(pointer.released(), None);
    }

    #[test]
    fn without_a_press_nothing_looks_around() {
        let mut pointer = Pointer::default();
        assert_eq!(pointer.moved((50.0, 10.0)), None);
        pointer.pressed();
        pointer.cancel();
        assert_eq!(pointer.moved((90.0, 10.0)), None);
        assert_eq!(pointer.released(), None);
    }
}

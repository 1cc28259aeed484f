//! What surrounds all objects.

use crate::effects::{Effect, Gradient, Haze, Rgb};
use crate::geometry::{Real, Vector};

use super::kernel::known;

/// What lies beyond all surfaces, and between them; what does nothing is not there.
#[derive(Clone, Copy, Debug, Default)]
pub struct Air<T> {
    /// Light from where there is no surface.
    pub background: Option<Gradient<T>>,
    /// Fog.
    pub haze: Option<Haze<T>>,
}

impl<T: Real> Air<T> {
    /// Whether there is neither.
    pub fn is_empty(&self) -> bool {
        self.background.is_none() && self.haze.is_none()
    }

    /// What code for these effects knows of it.
    #[inline(always)]
    pub(super) fn of_kernel<const EFFECTS: u32>(&self) -> Self {
        Self {
            background: known::<EFFECTS, _>(Effect::Background, self.background),
            haze: known::<EFFECTS, _>(Effect::Fog, self.haze),
        }
    }

    /// The light that arrives from a unit direction in which there is no surface.
    #[inline(always)]
    pub(super) fn beyond(&self, direction: Vector<T>) -> Rgb<T> {
        match (&self.haze, &self.background) {
            (Some(haze), _) => haze.color,
            (None, Some(background)) => background.toward(direction),
            (None, None) => Rgb::BLACK,
        }
    }
}

/// One row, and the memory that it takes, if it is there.
pub(super) fn size<R>(row: Option<&R>) -> (usize, usize) {
    row.map_or((0, 0), |row| (1, size_of_val(row)))
}

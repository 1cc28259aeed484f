//! What surrounds all objects.

use crate::effects::{Effect, EffectSet, Gradient, Haze, Rgb};
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

    /// The effects that are there.
    pub fn effects(&self) -> EffectSet {
        let present = [(Effect::Background, self.background.is_some()), (Effect::Fog, self.haze.is_some())];
        EffectSet::present(&present)
    }

    /// The light that arrives from a unit direction in which there is no surface, if any, as far as code for these effects
    /// knows.
    #[inline(always)]
    fn beyond<const EFFECTS: u32>(&self, direction: Vector<T>) -> Option<Rgb<T>> {
        let haze = known::<EFFECTS, _>(Effect::Fog, self.haze.as_ref());
        let background = known::<EFFECTS, _>(Effect::Background, self.background.as_ref());
        haze.map(|haze| haze.color).or_else(|| background.map(|background| background.toward(direction)))
    }
}

/// Adds the light from a unit direction in which there is no surface, of which a share arrives.
pub(super) fn look_beyond<T: Real, const EFFECTS: u32>(
    air: &Air<T>,
    direction: Vector<T>,
    share: Rgb<T>,
    found: &mut Rgb<T>,
) {
    if let Some(light) = air.beyond::<EFFECTS>(direction) {
        *found += light * share;
    }
}

/// One row, and the memory that it takes, if it is there.
pub(super) fn size<R>(row: Option<&R>) -> (usize, usize) {
    row.map_or((0, 0), |row| (1, size_of_val(row)))
}

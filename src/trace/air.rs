//! What surrounds all objects.

use crate::effects::{Effect, EffectSet, Rgb, RowOf, survey};
use crate::geometry::{Real, Vector};

use super::effect_rows::define_rows;
use super::kernel::known;

survey! {
    air, define_rows
    /// What lies beyond all surfaces, and between them; what does nothing is not there.
    #[derive(Clone, Copy, Debug)]
    Air
}

impl<T: Real> Air<T> {
    /// Whether there is nothing.
    pub fn is_empty(&self) -> bool {
        self.set().is_empty()
    }

    /// The light that arrives from a unit direction in which there is no surface, if any, as far as code for these effects
    /// knows.
    #[inline(always)]
    fn beyond<const EFFECTS: u32>(&self, direction: Vector<T>) -> Option<Rgb<T>> {
        let haze = known::<EFFECTS, _>(Effect::Fog, self.fog.as_ref());
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

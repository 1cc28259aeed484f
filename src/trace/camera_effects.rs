//! What a camera does beyond that of a pinhole.

use crate::components::{Aperture, ExposureStops};
use crate::effects::{Effect, EffectSet, Transfer};

use super::EffectCount;

/// The effects of a camera; what does nothing is not there.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CameraEffects {
    /// The width of its lens.
    pub aperture: Option<Aperture>,
    /// How often all light counts.
    pub exposure: Option<ExposureStops>,
    /// What becomes of light in 8 bits.
    pub transfer: Transfer,
}

impl CameraEffects {
    /// Which effects these are.
    pub fn set(&self) -> EffectSet {
        let all = [Effect::Aperture, Effect::Exposure, Effect::Srgb];
        all.into_iter().filter(|&effect| self.count(effect).rows > 0).collect()
    }

    /// What an effect takes: one row, or nothing.
    pub fn count(&self, effect: Effect) -> EffectCount {
        let (is_there, size) = match effect {
            Effect::Aperture => (self.aperture.is_some(), size_of::<Aperture>()),
            Effect::Exposure => (self.exposure.is_some(), size_of::<ExposureStops>()),
            Effect::Srgb => (self.transfer == Transfer::Srgb, size_of::<Transfer>()),
            _ => (false, 0),
        };
        let (rows, bytes) = if is_there { (1, size) } else { (0, 0) };
        EffectCount { effect, rows, bytes }
    }

    /// What all light is multiplied by.
    pub fn gain(&self) -> f64 {
        self.exposure.map_or(1.0, |exposure| libm::exp2(exposure.0))
    }
}

//! What a camera does beyond that of a pinhole.

use crate::components::{Aperture, ExposureStops, Shutter};
use crate::effects::{Effect, EffectSet, Transfer};

use super::{EffectCount, SampleGrid};

/// The effects of a camera; what does nothing is not there.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CameraEffects {
    /// The width of its lens.
    pub aperture: Option<Aperture>,
    /// During what time it sees.
    pub shutter: Option<Shutter>,
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

    /// The second that a pass over the picture shows.
    pub fn second(&self, grid: SampleGrid, pass: u32) -> f64 {
        self.shutter.map_or(0.0, |shutter| {
            let share = grid.moment(pass);
            shutter.open + (shutter.close - shutter.open) * share
        })
    }

    /// What all light is multiplied by.
    pub fn gain(&self) -> f64 {
        self.exposure.map_or(1.0, |exposure| libm::exp2(exposure.0))
    }
}

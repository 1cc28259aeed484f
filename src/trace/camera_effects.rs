//! What a camera does beyond that of a pinhole.

use crate::components::Shutter;
use crate::effects::{Effect, EffectSet, RowOf, Transfer, survey};
use crate::geometry::Real;

use super::effect_rows::define_rows;
use super::kernel::known;
use super::{EffectCount, SampleGrid};

survey! {
    camera, define_rows
    /// What a camera does with the light that it sees; what does nothing is not there.
    #[derive(Clone, Copy, Debug, PartialEq)]
    CameraRows
}

/// The effects of a camera.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CameraEffects {
    /// Its own.
    pub rows: CameraRows<f64>,
    /// During what time it sees objects that move; second 0 unless it says so.
    pub shutter: Option<Shutter>,
}

impl CameraEffects {
    /// Which effects these are.
    pub fn set(&self) -> EffectSet {
        self.rows.set()
    }

    /// What an effect takes: one row, or nothing.
    pub fn count(&self, effect: Effect) -> EffectCount {
        let (rows, bytes) = self.rows.size(effect);
        EffectCount { effect, rows, bytes }
    }

    /// What becomes of light in 8 bits.
    pub fn transfer(&self) -> Transfer {
        self.rows.srgb.map_or(Transfer::Linear, |_| Transfer::Srgb)
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
        self.rows.exposure.map_or(1.0, |exposure| libm::exp2(exposure.0))
    }
}

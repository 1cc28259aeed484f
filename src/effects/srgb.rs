//! The transfer curve of sRGB.

use crate::components::SrgbTransfer;
use crate::geometry::Real;

use super::{Bearer, EffectComponent, Number};

impl EffectComponent for SrgbTransfer {
    type Row<T: Real> = Self;

    fn numbers(&self) -> impl IntoIterator<Item = Number> {
        []
    }

    fn does_nothing(&self) -> bool {
        false
    }

    fn row<T: Real>(&self, _bearer: &Bearer<'_>) -> Option<Self> {
        Some(*self)
    }
}

/// What becomes of linear light in a picture of 8 bits a channel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Transfer {
    /// In proportion: 255 times the light, truncated.
    #[default]
    Linear,
    /// By the curve of sRGB, then the same.
    Srgb,
}

/// The least light, 0 to 1, that is shown as each of the 256 levels, by the curve of sRGB (IEC 61966-2-1).
#[derive(Clone, Debug)]
pub struct SrgbLevels([f64; 256]);

impl SrgbLevels {
    /// Computes the table.
    pub fn new() -> Self {
        let mut least = [0.0; 256];
        for (level, light) in (0_u8..=255).zip(&mut least) {
            *light = linear(level);
        }
        Self(least)
    }

    /// The least light that is shown as each level, in ascending order.
    pub fn least_light(&self) -> &[f64; 256] {
        &self.0
    }

    /// The level that light of 0 to 1 is shown as.
    pub fn level(&self, light: f64) -> u8 {
        // All but the first level, 0, which needs no light.
        let reached = self.0[1..].partition_point(|&least| least <= light);
        u8::try_from(reached).unwrap_or(u8::MAX)
    }
}

impl Default for SrgbLevels {
    fn default() -> Self {
        Self::new()
    }
}

/// The light that a level of sRGB stands for: with `v = level / 255`, `v / 12.92` up to `v = 0.04045`, and
/// `((v + 0.055) / 1.055)^2.4` from there. In whole numbers as far as they go, so that little is rounded.
fn linear(level: u8) -> f64 {
    let steps = f64::from(level);
    if level <= 10 { 100.0 * steps / 329_460.0 } else { libm::pow((40.0 * steps + 561.0) / 10_761.0, 2.4) }
}

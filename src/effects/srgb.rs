//! The transfer curve of sRGB.

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
            *light = linear(f64::from(level) / 255.0);
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

/// The light that a value of sRGB, 0 to 1, stands for.
fn linear(encoded: f64) -> f64 {
    if encoded <= 0.04045 { encoded / 12.92 } else { libm::pow((encoded + 0.055) / 1.055, 2.4) }
}

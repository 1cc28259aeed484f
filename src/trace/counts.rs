//! What a frame did, counted.

use core::ops::AddAssign;

/// Rays traced, by kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RayCounts {
    /// From the camera: one a sample, none at level 0.
    pub primary: u64,
    /// Towards a light.
    pub shadow: u64,
    /// Off a mirror or off glass.
    pub mirror: u64,
    /// Into glass or out of it.
    pub refracted: u64,
}

impl RayCounts {
    /// Rays of every kind.
    pub fn total(&self) -> u64 {
        self.primary + self.shadow + self.mirror + self.refracted
    }
}

/// What was done for some samples of pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Rays traced.
    pub rays: RayCounts,
    /// Samples whose radiance came out infinite or NaN. There should be none; they count as black.
    pub non_finite: u64,
}

impl Counts {
    /// A sample's radiance clamped to 0..=1; black where it is not finite, which is counted.
    #[inline(always)]
    pub(super) fn clamp(&mut self, color: [f64; 3]) -> [f64; 3] {
        if color.iter().all(|channel| channel.is_finite()) {
            color.map(|channel| channel.clamp(0.0, 1.0))
        } else {
            self.non_finite += 1;
            [0.0; 3]
        }
    }
}

impl AddAssign for Counts {
    fn add_assign(&mut self, other: Self) {
        self.rays.primary += other.rays.primary;
        self.rays.shadow += other.rays.shadow;
        self.rays.mirror += other.rays.mirror;
        self.rays.refracted += other.rays.refracted;
        self.non_finite += other.non_finite;
    }
}

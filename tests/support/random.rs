//! Random numbers from a seed: the same everywhere, for ever.

use glam::DVec3;

/// Sebastiano Vigna's splitmix64. A test names its seed and prints it when it fails.
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub(crate) fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// From 0, below 1.
    pub(crate) fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// A whole number below `count`.
    pub(crate) fn below(&mut self, count: usize) -> usize {
        (self.unit() * count as f64) as usize
    }

    /// True once in `count` times.
    pub(crate) fn one_in(&mut self, count: usize) -> bool {
        self.below(count) == 0
    }

    pub(crate) fn pick<V: Copy>(&mut self, values: &[V]) -> V {
        values[self.below(values.len())]
    }

    /// A point of the cube from `-size` to `size`.
    pub(crate) fn point(&mut self, size: f64) -> DVec3 {
        let mut coordinate = || self.between(-size, size);
        DVec3::new(coordinate(), coordinate(), coordinate())
    }

    /// A unit vector.
    pub(crate) fn direction(&mut self) -> DVec3 {
        loop {
            let point = self.point(1.0);
            if (0.1..1.0).contains(&point.length()) {
                return point.normalize();
            }
        }
    }

    /// The same values in another order (Fisher and Yates).
    pub(crate) fn shuffle<V>(&mut self, values: &mut [V]) {
        for last in (1..values.len()).rev() {
            values.swap(last, self.below(last + 1));
        }
    }
}

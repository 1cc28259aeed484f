//! Random numbers that are the same on every machine (splitmix64).

use glam::DVec3;

/// A stream of random numbers.
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// The stream of a seed.
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// From 0 up to, not including, 1.
    #[expect(clippy::cast_precision_loss, reason = "53 bits fit")]
    pub fn share(&mut self) -> f64 {
        (self.next() >> 11) as f64 * 2.0_f64.powi(-53)
    }

    /// Uniform between two numbers.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.share()
    }

    /// Log-uniform between two powers of ten.
    pub fn magnitude(&mut self, low: f64, high: f64) -> f64 {
        libm::exp10(self.between(low, high))
    }

    /// Log-uniform between the powers of ten `-power` and `power`; two times in three one of these two ends.
    pub fn extreme(&mut self, power: f64) -> f64 {
        match self.below(3) {
            0 => libm::exp10(-power),
            1 => libm::exp10(power),
            _ => self.magnitude(-power, power),
        }
    }

    /// A whole number below `count`.
    pub fn below(&mut self, count: u64) -> u64 {
        self.next() % count
    }

    /// A whole number from `low` to `high`, both included, as a float.
    #[expect(clippy::cast_precision_loss, reason = "32 bits fit")]
    pub fn whole(&mut self, low: i32, high: i32) -> f64 {
        let span = u64::from(high.abs_diff(low)) + 1;
        f64::from(low) + self.below(span) as f64
    }

    /// Heads or tails.
    pub fn coin(&mut self) -> bool {
        self.below(2) == 0
    }

    /// A point in the cube from -1 to 1.
    pub fn point(&mut self) -> DVec3 {
        DVec3::new(self.between(-1.0, 1.0), self.between(-1.0, 1.0), self.between(-1.0, 1.0))
    }

    /// A unit vector, evenly spread.
    pub fn direction(&mut self) -> DVec3 {
        loop {
            let point = self.point();
            let length = point.length();
            if (0.1..=1.0).contains(&length) {
                return point / length;
            }
        }
    }

    /// A unit vector across another one.
    pub fn across(&mut self, axis: DVec3) -> DVec3 {
        loop {
            let across = axis.cross(self.direction());
            if across.length() > 0.1 {
                return across.normalize();
            }
        }
    }
}

//! The unit that tables keep lengths in.

use glam::DVec3;

/// A power of two of world units. Numbers of single precision end at 1e38, and the kernels take lengths to the fourth
/// power; so single tables keep lengths in a unit of the scene's own, a picometre or a light year, as it were.
///
/// A product with a power of two changes no digit: a picture is the same to the bit in any unit that
/// [holds](Self::holding) its lengths.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    /// How many there are in a world unit.
    in_world: f64,
}

impl Unit {
    /// The world unit.
    pub const WORLD: Self = Self { in_world: 1.0 };

    /// A unit in which two lengths above 0, and all between, are from `1 / limit` to `limit`, if there is one: the world
    /// unit if that does, otherwise `2^n` of them for the roundest `n`, which small changes of a scene seldom change.
    pub fn holding(least: f64, greatest: f64, limit: f64) -> Option<Self> {
        let exponent = roundest(ceil_log2(greatest / limit), floor_log2(least * limit))?;
        Some(Self { in_world: libm::ldexp(1.0, -exponent) })
    }

    /// A length in world units, in this one.
    pub fn length(self, length: f64) -> f64 {
        length * self.in_world
    }

    /// A point, or a way, in world units, in this one.
    pub fn point(self, point: DVec3) -> DVec3 {
        point * self.in_world
    }

    /// What is so much per world unit, per this one.
    pub fn per_length(self, value: f64) -> f64 {
        value / self.in_world
    }

    /// What is so much per square of a world unit, per square of this one.
    pub fn per_area(self, value: f64) -> f64 {
        value / self.in_world / self.in_world
    }
}

impl Default for Unit {
    fn default() -> Self {
        Self::WORLD
    }
}

/// The greatest `n` for which `2^n` is no more than a number above 0.
fn floor_log2(number: f64) -> i32 {
    libm::frexp(number).1 - 1
}

/// The least `n` for which `2^n` is no less than a number above 0.
fn ceil_log2(number: f64) -> i32 {
    let is_power = libm::frexp(number).0 == 0.5;
    floor_log2(number) + i32::from(!is_power)
}

/// The number from `low` to `high` that the highest power of two divides, and so 0 if that is one of them.
fn roundest(low: i32, high: i32) -> Option<i32> {
    // Exponents of numbers have fewer bits.
    (0..12).rev().map(|zeros| (high >> zeros) << zeros).find(|&number| low <= number)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_world_unit_is_kept_wherever_it_holds_all() {
        for (least, greatest) in [(1e-9, 1e9), (1.0, 1.0), (1e-9, 1e-9), (1e9, 1e9)] {
            assert_eq!(Unit::holding(least, greatest, 1e9), Some(Unit::WORLD));
        }
        assert_ne!(Unit::holding(1e-9, 1.1e9, 1e9), Some(Unit::WORLD));
        assert_ne!(Unit::holding(0.9e-9, 1e9, 1e9), Some(Unit::WORLD));
    }

    #[test]
    fn the_roundest_number_has_the_most_zeros_at_its_end() {
        for (low, high) in (-70..70).flat_map(|low| (low..70).map(move |high| (low, high))) {
            let found = roundest(low, high).unwrap();
            assert!((low..=high).contains(&found));
            let most = (low..=high).map(i32::trailing_zeros).max().unwrap();
            assert_eq!(found.trailing_zeros(), most, "{low} to {high}");
        }
        assert_eq!(roundest(3, 2), None);
    }

    #[test]
    fn every_pair_of_lengths_that_a_unit_can_hold_is_held() {
        for exponent in -230..230 {
            for (least, ratio) in [(1.0, 1.0), (1.3, 1e6), (1.99, 1e12), (1.0, 4.9e17)] {
                let least = least * libm::ldexp(1.0, exponent);
                let unit = Unit::holding(least, least * ratio, 1e9).unwrap();
                assert!(unit.length(least) >= 1e-9 && unit.length(least * ratio) <= 1e9);
            }
            assert_eq!(Unit::holding(libm::ldexp(1.0, exponent), libm::ldexp(1.01e18, exponent), 1e9), None);
        }
    }

    #[test]
    fn densities_go_the_other_way() {
        let unit = Unit::holding(1e30, 1e32, 1e9).unwrap();
        assert_ne!(unit, Unit::WORLD);
        assert_eq!(unit.length(3.0) * unit.per_length(7.0), 21.0);
        assert_eq!(unit.length(3.0) * unit.length(3.0) * unit.per_area(7.0), 63.0);
        assert_eq!(unit.point(DVec3::new(3.0, -0.0, 0.0)), DVec3::X * unit.length(3.0));
    }
}

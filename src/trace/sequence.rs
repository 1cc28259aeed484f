//! Sample points that are spread evenly: the same for every thread, tiling and machine.
//!
//! The first two dimensions of Sobol's sequence, scrambled anew for every seed by hashes that keep what makes it even
//! (B. Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020). All in whole numbers.

use crate::geometry::Real;

/// Which sample of which pixel something is drawn for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SampleId {
    /// Column of the pixel, from the left.
    pub column: u32,
    /// Row of the pixel, from the top.
    pub row: u32,
    /// Number of the sample within its pixel, from 0.
    pub index: u32,
}

/// What something is drawn for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// Where a ray passes the camera's lens.
    Lens,
    /// Where on a light a shadow ray ends, for numbered pairs of ray and light.
    Light(u32),
}

impl Purpose {
    /// A number of its own.
    const fn number(self) -> u32 {
        match self {
            Self::Lens => 0,
            Self::Light(pair) => pair.wrapping_add(1),
        }
    }
}

/// A sequence of points in the unit square.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sequence {
    seed: u32,
}

impl SampleId {
    /// The sequence of this sample's pixel for one purpose: others are independent of it.
    pub fn sequence(self, purpose: Purpose) -> Sequence {
        Sequence { seed: mix(mix(mix(purpose.number(), 0), self.column), self.row) }
    }
}

impl Sequence {
    /// The point of a number: the first 2^n lie one each in every cell of every division of the unit square into 2^n
    /// equal boxes by powers of two. Coordinates are multiples of 2^-24 from 0 to below 1.
    #[inline(never)]
    pub fn point<T: Real>(self, number: u32) -> [T; 2] {
        // The order is shuffled, too, so that sequences can be paired.
        let number = scramble(number, mix(self.seed, 1));
        let x = scramble(number.reverse_bits(), mix(self.seed, 2));
        let y = scramble(second_dimension(number), mix(self.seed, 3));
        [fraction(x), fraction(y)]
    }
}

/// The top 24 bits as a fraction: exact in both precisions.
fn fraction<T: Real>(bits: u32) -> T {
    T::from_f64(f64::from(bits >> 8) / f64::from(1_u32 << 24))
}

/// Sobol's second dimension: the columns of its matrix are those of Pascal's triangle modulo 2.
fn second_dimension(number: u32) -> u32 {
    let (mut value, mut column) = (0, 1_u32 << 31);
    let mut left = number;
    while left != 0 {
        if left & 1 != 0 {
            value ^= column;
        }
        column ^= column >> 1;
        left >>= 1;
    }
    value
}

/// Flips each bit depending on the seed and on the bits above it.
fn scramble(value: u32, seed: u32) -> u32 {
    // Steps by which lower bits never change higher ones, upside down.
    let mut x = value.reverse_bits();
    x = x.wrapping_add(seed);
    x ^= x.wrapping_mul(0x6c50_b47c);
    x ^= x.wrapping_mul(0xb82f_1e52);
    x ^= x.wrapping_mul(0xc7af_e638);
    x ^= x.wrapping_mul(0x8d22_f6e6);
    x.reverse_bits()
}

/// A hash of two numbers: multiplication carries upwards, shifts carry back.
fn mix(state: u32, value: u32) -> u32 {
    let mut x = state ^ value.wrapping_mul(0x9e37_79b9).wrapping_add(0x85eb_ca6b);
    x = (x ^ (x >> 16)).wrapping_mul(0x7feb_352d);
    x = (x ^ (x >> 15)).wrapping_mul(0x846c_a68b);
    x ^ (x >> 16)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(seed: u32, count: u32) -> Vec<[f64; 2]> {
        (0..count).map(|number| Sequence { seed }.point(number)).collect()
    }

    /// The number of the cell that a coordinate lies in, as something that can be compared.
    fn cell(coordinate: f64) -> u64 {
        coordinate.floor().to_bits()
    }

    #[test]
    fn every_box_of_every_division_holds_one_point() {
        for seed in 0..32 {
            for log in 0..=8_u32 {
                let points = points(seed, 1 << log);
                for across in 0..=log {
                    let (columns, rows) = (f64::from(1 << across), f64::from(1 << (log - across)));
                    let mut cells: Vec<_> =
                        points.iter().map(|[x, y]| (cell(x * columns), cell(y * rows))).collect();
                    cells.sort_unstable();
                    cells.dedup();
                    assert_eq!(cells.len(), points.len(), "seed {seed}, {columns} by {rows}");
                }
            }
        }
    }

    #[test]
    fn both_precisions_draw_the_same_points_below_one() {
        for number in 0..10_000 {
            let sequence = SampleId { column: 3, row: 5, index: 0 }.sequence(Purpose::Light(5));
            let [x, y]: [f64; 2] = sequence.point(number);
            let [x_single, y_single]: [f32; 2] = sequence.point(number);
            assert_eq!((x, y), (f64::from(x_single), f64::from(y_single)));
            assert!((0.0..1.0).contains(&x) && (0.0..1.0).contains(&y));
        }
    }

    #[test]
    fn pixels_and_purposes_have_sequences_of_their_own() {
        let at =
            |column, row, purpose| SampleId { column, row, index: 0 }.sequence(Purpose::Light(purpose)).seed;
        let mut seeds: Vec<_> = (0..20_u32.pow(3)).map(|n| at(n % 20, n / 20 % 20, n / 400)).collect();
        seeds.sort_unstable();
        seeds.dedup();
        assert_eq!(seeds.len(), 20_usize.pow(3));
    }

    #[test]
    fn two_sequences_of_one_pixel_are_not_in_step() {
        // Pairs of first coordinates fill the square about as evenly as chance would: no diagonal.
        let mut filled = std::collections::BTreeSet::new();
        for number in 0..256 {
            let id = SampleId { column: 1, row: 2, index: 0 };
            let [[a, _], [b, _]] =
                [Purpose::Lens, Purpose::Light(0)].map(|purpose| id.sequence(purpose).point::<f64>(number));
            filled.insert((cell(a * 16.0), cell(b * 16.0)));
        }
        assert!(filled.len() > 140, "{} of 256 cells", filled.len());
    }
}

//! `e^x` and `x^y` without branches and tables, so that a compiler can do many at once: the one source for every path
//! and machine.
//!
//! Series of `e^r` and of the inverse hyperbolic tangent around 0, after reduction to powers of two. Whole numbers are
//! rounded, and moved into exponents, by adding a number so large that its last digits are theirs.

use super::Real;

/// What the two functions know about a precision.
pub(super) trait Exponential: Real {
    /// Coefficients of `e^r` from the highest power down to `r^2`: inverse factorials.
    const EXP_SERIES: &'static [Self];
    /// Coefficients of `atanh(s) / s` in `s^2` from the highest power down to the first: inverse odd numbers.
    const LOG_SERIES: &'static [Self];
    /// Arguments of `e^x` beyond this, and of `2^x`, give 0 or infinity.
    const EXP_LIMIT: Self;
    /// `1 / ln 2`
    const LOG2_E: Self;
    /// `ln 2`, cut so that its product with any exponent is exact.
    const LN_2_HIGH: Self;
    /// The rest of `ln 2`.
    const LN_2_LOW: Self;
    /// `ln 2`
    const LN_2: Self;

    /// The nearest whole number, of magnitude below a quarter of the significand's range.
    fn nearest_whole(self) -> Self;
    /// `2^self` for a whole number in the range of normal exponents.
    fn power_of_two(self) -> Self;
    /// A normal number above 0 as `2^e * m` with `m` from `sqrt(1/2)` to `sqrt(2)`: `(e, m)`.
    fn split_exponent(self) -> (Self, Self);
    /// What an exponent of 0 is written as.
    const BIAS: Self;
    /// The smallest normal number.
    const SMALLEST_NORMAL: Self;
    /// A power of two that makes every number above 0 normal, and its exponent.
    const RAISE: (Self, Self);
}

/// `e^x`, to about 1 ulp.
#[inline(always)]
pub(super) fn exp<T: Exponential>(x: T) -> T {
    let x = x.at_least(-T::EXP_LIMIT).at_most(T::EXP_LIMIT);
    let whole = (x * T::LOG2_E).nearest_whole();
    let rest = (x - whole * T::LN_2_HIGH) - whole * T::LN_2_LOW;
    scaled_exp(rest, whole)
}

/// `x^y` for `x > 0`, to about `1 + 3 |y ln x|` ulp: an error of the logarithm counts `y` times, as one of `x` does.
#[inline(always)]
pub(super) fn pow<T: Exponential>(x: T, y: T) -> T {
    let power = (y * log2(x)).at_least(-T::EXP_LIMIT).at_most(T::EXP_LIMIT);
    let whole = power.nearest_whole();
    scaled_exp((power - whole) * T::LN_2, whole)
}

/// `e^rest * 2^whole` for a rest of at most half of `ln 2`; down to the smallest numbers, rounded once.
#[inline(always)]
fn scaled_exp<T: Exponential>(rest: T, whole: T) -> T {
    let mut tail = T::ZERO;
    for &coefficient in T::EXP_SERIES {
        tail = tail * rest + coefficient;
    }
    let mantissa = T::ONE + (rest + rest * rest * tail);
    // In two steps, because 2^whole alone may be no normal number.
    let half = (whole / T::TWO).nearest_whole();
    mantissa * half.power_of_two() * (whole - half).power_of_two()
}

/// `log2(x)` for `x > 0`, to about 3 ulp; exact for powers of two.
#[inline(always)]
fn log2<T: Exponential>(x: T) -> T {
    let (scale, raised) = T::RAISE;
    let is_normal = x >= T::SMALLEST_NORMAL;
    let normal = if is_normal { x } else { x * scale };
    let (exponent, mantissa) = normal.split_exponent();
    let exponent = if is_normal { exponent } else { exponent - raised };
    let s = (mantissa - T::ONE) / (mantissa + T::ONE);
    let square = s * s;
    let mut tail = T::ZERO;
    for &coefficient in T::LOG_SERIES {
        tail = (tail + coefficient) * square;
    }
    let logarithm = T::TWO * (s + s * tail);
    exponent + logarithm * T::LOG2_E
}

macro_rules! exponential {
    ($float:ident, $bits:ident, $limit:expr, $bias:expr, $ln_2_high:expr, $ln_2_low:expr, $raise:expr,
     [$($exp:expr),*], [$($log:expr),*]) => {
        impl Exponential for $float {
            const EXP_SERIES: &'static [Self] = &[$(1.0 / $exp),*];
            const LOG_SERIES: &'static [Self] = &[$(1.0 / $log),*];
            const EXP_LIMIT: Self = $limit;
            const LOG2_E: Self = core::$float::consts::LOG2_E;
            const LN_2_HIGH: Self = $ln_2_high;
            const LN_2_LOW: Self = $ln_2_low;
            const LN_2: Self = core::$float::consts::LN_2;
            const BIAS: Self = $bias;
            const SMALLEST_NORMAL: Self = $float::MIN_POSITIVE;
            const RAISE: (Self, Self) = $raise;

            #[inline(always)]
            fn nearest_whole(self) -> Self {
                const LARGE: $float = 1.5 / $float::EPSILON;
                (self + LARGE) - LARGE
            }

            #[inline(always)]
            fn power_of_two(self) -> Self {
                const FRACTION_BITS: u32 = $float::MANTISSA_DIGITS - 1;
                const LARGE: $float = 1.5 / $float::EPSILON;
                // The last digits of the sum are the biased exponent; the shift drops the rest.
                $float::from_bits((self + (LARGE + Self::BIAS)).to_bits() << FRACTION_BITS)
            }

            #[inline(always)]
            fn split_exponent(self) -> (Self, Self) {
                const FRACTION_BITS: u32 = $float::MANTISSA_DIGITS - 1;
                const ONE: $bits = (1.0 as $float).to_bits();
                const ROOT_HALF: $bits = core::$float::consts::FRAC_1_SQRT_2.to_bits();
                const LARGE: $float = 1.5 / $float::EPSILON;
                // Counted from sqrt(1/2), so that the exponent steps there and not at 1.
                let biased = self.to_bits().wrapping_add(ONE - ROOT_HALF) >> FRACTION_BITS;
                let exponent = $float::from_bits(biased | LARGE.to_bits()) - (LARGE + Self::BIAS);
                let mantissa = self.to_bits().wrapping_sub(biased << FRACTION_BITS).wrapping_add(ONE);
                (exponent, $float::from_bits(mantissa))
            }
        }
    };
}

exponential!(
    f64,
    u64,
    1100.0,
    1023.0,
    0.693_147_180_559_208_2,
    7.371_002_565_167_799e-13,
    (18_014_398_509_481_984.0, 54.0),
    [
        6_227_020_800.0,
        479_001_600.0,
        39_916_800.0,
        3_628_800.0,
        362_880.0,
        40_320.0,
        5_040.0,
        720.0,
        120.0,
        24.0,
        6.0,
        2.0
    ],
    [21.0, 19.0, 17.0, 15.0, 13.0, 11.0, 9.0, 7.0, 5.0, 3.0]
);
exponential!(
    f32,
    u32,
    160.0,
    127.0,
    0.693_115_23,
    3.194_618_5e-5,
    (33_554_432.0, 25.0),
    [5_040.0, 720.0, 120.0, 24.0, 6.0, 2.0],
    [9.0, 7.0, 5.0, 3.0]
);

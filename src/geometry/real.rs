//! The precision of a kernel.

use core::fmt::{Debug, Display};
use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

use super::exponential;

/// A floating-point precision that every kernel can be compiled for: `f64` (default) or `f32`.
///
/// `e^x` and `x^y` are our own, so that a picture is the same on every machine and path.
/// There is deliberately no `mul_add`: without the FMA target feature it calls a software routine, and with it
/// pictures would depend on the CPU.
pub trait Real:
    Copy
    + Debug
    + Default
    + Display
    + PartialOrd
    + Send
    + Sync
    + Add<Output = Self>
    + AddAssign
    + Sub<Output = Self>
    + SubAssign
    + Mul<Output = Self>
    + MulAssign
    + Div<Output = Self>
    + Neg<Output = Self>
    + 'static
{
    /// 0.
    const ZERO: Self;
    /// 1.
    const ONE: Self;
    /// 2.
    const TWO: Self;
    /// Above every finite number.
    const INFINITY: Self;
    /// Below every finite number.
    const LOWEST: Self;
    /// Not a number: compares false with everything.
    const NAN: Self;
    /// The largest finite number.
    const MAX: Self;
    /// Unit in the last place of 1: the gap to the next number.
    const ULP: Self;
    /// A share of which the square is still some [`ULP`](Self::ULP): what is closer is worth a second look.
    const CLOSE: Self;
    /// Sums of squares above this have lost nothing to underflow.
    const SQUARE_FLOOR: Self;
    /// `2^ceil(p/2) + 1` for a significand of `p` bits: splits a number into two halves (Dekker 1971).
    const SPLITTER: Self;
    /// Largest length or coordinate, and the inverse of the smallest length, for which no kernel overflows or
    /// loses a product to underflow; in a [`Unit`](super::Unit) of the scene's own. The largest product formed is of fourth
    /// degree in lengths.
    const LENGTH_LIMIT: f64;
    /// The name on the command line and in reports: `"f64"` or `"f32"`.
    const NAME: &'static str;

    /// The nearest value of this precision.
    fn from_f64(value: f64) -> Self;
    /// The same value as `f64`, exactly.
    fn to_f64(self) -> f64;
    /// A whole number below 2^24, exactly.
    fn from_u32(value: u32) -> Self;
    /// Correctly rounded square root.
    fn sqrt(self) -> Self;
    /// Magnitude.
    fn abs(self) -> Self;
    /// The greatest whole number not above `self`.
    fn floor(self) -> Self;
    /// The magnitude of `self` with the sign of `sign`.
    fn copysign(self, sign: Self) -> Self;
    /// `e^self`, to 1 ulp.
    fn exp(self) -> Self;
    /// `self^exponent` for `self` above 0, to `1 + 3 |exponent ln self|` ulp.
    fn pow(self, exponent: Self) -> Self;
    /// Neither infinite nor NaN.
    fn is_finite(self) -> bool;

    /// Does work that is written for each precision by itself.
    fn by_precision<W: ByPrecision>(input: W::Input<Self>) -> W::Output;

    /// The larger of two numbers, neither of them NaN.
    #[inline(always)]
    fn at_least(self, low: Self) -> Self {
        if self < low { low } else { self }
    }

    /// The smaller of two numbers, neither of them NaN.
    #[inline(always)]
    fn at_most(self, high: Self) -> Self {
        if self > high { high } else { self }
    }
}

/// Work that exists once for each precision. What is generic over a precision is compiled again wherever it is used; large
/// pieces of code are better compiled once.
pub trait ByPrecision {
    /// What it takes.
    type Input<T: Real>;
    /// What it gives.
    type Output;

    /// The work in `f32`.
    fn single(input: Self::Input<f32>) -> Self::Output;
    /// The work in `f64`.
    fn double(input: Self::Input<f64>) -> Self::Output;
}

macro_rules! real {
    ($float:ident, $splitter:expr, $close:expr, $limit:expr, $from:expr, $from_u32:expr, $work:ident) => {
        impl Real for $float {
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const TWO: Self = 2.0;
            const INFINITY: Self = $float::INFINITY;
            const LOWEST: Self = $float::NEG_INFINITY;
            const NAN: Self = $float::NAN;
            const MAX: Self = $float::MAX;
            const ULP: Self = $float::EPSILON;
            const CLOSE: Self = $close;
            const SQUARE_FLOOR: Self = $float::MIN_POSITIVE / $float::EPSILON;
            const SPLITTER: Self = $splitter;
            const LENGTH_LIMIT: f64 = $limit;
            const NAME: &'static str = stringify!($float);

            #[inline(always)]
            fn from_f64(value: f64) -> Self {
                $from(value)
            }
            #[inline(always)]
            fn to_f64(self) -> f64 {
                self.into()
            }
            #[inline(always)]
            fn from_u32(value: u32) -> Self {
                $from_u32(value)
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                $float::sqrt(self)
            }
            #[inline(always)]
            fn abs(self) -> Self {
                $float::abs(self)
            }
            #[inline(always)]
            fn floor(self) -> Self {
                $float::floor(self)
            }
            #[inline(always)]
            fn copysign(self, sign: Self) -> Self {
                $float::copysign(self, sign)
            }
            #[inline(always)]
            fn exp(self) -> Self {
                exponential::exp(self)
            }
            #[inline(always)]
            fn pow(self, exponent: Self) -> Self {
                exponential::pow(self, exponent)
            }
            #[inline(always)]
            fn is_finite(self) -> bool {
                $float::is_finite(self)
            }
            fn by_precision<W: ByPrecision>(input: W::Input<Self>) -> W::Output {
                W::$work(input)
            }
        }
    };
}

/// Rounds to nearest: the one place where precision is given up.
#[expect(clippy::cast_possible_truncation, reason = "rounding to f32 is what choosing f32 means")]
#[inline(always)]
fn round_to_f32(value: f64) -> f32 {
    value as f32
}

#[expect(clippy::cast_precision_loss, reason = "callers pass pixel coordinates, below 2^24")]
#[inline(always)]
fn f32_from_u32(value: u32) -> f32 {
    value as f32
}

real!(f64, 134_217_729.0, f64::EPSILON * 4_294_967_296.0, 1e70, core::convert::identity, f64::from, double);
real!(f32, 4097.0, f32::EPSILON * 8192.0, 1e9, round_to_f32, f32_from_u32, single);

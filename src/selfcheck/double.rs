//! Numbers of twice the digits.

use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::geometry::{Real, two_prod, two_sum};

/// The sum of two `f64`, the second at most half a unit in the last place of the first: about 31 decimal digits, as long as
/// no part overflows or underflows (T. J. Dekker, Numerische Mathematik 18, 1971).
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Double {
    high: f64,
    low: f64,
}

impl Double {
    /// 0.
    pub const ZERO: Self = Self { high: 0.0, low: 0.0 };

    /// A float of either precision, exactly.
    pub fn of<T: Real>(value: T) -> Self {
        Self { high: value.to_f64(), low: 0.0 }
    }

    /// The two parts; their sum is the number.
    pub fn parts(self) -> (f64, f64) {
        (self.high, self.low)
    }

    /// The nearest `f64`.
    pub fn nearest(self) -> f64 {
        self.high
    }

    /// The product of two floats, exactly.
    pub fn product(a: f64, b: f64) -> Self {
        let (high, low) = two_prod(a, b);
        Self { high, low }
    }

    /// Square root of a number not below 0.
    pub fn sqrt(self) -> Self {
        if self.high <= 0.0 {
            return Self::ZERO;
        }
        // One step of Newton's from the rounded root.
        let root = self.high.sqrt();
        let rest = self - Self::product(root, root);
        Self::joined(root, rest.high / (root + root))
    }

    /// Magnitude.
    pub fn abs(self) -> Self {
        if self.high < 0.0 { -self } else { self }
    }

    fn joined(a: f64, b: f64) -> Self {
        let (high, low) = two_sum(a, b);
        Self { high, low }
    }
}

impl Add for Double {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (high, error) = two_sum(self.high, other.high);
        let (low, rest) = two_sum(self.low, other.low);
        let sum = Self::joined(high, error + low);
        Self::joined(sum.high, sum.low + rest)
    }
}

impl Neg for Double {
    type Output = Self;
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Sub for Double {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Double {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let product = Self::product(self.high, other.high);
        Self::joined(product.high, product.low + (self.high * other.low + self.low * other.high))
    }
}

impl Div for Double {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        // Long division: two digits, each a float, and the rest as a third.
        let first = self.high / other.high;
        let rest = self - other * Self { high: first, low: 0.0 };
        let second = rest.high / other.high;
        let rest = rest - other * Self { high: second, low: 0.0 };
        Self::joined(first, second) + Self { high: rest.high / other.high, low: 0.0 }
    }
}

/// Three of them.
#[derive(Clone, Copy, Debug)]
pub(super) struct DoubleVector([Double; 3]);

impl DoubleVector {
    /// A vector of floats, exactly.
    pub(super) fn of<T: Real>(v: crate::geometry::Vector<T>) -> Self {
        Self([v.x, v.y, v.z].map(Double::of))
    }

    /// Difference.
    pub(super) fn minus(self, other: Self) -> Self {
        let ([x, y, z], [u, v, w]) = (self.0, other.0);
        Self([x - u, y - v, z - w])
    }

    /// Scalar product.
    pub(super) fn dot(self, other: Self) -> Double {
        let ([x, y, z], [u, v, w]) = (self.0, other.0);
        (x * u + y * v) + z * w
    }
}

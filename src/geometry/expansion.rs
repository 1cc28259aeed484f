//! Sums of floats that lose nothing, for signs that rounding cannot tell.
//!
//! J. R. Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric predicates", Discrete &
//! Computational Geometry 18, 1997.

use core::ops::{Add, Mul, Neg, Sub};

use super::compensated::{two_prod, two_sum};

/// A number as a sum of floats of which none overlaps another, the smallest first: exact, as long as no product
/// underflows or overflows.
#[derive(Clone, Debug, Default)]
pub(super) struct Expansion(Vec<f64>);

impl Expansion {
    /// A float as it is.
    pub(super) fn of(value: f64) -> Self {
        let mut sum = Self::default();
        sum.take(value);
        sum
    }

    /// -1, 0 or 1.
    pub(super) fn sign(&self) -> i8 {
        match self.0.last() {
            Some(&largest) if largest < 0.0 => -1,
            Some(_) => 1,
            None => 0,
        }
    }

    /// The number, rounded to a unit in the last place.
    pub(super) fn nearest(&self) -> f64 {
        self.0.iter().sum()
    }

    fn take(&mut self, value: f64) {
        let mut sum = value;
        self.0.retain_mut(|part| {
            let (rounded, error) = two_sum(sum, *part);
            (sum, *part) = (rounded, error);
            error != 0.0
        });
        if sum != 0.0 {
            self.0.push(sum);
        }
    }
}

impl Add for &Expansion {
    type Output = Expansion;
    fn add(self, other: Self) -> Expansion {
        let mut sum = self.clone();
        other.0.iter().for_each(|&part| sum.take(part));
        sum
    }
}

impl Neg for &Expansion {
    type Output = Expansion;
    fn neg(self) -> Expansion {
        Expansion(self.0.iter().map(|&part| -part).collect())
    }
}

impl Sub for &Expansion {
    type Output = Expansion;
    fn sub(self, other: Self) -> Expansion {
        self + &-other
    }
}

impl Mul for &Expansion {
    type Output = Expansion;
    fn mul(self, other: Self) -> Expansion {
        let mut sum = Expansion::default();
        for &a in &self.0 {
            for &b in &other.0 {
                let (product, error) = two_prod(a, b);
                sum.take(error);
                sum.take(product);
            }
        }
        sum
    }
}

//! What the tests need to know about a precision.

use archetrace::geometry::{Ray, Real, Vector};
use glam::DVec3;

use crate::oracle::Exact;

/// A precision under test.
pub(crate) trait Precision: Real {
    /// Distance from 1 to the next number: twice the largest relative rounding error.
    const EPSILON: f64;

    /// What a case uses in double and in single precision.
    fn of<A>(double: A, single: A) -> A;
    /// The nearest number to an exact one.
    fn rounded(value: &Exact) -> Self;
    /// The next larger number.
    fn up(self) -> Self;
    /// The next smaller number.
    fn down(self) -> Self;
    /// The bits, to tell -0 from 0.
    fn bits(self) -> u64;
}

impl Precision for f64 {
    const EPSILON: f64 = f64::EPSILON;

    fn of<A>(double: A, _single: A) -> A {
        double
    }
    fn rounded(value: &Exact) -> Self {
        value.to_f64().value()
    }
    fn up(self) -> Self {
        self.next_up()
    }
    fn down(self) -> Self {
        self.next_down()
    }
    fn bits(self) -> u64 {
        self.to_bits()
    }
}

impl Precision for f32 {
    const EPSILON: f64 = 1.192_092_895_507_812_5e-7;

    fn of<A>(_double: A, single: A) -> A {
        single
    }
    fn rounded(value: &Exact) -> Self {
        value.to_f32().value()
    }
    fn up(self) -> Self {
        self.next_up()
    }
    fn down(self) -> Self {
        self.next_down()
    }
    fn bits(self) -> u64 {
        u64::from(self.to_bits())
    }
}

/// The ray with these two vectors, rounded to the precision.
pub(crate) fn ray<T: Precision>(origin: DVec3, direction: DVec3) -> Ray<T> {
    Ray { origin: Vector::from_dvec3(origin), direction: Vector::from_dvec3(direction) }
}

/// The bits of a vector.
pub(crate) fn bits<T: Precision>(v: Vector<T>) -> [u64; 3] {
    [v.x.bits(), v.y.bits(), v.z.bits()]
}

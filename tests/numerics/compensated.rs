//! Error-free transformations: rounded result and error add up exactly.

use archetrace::geometry::{Real, two_diff, two_prod, two_sum};
use proptest::prelude::*;

use crate::oracle::exact;
use crate::precision::Precision;

/// A float with any significand and an exponent of 2 within a range.
fn float(exponents: core::ops::RangeInclusive<i32>) -> impl Strategy<Value = f64> {
    (-1.0..1.0_f64, exponents).prop_map(|(part, exponent)| part * 2.0_f64.powi(exponent))
}

/// Two floats, the second one often close to the first, where sums cancel.
fn pair() -> impl Strategy<Value = (f64, f64)> {
    let close = (float(-300..=300), -8..8_i64).prop_map(|(a, steps)| {
        let b = f64::from_bits(a.to_bits().wrapping_add_signed(steps));
        (a, if b.is_finite() { b } else { a })
    });
    prop_oneof![(float(-300..=300), float(-300..=300)), (float(-30..=30), float(-30..=30)), close]
}

fn check_sum<T: Precision>(a: T, b: T) {
    let (sum, error) = two_sum(a, b);
    assert_eq!(sum.bits(), (a + b).bits());
    assert_eq!(exact(sum) + exact(error), exact(a) + exact(b), "{a} + {b}");
    let (difference, error) = two_diff(a, b);
    assert_eq!(difference.bits(), (a - b).bits());
    assert_eq!(exact(difference) + exact(error), exact(a) - exact(b), "{a} - {b}");
}

fn check_product<T: Precision>(a: T, b: T) {
    let (product, error) = two_prod(a, b);
    assert_eq!(product.bits(), (a * b).bits());
    assert_eq!(exact(product) + exact(error), exact(a) * exact(b), "{a} * {b}");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 20_000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn sums_and_differences_are_exact_f64((a, b) in pair()) {
        check_sum(a, b);
    }

    #[test]
    fn sums_and_differences_are_exact_f32((a, b) in (float(-40..=40), float(-40..=40))) {
        check_sum(f32::from_f64(a), f32::from_f64(b));
    }

    #[test]
    fn products_are_exact_f64((a, b) in (float(-400..=400), float(-400..=400))) {
        check_product(a, b);
    }

    #[test]
    fn products_are_exact_f32((a, b) in (float(-40..=40), float(-40..=40))) {
        check_product(f32::from_f64(a), f32::from_f64(b));
    }
}

#[test]
fn what_is_lost_by_rounding_is_in_the_error() {
    assert_eq!(two_sum(1.0, 2.0_f64.powi(-60)), (1.0, 2.0_f64.powi(-60)));
    assert_eq!(two_diff(1.0, 2.0_f64.powi(-60)), (1.0, -2.0_f64.powi(-60)));
    let step = 1.0 + f64::EPSILON;
    assert_eq!(two_prod(step, step), (1.0 + 2.0 * f64::EPSILON, f64::EPSILON * f64::EPSILON));
}

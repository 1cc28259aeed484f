//! `e^x` and `x^y` against 300 bits.

use archetrace::geometry::Real as _;

use crate::oracle::{exact, from_long, long, nearest, relative_error};
use crate::precision::Precision;
use crate::worst::Worst;
use archetrace::selfcheck::Random;

/// Every normal result to 1 ulp; what underflows is rounded to what numbers there are.
fn check_exp<T: Precision>(largest: f64, seed: u64) {
    let mut worst = Worst::new(&format!("exp, ulp, {}", T::NAME));
    for number in 0..20_000 {
        let random = &mut Random::new(seed + number);
        let size = random.magnitude(-9.0, largest.log10()).min(largest);
        let x = T::from_f64(if random.coin() { size } else { -size });
        let truth = from_long(long(&exact(x)).exp());
        worst.measure(relative_error(x.exp(), &truth) / T::EPSILON, 1.0, || format!("{x}"));
    }
}

/// `1 + 3 |y ln x|` ulp.
fn check_pow<T: Precision>(smallest: f64, seed: u64) {
    let mut worst = Worst::new(&format!("pow / bound, {}", T::NAME));
    for number in 0..20_000 {
        let random = &mut Random::new(seed + number);
        let x = match random.below(4) {
            0 => 1.0 - random.magnitude(-9.0, -1.0),
            1 => random.magnitude(smallest, 0.0),
            _ => random.between(0.0, 1.0),
        };
        let x = T::from_f64(x);
        let logarithm = long(&exact(x)).ln();
        let size = nearest(&from_long(logarithm.clone())).abs();
        // A result from 1 down to about the smallest normal number.
        let y = T::from_f64(random.between(0.0, 2.3 * -smallest).min(1e12 * size) / size.max(1e-12));
        let truth = from_long((logarithm * long(&exact(y))).exp());
        let bound = 1.0 + 3.0 * y.to_f64() * size;
        worst.measure(relative_error(x.pow(y), &truth) / T::EPSILON / bound, 1.0, || format!("{x} {y}"));
    }
}

#[test]
fn exp_is_right_to_an_ulp() {
    check_exp::<f64>(708.0, 0x7_0300_0000);
    check_exp::<f32>(87.0, 0x7_0400_0000);
}

#[test]
fn pow_is_right_as_far_as_its_logarithm() {
    check_pow::<f64>(-307.0, 0x7_0500_0000);
    check_pow::<f32>(-37.0, 0x7_0600_0000);
}

#[test]
fn ends_and_whole_powers_are_exact() {
    fn check<T: Precision>() {
        let two = T::TWO;
        let half = T::ONE / two;
        assert_eq!(T::ZERO.exp(), T::ONE);
        assert_eq!((-T::INFINITY).exp(), T::ZERO);
        assert_eq!((-T::MAX).exp(), T::ZERO);
        assert_eq!(T::MAX.exp(), T::INFINITY);
        for power in 0..120 {
            let power = T::from_u32(power);
            assert_eq!(T::ONE.pow(power), T::ONE);
            assert_eq!(two.pow(power) * half.pow(power), T::ONE, "{power}");
        }
        assert_eq!(half.pow(T::MAX), T::ZERO);
        assert_eq!(half.pow(T::ZERO), T::ONE);
    }
    check::<f64>();
    check::<f32>();
    let least = f64::from_bits(1);
    assert_eq!(least.pow(0.5), 2.0_f64.powi(-537));
    assert_eq!(f32::from_bits(1).pow(0.5).bits(), 2.0_f32.powf(-74.5).bits());
    assert_eq!((-745.1_f64).exp(), least);
}

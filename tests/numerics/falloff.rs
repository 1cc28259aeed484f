//! Loss of light over distance: the ends of the range, scale, and digits.

use archetrace::components::range;
use archetrace::effects::attenuation;

use crate::oracle::{exact, from_long, long, nearest, relative_error};
use crate::precision::Precision;
use crate::worst::Worst;
use archetrace::selfcheck::Random;

#[test]
fn l01_at_the_light_nothing_is_lost() {
    for falloff in [0.0, 1.0, 1e150] {
        assert_eq!(attenuation(0.0, falloff), 1.0);
    }
    for falloff in [0.0_f32, 1.0, 1e38] {
        assert_eq!(attenuation(0.0, falloff), 1.0);
    }
}

#[test]
fn l03_far_away_exactly_nothing_is_left() {
    assert_eq!(attenuation(1e6, 1.0), 0.0);
    assert_eq!(attenuation(1e141, 1e150), 0.0);
    assert_eq!(attenuation(1e4_f32, 1.0), 0.0);
    let last = attenuation(27.2_f64 * 27.2, 1.0);
    assert!(last > 0.0 && last < f64::MIN_POSITIVE);
    assert_eq!(attenuation(27.5_f64 * 27.5, 1.0), 0.0);
}

#[test]
fn l04_without_falloff_no_distance_counts() {
    // The farthest two points: opposite corners of the allowed world.
    let farthest = 12.0 * 1e70_f64 * 1e70;
    assert_eq!(attenuation(farthest, 0.0), 1.0);
    assert_eq!(attenuation(12.0 * 1e9_f32 * 1e9, 0.0), 1.0);
    assert_eq!(attenuation(f64::MIN_POSITIVE, 0.0), 1.0);
}

#[test]
fn l05_a_falloff_below_zero_is_refused() {
    for falloff in [-1e-300, f64::NAN, f64::INFINITY] {
        assert!(!range::FALLOFF.contains(falloff));
    }
    assert!(range::FALLOFF.contains(0.0) && range::FALLOFF.contains(1e150));
}

#[test]
fn l06_scale_and_falloff_cancel_bit_for_bit() {
    fn check<T: Precision>(powers: [i32; 6]) {
        for number in 0..20_000 {
            let random = &mut Random::new(0x1_0600_0000 + number);
            let (square, falloff) = (random.magnitude(-3.0, 6.0), random.magnitude(-8.0, 1.0));
            let (square, falloff) = (T::from_f64(square), T::from_f64(falloff));
            for power in powers {
                let scale = T::from_f64(4.0_f64.powi(power));
                let scaled = attenuation(square * scale, falloff / scale);
                assert_eq!(scaled.bits(), attenuation(square, falloff).bits(), "{square} {falloff}");
            }
        }
    }
    check::<f64>([-60, -20, -1, 1, 20, 60]);
    // Squared lengths of a scene's own unit.
    check::<f32>([-30, -20, -1, 1, 20, 30]);
}

/// The exponent is rounded once, which counts with its own size; the function adds one epsilon at most.
fn check_digits<T: Precision>(largest: f64, seed: u64) {
    let mut worst = Worst::new(&format!("falloff / bound, {}", T::NAME));
    for number in 0..3_000 {
        let random = &mut Random::new(seed + number);
        let exponent = random.magnitude(-6.0, largest);
        let falloff = T::from_f64(random.magnitude(-4.0, 4.0));
        let square = T::from_f64(exponent / falloff.to_f64());
        let product = exact(square) * exact(falloff);
        let size = nearest(&product);
        let truth = from_long(long(&-product).exp());
        let error = relative_error(attenuation(square, falloff), &truth) / T::EPSILON;
        worst.measure(error / (1.0 + 0.5 * size), 1.0, || format!("{square} {falloff}"));
    }
}

#[test]
fn l03_random_distances_keep_their_digits_f64() {
    check_digits::<f64>(2.8, 0x1_0301_0000);
}

#[test]
fn l03_random_distances_keep_their_digits_f32() {
    check_digits::<f32>(1.9, 0x1_0302_0000);
}

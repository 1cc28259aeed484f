//! The curve of sRGB: all 256 levels against exact arithmetic.

use archetrace::effects::SrgbLevels;

use crate::oracle::{Exact, exact};

fn power(base: &Exact, exponent: usize) -> Exact {
    (0..exponent).fold(Exact::ONE, |product, _| product * base.clone())
}

/// How the least light of a level, above 0, compares with the standard's: `((level / 255 + 0.055) / 1.055)^2.4`, in
/// whole numbers `((40 level + 561) / 10761)^(12/5)`; for dark levels `level / 255 / 12.92`.
fn is_below(light: f64, level: u32) -> bool {
    let light = exact(light);
    // 0.04045 * 255 is between 10 and 11.
    if level <= 10 {
        return light < Exact::from(100 * level) / Exact::from(255 * 1292);
    }
    let base = Exact::from(40 * level + 561) / Exact::from(10761);
    power(&light, 5) < power(&base, 12)
}

#[test]
fn every_level_begins_where_the_standard_says() {
    let levels = SrgbLevels::new();
    assert_eq!(levels.least_light()[0], 0.0);
    assert_eq!(levels.least_light()[255], 1.0);
    for (level, &least) in (0..).zip(levels.least_light()).skip(1) {
        // The base is rounded once, which the power makes 1.2 units in the last place of, and so is the power.
        let [low, high] = [1.0 - 3.0 * f64::EPSILON, 1.0 + 3.0 * f64::EPSILON].map(|near| least * near);
        let is_near = is_below(low, level) && !is_below(high, level);
        assert!(is_near, "level {level} begins at {least}");
    }
}

#[test]
fn light_gets_the_highest_level_that_it_reaches() {
    let levels = SrgbLevels::new();
    for (level, &least) in (0_u8..=255).zip(levels.least_light()) {
        assert_eq!(levels.level(least), level);
        assert_eq!(levels.level(least.next_down().max(0.0)), level.saturating_sub(1));
    }
    // A middle grey is shown much brighter than in proportion.
    assert_eq!(levels.level(0.5), 187);
    assert_eq!(levels.level(0.18), 117);
}

//! Numbers as text.

use crate::scene::Number;
use crate::viewer::editor::significant;

/// A number in at most six significant digits, and no more than it needs.
pub(super) fn short(value: f64) -> String {
    exact(significant(value, 6))
}

/// A number in the fewest digits that read back to it.
pub(super) fn exact(value: f64) -> String {
    Number(value).to_string()
}

/// A whole number, with narrow gaps between groups of three digits.
pub(super) fn grouped(value: u64) -> String {
    let digits = value.to_string();
    let mut text = String::with_capacity(digits.len() * 2);
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            text.push('\u{2009}');
        }
        text.push(digit);
    }
    text
}

/// What was typed: a number with point or comma, not NaN.
pub(super) fn parse(text: &str) -> Option<f64> {
    text.trim().replace(',', ".").parse().ok().filter(|value: &f64| !value.is_nan())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_numbers_are_rounded_and_exact_ones_read_back() {
        assert_eq!(short(0.1 + 0.2), "0.3");
        assert_eq!(exact(0.1 + 0.2), "0.30000000000000004");
        assert_eq!(short(-150.0), "-150");
        assert_eq!(short(1e70), "1e70");
        for value in [0.1 + 0.2, 1e-70, 1.0 / 3.0, -1e70, f64::MIN_POSITIVE] {
            assert_eq!(parse(&exact(value)), Some(value));
        }
    }

    #[test]
    fn numbers_are_read_with_point_comma_and_exponent() {
        assert_eq!(parse(" 1,5 "), Some(1.5));
        assert_eq!(parse("-2e-3"), Some(-0.002));
        assert_eq!(parse("1.5.2"), None);
        assert_eq!(parse(""), None);
        assert_eq!(parse("NaN"), None);
    }

    #[test]
    fn digits_are_grouped_from_the_right() {
        assert_eq!(grouped(0), "0");
        assert_eq!(grouped(999), "999");
        assert_eq!(grouped(1_234_567), "1\u{2009}234\u{2009}567");
    }
}

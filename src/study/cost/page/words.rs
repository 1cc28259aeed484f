//! Numbers as people read them, with the exact ones beside them for programs.

use maud::{Markup, html};

/// A number in three significant digits or all digits before the point, with the exact one in `value`.
pub(super) fn number(value: f64) -> Markup {
    html! { data value=(value) { (short(value)) } }
}

/// The same with its sign, for what is added.
pub(super) fn signed(value: f64) -> Markup {
    html! { data value=(value) { (plus(value >= 0.0)) (short(value)) } }
}

/// A whole number in groups of three digits.
pub(super) fn count(value: u64) -> Markup {
    html! { data value=(value) { (grouped(value)) } }
}

/// The same with its sign.
pub(super) fn signed_count(value: i64) -> Markup {
    let sign = if value < 0 { "\u{2212}" } else { plus(true) };
    html! { data value=(value) { (sign) (grouped(value.unsigned_abs())) } }
}

/// A share as percent.
pub(super) fn percent(share: f64) -> Markup {
    html! { data value=(share) { (short(share * 100.0)) "\u{202f}%" } }
}

fn plus(is_positive: bool) -> &'static str {
    if is_positive { "+" } else { "" }
}

/// Three significant digits, or all digits before the point; whole numbers as they are, powers of ten for what is tiny.
pub(super) fn short(value: f64) -> String {
    let size = value.abs();
    let text = match size {
        _ if value.is_nan() => "\u{2014}".to_owned(),
        _ if size.is_infinite() => "\u{221e}".to_owned(),
        _ if size >= 99.95 || size.fract() == 0.0 => grouped(whole(size)),
        _ if size >= 9.995 => format!("{size:.1}"),
        _ if size >= 0.9995 => format!("{size:.2}"),
        _ if size >= 0.01 => format!("{size:.3}"),
        _ => format!("{size:.1e}"),
    };
    let sign = if value < 0.0 { "\u{2212}" } else { "" };
    sign.to_owned() + &text
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "positive; what is beyond 64 bits is shown as the most that they hold"
)]
fn whole(size: f64) -> u64 {
    size.round() as u64
}

fn grouped(value: u64) -> String {
    let digits = value.to_string();
    let mut text = String::new();
    for (at, digit) in digits.char_indices() {
        if at > 0 && (digits.len() - at).is_multiple_of(3) {
            text.push('\u{202f}');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_digits_are_enough_for_people() {
        let shown = [0.0, 16.0, 38.234, 9.999, 99.96, 1234.5, 0.5, 0.012_34, 0.5 / 1000.0, -2.5, -0.04];
        assert_eq!(
            shown.map(short),
            [
                "0",
                "16",
                "38.2",
                "10.0",
                "100",
                "1\u{202f}235",
                "0.500",
                "0.012",
                "5.0e-4",
                "\u{2212}2.50",
                "\u{2212}0.040"
            ]
        );
        assert_eq!(short(f64::INFINITY), "\u{221e}");
        assert_eq!(short(f64::NEG_INFINITY), "\u{2212}\u{221e}");
        assert_eq!(short(f64::NAN), "\u{2014}");
    }

    #[test]
    fn the_exact_number_is_there_for_programs() {
        assert_eq!(number(0.1 + 0.2).into_string(), "<data value=\"0.30000000000000004\">0.300</data>");
        assert_eq!(signed(1.5).into_string(), "<data value=\"1.5\">+1.50</data>");
        assert_eq!(signed_count(-1234).into_string(), "<data value=\"-1234\">\u{2212}1\u{202f}234</data>");
        assert_eq!(signed_count(7).into_string(), "<data value=\"7\">+7</data>");
        assert_eq!(count(1_000_000).into_string(), "<data value=\"1000000\">1\u{202f}000\u{202f}000</data>");
        assert_eq!(percent(0.25).into_string(), "<data value=\"0.25\">25\u{202f}%</data>");
    }
}

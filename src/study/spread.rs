//! What repeated measurements say.

use serde::Serialize;

/// Repeated measurements in brief.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Spread {
    /// The least.
    pub min: f64,
    /// The one in the middle, or the mean of the two there.
    pub median: f64,
    /// Between the quarter from below and the quarter from above: interpolated between neighbours.
    pub iqr: f64,
}

impl Spread {
    /// Of some measurements, none of them NaN; all 0 if there is none.
    pub fn of(measured: &[f64]) -> Self {
        let mut sorted = measured.to_vec();
        sorted.sort_by(f64::total_cmp);
        let at = |fraction| quantile(&sorted, fraction);
        Self { min: at(0.0), median: at(0.5), iqr: at(0.75) - at(0.25) }
    }
}

fn quantile(sorted: &[f64], fraction: f64) -> f64 {
    let Some(last) = sorted.len().checked_sub(1) else { return 0.0 };
    // Measurements are few.
    let position = fraction * f64::from(u32::try_from(last).unwrap_or(u32::MAX));
    let below =
        (0..last).take_while(|&index| f64::from(u32::try_from(index + 1).unwrap_or(u32::MAX)) <= position);
    let index = below.count();
    let rest = position - f64::from(u32::try_from(index).unwrap_or(u32::MAX));
    let above = sorted[(index + 1).min(last)];
    sorted[index] + (above - sorted[index]) * rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quartiles_lie_between_neighbours() {
        assert_eq!(Spread::of(&[]), Spread::default());
        assert_eq!(Spread::of(&[7.0]), Spread { min: 7.0, median: 7.0, iqr: 0.0 });
        assert_eq!(Spread::of(&[3.0, 1.0]), Spread { min: 1.0, median: 2.0, iqr: 1.0 });
        assert_eq!(Spread::of(&[5.0, 1.0, 4.0, 2.0, 3.0]), Spread { min: 1.0, median: 3.0, iqr: 2.0 });
    }
}

//! Axes of the plot: where a number is, and which numbers are named.

/// A range of numbers along a line of the drawing.
#[derive(Clone, Copy, Debug)]
pub(super) struct Axis {
    /// Numbers at both ends.
    pub(super) range: [f64; 2],
    /// Places of both ends, in pixels.
    pub(super) ends: [f64; 2],
}

impl Axis {
    /// The place of a number; of what is beyond an end, that end.
    pub(super) fn place(&self, number: f64) -> f64 {
        let share = (number - self.range[0]) / (self.range[1] - self.range[0]);
        let share = share.clamp(0.0, 1.0);
        self.ends[0] + share * (self.ends[1] - self.ends[0])
    }
}

/// 1, 2 and 5 times powers of ten within a range; the powers alone where those would be many.
pub(super) fn log_ticks(least: f64, most: f64) -> Vec<f64> {
    let within = |factors: &'static [f64]| {
        let powers = (-12..=12).map(|power| 10.0_f64.powi(power));
        let ticks = powers.flat_map(|power| factors.iter().map(move |factor| factor * power));
        ticks.filter(|tick| (least..=most).contains(tick)).collect::<Vec<f64>>()
    };
    let ticks = within(&[1.0, 2.0, 5.0]);
    if ticks.len() > 10 { within(&[1.0]) } else { ticks }
}

/// Multiples of 1, 2, 5, 10, ... within a range, ten at most.
pub(super) fn even_ticks(least: f64, most: f64) -> Vec<f64> {
    let steps = [1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0];
    let step = steps.into_iter().find(|step| (most - least) / step <= 10.0).unwrap_or(100.0);
    let first = (least / step).ceil() * step;
    (0..=10).map(|number| first + f64::from(number) * step).filter(|&tick| tick <= most).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_lie_between_the_ends() {
        let axis = Axis { range: [10.0, 20.0], ends: [100.0, 0.0] };
        assert_eq!(
            [5.0, 10.0, 15.0, 20.0, 99.0].map(|number| axis.place(number)),
            [100.0, 100.0, 50.0, 0.0, 0.0]
        );
        assert_eq!(axis.place(f64::INFINITY), 0.0);
    }

    #[test]
    fn ticks_are_round_and_few() {
        assert_eq!(log_ticks(3.0, 120.0), [5.0, 10.0, 20.0, 50.0, 100.0]);
        assert_eq!(log_ticks(0.5, 40_000.0), [1.0, 10.0, 100.0, 1000.0, 10_000.0]);
        assert_eq!(even_ticks(23.0, 53.0), [25.0, 30.0, 35.0, 40.0, 45.0, 50.0]);
        assert_eq!(even_ticks(-1.0, 2.0), [-1.0, 0.0, 1.0, 2.0]);
    }
}

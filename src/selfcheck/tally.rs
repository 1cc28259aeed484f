//! What the rays of a group have shown.

use core::fmt;

/// Rays of one kind in one precision, counted.
#[derive(Clone, Debug, PartialEq)]
pub struct Tally {
    /// What was checked.
    pub group: &'static str,
    /// In which precision, `"f64"` or `"f32"`.
    pub precision: &'static str,
    /// Rays, or pixels.
    pub cases: u64,
    /// How many of the measured ray parameters were off by at most half an epsilon, by at most 1, 2, 4, and by more.
    pub errors: [u64; 5],
    /// The largest error in epsilons.
    pub worst: f64,
    /// Surfaces that were missed; of spheres, where no rounding could excuse it.
    pub leaks: u64,
    /// Surfaces that were met where there are none; of spheres, where no rounding could excuse it.
    pub false_hits: u64,
    /// Answers that were wrong in another way: side, ray parameter, or not the same on every path.
    pub wrong: u64,
}

impl Tally {
    /// Nothing counted yet.
    pub(super) fn new(group: &'static str, precision: &'static str) -> Self {
        let errors = [0; 5];
        Self { group, precision, cases: 0, errors, worst: 0.0, leaks: 0, false_hits: 0, wrong: 0 }
    }

    /// Takes an error in epsilons that may be as large as a bound.
    pub(super) fn measure(&mut self, error: f64, bound: f64) {
        let class = [0.5, 1.0, 2.0, 4.0].iter().take_while(|&&limit| error > limit).count();
        self.errors[class] += 1;
        self.worst = self.worst.max(error);
        // A NaN is wrong, too.
        let is_right = error <= bound;
        self.wrong += u64::from(!is_right);
    }

    /// Whether every answer was right.
    pub fn is_good(&self) -> bool {
        self.leaks + self.false_hits + self.wrong == 0
    }

    /// The line above the rows.
    pub fn header() -> String {
        format!(
            "{:<26} {:>4} {:>9} {:>7} {:>7} {:>7} {:>7} {:>6} {:>6} {:>6} {:>6} {:>6}",
            "rays", "", "cases", "<= 1/2", "<= 1", "<= 2", "<= 4", "> 4", "worst", "leaks", "false", "wrong"
        )
    }

    /// Share of the measured errors in each class, in percent; nothing where nothing was measured.
    fn shares(&self) -> [String; 5] {
        let measured: u64 = self.errors.iter().sum();
        self.errors.map(|count| match count {
            _ if measured == 0 => "-".to_owned(),
            0 => "0".to_owned(),
            _ => format!("{:.2}%", percent(count, measured)),
        })
    }
}

impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [half, one, two, four, more] = self.shares();
        let worst = if self.errors == [0; 5] { "-".to_owned() } else { format!("{:.2}", self.worst) };
        write!(
            f,
            "{:<26} {:>4} {:>9} {half:>7} {one:>7} {two:>7} {four:>7} {more:>6} {worst:>6} {:>6} {:>6} {:>6}  {}",
            self.group,
            self.precision,
            self.cases,
            self.leaks,
            self.false_hits,
            self.wrong,
            if self.is_good() { "good" } else { "BAD" }
        )
    }
}

#[expect(clippy::cast_precision_loss, reason = "two digits are shown")]
fn percent(count: u64, of: u64) -> f64 {
    100.0 * count as f64 / of as f64
}

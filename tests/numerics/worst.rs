//! The largest error seen.

/// A figure that must stay within a bound; printed at the end.
pub(crate) struct Worst {
    name: String,
    error: f64,
}

impl Worst {
    /// Nothing measured yet.
    pub(crate) fn new(name: &str) -> Self {
        Self { name: name.to_owned(), error: 0.0 }
    }

    /// Takes an error and fails above its bound; NaN fails, too.
    pub(crate) fn measure(&mut self, error: f64, bound: f64, input: impl Fn() -> String) {
        assert!(error <= bound, "{}: {error} above {bound}: {}", self.name, input());
        self.error = self.error.max(error);
    }
}

impl Drop for Worst {
    fn drop(&mut self) {
        println!("{}: worst {:.3}", self.name, self.error);
    }
}

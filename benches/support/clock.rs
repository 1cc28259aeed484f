//! Wall and processor time of work that is done again and again.

use std::fs;
use std::time::Instant;

use serde::Serialize;

/// Milliseconds of each repetition.
#[derive(Default)]
pub(crate) struct Laps {
    wall: Vec<f64>,
    processor: Vec<f64>,
}

/// Milliseconds of a repetition.
#[derive(Clone, Copy, Serialize)]
pub(crate) struct Times {
    pub(crate) ms_min: f64,
    pub(crate) ms_median: f64,
    /// Of all threads together, where the system tells.
    pub(crate) cpu_ms_min: Option<f64>,
    pub(crate) cpu_ms_median: Option<f64>,
}

impl Laps {
    /// Does the work once.
    pub(crate) fn time(&mut self, work: impl FnOnce()) {
        let (start, before) = (Instant::now(), processor_ms());
        work();
        self.wall.push(start.elapsed().as_secs_f64() * 1e3);
        self.processor.extend(before.zip(processor_ms()).map(|(before, after)| after - before));
    }

    /// The least and the median.
    pub(crate) fn times(&mut self) -> Times {
        let (ms_min, ms_median) = least_and_median(&mut self.wall).unwrap_or((f64::NAN, f64::NAN));
        let (cpu_ms_min, cpu_ms_median) = least_and_median(&mut self.processor).unzip();
        Times { ms_min, ms_median, cpu_ms_min, cpu_ms_median }
    }
}

fn least_and_median(values: &mut [f64]) -> Option<(f64, f64)> {
    values.sort_by(f64::total_cmp);
    Some((*values.first()?, *values.get(values.len() / 2)?))
}

/// Processor time of all threads of this process so far, on Linux.
fn processor_ms() -> Option<f64> {
    let mut sum = 0.0;
    for thread in fs::read_dir("/proc/self/task").ok()? {
        let stat = fs::read_to_string(thread.ok()?.path().join("schedstat")).ok()?;
        sum += stat.split(' ').next()?.parse::<f64>().ok()?;
    }
    Some(sum * 1e-6)
}

//! The error of a picture, as its own samples tell it.
//!
//! Of `n` samples with the standard deviation `s` the first differs from their mean by `s` times the root of `1 - 1/n`, in
//! the root mean square: over a whole picture that tells `s` well, in a single pixel it is a guess. The error of the mean of
//! `n` points of a regular grid is then `s` by the 3/4th power of `n`, as
//! [`error_of_mean`](crate::trace::error_of_mean) has it: where an edge runs through a pixel that is right within a factor of
//! two, in smooth shading it is too much. What no sample has met, a deeper mirror image above all, is not in it.

use crate::film::Film;

/// The error to expect of each channel of each pixel.
pub(super) struct Estimate {
    channels: Vec<[f64; 3]>,
}

impl Estimate {
    /// Of a picture with so many samples a pixel, of which the first are known; the mean is over another number of them.
    pub(super) fn uniform(first: &Film, (mean, of): (&Film, u32), samples: u32) -> Self {
        let factor = factor(f64::from(of), f64::from(samples));
        Self::new(first, mean, |_| factor)
    }

    /// Of a picture whose pixels have different numbers of samples. One that was left at one sample, because what is around
    /// it was found to be alike, counts as known.
    pub(super) fn adaptive(first: &Film, mean: &Film, samples: &[u16]) -> Self {
        Self::new(first, mean, |index| {
            samples.get(index).map_or(0.0, |&n| factor(f64::from(n), f64::from(n)))
        })
    }

    fn new(first: &Film, mean: &Film, factor: impl Fn(usize) -> f64) -> Self {
        let pixels = first.pixels().iter().zip(mean.pixels()).enumerate();
        let channels = pixels.map(|(index, (first, mean))| {
            let factor = factor(index);
            [0, 1, 2].map(|channel| (first[channel] - mean[channel]).abs() * factor)
        });
        Self { channels: channels.collect() }
    }

    /// Root of the mean squared error of all channels, 0 to 1.
    pub(super) fn rmse(&self) -> f64 {
        let (mut sum, mut count) = (0.0, 0.0_f64);
        for error in self.channels.iter().flatten() {
            sum += error * error;
            count += 1.0;
        }
        (sum / count.max(1.0)).sqrt()
    }

    /// The largest error of a channel of each pixel, 0 to 1.
    pub(super) fn of_pixels(&self) -> Vec<f64> {
        self.channels.iter().map(|error| error.iter().copied().fold(0.0, f64::max)).collect()
    }
}

/// From the difference between one of `of` samples and their mean to the error of the mean of `samples`.
fn factor(of: f64, samples: f64) -> f64 {
    if of > 1.0 { 1.0 / ((1.0 - 1.0 / of).sqrt() * samples.powf(0.75)) } else { 0.0 }
}

//! How far two pictures are apart.

use crate::film::Film;

/// Two pictures of the same size compared, pixel by pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Difference {
    /// Root of the mean squared difference of all channels, 0 to 1.
    pub rmse: f64,
    /// The largest difference of a channel in levels of 8 bits, 0 to 255.
    pub worst_level: u8,
    /// Share of the pixels of which some channel differs by more than 1 level, 0 to 1.
    pub over1: f64,
    /// Share of the pixels of which some channel differs by more than 8 levels, 0 to 1.
    pub over8: f64,
}

impl Difference {
    /// Between two films; `None` unless they are of the same size and not empty.
    pub fn between(a: &Film, b: &Film) -> Option<Self> {
        if a.side() != b.side() || a.side() == 0 {
            return None;
        }
        let channels = || a.pixels().as_flattened().iter().zip(b.pixels().as_flattened().iter());
        let squares: f64 = channels().map(|(a, b)| (a - b) * (a - b)).sum();
        let pixels = f64::from(a.side()) * f64::from(a.side());
        let levels: Vec<u8> = a.to_rgb8().iter().zip(b.to_rgb8()).map(|(a, b)| a.abs_diff(b)).collect();
        let worst: Vec<u8> = levels.chunks_exact(3).map(|rgb| rgb[0].max(rgb[1]).max(rgb[2])).collect();
        let over = |most: u8| {
            // At most 8192 x 8192.
            f64::from(u32::try_from(worst.iter().filter(|&&level| level > most).count()).unwrap_or(u32::MAX))
        };
        Some(Self {
            rmse: (squares / (3.0 * pixels)).sqrt(),
            worst_level: worst.iter().copied().max().unwrap_or(0),
            over1: over(1) / pixels,
            over8: over(8) / pixels,
        })
    }

    /// Peak signal to noise in decibels, infinite for equal pictures.
    pub fn psnr_db(&self) -> f64 {
        -20.0 * self.rmse.log10()
    }
}

//! The film: a square picture in linear colour.

use core::ops::Range;

use rayon::prelude::*;

use crate::effects::{SrgbLevels, Transfer};
use crate::large_pages;

/// Channels that are worth waking a thread for.
const PART: usize = 1 << 17;

/// Linear red, green and blue of each pixel, 0 to 1; row 0 is the top, rows follow each other.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Film {
    side: u32,
    pixels: Vec<[f64; 3]>,
    transfer: Transfer,
}

impl Film {
    /// A black film of `side` by `side` pixels; `None` if there is no memory for it.
    pub fn new(side: u32) -> Option<Self> {
        let count = usize::try_from(u64::from(side) * u64::from(side)).ok()?;
        // Tried first, because `vec!` would abort; `vec!` then, because its zeroes cost nothing until used.
        Vec::<[f64; 3]>::new().try_reserve_exact(count).ok()?;
        let pixels = vec![[0.0; 3]; count];
        large_pages::ask_for(&pixels);
        Some(Self { side, pixels, transfer: Transfer::Linear })
    }

    /// Pixels along each side.
    pub fn side(&self) -> u32 {
        self.side
    }

    /// All pixels, top row first.
    pub fn pixels(&self) -> &[[f64; 3]] {
        &self.pixels
    }

    /// All pixels, top row first, to be written.
    pub fn pixels_mut(&mut self) -> &mut [[f64; 3]] {
        &mut self.pixels
    }

    /// Chooses what light becomes in 8 bits; linear unless said otherwise.
    pub fn set_transfer(&mut self, transfer: Transfer) {
        self.transfer = transfer;
    }

    /// The picture in 8 bits a channel, red, green, blue, top row first: each channel times 255, truncated, after the
    /// film's transfer. A large one is made by rayon's current threads.
    pub fn to_rgb8(&self) -> Vec<u8> {
        self.mean_to_rgb8(1)
    }

    /// The same of a film that holds the sums of that many samples: what [`Self::divide`] and [`Self::to_rgb8`] give,
    /// but the sums stay.
    pub fn mean_to_rgb8(&self, samples: u32) -> Vec<u8> {
        let tone = Tone::of(self.transfer);
        // As one slice: of pixels one after the other it took ten times as long, a tenth of the time from start to file.
        let channels = self.pixels.as_flattened();
        let mut levels = vec![0; channels.len()];
        if channels.len() <= PART {
            tone.put_levels(channels, samples, &mut levels);
        } else {
            let parts = levels.par_chunks_mut(PART).zip(channels.par_chunks(PART));
            parts.for_each(|(levels, channels)| tone.put_levels(channels, samples, levels));
        }
        levels
    }

    /// The same picture with more pixels along each side, each of which shows the one below it; `None` if there is no memory
    /// for it.
    pub fn enlarged(&self, side: u32) -> Option<Self> {
        let mut large = Self::new(side)?;
        large.transfer = self.transfer;
        let from = |place: u32| place as usize * self.side as usize / side as usize;
        for (row, pixels) in (0..side).zip(large.pixels.chunks_mut(side.max(1) as usize)) {
            for (column, pixel) in (0..side).zip(pixels) {
                *pixel = self.pixels[from(row) * self.side as usize + from(column)];
            }
        }
        Some(large)
    }

    /// Divides every pixel, as the sum of that many samples.
    pub fn divide(&mut self, samples: u32) {
        // Nothing changes for one, and reading a large film takes its time.
        if samples == 1 {
            return;
        }
        let count = f64::from(samples);
        self.pixels.iter_mut().flatten().for_each(|channel| *channel /= count);
    }

    /// The film cut across into bands of `height` rows (at least 1), the last one lower if need be, which can be filled
    /// in any order. Nothing is allocated.
    pub fn bands_mut(&mut self, height: u32) -> impl Iterator<Item = FilmBand<'_>> {
        let (side, length) = (self.side, self.band_length(height));
        self.pixels
            .chunks_mut(length)
            .enumerate()
            .map(move |(number, pixels)| FilmBand::new(side, height, number, pixels))
    }

    /// Pixels in bands of `height` rows.
    pub fn band_length(&self, height: u32) -> usize {
        (self.side as usize * height.max(1) as usize).max(1)
    }
}

/// Room for a picture of `side` by `side` pixels in 8 bits a channel, three bytes a pixel; `None` if there is no memory for
/// it.
pub fn room_for_levels(side: u32) -> Option<Vec<u8>> {
    let count = usize::try_from(3 * u64::from(side) * u64::from(side)).ok()?;
    Vec::<u8>::new().try_reserve_exact(count).ok()?;
    let levels = vec![0; count];
    large_pages::ask_for(&levels);
    Some(levels)
}

/// How light becomes levels.
#[derive(Clone, Debug)]
pub enum Tone {
    /// In proportion.
    Linear,
    /// By the curve of sRGB.
    Srgb(Box<SrgbLevels>),
}

impl Tone {
    /// That of a transfer.
    pub fn of(transfer: Transfer) -> Self {
        match transfer {
            Transfer::Linear => Self::Linear,
            Transfer::Srgb => Self::Srgb(Box::default()),
        }
    }

    /// The level of each channel, of as many as there is room for, whose light is the sum of that many samples.
    pub fn put_levels(&self, channels: &[f64], samples: u32, levels: &mut [u8]) {
        let count = f64::from(samples);
        match self {
            // Divisions would take a ninth of the time.
            Self::Linear if samples == 1 => put(channels, levels, quantize),
            Self::Linear => put(channels, levels, |sum| quantize(sum / count)),
            Self::Srgb(curve) => put(channels, levels, |sum| curve.level(sum / count)),
        }
    }
}

fn put(channels: &[f64], levels: &mut [u8], level: impl Fn(f64) -> u8) {
    for (place, &channel) in levels.iter_mut().zip(channels) {
        *place = level(channel);
    }
}

/// Some rows of a film that can be written while others write the rest.
#[derive(Debug)]
pub struct FilmBand<'a> {
    side: u32,
    top: u32,
    pixels: &'a mut [[f64; 3]],
}

impl<'a> FilmBand<'a> {
    /// The band of this number, of a film of `side` pixels a row that is cut into bands of `height` rows (at least 1).
    pub fn new(side: u32, height: u32, number: usize, pixels: &'a mut [[f64; 3]]) -> Self {
        let top = u32::try_from(number).unwrap_or(u32::MAX).saturating_mul(height.max(1));
        Self { side, top, pixels }
    }

    /// Pixels in a row.
    pub fn side(&self) -> u32 {
        self.side
    }

    /// Number of the first row in the film.
    pub fn top(&self) -> u32 {
        self.top
    }

    /// Number of rows.
    pub fn height(&self) -> u32 {
        u32::try_from(self.pixels.len() / (self.side as usize).max(1)).unwrap_or(u32::MAX)
    }

    /// The pixels in this row of the band and these columns of the film.
    #[inline(always)]
    pub fn pixels_mut(&mut self, row: u32, columns: Range<u32>) -> &mut [[f64; 3]] {
        let first = row as usize * self.side as usize;
        &mut self.pixels[first + columns.start as usize..first + columns.end as usize]
    }
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "truncation is the definition; the channel is clamped to 0..=1"
)]
fn quantize(channel: f64) -> u8 {
    (channel * 255.0) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every channel another one, below 0 and above 1 too, the first and the last no number.
    fn film(side: u32) -> Film {
        let mut film = Film::new(side).unwrap();
        let count = f64::from(3 * side * side);
        for (number, channel) in (0_u32..).zip(film.pixels.as_flattened_mut()) {
            *channel = 1.2 * f64::from(number) / count - 0.1;
        }
        let (first, last) = (0, film.pixels.len() - 1);
        (film.pixels[first][0], film.pixels[last][2]) = (f64::NAN, f64::NAN);
        film
    }

    #[test]
    fn many_threads_make_of_a_film_what_its_rows_are_alone() {
        // Parts of a whole number of channels and one that is smaller.
        let side = 300;
        assert!(3 * (side * side) as usize > 2 * PART);
        for transfer in [Transfer::Linear, Transfer::Srgb] {
            let mut film = film(side);
            film.set_transfer(transfer);
            for samples in [1, 3] {
                let alone = |pixels: &[[f64; 3]]| {
                    Film { side, pixels: pixels.into(), transfer }.mean_to_rgb8(samples)
                };
                let expected: Vec<u8> = film.pixels().chunks(side as usize).flat_map(alone).collect();
                assert!(film.mean_to_rgb8(samples) == expected, "{transfer:?}, {samples} samples");
            }
        }
    }

    #[test]
    fn levels_are_truncated_and_clamped() {
        for (light, level) in
            [(-1.0, 0), (0.0, 0), (0.999 / 255.0, 0), (1.0 / 255.0, 1), (0.5, 127), (1.0, 255), (9.0, 255)]
        {
            assert_eq!(quantize(light), level, "{light}");
        }
    }
}

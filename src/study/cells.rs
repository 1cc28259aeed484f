//! Parts of a picture that tell what the whole costs and how wrong it is.
//!
//! The picture is cut into square cells. Some are drawn, the likelier the more error is expected in them, and what is summed
//! over them is weighed by the inverse of their chance: such sums are right on average whatever was expected (D. G. Horvitz
//! and D. J. Thompson, "A Generalization of Sampling Without Replacement from a Finite Universe", JASA 47, 1952). Cells are
//! drawn at even steps along the sums of their chances, so that nothing here is random.

use std::ops::Range;

use crate::film::Film;

use super::{Glimpse, Windows};

/// Pixels along each side of a cell, and how many more are traced around it: adaptive samples look so far.
const CELL: u32 = 16;
const RIM: u32 = 1;
/// Of so many cells one is drawn, within these numbers.
const ONE_OF: usize = 24;
const FEWEST: usize = 32;
const MOST: usize = 128;
/// Share of the draws that does not look at expected errors: where none is expected there may be one.
const EVEN_SHARE: f64 = 0.4;

/// Cells that were drawn.
pub(super) struct Cells {
    /// The cells and what is around them.
    windows: Windows,
    /// Columns and rows of the cell in each window.
    inside: Vec<[Range<usize>; 2]>,
    /// The chance that each had.
    chances: Vec<f64>,
    /// Pixels of the whole picture.
    area: f64,
}

/// A mean over the whole picture, guessed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Guess {
    pub(super) mean: f64,
    /// Standard error of the mean.
    pub(super) deviation: f64,
}

impl Cells {
    /// Draws from a picture of `pixels` by `pixels`, by the errors (0 to 1) that are expected in a picture of the same
    /// from `side` by `side`, top row first.
    pub(super) fn draw(pixels: u32, side: u32, errors: &[f64]) -> Self {
        let all = lattice(pixels);
        let weights = weights(pixels, &all, side, errors);
        let number = (all.len() / ONE_OF).clamp(FEWEST, MOST).min(all.len());
        let chances = chances(&weights, number);
        let drawn: Vec<usize> = draw(&chances);
        let window = (CELL + 2 * RIM).min(pixels);
        let corner = |cell: &[Range<u32>; 2]| {
            cell.clone().map(|places| places.start.saturating_sub(RIM).min(pixels - window))
        };
        let corners: Vec<[u32; 2]> = drawn.iter().map(|&cell| corner(&all[cell])).collect();
        let inside = drawn.iter().zip(&corners).map(|(&cell, corner)| {
            [0, 1].map(|axis| {
                let Range { start, end } = all[cell][axis].clone();
                (start - corner[axis]) as usize..(end - corner[axis]) as usize
            })
        });
        Self {
            inside: inside.collect(),
            chances: drawn.iter().map(|&cell| chances[cell]).collect(),
            windows: Windows { corners, side: window },
            area: f64::from(pixels) * f64::from(pixels),
        }
    }

    /// What is to be traced.
    pub(super) fn windows(&self) -> &Windows {
        &self.windows
    }

    /// The mean square of the differences of all channels over the picture.
    pub(super) fn mean_square(&self, a: &Glimpse, b: &Glimpse) -> Guess {
        let films = a.films.iter().zip(&b.films).zip(&self.inside);
        let sums: Vec<f64> = films.map(|((a, b), inside)| squares(a, b, inside)).collect();
        let channels = 3.0 * self.area;
        let sum: f64 = self.weighed(&sums).sum();
        Guess { mean: sum / channels, deviation: self.deviation(&sums) / channels }
    }

    /// How many times as many rays one takes for the whole picture as the other.
    pub(super) fn times_the_rays(&self, a: &Glimpse, b: &Glimpse) -> f64 {
        let sum = |glimpse: &Glimpse| self.weighed(&rays(glimpse)).sum::<f64>();
        sum(a) / sum(b).max(1.0)
    }

    fn weighed(&self, sums: &[f64]) -> impl Iterator<Item = f64> {
        sums.iter().zip(&self.chances).map(|(sum, chance)| sum / chance)
    }

    /// The standard error of a weighed sum, as if the cells had been drawn one by one: J. Hajek, "Asymptotic Theory of
    /// Rejective Sampling with Varying Probabilities from a Finite Population", Ann. Math. Stat. 35, 1964. Even steps
    /// are better than that.
    fn deviation(&self, sums: &[f64]) -> f64 {
        let doubts = || self.chances.iter().map(|chance| 1.0 - chance);
        let doubt: f64 = doubts().sum();
        let number = doubts().filter(|&doubt| doubt > 0.0).map(|_| 1.0).sum::<f64>();
        if number < 2.0 {
            return 0.0;
        }
        let center = self.weighed(sums).zip(doubts()).map(|(sum, doubt)| sum * doubt).sum::<f64>() / doubt;
        let squares = self.weighed(sums).zip(doubts()).map(|(sum, doubt)| doubt * (sum - center).powi(2));
        (squares.sum::<f64>() * number / (number - 1.0)).sqrt()
    }
}

/// Milliseconds that windows took for a ray.
pub(super) fn price_of_ray(glimpse: &Glimpse) -> f64 {
    glimpse.milliseconds / rays(glimpse).iter().sum::<f64>().max(1.0)
}

fn rays(glimpse: &Glimpse) -> Vec<f64> {
    glimpse.counts.iter().map(|counts| whole(counts.rays.total())).collect()
}

/// All cells of a picture: columns and rows. Those at its right and bottom may be narrower.
fn lattice(pixels: u32) -> Vec<[Range<u32>; 2]> {
    let places = move || (0..pixels).step_by(CELL as usize).map(move |at| at..(at + CELL).min(pixels));
    places().flat_map(|rows| places().map(move |columns| [columns, rows.clone()])).collect()
}

/// How likely each cell should be drawn, compared with the others.
fn weights(pixels: u32, cells: &[[Range<u32>; 2]], side: u32, errors: &[f64]) -> Vec<f64> {
    let per_row = pixels.div_ceil(CELL) as usize;
    let cell_of = |place: usize| {
        let side = side.max(1) as usize;
        let cell = |place: usize| place * pixels as usize / side / CELL as usize;
        cell(place / side) * per_row + cell(place % side)
    };
    let mut expected = vec![0.0; cells.len()];
    for (place, error) in errors.iter().enumerate() {
        expected[cell_of(place)] += error * error;
    }
    let total: f64 = expected.iter().sum();
    let area = f64::from(pixels) * f64::from(pixels);
    let weight = |(cell, expected): (&[Range<u32>; 2], &f64)| {
        let [columns, rows] = cell.clone().map(|places| f64::from(places.end - places.start));
        let even = columns * rows / area;
        if total > 0.0 { EVEN_SHARE * even + (1.0 - EVEN_SHARE) * expected / total } else { even }
    };
    cells.iter().zip(&expected).map(weight).collect()
}

/// Chances in proportion to weights above 0, none above 1, that add up to a number.
fn chances(weights: &[f64], number: usize) -> Vec<f64> {
    let mut certain = vec![false; weights.len()];
    loop {
        let taken = certain.iter().filter(|&&certain| certain).count();
        let rest: f64 = weights.iter().zip(&certain).filter(|(_, certain)| !**certain).map(|(w, _)| w).sum();
        let scale = whole(number.saturating_sub(taken) as u64) / rest.max(f64::MIN_POSITIVE);
        // A hair below 1 is rounding.
        let too_many = |cell: &usize| !certain[*cell] && weights[*cell] * scale > 1.0 - 1e-9;
        let more: Vec<usize> = (0..weights.len()).filter(too_many).collect();
        if more.is_empty() {
            let chance = |(weight, certain): (&f64, &bool)| if *certain { 1.0 } else { weight * scale };
            return weights.iter().zip(&certain).map(chance).collect();
        }
        more.into_iter().for_each(|cell| certain[cell] = true);
    }
}

/// Those that are certain, and of the others each in which the sum of chances passes the middle between two whole numbers.
fn draw(chances: &[f64]) -> Vec<usize> {
    let mut sum = 0.5_f64;
    let mut is_drawn = |chance: f64| {
        let before = sum.floor();
        sum += if chance < 1.0 { chance } else { 0.0 };
        chance >= 1.0 || sum.floor() > before
    };
    (0..chances.len()).filter(|&cell| is_drawn(chances[cell])).collect()
}

/// The sum of the squares of the differences of all channels within columns and rows.
fn squares(a: &Film, b: &Film, [columns, rows]: &[Range<usize>; 2]) -> f64 {
    let side = a.side() as usize;
    let pixels = a.pixels().iter().zip(b.pixels()).enumerate();
    let inside = pixels.filter(|(at, _)| columns.contains(&(at % side)) && rows.contains(&(at / side)));
    inside.flat_map(|(_, (a, b))| (0..3).map(|channel| (a[channel] - b[channel]).powi(2))).sum()
}

/// Far below 2^53.
#[expect(clippy::cast_precision_loss, reason = "counts of rays and cells are far below 2^53")]
fn whole(count: u64) -> f64 {
    count as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trace::Counts;

    /// Films whose pixels are off by `error(column, row)` in each channel.
    fn glimpse(cells: &Cells, error: impl Fn(u32, u32) -> f64) -> Glimpse {
        let side = cells.windows.side;
        let film = |corner: &[u32; 2]| {
            let mut film = Film::new(side).unwrap();
            for (at, pixel) in (0..).zip(film.pixels_mut()) {
                *pixel = [error(corner[0] + at % side, corner[1] + at / side); 3];
            }
            film
        };
        let films: Vec<Film> = cells.windows.corners.iter().map(film).collect();
        Glimpse { counts: vec![Counts::default(); films.len()], films, milliseconds: 0.0 }
    }

    fn guess(pixels: u32, expected: &[f64], side: u32, error: impl Fn(u32, u32) -> f64) -> Guess {
        let cells = Cells::draw(pixels, side, expected);
        cells.mean_square(&glimpse(&cells, error), &glimpse(&cells, |_, _| 0.0))
    }

    #[test]
    fn a_small_picture_is_known() {
        for pixels in [1, 3, 15, 16, 17, 18, 19, 40, 64, 80] {
            let error = |column: u32, row: u32| f64::from(column * 3 + row % 7) / 300.0;
            let squares = |row: u32| (0..pixels).map(|column| error(column, row).powi(2)).sum::<f64>();
            let truth = (0..pixels).map(squares).sum::<f64>() / f64::from(pixels * pixels);
            let guess = guess(pixels, &[0.1, 0.2, 0.3, 0.4], 2, error);
            assert!((guess.mean - truth).abs() < 1e-12 * (truth + 1e-3), "{pixels}: {guess:?} {truth}");
            assert!(guess.deviation < 1e-12);
        }
    }

    #[test]
    fn what_is_the_same_everywhere_is_known_whatever_was_expected() {
        let mut expected = vec![0.0; 64 * 64];
        (0..64).for_each(|at| expected[at * 65] = 0.5);
        let guess = guess(768, &expected, 64, |_, _| 0.25);
        // The number of drawn cells is right but for the last step.
        assert!((guess.mean - 0.0625).abs() < 0.0625 * 0.35, "{guess:?}");
    }

    #[test]
    fn a_rare_edge_is_found_where_it_is_expected() {
        // One pixel in each row, along a diagonal.
        let truth = 768.0 / (768.0 * 768.0);
        let expected: Vec<f64> =
            (0..768 * 768).map(|at| if at % 768 == at / 768 { 0.3 } else { 0.0 }).collect();
        let found = guess(768, &expected, 768, |column, row| f64::from(u8::from(column == row)));
        assert!((found.mean / truth - 1.0).abs() < 0.05, "{found:?}");
        assert!(found.deviation < 0.1 * found.mean);
        // Nobody expected it: wrong by more, but not by more than is said.
        let found = guess(768, &[0.0], 1, |column, row| f64::from(u8::from(column == row)));
        assert!((found.mean - truth).abs() < 3.0 * found.deviation, "{found:?} {truth}");
    }

    #[test]
    fn chances_add_up_and_end_at_one() {
        for weights in [vec![1.0; 7], vec![1e-9, 1.0, 2.0, 100.0, 1e-3, 5.0, 5.0], vec![1.0]] {
            for number in 1..=weights.len() {
                let chances = chances(&weights, number);
                let sum: f64 = chances.iter().sum();
                assert!((sum - f64::from(u32::try_from(number).unwrap())).abs() < 1e-9, "{chances:?}");
                assert!(chances.iter().all(|&chance| chance > 0.0 && chance <= 1.0));
                let drawn = draw(&chances).len();
                assert!(drawn.abs_diff(number) <= 1, "{number}: {chances:?}");
            }
        }
    }

    #[test]
    fn cells_cover_a_picture_once_and_windows_lie_in_it() {
        for pixels in [1, 15, 16, 17, 100, 768, 1024] {
            let area: u32 = lattice(pixels).iter().map(|[x, y]| (x.end - x.start) * (y.end - y.start)).sum();
            assert_eq!(area, pixels * pixels);
            let Cells { windows, inside, .. } = Cells::draw(pixels, 1, &[0.1]);
            assert!(!windows.corners.is_empty());
            for ([column, row], [columns, rows]) in windows.corners.iter().zip(&inside) {
                assert!(column + windows.side <= pixels && row + windows.side <= pixels, "{pixels}");
                assert!(columns.end.max(rows.end) <= windows.side as usize, "{pixels}");
            }
        }
    }
}

//! Structural similarity of pictures whose similarity can be computed by hand.

use archetrace::film::Film;
use archetrace::study::mean_ssim;

fn film(side: u32, level: impl Fn(usize, usize) -> [u8; 3]) -> Film {
    let mut film = Film::new(side).unwrap();
    for (row, pixels) in film.pixels_mut().chunks_mut(side as usize).enumerate() {
        for (column, pixel) in pixels.iter_mut().enumerate() {
            *pixel = level(column, row).map(|level| (f64::from(level) + 0.5) / 255.0);
        }
    }
    film
}

fn grey(side: u32, level: impl Fn(usize, usize) -> u8) -> Film {
    film(side, |column, row| [level(column, row); 3])
}

/// Scattered levels without any order to the eye.
fn noise(column: usize, row: usize) -> u8 {
    u8::try_from((column * 97 + row * row * 31 + column * column * row * 7) % 251).unwrap()
}

#[test]
fn equal_pictures_are_alike() {
    for side in [1, 2, 10, 11, 12, 40] {
        let picture = film(side, |column, row| [noise(column, row), noise(row, column), 9]);
        assert_eq!(mean_ssim(&picture, &picture), Some(1.0), "{side}");
    }
}

#[test]
fn pictures_of_different_sizes_cannot_be_compared() {
    assert_eq!(mean_ssim(&grey(2, |_, _| 0), &grey(3, |_, _| 0)), None);
    assert_eq!(mean_ssim(&Film::default(), &Film::default()), None);
}

#[test]
fn flat_pictures_differ_by_their_luminance_alone() {
    for (side, a, b) in [(1, 0, 255), (5, 100, 110), (11, 51, 204), (30, 7, 8)] {
        let [x, y] = [a, b].map(|level| f64::from(level) / 255.0);
        let expected = (2.0 * x * y + 1e-4) / (x * x + y * y + 1e-4);
        let found = mean_ssim(&grey(side, |_, _| a), &grey(side, |_, _| b)).unwrap();
        // What cancels in the variances is rounding, far below the constant that is added to them.
        assert!((found - expected).abs() < 1e-11, "{a} {b}: {found} {expected}");
    }
}

#[test]
fn colours_count_by_their_luma() {
    let luma = |rgb: [u8; 3]| film(4, |_, _| rgb);
    let of = |x: f64| (1e-4 / (x * x + 1e-4)).abs();
    for (rgb, weight) in [([255, 0, 0], 0.299), ([0, 255, 0], 0.587), ([0, 0, 255], 0.114)] {
        let found = mean_ssim(&luma([0; 3]), &luma(rgb)).unwrap();
        assert!((found - of(weight)).abs() < 1e-11, "{rgb:?}: {found}");
    }
}

#[test]
fn stripes_and_their_negative_are_each_others_opposite() {
    // 2 x 2 pixels are one window of equal weights: means 1/2, variances 1/4, covariance -1/4.
    let stripes = grey(2, |column, _| if column == 0 { 255 } else { 0 });
    let negative = grey(2, |column, _| if column == 0 { 0 } else { 255 });
    let expected = (-0.5 + 9e-4) / (0.5 + 9e-4);
    let found = mean_ssim(&stripes, &negative).unwrap();
    assert!((found - expected).abs() < 1e-12, "{found} {expected}");

    let picture = grey(40, noise);
    let inverted = grey(40, |column, row| 255 - noise(column, row));
    assert!(mean_ssim(&picture, &inverted).unwrap() < -0.5);
}

#[test]
fn noise_hurts_more_than_a_shift_of_all_levels() {
    let ramp = |column: usize, row: usize| u8::try_from(40 + 3 * column + 2 * row).unwrap();
    let picture = grey(32, ramp);
    // The same mean squared difference: 10 levels everywhere.
    let shifted = grey(32, |column, row| ramp(column, row) + 10);
    let noisy = grey(32, |column, row| {
        if noise(column, row).is_multiple_of(2) { ramp(column, row) + 10 } else { ramp(column, row) - 10 }
    });
    assert!(mean_ssim(&picture, &shifted).unwrap() > 0.95);
    assert!(mean_ssim(&picture, &noisy).unwrap() < 0.8);
}

#[test]
fn it_does_not_matter_which_picture_is_first() {
    let (a, b) = (grey(20, noise), grey(20, |column, row| noise(row, column)));
    assert_eq!(mean_ssim(&a, &b), mean_ssim(&b, &a));
}

//! Numbers of each pixel, and colours for them.

use crate::film::Film;

/// Levels of 8 bits at which the scale of [`error_share`] ends.
pub const ERROR_LEVELS: f64 = 64.0;

/// The largest difference of a channel of each pixel, 0 to 1, top row first; `None` unless both films are of the same size.
pub fn error_map(a: &Film, b: &Film) -> Option<Vec<f64>> {
    if a.side() != b.side() {
        return None;
    }
    let worst = |(a, b): (&[f64; 3], &[f64; 3])| {
        let channels = a.iter().zip(b).map(|(a, b)| (a - b).abs());
        channels.fold(0.0, f64::max)
    };
    Some(a.pixels().iter().zip(b.pixels()).map(worst).collect())
}

/// Red, green and blue for a share: black for 0 over purple, red and orange to pale yellow for 1, evenly brighter to the
/// eye. Shares beyond are as those at the ends, and NaN is as 1.
pub fn false_color(share: f64) -> [u8; 3] {
    let share = if share.is_nan() { 1.0 } else { share.clamp(0.0, 1.0) };
    colorous::INFERNO.eval_continuous(share).as_array()
}

/// Place of an error, 0 to 1, on a scale that shows one level of 8 bits as well as many: the square root, and 1 from
/// [`ERROR_LEVELS`] on.
pub fn error_share(error: f64) -> f64 {
    (error * 255.0 / ERROR_LEVELS).sqrt().min(1.0)
}

/// A [`false_color`] for each number, black for 0 and the brightest for `most`: red, green, blue, and so on.
pub fn false_colors(values: &[f64], most: f64) -> Vec<u8> {
    let share = |value: f64| if most > 0.0 { value / most } else { 0.0 };
    values.iter().flat_map(|&value| false_color(share(value))).collect()
}

/// A [`false_color`] for each error of an [`error_map`], on the scale of [`error_share`].
pub fn error_colors(errors: &[f64]) -> Vec<u8> {
    errors.iter().flat_map(|&error| false_color(error_share(error))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn film(pixels: [[f64; 3]; 4]) -> Film {
        let mut film = Film::new(2).unwrap();
        film.pixels_mut().copy_from_slice(&pixels);
        film
    }

    #[test]
    fn the_largest_channel_counts() {
        let a = film([[0.0; 3], [0.5; 3], [0.25, 0.5, 0.75], [1.0; 3]]);
        let b = film([[0.0, 0.5, 0.25], [0.5; 3], [0.25, 0.0, 0.5], [0.0; 3]]);
        assert_eq!(error_map(&a, &b), Some(vec![0.5, 0.0, 0.5, 1.0]));
        assert_eq!(error_map(&a, &Film::new(3).unwrap()), None);
    }

    #[test]
    fn colours_get_brighter_all_the_way() {
        let brightness = |step: i32| {
            let [red, green, blue] = false_color(f64::from(step) / 16.0).map(f64::from);
            0.299 * red + 0.587 * green + 0.114 * blue
        };
        assert!((0..16).all(|step| brightness(step) < brightness(step + 1)));
        assert!(brightness(0) < 2.0 && brightness(16) > 240.0);
    }

    #[test]
    fn what_is_off_the_scale_gets_its_ends() {
        assert_eq!(false_color(-1.0), false_color(0.0));
        for share in [2.0, f64::INFINITY, f64::NAN] {
            assert_eq!(false_color(share), false_color(1.0));
        }
        assert_eq!(error_share(1.0), 1.0);
        assert_eq!(
            [0.0, 1.0, 4.0, 16.0, 64.0].map(|levels| error_share(levels / 255.0)),
            [0.0, 0.125, 0.25, 0.5, 1.0]
        );
    }

    #[test]
    fn maps_have_three_bytes_a_pixel_and_scales_of_nothing_are_black() {
        let [low, half, high] = [0.0, 0.5, 1.0].map(false_color);
        assert_eq!(false_colors(&[0.0, 2.0, 4.0], 4.0), [low, half, high].concat());
        assert_eq!(false_colors(&[0.0, 3.0], 0.0), [low, low].concat());
        assert_eq!(error_colors(&[0.0, 16.0 / 255.0, 1.0]), [low, half, high].concat());
    }
}

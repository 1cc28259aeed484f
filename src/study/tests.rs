use crate::film::Film;

use super::Difference;

fn film(levels: [[f64; 3]; 4]) -> Film {
    let mut film = Film::new(2).unwrap();
    let mut levels = levels.into_iter();
    for mut tile in film.tiles_mut(2) {
        for (_, rows) in tile.bands_mut(2) {
            for pixel in rows.iter_mut().flat_map(|row| row.iter_mut()) {
                *pixel = levels.next().unwrap().map(|level| (level + 0.5) / 255.0);
            }
        }
    }
    film
}

#[test]
fn differences_are_those_counted_by_hand() {
    let black = film([[0.0; 3]; 4]);
    let other = film([[0.0; 3], [1.0, 0.0, 0.0], [0.0, 9.0, 0.0], [0.0, 3.0, 51.0]]);
    let difference = Difference::between(&black, &other).unwrap();
    assert_eq!((difference.worst_level, difference.over1, difference.over8), (51, 0.5, 0.5));
    let squares = difference.rmse.powi(2) * 12.0 * 255.0_f64.powi(2);
    assert_eq!(squares.round(), 1.0 + 81.0 + 9.0 + 51.0 * 51.0);
    // Half of a decibel is 6 % of an amplitude.
    assert_eq!(difference.psnr_db().round(), 25.0);
}

#[test]
fn equal_pictures_do_not_differ_and_others_cannot_be_compared() {
    let picture = film([[7.0; 3]; 4]);
    let difference = Difference::between(&picture, &picture).unwrap();
    assert_eq!(difference, Difference::default());
    assert_eq!(difference.psnr_db(), f64::INFINITY);
    assert_eq!(Difference::between(&picture, &Film::new(3).unwrap()), None);
    assert_eq!(Difference::between(&Film::default(), &Film::default()), None);
}

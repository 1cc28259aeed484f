//! The averaged checker pattern: against exact areas, at its edges, far away, and without an area.

use archetrace::effects::{PixelCone, cell_point, white_share};
use archetrace::geometry::{Real, Vector};

use crate::oracle::{Exact, exact, magnitude, nearest};
use crate::precision::Precision;
use crate::worst::Worst;
use archetrace::selfcheck::Random;

/// The length of white cells 0 to 1, 2 to 3, ... in an interval, less that of black ones, exactly: cell by cell.
fn white_less_black(from: &Exact, to: &Exact) -> Exact {
    let mut sum = Exact::ZERO;
    let mut cell = nearest(from).floor() as i64 - 1;
    while Exact::from(cell) < *to {
        let low = Exact::from(cell).max(from.clone());
        let high = Exact::from(cell + 1).min(to.clone());
        if low < high {
            let length = high - low;
            sum += if cell.rem_euclid(2) == 0 { length } else { -length };
        }
        cell += 1;
    }
    sum
}

fn exact_share(middle: [f64; 2], widths: [f64; 2]) -> Exact {
    let [x, y] = [0, 1].map(|axis| {
        let (middle, half) = (exact(middle[axis]), exact(widths[axis]) / Exact::from(2));
        white_less_black(&(middle.clone() - half.clone()), &(middle + half)) / exact(widths[axis])
    });
    (Exact::ONE + x * y) / Exact::from(2)
}

/// Areas about points up to so many cells from the origin.
fn check<T: Precision>(cells: f64, seed: u64) {
    let mut worst = Worst::new(&format!("checker filter, {}", T::NAME));
    for number in 0..20_000 {
        let random = &mut Random::new(seed + number);
        let middle = [0, 1].map(|_| T::from_f64(random.between(-cells, cells)));
        let widths = [0, 1].map(|_| T::from_f64(random.magnitude(-3.0, 1.5)));
        let found = white_share(cell_point(middle[0], middle[1], T::ONE), widths);
        let truth = exact_share(middle.map(T::to_f64), widths.map(T::to_f64));
        // A border is found to a rounding of 1, and counts in proportion to the width.
        let narrowest = widths[0].to_f64().min(widths[1].to_f64()).min(1.0);
        let error = nearest(&magnitude(exact(found) - truth)) * narrowest;
        worst.measure(error / T::EPSILON, 4.0, || format!("{middle:?} {widths:?}"));
    }
}

#[test]
fn the_share_of_white_is_the_area_of_white_f64() {
    check::<f64>(20.0, 0xCF_0001_0000);
}

#[test]
fn the_share_of_white_is_the_area_of_white_f32() {
    check::<f32>(20.0, 0xCF_0002_0000);
}

#[test]
fn c12_ten_thousand_cells_away_the_share_keeps_its_digits_f32() {
    check::<f32>(1e4, 0xCF_0004_0000);
    check::<f32>(1e6, 0xCF_0005_0000);
}

#[test]
fn without_an_area_the_share_is_the_pattern() {
    fn check<T: Real>() {
        for number in 0..10_000 {
            let random = &mut Random::new(0xCF_0003_0000 + number);
            let [x, y] = [0, 1].map(|_| T::from_f64(random.between(-1e6, 1e6)));
            let at = cell_point(x, y, T::from_f64(0.7));
            let expected = if at.white { T::ONE } else { T::ZERO };
            assert!(white_share(at, [T::ZERO; 2]) == expected, "{x}, {y}");
            // Nor does it matter within a cell, here almost up to its border.
            let room = (T::ONE / T::TWO - (at.along_x - T::ONE / T::TWO).abs()) * T::TWO;
            if T::from_f64(1e-3) < room {
                assert!(white_share(at, [room * T::from_f64(0.999), T::ZERO]) == expected, "{x}, {y}");
            }
        }
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn towards_the_horizon_half_is_white() {
    fn check<T: Real>() {
        let cone = PixelCone { width: T::ZERO, spread: T::from_f64(1e-3) };
        let mut last = T::ONE;
        for power in 0..30 {
            let distance = T::from_f64(10.0_f64.powi(power));
            let direction = Vector::new(T::from_f64(0.6), T::from_f64(0.8), -T::ONE / distance);
            let covered = cone.after(distance).on_level_plane(direction);
            let at = cell_point(T::from_f64(0.3), T::from_f64(0.4), T::ONE);
            let off = (white_share(at, covered) - T::ONE / T::TWO).abs();
            // The mean of a wave differs from 0 by no more than 1 / width.
            let bound = T::ONE / (T::TWO * covered[0] * covered[1]);
            assert!(off <= bound.at_most(T::ONE / T::TWO), "{off} at {distance}");
            last = off;
        }
        assert!(last <= T::ULP);
        let endless = [T::INFINITY, T::INFINITY];
        assert!(white_share(cell_point(T::ZERO, T::ZERO, T::ONE), endless) == T::ONE / T::TWO);
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn a_cone_lies_on_the_plane_as_a_stretched_disk() {
    // Straight down it covers its own width; at 60 degrees from the normal twice that along the slope; and an oblique
    // slope spreads along both axes, in all as far as in any other direction.
    let cone = PixelCone { width: 0.5, spread: 0.25 }.after(2.0);
    assert_eq!(cone.width, 1.0);
    assert_eq!(cone.on_level_plane(Vector::new(0.0, 0.0, -1.0)), [1.0, 1.0]);
    let [x, y] = cone.on_level_plane(Vector::new(0.75_f64.sqrt(), 0.0, -0.5));
    assert!((x - 2.0).abs() < 1e-15 && y == 1.0);
    let [x, y] = cone.on_level_plane(Vector::new(0.375_f64.sqrt(), 0.375_f64.sqrt(), 0.5));
    assert!((x * x + y * y - 5.0).abs() < 1e-14 && x == y);
}

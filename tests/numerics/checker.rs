//! The checker pattern: whole cells counted exactly, on edges, below zero and beyond the integers.

use archetrace::effects::cell_point;
use archetrace::geometry::Real;

use crate::oracle::{Exact, exact, floor_is_odd, magnitude, nearest};
use crate::precision::Precision;
use archetrace::selfcheck::Random;

/// Whether the column of `x` is odd: with y in row 0 the cell is then black.
fn is_odd<T: Precision>(x: T, cell: T) -> bool {
    let along_x = cell_point(x, T::ZERO, cell);
    let along_y = cell_point(T::ZERO, x, cell);
    assert_eq!(along_x.white, along_y.white, "{x} {cell}");
    !along_x.white
}

#[test]
fn c05_parity_is_that_of_the_floor_also_below_zero() {
    let places = [-0.5, -1.0, -1e-17, -0.0, 0.0, 0.5, -1.5];
    let odd = [true, true, true, false, false, false, false];
    assert_eq!(places.map(|x| is_odd::<f64>(x, 1.0)), odd);
    assert_eq!(places.map(|x| is_odd::<f32>(f32::from_f64(x), 1.0)), odd);
}

#[test]
fn c06_the_rows_at_the_origin_are_as_wide_as_all_others() {
    fn check<T: Precision>() {
        let odd = |tenth: i32| is_odd(T::from_f64(f64::from(tenth) / 10.0 + 0.05), T::ONE);
        let colours: Vec<bool> = (-40..40).map(odd).collect();
        for cell in colours.chunks(10) {
            assert!(cell.iter().all(|&odd| odd == cell[0]));
        }
        let cells: Vec<bool> = colours.iter().step_by(10).copied().collect();
        assert_eq!(cells, [false, true, false, true, false, true, false, true]);
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn c06_a_cell_is_white_where_column_and_row_are_alike() {
    fn check<T: Precision>() {
        let white = |x: f64, y: f64| cell_point(T::from_f64(x), T::from_f64(y), T::from_f64(20.0)).white;
        assert!(white(10.0, 10.0) && white(-10.0, -10.0) && white(30.0, -10.0) && white(0.0, 0.0));
        assert!(!white(10.0, 30.0) && !white(-1.0, 1.0) && !white(20.0, 0.0) && !white(0.0, -20.0));
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn c07_beyond_32_bit_integers_cells_still_change() {
    assert!(!is_odd(2_147_483_648.5, 1.0));
    assert!(is_odd(2_147_483_649.5, 1.0));
    assert!(is_odd(-2_147_483_648.5, 1.0));
    // A single number of that size is whole and even; cells of a thousandth make as many.
    assert!(!is_odd(2_147_483_648.0_f32, 1.0) && !is_odd(-2_147_483_648.0_f32, 1.0));
    let cell = 2.0_f32.powi(-10);
    assert!(!is_odd(2_147_483_648.0 * cell, cell) && is_odd(8_388_609.0 * cell, cell));
}

#[test]
fn c08_beyond_64_bit_integers_a_float_is_even() {
    for x in [9_007_199_254_740_992.0, 1e18, 1e300] {
        assert!(!is_odd(x, 1.0) && !is_odd(-x, 1.0), "{x}");
    }
    assert!(is_odd(9_007_199_254_740_991.0, 1.0));
    for x in [16_777_216.0_f32, 1e18, 1e38] {
        assert!(!is_odd(x, 1.0) && !is_odd(-x, 1.0), "{x}");
    }
    assert!(is_odd(16_777_215.0_f32, 1.0));
}

/// Parity against the exact floor with no tolerance, and the rest against the exact rest.
fn check<T: Precision>(x: T, cell: T) {
    let width = exact(cell);
    assert_eq!(is_odd(x, cell), floor_is_odd(&exact(x), &width), "{x} / {cell}");
    let along = cell_point(x, T::ZERO, cell).along_x;
    assert!(T::ZERO <= along && along <= T::ONE, "{x} / {cell}: {along}");
    let count = exact(x) / &width;
    let rest = &count - Exact::from(count.floor());
    let error = nearest(&magnitude(exact(along) - rest));
    // The rest is one sum and one quotient: half an epsilon each, of at most 1.
    assert!(error <= 1.01 * T::EPSILON, "{x} / {cell}: rest off by {error:e}");
}

/// Positions up to a number of cells from the origin.
fn check_random<T: Precision>(cells: f64, seed: u64) {
    for number in 0..100_000 {
        let random = &mut Random::new(seed + number);
        let cell = random.magnitude(-8.0, 8.0);
        let x = cell * random.magnitude(-20.0, cells) * if random.coin() { 1.0 } else { -1.0 };
        check(T::from_f64(x), T::from_f64(cell));
    }
}

#[test]
fn c07_c08_random_positions_up_to_1e15_cells_are_exact_f64() {
    check_random::<f64>(15.0, 0xCE_0001_0000);
}

#[test]
fn c09_random_positions_up_to_1e7_cells_are_exact_for_the_f32_they_are() {
    check_random::<f32>(7.0, 0xCE_0002_0000);
}

/// Positions on the line between two cells as nearly as a float can say, and its neighbours.
fn check_edges<T: Precision>(cells: f64, seed: u64) {
    for number in 0..100_000 {
        let random = &mut Random::new(seed + number);
        let cell = T::from_f64(random.magnitude(-8.0, 8.0));
        let count = random.magnitude(0.0, cells).floor() * if random.coin() { 1.0 } else { -1.0 };
        let edge = T::from_f64(count) * cell;
        for x in [edge, edge.up(), edge.down()] {
            check(x, cell);
        }
    }
}

#[test]
fn c05_c07_next_to_a_cell_edge_parity_is_exact_f64() {
    check_edges::<f64>(15.0, 0xCE_0003_0000);
}

#[test]
fn c05_c07_next_to_a_cell_edge_parity_is_exact_f32() {
    check_edges::<f32>(7.0, 0xCE_0004_0000);
}

#[test]
fn c05_the_division_alone_would_be_wrong_next_to_an_edge() {
    // 1 / 49 * 49 is below 1: the quotient rounds up to a whole number that x does not reach.
    let mut wrong = 0;
    for number in 0..10_000 {
        let random = &mut Random::new(0xCE_0005_0000 + number);
        let cell = random.magnitude(-2.0, 2.0);
        let x = (random.whole(1, 1000) * cell).down();
        let rounded = (x / cell).floor().rem_euclid(2.0) == 1.0;
        wrong += u32::from(rounded != floor_is_odd(&exact(x), &exact(cell)));
    }
    assert!(wrong > 100, "{wrong}");
}

//! Texels at the ends of a cell, and of an image of one texel.

use archetrace::effects::{cell_point, texel_index};
use archetrace::geometry::Real;

use crate::precision::Precision;
use archetrace::selfcheck::Random;

fn check<T: Precision>(seed: u64) {
    for size in [1, 2, 3, 7, 255, 256, 8192] {
        assert_eq!(texel_index(T::ZERO, size), 0);
        assert_eq!(texel_index(T::ONE, size), size - 1);
        assert_eq!(texel_index(T::ONE.down(), size), size - 1);
        for number in 0..20_000 {
            let random = &mut Random::new(seed + number);
            let cell = T::from_f64(random.magnitude(-9.0, 9.0));
            let cells = T::from_f64(random.point().x * random.magnitude(-20.0, 25.0));
            let at = cell_point(cells * cell, -cells * cell, cell);
            for along in [at.along_x, at.along_y] {
                // Beyond 2^53 cells (2^24 in f32) a number does not say where within a cell it lies.
                assert!(texel_index(along, size) < size, "{cells} cells of {cell}: {along}");
            }
        }
    }
}

#[test]
fn q08_every_place_has_a_texel_f64() {
    check::<f64>(0x8_0001_0000);
}

#[test]
fn q08_every_place_has_a_texel_f32() {
    check::<f32>(0x8_0002_0000);
}

#[test]
fn q08_a_hair_below_a_cell_edge_is_the_last_texel_of_the_cell_before() {
    fn check<T: Precision>() {
        let at = cell_point(T::from_f64(-1e-17), T::ZERO, T::ONE);
        assert!(!at.white);
        assert_eq!(texel_index(at.along_x, 16), 15);
        assert_eq!(texel_index(at.along_y, 16), 0);
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn q08_texels_share_a_cell_evenly() {
    for size in [1, 2, 3, 5, 16] {
        for texel in 0..size {
            let middle = (f64::from(texel) + 0.5) / f64::from(size);
            assert_eq!(texel_index(middle, size), texel);
            assert_eq!(texel_index(f32::from_f64(middle), size), texel);
        }
    }
}

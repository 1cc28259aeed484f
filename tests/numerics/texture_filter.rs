//! Filtered textures: exact at texel centres and on ramps, and means that stay what they are.

use archetrace::components::Texture;
use archetrace::effects::{MipChain, Rgb, bilinear_color, texel_index};
use archetrace::geometry::Real;

use archetrace::selfcheck::Random;

fn noise(seed: u64, width: u32, height: u32) -> Texture {
    let random = &mut Random::new(seed);
    let texels = (0..width * height).map(|_| [0; 3].map(|_: u8| random.below(256) as u8)).collect();
    Texture::new(width, height, texels).unwrap()
}

/// The middle of a texel as a share of the image.
fn middle<T: Real>(index: u32, size: u32) -> T {
    (T::from_u32(2 * index) + T::ONE) / T::from_u32(2 * size)
}

fn assert_near<T: Real>(found: Rgb<T>, expected: [f64; 3], allowed: f64) {
    for (found, expected) in found.to_f64().into_iter().zip(expected) {
        assert!((found - expected).abs() <= allowed, "{found}, but on paper {expected}");
    }
}

#[test]
fn in_the_middle_of_a_texel_its_own_colour_shows() {
    fn check<T: Real>() {
        for (width, height) in [(1, 1), (8, 4), (2, 16), (7, 5), (3, 10)] {
            let image = noise(3, width, height);
            for (row, column) in (0..height).flat_map(|row| (0..width).map(move |column| (row, column))) {
                let at = [middle::<T>(column, width), middle(row, height)];
                assert_eq!([texel_index(at[0], width), texel_index(at[1], height)], [column, row]);
                let found = bilinear_color(&image, at);
                let own = Rgb::<T>::from_bytes(image.texel(column, row));
                // Where the middle is a number of the precision, so is the colour; else it is off by its rounding.
                let is_exact = width.is_power_of_two() && height.is_power_of_two();
                let allowed = if is_exact { 0.0 } else { 16.0 * T::ULP.to_f64() };
                assert_near(found, own.to_f64(), allowed);
            }
        }
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn a_ramp_stays_a_ramp() {
    // Red grows to the right and green downwards by one level a texel.
    let texels = (0..16 * 8_u32).map(|index| [10 + (index % 16) as u8, 20 + (index / 16) as u8, 7]).collect();
    let image = Texture::new(16, 8, texels).unwrap();
    for number in 0..2_000 {
        let random = &mut Random::new(0x7F_0000 + number);
        let [x, y] = [random.share(), random.share()];
        // Beyond the outermost middles it is level.
        let red = 10.0 + (16.0 * x - 0.5).clamp(0.0, 15.0);
        let green = 20.0 + (8.0 * y - 0.5).clamp(0.0, 7.0);
        assert_near(bilinear_color(&image, [x, y]), [red / 255.0, green / 255.0, 7.0 / 255.0], 1e-15);
    }
}

#[test]
fn copies_of_one_colour_are_of_that_colour_to_the_bit() {
    fn check<T: Real>() {
        let color = [17, 130, 254];
        for (width, height) in [(1, 1), (64, 64), (100, 30), (1, 77), (13, 5)] {
            let image = Texture::new(width, height, vec![color; (width * height) as usize]).unwrap();
            let chain = MipChain::new(&image);
            for number in 0..300 {
                let random = &mut Random::new(0x7E_0000 + number);
                let at = [0, 1].map(|_| T::from_f64(random.share()));
                let covered = T::from_f64(random.magnitude(-1.0, 3.0));
                let found: Rgb<T> = chain.color(&image, at, covered);
                assert!(found == Rgb::from_bytes(color), "{found:?} of {width} x {height}");
            }
        }
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn the_smallest_copy_is_the_mean_of_all_texels() {
    for (width, height) in [(64, 64), (100, 30), (1, 77), (13, 5), (31, 64)] {
        let image = noise(9, width, height);
        let mean = [0, 1, 2].map(|channel| {
            let texels = (0..height).flat_map(|row| (0..width).map(move |column| (column, row)));
            let sum: u32 = texels.map(|(column, row)| u32::from(image.texel(column, row)[channel])).sum();
            f64::from(sum) / f64::from(width * height) / 255.0
        });
        // Each copy rounds to 24 bits, and there are up to seven.
        let found: Rgb<f64> = MipChain::new(&image).color(&image, [0.3, 0.8], 1e6);
        assert_near(found, mean, 8.0 * f64::from(f32::EPSILON));
    }
}

#[test]
fn each_copy_is_the_mean_of_four_texels_and_between_two_both_count() {
    let image = noise(4, 8, 8);
    let chain = MipChain::new(&image);
    let at = [middle::<f64>(1, 4), middle(2, 4)];
    let four = [(2, 4), (3, 4), (2, 5), (3, 5)].map(|(column, row)| image.texel(column, row));
    let mean = [0, 1, 2].map(|i| four.iter().map(|texel| f64::from(texel[i])).sum::<f64>() / 4.0 / 255.0);
    let half: Rgb<f64> = chain.color(&image, at, 2.0);
    assert_near(half, mean, 1e-15);
    let full: Rgb<f64> = bilinear_color(&image, at);
    assert!(chain.color(&image, at, 1.0) == full && chain.color(&image, at, 0.1) == full);
    // Half a doubling lies halfway.
    let between: Rgb<f64> = chain.color(&image, at, 2.0_f64.sqrt());
    let halfway = [0, 1, 2].map(|i| (full.to_f64()[i] + mean[i]) / 2.0);
    assert_near(between, halfway, 1e-15);
}

#[test]
fn copies_take_a_third_as_many_texels_as_the_image() {
    let texels = MipChain::new(&noise(1, 64, 64)).bytes() / size_of::<[f32; 3]>();
    assert_eq!(texels, 1024 + 256 + 64 + 16 + 4 + 1);
    assert_eq!(MipChain::new(&noise(1, 1, 1)).bytes(), 0);
}

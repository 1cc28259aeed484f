//! Rays through a lens: where they meet the plane in focus, and how far apart they are before and behind it.

use archetrace::components::{Aperture, CameraPose, Lens};
use archetrace::geometry::Real;
use archetrace::trace::{CameraEffects, CameraRays, CameraRows, SampleId};
use glam::DVec3;

use crate::precision::{Precision, bits};

const LENS: Lens = Lens { near: 2.0, far: 1000.0, fovy: 50.0, aspect: 1.3 };
const FOCUS: f64 = 40.0;

fn through_lens<T: Real>(radius: f64) -> CameraRays<T> {
    let pose = CameraPose::looking(DVec3::ZERO, DVec3::Y, DVec3::Z).unwrap();
    let rows = CameraRows { aperture: Some(Aperture { radius, focus: FOCUS }), ..CameraRows::default() };
    CameraRays::new(&pose, &LENS, 9).with_effects(CameraEffects { rows, shutter: None })
}

/// Where the samples of a pixel are at a depth, from where the ray through a pinhole is: x and z.
fn spread(rays: &CameraRays<f64>, (column, row): (u32, u32), depth: f64) -> Vec<[f64; 2]> {
    let at_depth = |ray: archetrace::geometry::Ray<f64>| ray.at((depth - ray.origin.y) / ray.direction.y);
    let pinhole = at_depth(rays.ray(column, row).ray);
    let samples = (0..4096).map(|index| {
        let found = rays.sample(column, row, SampleId { column, row, index });
        assert!((found.ray.origin.y - LENS.near).abs() < 1e-14, "not on the near plane");
        let end = found.ray.at(found.reach).y;
        assert!((end - (LENS.near + LENS.far)).abs() < 1e-11, "not up to the far plane, but {end}");
        let point = at_depth(found.ray);
        [point.x - pinhole.x, point.z - pinhole.z]
    });
    samples.collect()
}

#[test]
fn samples_of_a_pixel_fill_the_circle_of_confusion_and_meet_in_focus() {
    let (radius, pixel) = (1.5, (7, 2));
    let rays = through_lens::<f64>(radius);
    for depth in [3.0, 20.0, FOCUS, 80.0, 900.0] {
        let circle = radius * (1.0 - depth / FOCUS).abs();
        let spread = spread(&rays, pixel, depth);
        let distances = || spread.iter().map(|[x, z]| x.hypot(*z));
        let widest = distances().fold(0.0, f64::max);
        let rounding = 1e-14 * depth;
        assert!(widest <= circle + rounding, "{widest} beyond {circle} at depth {depth}");
        assert!(widest >= 0.98 * circle, "only {widest} of {circle} at depth {depth}");
        // The mean square of the distance from the middle of an even disk is half the square of its radius.
        let mean_square = distances().map(|d| d * d).sum::<f64>() / 4096.0;
        assert!((mean_square - circle * circle / 2.0).abs() <= 2e-3 * circle * circle + rounding);
    }
}

fn check_pinhole<T: Precision>() {
    for rays in [through_lens::<T>(0.0), through_lens::<T>(1.0).with_effects(CameraEffects::default())] {
        for pixel in 0..81 {
            let (column, row) = (pixel % 9, pixel / 9);
            let pinhole = rays.ray(column, row);
            let sample = rays.sample(column, row, SampleId { column, row, index: pixel });
            assert_eq!(bits(sample.ray.direction), bits(pinhole.ray.direction));
            assert_eq!(bits(sample.ray.origin), bits(pinhole.ray.origin));
            assert_eq!(sample.reach.bits(), pinhole.reach.bits());
        }
    }
}

#[test]
fn a_lens_without_width_is_a_pinhole_to_the_bit() {
    check_pinhole::<f64>();
    check_pinhole::<f32>();
}

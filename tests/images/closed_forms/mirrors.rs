//! Mirrors, levels, and how many rays they take.

use archetrace::components::{Color, Diffuse, Mirror};
use archetrace::geometry::Real;
use archetrace::trace::RayCounts;

use super::{View, assert_close, lamp, seen, wall_ahead, wall_behind, white};
use crate::support::tracing::{Traced, trace};

/// Between two mirrors that face each other.
fn hall<T: Real>(level: u32, ambient: f64, reflectance: f64) -> Traced {
    let mut world = View { level, ..View::one_ray() }.world();
    world.spawn((wall_ahead(10.0), white(ambient, 0.0), Mirror(reflectance)));
    world.spawn((wall_behind(-30.0), white(ambient, 0.0), Mirror(reflectance)));
    trace::<T>(&mut world)
}

#[test]
fn facing_mirrors_give_the_finite_geometric_sum() {
    for level in 1..=50_u32 {
        // 1/2 + 1/4 + ... to 50 places: every partial sum is exact.
        let exact = 1.0 - 0.5_f64.powi(level.cast_signed());
        assert_eq!(hall::<f64>(level, 0.5, 0.5).picture.middle(), [exact; 3]);
    }
    for level in 1..=20_u32 {
        let exact = 1.0 - 0.5_f64.powi(level.cast_signed());
        assert_eq!(hall::<f32>(level, 0.5, 0.5).picture.middle(), [exact; 3]);
    }
}

#[test]
fn facing_mirrors_of_any_reflectance_agree_with_paper() {
    for level in [1_u32, 2, 3, 7] {
        let sum = (1.0 - 0.9_f64.powi(level.cast_signed())) / (1.0 - 0.9);
        let found = hall::<f64>(level, 0.1, 0.9).picture.middle();
        for channel in found {
            // The formula itself cancels one digit.
            assert!((channel - 0.1 * sum).abs() <= 16.0 * f64::EPSILON);
        }
    }
}

#[test]
fn a_thousand_levels_are_a_loop() {
    fn check<T: Real>() {
        let Traced { picture, counts } = hall::<T>(1000, 1.0 / 1024.0, 1.0);
        assert_eq!(picture.middle(), [1000.0 / 1024.0; 3]);
        let rays = RayCounts { primary: 1, shadow: 0, mirror: 999, refracted: 0 };
        assert_eq!(counts.rays, rays);
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn level_0_is_black_and_traces_nothing() {
    for Traced { picture, counts } in [hall::<f64>(0, 1.0, 1.0), hall::<f32>(0, 1.0, 1.0)] {
        assert_eq!(picture.middle(), [0.0; 3]);
        assert_eq!(counts.rays, RayCounts::default());
    }
}

#[test]
fn level_1_reflects_nothing() {
    for Traced { picture, counts } in [hall::<f64>(1, 0.25, 1.0), hall::<f32>(1, 0.25, 1.0)] {
        assert_eq!(picture.middle(), [0.25; 3]);
        assert_eq!(counts.rays.mirror, 0);
    }
}

#[test]
fn reflected_light_is_not_capped_on_its_way() {
    // The wall behind the camera is three times white; a mirror of a quarter shows three quarters.
    let mut world = View { level: 2, ..View::one_ray() }.world();
    world.spawn((wall_ahead(10.0), white(0.0, 0.0), Mirror(0.25)));
    world.spawn((wall_behind(-30.0), white(0.0, 1.0)));
    for y in [-3.0, -2.0, 0.0] {
        world.spawn(lamp(0.0, y, 0.0));
    }
    assert_eq!(seen(&mut world).0, [0.75; 3]);
}

#[test]
fn a_mirror_does_not_tint() {
    let mut world = View { level: 2, ..View::one_ray() }.world();
    world.spawn((wall_ahead(10.0), Color::new(1.0, 0.0, 0.5), Diffuse(0.0), Mirror(0.5)));
    world.spawn((wall_behind(-30.0), white(0.5, 0.0)));
    assert_eq!(seen(&mut world).0, [0.25; 3]);
}

#[test]
fn a_mirror_that_shows_nothing_adds_nothing() {
    let mut world = View { level: 5, ..View::one_ray() }.world();
    world.spawn((wall_ahead(10.0), white(0.5, 0.0), Mirror(1.0)));
    let (color, rays) = seen(&mut world);
    assert_close(color, [0.5; 3]);
    assert_eq!(rays.mirror, 1);
}

#[test]
fn rays_are_counted_one_by_one() {
    // 9 x 9 pixels see a wall, each asks for three of four lights, and sees one mirror image.
    let mut world = View { level: 3, pixels: 9, ..View::one_ray() }.world();
    world.spawn((wall_ahead(10.0), white(0.1, 0.1), Mirror(0.5)));
    for light in [lamp(0.0, 0.0, 0.0), lamp(5.0, 0.0, 1.0), lamp(0.0, -40.0, 0.0)] {
        world.spawn(light);
    }
    world.spawn(lamp(0.0, 40.0, 0.0));
    let rays = RayCounts { primary: 81, shadow: 3 * 81, mirror: 81, refracted: 0 };
    assert_eq!(trace::<f64>(&mut world).counts.rays, rays);
    // A wall behind, beyond the last light, is met second; the wall ahead again third.
    world.spawn((wall_behind(-43.0), white(0.1, 0.1), Mirror(0.5)));
    let rays = RayCounts {
        primary: 81,
        // Before the wall ahead are three lights, before the one behind all four.
        shadow: (3 + 4 + 3) * 81,
        mirror: 2 * 81,
        refracted: 0,
    };
    assert_eq!(trace::<f64>(&mut world).counts.rays, rays);
}

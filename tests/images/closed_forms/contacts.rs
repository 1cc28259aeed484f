//! Objects that touch, or nearly: no ray passes a wall, no light leaks, nothing shadows itself.

use archetrace::components::{Checkerboard, Cube, Lens, Mirror, Position, Pyramid, Sphere};
use archetrace::geometry::Real;
use bevy_ecs::prelude::*;
use glam::DVec3;

use super::{View, lamp, white};
use crate::support::tracing::{Traced, trace};

/// A view of a point from a direction, so narrow that it shows `extent` around the point.
fn close_up(point: DVec3, from: DVec3, extent: f64) -> View {
    let distance = from.length();
    let half_angle = (0.5 * extent / distance).atan().to_degrees();
    let lens = Lens { near: 1e-3 * distance, far: 1e3 * distance, fovy: 2.0 * half_angle, aspect: 1.0 };
    View { position: point + from, look: -from, lens, pixels: 48, ..View::one_ray() }
}

/// Everything larger by a factor: views and lights below are given for scale 1.
fn scaled(view: View, scale: f64) -> View {
    let lens = Lens { near: view.lens.near * scale, far: view.lens.far * scale, ..view.lens };
    View { position: view.position * scale, lens, ..view }
}

fn lit_board(view: &View, light: DVec3, scale: f64) -> World {
    let mut world = scaled(*view, scale).world();
    let origin = Position(DVec3::new(-500.0, -500.0, 0.0) * scale);
    world.spawn((Checkerboard { cell: 1000.0 * scale }, white(0.0, 1.0), origin));
    let light = light * scale;
    world.spawn(lamp(light.x, light.y, light.z));
    world
}

fn is_black(traced: &Traced) -> bool {
    traced.picture.pixels.iter().all(|&pixel| pixel == [0.0; 3])
}

/// Number of black pixels.
fn black(traced: &Traced) -> usize {
    let is_black = |pixel: &&[f64; 3]| **pixel == [0.0; 3];
    traced.picture.pixels.iter().filter(is_black).count()
}

#[test]
fn a_shadow_starts_at_the_foot_of_its_cube() {
    fn check<T: Real>(scales: &[f64], extents: &[f64]) {
        for &scale in scales {
            for &extent in extents {
                // The light is on the -x side, the camera looks at the foot of the +x side.
                let foot = DVec3::new(1.0, 0.37, 0.0);
                let view = close_up(foot, DVec3::new(3.1, 0.7, 2.3), extent);
                let mut world = lit_board(&view, DVec3::new(-2.0, 0.4, 1.5), scale);
                assert_eq!(black(&trace::<T>(&mut world)), 0, "the board alone is lit");
                world.spawn((Cube { side: scale }, white(0.0, 1.0)));
                assert!(is_black(&trace::<T>(&mut world)), "{scale:e}, {extent:e}: a gap");
            }
        }
    }
    check::<f64>(&[1e-6, 1.0, 1e6], &[1e-9, 1e-6, 1e-3, 0.1]);
    check::<f32>(&[1e-3, 1.0, 1e3], &[1e-4, 1e-2, 0.1]);
}

#[test]
fn the_lit_foot_of_a_cube_has_no_dark_line() {
    fn check<T: Real>(scales: &[f64], extents: &[f64]) {
        for &scale in scales {
            for &extent in extents {
                let foot = DVec3::new(0.0, 0.37, 0.0);
                let view = close_up(foot, DVec3::new(-3.1, 0.7, 2.3), extent);
                let mut world = lit_board(&view, DVec3::new(-2.0, 0.4, 1.5), scale);
                world.spawn((Cube { side: scale }, white(0.0, 1.0)));
                let dark = black(&trace::<T>(&mut world));
                assert_eq!(dark, 0, "{scale:e}, {extent:e}");
            }
        }
    }
    check::<f64>(&[1e-6, 1.0, 1e6], &[1e-9, 1e-6, 1e-3, 0.1]);
    check::<f32>(&[1e-3, 1.0, 1e3], &[1e-4, 1e-2, 0.1]);
}

#[test]
fn there_is_no_halo_under_a_resting_sphere() {
    fn check<T: Real>(gaps: &[f64], extents: &[f64]) {
        for &gap in gaps {
            for &extent in extents {
                let view = close_up(DVec3::ZERO, DVec3::new(3.0, -4.0, 0.4), extent);
                let mut world = lit_board(&view, DVec3::new(0.1, 0.2, 9.0), 1.0);
                world.spawn((Sphere { radius: 1.0 }, Position::new(0.0, 0.0, 1.0 + gap), white(0.0, 1.0)));
                assert!(is_black(&trace::<T>(&mut world)), "gap {gap:e}, {extent:e}");
            }
        }
    }
    check::<f64>(&[0.0, 1e-9, 1e-6, 1e-2], &[1e-9, 1e-6, 1e-3, 0.2]);
    check::<f32>(&[0.0, 1e-6, 1e-2], &[1e-5, 1e-3, 0.2]);
}

const GAPS: [f64; 6] = [0.0, 1e-9, 1e-6, 1e-4, 1e-3, 1e-2];

/// Two mirror spheres with a light inside each; a camera that looks at the gap between them.
fn two_spheres(gap: f64, ambient: f64, extent: f64) -> World {
    let mut world = View { level: 50, ..close_up(DVec3::ZERO, DVec3::new(0.3, -8.0, 1.7), extent) }.world();
    for side in [-1.0, 1.0] {
        let x = side * (1.0 + 0.5 * gap);
        let place = Position::new(x, 0.0, 0.0);
        world.spawn((Sphere { radius: 1.0 }, place, white(ambient, 1.0), Mirror(0.9)));
        world.spawn(lamp(x, 0.1, 0.2));
    }
    world
}

#[test]
fn mirror_spheres_that_almost_touch_let_no_ray_in() {
    // Only the insides are lit: whatever is not black has been inside.
    fn check<T: Real>() {
        for gap in GAPS {
            for extent in [1e-4, 1e-2, 0.3, 4.0] {
                let traced = trace::<T>(&mut two_spheres(gap, 0.0, extent));
                assert!(is_black(&traced), "{}: gap {gap:e}, extent {extent:e}", T::NAME);
            }
        }
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn light_between_mirror_spheres_stays_bounded() {
    let most = 0.05 * (1.0 - 0.9_f64.powi(50)) / (1.0 - 0.9);
    let mut deepest = 0.0;
    for gap in GAPS {
        for extent in [1e-4, 1e-2, 0.3, 4.0] {
            let traced = trace::<f64>(&mut two_spheres(gap, 0.05, extent));
            for channel in traced.picture.pixels.iter().flatten() {
                assert!(*channel <= most * (1.0 + 1e-12), "gap {gap:e}: {channel}");
            }
            let Traced { counts, .. } = traced;
            deepest = f64::max(deepest, counts.rays.mirror as f64 / counts.rays.primary as f64);
        }
    }
    assert!(deepest > 10.0, "{deepest} reflections a pixel are no test");
}

#[test]
fn no_light_leaves_a_closed_object() {
    // Every object has a light inside, every surface is a mirror; the camera and the board are outside.
    fn check<T: Real>(scale: f64) {
        let view = View {
            position: DVec3::new(1.3, -9.0, 4.1) * scale,
            look: DVec3::new(-0.1, 9.0, -3.0),
            pixels: 128,
            level: 5,
            ..View::one_ray()
        };
        let lens = Lens { near: 0.1 * scale, far: 100.0 * scale, ..view.lens };
        let mut world = View { lens, ..view }.world();
        let at = |x: f64, y: f64, z: f64| Position::new(x * scale, y * scale, z * scale);
        let glowing = || (white(0.0, 1.0), Mirror(0.8));
        world.spawn((Checkerboard { cell: scale }, glowing()));
        world.spawn((Sphere { radius: scale }, at(-2.0, 0.0, 1.0), glowing()));
        world.spawn((Cube { side: 2.0 * scale }, at(-1.0, -0.5, 0.0), glowing()));
        world.spawn((Cube { side: 1.5 * scale }, at(-0.8, -0.3, 2.0), glowing()));
        let pyramid = Pyramid { width: 2.0 * scale, height: 3.0 * scale };
        world.spawn((pyramid, at(1.0, -0.5, 0.0), glowing()));
        for (x, y, z) in [(-2.0, 0.1, 1.1), (0.0, 0.4, 0.9), (0.1, 0.3, 2.8), (2.1, 0.4, 0.7)] {
            world.spawn(lamp(x * scale, y * scale, z * scale));
        }
        let traced = trace::<T>(&mut world);
        let leaks = 128 * 128 - black(&traced);
        assert_eq!(leaks, 0, "{} at scale {scale:e}", T::NAME);
        assert!(traced.counts.rays.mirror > 10_000 && traced.counts.rays.shadow > 10_000);
    }
    for scale in [1e-30, 1e-6, 1.0, 1e6, 1e30] {
        check::<f64>(scale);
    }
    for scale in [1e-3, 1.0, 1e3] {
        check::<f32>(scale);
    }
}

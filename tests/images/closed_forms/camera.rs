//! What the camera shows: near and far planes, fields of view.

use archetrace::components::{Lens, Mirror, Position, Sphere};
use archetrace::geometry::Real;
use glam::DVec3;

use super::{View, lamp, seen, wall_ahead, wall_behind, white};
use crate::support::picture::Picture;
use crate::support::tracing::trace;

/// A 33 x 33 view with near plane 2 and far plane 10, from (0, -10, 0) along +y: the planes are y = -8 and y = 2.
fn short_view() -> View {
    let lens = Lens { near: 2.0, far: 10.0, fovy: 100.0, aspect: 1.0 };
    View { lens, pixels: 33, ..View::one_ray() }
}

fn is_all(picture: &Picture, channel: f64) -> bool {
    picture.pixels.iter().all(|&pixel| pixel == [channel; 3])
}

#[test]
fn the_far_plane_is_a_plane_and_counts_from_the_near_one() {
    fn check<T: Real>(margin: f64) {
        for (y, shown) in [(2.0 - margin, 1.0), (2.0 + margin, 0.0)] {
            let mut world = short_view().world();
            world.spawn((wall_ahead(y), white(1.0, 0.0)));
            assert!(is_all(&trace::<T>(&mut world).picture, shown), "wall at {y}");
        }
    }
    check::<f64>(1e-13);
    check::<f32>(1e-4);
}

#[test]
fn the_far_plane_does_not_end_reflected_rays() {
    let mut world = View { level: 2, ..short_view() }.world();
    world.spawn((wall_ahead(1.0), white(0.0, 0.0), Mirror(0.5)));
    world.spawn((wall_behind(-300.0), white(1.0, 0.0)));
    assert_eq!(seen(&mut world).0, [0.5; 3]);
}

#[test]
fn the_far_plane_does_not_end_shadow_rays() {
    let lit = |blocked: bool| {
        let mut world = View { pixels: 1, ..short_view() }.world();
        world.spawn((wall_ahead(0.0), white(0.25, 0.5)));
        world.spawn(lamp(0.0, -400.0, 0.0));
        if blocked {
            world.spawn((Sphere { radius: 5.0 }, Position::new(0.0, -300.0, 0.0)));
        }
        seen(&mut world).0
    };
    assert_eq!(lit(false), [0.75; 3]);
    assert_eq!(lit(true), [0.25; 3]);
}

#[test]
fn what_lies_before_the_near_plane_is_not_seen_but_casts_shadows() {
    let mut world = View { pixels: 1, ..short_view() }.world();
    world.spawn((wall_ahead(0.0), white(0.25, 0.5)));
    world.spawn((Sphere { radius: 0.5 }, Position::new(0.0, -9.0, 0.0), white(1.0, 0.0)));
    let light = world.spawn(lamp(0.0, -8.2, 0.0)).id();
    assert_eq!(seen(&mut world).0, [0.75; 3]);
    world.entity_mut(light).insert(Position::new(0.0, -12.0, 0.0));
    assert_eq!(seen(&mut world).0, [0.25; 3]);
}

#[test]
fn an_object_across_the_near_plane_is_seen_from_within() {
    // The ray starts at y = -8, inside the sphere, and meets its far side at y = -7.
    let mut world = View { pixels: 1, ..short_view() }.world();
    world.spawn((Sphere { radius: 2.0 }, Position::new(0.0, -9.0, 0.0), white(0.125, 0.5)));
    world.spawn(lamp(0.0, -7.5, 0.0));
    assert_eq!(seen(&mut world).0, [0.625; 3]);
}

#[test]
fn the_aspect_ratio_is_one_of_angles() {
    // 60 degrees high and 90 wide: the right edge is at distance 1 where the look is 1 long. A ratio of lengths
    // would put it at 1.5 tan(30) = 0.866 and the sphere in another column.
    let lens = Lens { fovy: 60.0, aspect: 1.5, ..View::one_ray().lens };
    let view = View { lens, pixels: 101, ..View::one_ray() };
    for (column, row) in [(75, 50), (10, 50), (50, 90), (20, 30)] {
        let right = (2.0 * f64::from(column) - 100.0) / 101.0;
        let down = (2.0 * f64::from(row) - 100.0) / 101.0 * 30.0_f64.to_radians().tan();
        let place = view.position + 10.0 * (DVec3::Y + right * DVec3::X - down * DVec3::Z);
        let mut world = view.world();
        world.spawn((Sphere { radius: 0.03 }, Position(place), white(1.0, 0.0)));
        let picture = trace::<f64>(&mut world).picture;
        let lit: Vec<usize> = (0..101 * 101).filter(|&i| picture.pixels[i][0] > 0.0).collect();
        assert_eq!(lit, [row as usize * 101 + column as usize]);
    }
}

#[test]
fn a_single_pixel_looks_along_the_axis() {
    let look = DVec3::new(0.3, 1.0, -0.2).normalize();
    let view = View { look, ..View::one_ray() };
    let mut world = view.world();
    let place = view.position + 500.0 * look;
    world.spawn((Sphere { radius: 1e-9 }, Position(place), white(1.0, 0.0)));
    assert_eq!(trace::<f64>(&mut world).picture.middle(), [1.0; 3]);
    // Single numbers place it to 3e-5.
    world.spawn((Sphere { radius: 1e-4 }, Position(place), white(1.0, 0.0)));
    assert_eq!(seen(&mut world).0, [1.0; 3]);
}

//! A camera and a light within an object.

use archetrace::components::{Cube, Gloss, Position, Pyramid, Sphere};
use archetrace::geometry::Real;
use bevy_ecs::prelude::*;
use glam::DVec3;

use super::{View, assert_close, lamp, white};
use crate::support::picture::Picture;
use crate::support::tracing::{Traced, trace};

/// From (0, -5, 0) along +y.
fn view(pixels: u32) -> View {
    View { position: DVec3::new(0.0, -5.0, 0.0), pixels, ..View::one_ray() }
}

fn gloss() -> Gloss {
    Gloss { specular: 0.25, shininess: 2.0 }
}

#[test]
fn a_sphere_from_within_faces_the_camera() {
    // The wall at (0, 10, 0) has its normal towards -y: a light at (3, 6, 0) is 5 away, at a cosine of 4/5.
    let mut world = view(1).world();
    world.spawn((Sphere { radius: 10.0 }, white(0.125, 0.5), gloss()));
    world.spawn(lamp(3.0, 6.0, 0.0));
    let Traced { picture, counts } = trace::<f64>(&mut world);
    assert_close(picture.middle(), [0.125 + 0.5 * 0.8 + 0.25 * 0.64; 3]);
    assert_eq!(counts.rays.shadow, 1);
}

#[test]
fn a_cube_from_within_faces_the_camera() {
    let mut world = view(1).world();
    world.spawn((Cube { side: 20.0 }, Position::new(-10.0, -10.0, -10.0), white(0.125, 0.5), gloss()));
    world.spawn(lamp(3.0, 6.0, 0.0));
    let found = trace::<f64>(&mut world).picture.middle();
    assert_close(found, [0.125 + 0.5 * 0.8 + 0.25 * 0.64; 3]);
}

#[test]
fn a_pyramid_from_within_faces_the_camera() {
    // Looking down at the base, z = -10; the light at (3, -5, -6) is 5 away from (0, -5, -10).
    let mut world = View { look: DVec3::NEG_Z, up: DVec3::Y, ..view(1) }.world();
    let shape = Pyramid { width: 40.0, height: 60.0 };
    world.spawn((shape, Position::new(-20.0, -20.0, -10.0), white(0.125, 0.5), gloss()));
    world.spawn(lamp(3.0, -5.0, -6.0));
    let found = trace::<f64>(&mut world).picture.middle();
    assert_close(found, [0.125 + 0.5 * 0.8 + 0.25 * 0.64; 3]);
}

#[test]
fn a_light_without_does_not_shine_into_an_object() {
    fn check<T: Real>(spawn_shape: impl Fn(&mut World)) {
        let mut world = view(33).world();
        spawn_shape(&mut world);
        world.spawn(lamp(0.0, -40.0, 0.0));
        world.spawn(lamp(0.0, 40.0, 3.0));
        let Traced { picture, counts } = trace::<T>(&mut world);
        assert!(picture.pixels.iter().all(|&pixel| pixel == [0.25; 3]));
        assert!(counts.rays.shadow >= 33 * 33, "the light is before some wall");
    }
    fn check_all<T: Real>() {
        check::<T>(|world| {
            world.spawn((Sphere { radius: 10.0 }, white(0.25, 0.5)));
        });
        check::<T>(|world| {
            let corner = Position::new(-10.0, -10.0, -10.0);
            world.spawn((Cube { side: 20.0 }, corner, white(0.25, 0.5)));
        });
        check::<T>(|world| {
            let shape = Pyramid { width: 30.0, height: 30.0 };
            world.spawn((shape, Position::new(-15.0, -15.0, -10.0), white(0.25, 0.5)));
        });
    }
    check_all::<f64>();
    check_all::<f32>();
}

/// A closed room around the camera, with a light in it. `wall` is what a point of it should show.
fn assert_room_without_acne<T: Real>(shape: impl Bundle, wall: impl Fn([f64; 3]) -> bool) {
    let mut world = view(65).world();
    world.spawn((shape, white(0.0, 0.5)));
    world.spawn(lamp(0.5, -4.0, 0.5));
    let picture: Picture = trace::<T>(&mut world).picture;
    let bad = picture.pixels.iter().filter(|&&pixel| !wall(pixel)).count();
    assert_eq!(bad, 0, "points of the wall in shadow of themselves");
}

#[test]
fn no_point_of_a_room_shadows_itself() {
    // Seen from near the light, no wall is darker than its grazing cosine allows.
    let lit = |pixel: [f64; 3]| pixel[0] > 0.05;
    assert_room_without_acne::<f64>(Sphere { radius: 10.0 }, lit);
    assert_room_without_acne::<f32>(Sphere { radius: 10.0 }, lit);
    let corner = Position::new(-10.0, -10.0, -10.0);
    assert_room_without_acne::<f64>((Cube { side: 20.0 }, corner), lit);
    assert_room_without_acne::<f32>((Cube { side: 20.0 }, corner), lit);
}

//! Bodies that light passes.

use archetrace::components::{
    Absorption, Ambient, Background, Checkerboard, Color, Cube, Diffuse, Glass, Mirror, Position, Pyramid,
    Snapshot, Sphere,
};
use archetrace::geometry::Real;
use bevy_ecs::prelude::*;
use glam::DVec3;

use super::{View, assert_close, lamp, wall_ahead, white};
use crate::paths;
use crate::support::picture::assert_same;
use crate::support::scenes::full_case;
use crate::support::tracing::{Traced, trace};

fn clear(index: f64) -> Glass {
    Glass { index, transmission: 1.0 }
}

/// The share that one face reflects of a ray that meets it head on.
fn head_on(index: f64) -> f64 {
    ((index - 1.0) / (index + 1.0)).powi(2)
}

/// A background that shows the height of a direction: (1 + z) / 2.
fn height() -> Background {
    Background { below: DVec3::ZERO, above: DVec3::ONE }
}

fn white_room() -> Background {
    Background { below: DVec3::ONE, above: DVec3::ONE }
}

/// What a ray that meets nothing sees of [`height`], and any ray that is turned by an angle from level.
fn height_at(angle: f64) -> f64 {
    0.5 * (1.0 + angle.sin())
}

#[test]
fn glass_of_index_1_is_not_there() {
    fn check<T: Real>() {
        let picture = |glass: bool| {
            let mut case = full_case();
            // Nothing that a shadow or one ray less could change.
            case.description.lights.clear();
            case.description.spots.clear();
            for object in &mut case.description.objects {
                object.surface.reflection = 0.0;
            }
            case.description.board.reflection = 0.0;
            case.description.level = if glass { 7 } else { 1 };
            let mut world = case.world();
            if glass {
                world.spawn((Sphere { radius: 21.0 }, Position::new(20.0, -70.0, 40.0), clear(1.0)));
                world.spawn((Cube { side: 25.0 }, Position::new(-35.0, -80.0, 4.0), clear(1.0)));
                world.spawn((
                    Pyramid { width: 30.0, height: 33.0 },
                    Position::new(-5.0, -60.0, 2.0),
                    clear(1.0),
                ));
            }
            trace::<T>(&mut world)
        };
        let (plain, through) = (picture(false), picture(true));
        assert_same(T::NAME, &plain.picture, &through.picture);
        assert_eq!(through.counts.rays.mirror, 0);
        assert!(through.counts.rays.refracted > 2000, "{:?}", through.counts.rays);
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn a_ball_bends_rays_by_twice_the_difference_of_its_angles() {
    // A ray at height b: sin i = b / R, sin t = b / (n R), and it leaves turned down by 2 (i - t).
    let (radius, index) = (10.0, 1.5);
    for height_of_ray in [0.0, 1.0, -4.0, 7.5, 9.9] {
        let position = DVec3::new(0.0, -30.0, height_of_ray);
        let mut world = View { position, level: 3, ..View::one_ray() }.world();
        world.spawn((Sphere { radius }, clear(index)));
        world.spawn(height());
        let (sine, refracted_sine) = (height_of_ray / radius, height_of_ray / radius / index);
        let (angle, inside) = (f64::asin(sine), f64::asin(refracted_sine));
        let perpendicular = (angle.cos() - index * inside.cos()) / (angle.cos() + index * inside.cos());
        let parallel = (inside.cos() - index * angle.cos()) / (inside.cos() + index * angle.cos());
        let share = (perpendicular.powi(2) + parallel.powi(2)) / 2.0;
        // Once reflected outside; or in and out. What is reflected inside is at its third ray, and ends there.
        let outside = share * height_at(2.0 * angle);
        let through = (1.0 - share).powi(2) * height_at(2.0 * (inside - angle));
        let Traced { picture, counts } = trace::<f64>(&mut world);
        let found = picture.middle()[0];
        assert!((found - (outside + through)).abs() < 4e-15, "{found}, not {}", outside + through);
        assert_eq!((counts.rays.mirror, counts.rays.refracted), (2, 2));
    }
}

#[test]
fn a_slab_head_on_passes_what_its_faces_leave() {
    let mut world = View { level: 3, ..View::one_ray() }.world();
    world.spawn((
        Cube { side: 20.0 },
        Position::new(-10.0, 0.0, -10.0),
        Glass { index: 1.5, transmission: 0.75 },
    ));
    world.spawn(white_room());
    let face = head_on(1.5);
    let through = (0.75 * (1.0 - face)).powi(2);
    assert_close(trace::<f64>(&mut world).picture.middle(), [0.75 * face + through; 3]);
}

#[test]
fn clear_glass_in_a_white_room_is_white() {
    // Whatever way light takes, none is lost: but for parts too weak to be followed, at most one level of 8 bits.
    let view =
        View { position: DVec3::new(-3.0, -30.0, 8.0), look: DVec3::new(3.0, 30.0, -6.0), ..View::one_ray() };
    let shapes: [fn(&mut World); 3] = [
        |world| _ = world.spawn((Sphere { radius: 10.0 }, clear(1.5))),
        |world| _ = world.spawn((Cube { side: 12.0 }, Position::new(-6.0, -6.0, -6.0), clear(1.3))),
        |world| {
            let shape = Pyramid { width: 15.0, height: 11.0 };
            world.spawn((shape, Position::new(-7.0, -7.0, -4.0), clear(1.4)));
        },
    ];
    for spawn in shapes {
        let mut world = View { pixels: 65, level: 1000, ..view }.world();
        spawn(&mut world);
        world.spawn(white_room());
        let Traced { picture, counts } = trace::<f64>(&mut world);
        let darkest = picture.pixels.iter().map(|pixel| pixel[0]).fold(1.0, f64::min);
        assert!(darkest > 1.0 - 2.0 / 255.0, "{darkest}");
        assert!(counts.rays.refracted > 1000, "{:?}", counts.rays);
    }
}

#[test]
fn total_reflection_keeps_a_ray_inside() {
    // From the middle of a cube at 45 degrees to its walls: round and round, if the index is above the root of 2.
    for (index, total) in [(1.415, true), (1.414, false)] {
        let view =
            View { position: DVec3::ZERO, look: DVec3::new(1.0, 1.0, 0.0), level: 9, ..View::one_ray() };
        let mut world = view.world();
        world.spawn((Cube { side: 20.0 }, Position::new(-10.0, -9.0, -10.0), clear(index)));
        world.spawn(white_room());
        let Traced { picture, counts } = trace::<f64>(&mut world);
        assert_eq!(picture.middle() == [0.0; 3], total);
        assert_eq!(counts.rays.refracted == 0, total);
        assert!(!total || counts.rays.mirror == 8);
    }
}

#[test]
fn what_is_left_falls_exponentially_with_the_way_through_the_body() {
    let absorption = [0.02, 0.1, 0.0];
    for side in [1.0, 7.0, 30.0] {
        let mut world = View { level: 3, ..View::one_ray() }.world();
        let corner = Position::new(-0.5 * side, 0.0, -0.5 * side);
        world.spawn((Cube { side }, corner, clear(1.0), Absorption(DVec3::from_array(absorption))));
        world.spawn(white_room());
        assert_close(trace::<f64>(&mut world).picture.middle(), absorption.map(|a| (-a * side).exp()));
    }
    // A chord of a ball, 2 sqrt(10^2 - 6^2) = 16 long.
    let mut world = View { position: DVec3::new(6.0, -30.0, 0.0), level: 3, ..View::one_ray() }.world();
    world.spawn((Sphere { radius: 10.0 }, clear(1.0), Absorption(DVec3::from_array(absorption))));
    world.spawn(white_room());
    assert_close(trace::<f64>(&mut world).picture.middle(), absorption.map(|a| (-a * 16.0).exp()));
}

#[test]
fn a_board_of_glass_is_a_sheet() {
    let view =
        View { position: DVec3::new(3.0, 4.0, 10.0), look: DVec3::NEG_Z, up: DVec3::Y, ..View::one_ray() };
    let mut world = View { level: 2, ..view }.world();
    world.spawn((Checkerboard { cell: 10.0 }, white(0.125, 0.0), clear(1.5)));
    world.spawn(Background { below: DVec3::splat(0.25), above: DVec3::splat(0.75) });
    let face = head_on(1.5);
    let reflected = 2.0 * face / (1.0 + face);
    let Traced { picture, counts } = trace::<f64>(&mut world);
    assert_close(picture.middle(), [0.125 + 0.25 * (1.0 - reflected) + 0.75 * reflected; 3]);
    assert_eq!((counts.rays.mirror, counts.rays.refracted), (1, 1));
}

#[test]
fn mirror_and_glass_share_one_reflected_ray() {
    let mut world = View { level: 2, ..View::one_ray() }.world();
    world.spawn((wall_ahead(0.0), white(0.0, 0.0), Mirror(0.25), Glass { index: 1.5, transmission: 0.75 }));
    world.spawn(white_room());
    let Traced { picture, counts } = trace::<f64>(&mut world);
    assert_close(picture.middle(), [0.25 + 0.75 * head_on(1.5); 3]);
    assert_eq!((counts.rays.mirror, counts.rays.refracted), (1, 1));
}

#[test]
fn at_the_last_level_glass_sends_no_ray_and_a_full_share_adds_no_ray_of_weight_0() {
    let mut world = View::one_ray().world();
    world.spawn((wall_ahead(0.0), white(0.25, 0.0), clear(1.5)));
    world.spawn(white_room());
    let Traced { picture, counts } = trace::<f64>(&mut world);
    assert_eq!((picture.middle(), counts.rays.mirror, counts.rays.refracted), ([0.25; 3], 0, 0));
    world.insert_resource(Snapshot { pixels: 1, level: 2 });
    let mut glasses = world.query::<&mut Glass>();
    glasses.single_mut(&mut world).unwrap().index = 1.0;
    let counts = trace::<f64>(&mut world).counts;
    assert_eq!((counts.rays.mirror, counts.rays.refracted), (0, 1));
}

#[test]
fn rays_between_bodies_of_glass_come_to_an_end() {
    // Two walls, two balls and mirrors inside: the number of rays would double 1000 times.
    let mut world = View { pixels: 9, level: 1000, ..View::one_ray() }.world();
    let half = Glass { index: 1.5, transmission: 0.5 };
    world.spawn((wall_ahead(0.0), white(0.01, 0.0), Mirror(0.5), half));
    world.spawn((wall_ahead(1100.0), white(0.01, 0.0), Mirror(0.5), half));
    for x in [-3.0, 3.0] {
        world.spawn((Sphere { radius: 2.5 }, Position::new(x, 20.0, 0.0), Mirror(0.5), half));
    }
    let counts = trace::<f64>(&mut world).counts;
    let rays = counts.rays.mirror + counts.rays.refracted;
    assert!((1000..81 * 3 * 4096 * 20).contains(&rays), "{rays} rays");
}

#[test]
fn glass_throws_a_shadow_and_is_lit_like_any_body() {
    let mut world = View::one_ray().world();
    world.spawn((wall_ahead(0.0), Color::default(), Ambient(0.125), Diffuse(0.5)));
    world.spawn((Sphere { radius: 1.0 }, Position::new(4.0, -5.0, 0.0), clear(1.5)));
    world.spawn(lamp(8.0, -10.0, 0.0));
    assert_close(trace::<f64>(&mut world).picture.middle(), [0.125; 3]);
}

#[test]
fn glass_is_the_same_on_every_path() {
    fn check<T: Real>() {
        let mut world = full_case().world();
        let tint = Absorption(DVec3::new(0.03, 0.001, 0.02));
        world.spawn((Sphere { radius: 21.0 }, Position::new(20.0, -70.0, 40.0), clear(1.5), tint));
        world.spawn((Cube { side: 25.0 }, Position::new(-35.0, -80.0, 4.0), clear(1.3), white(0.1, 0.2)));
        world.spawn((Pyramid { width: 30.0, height: 33.0 }, Position::new(-5.0, -60.0, 2.0), clear(0.8)));
        world.spawn(height());
        world.insert_resource(Snapshot { pixels: 61, level: 6 });
        paths::check_world::<T>("glass", world);
    }
    check::<f64>();
    check::<f32>();
}

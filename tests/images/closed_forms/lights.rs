//! One surface, a few lights.

use archetrace::components::{
    Ambient, Checkerboard, Color, Cube, Diffuse, Falloff, Gloss, Light, Position, Sphere, SpotCone,
};
use archetrace::geometry::Real;
use bevy_ecs::prelude::*;
use glam::DVec3;

use super::{View, assert_close, lamp, wall_ahead, white};
use crate::support::picture::{Picture, assert_same};
use crate::support::tracing::trace;

const OWN: [f64; 3] = [0.9, 0.5, 0.1];

fn colored(ambient: f64, diffuse: f64) -> (Color, Ambient, Diffuse) {
    (Color::new(OWN[0], OWN[1], OWN[2]), Ambient(ambient), Diffuse(diffuse))
}

fn shiny(specular: f64, shininess: f64) -> Gloss {
    Gloss { specular, shininess }
}

fn times(strength: f64) -> [f64; 3] {
    OWN.map(|channel| channel * strength)
}

/// The middle pixel, and shadow rays cast, in both precisions.
fn seen(world: &mut World) -> ([f64; 3], u64) {
    let (color, rays) = super::seen(world);
    (color, rays.shadow)
}

#[test]
fn a_light_on_the_normal_gives_every_part_in_full() {
    let mut world = View::one_ray().world();
    world.spawn((Sphere { radius: 2.0 }, colored(0.1, 0.3), shiny(0.2, 30.0)));
    world.spawn((lamp(0.0, -5.0, 0.0), Falloff(0.05)));
    let fade = (-9.0_f64 * 0.05).exp();
    let (color, shadow_rays) = seen(&mut world);
    assert_close(color, times(0.1 + 0.3 * fade + 0.2 * fade));
    assert_eq!(shadow_rays, 1);
}

#[test]
fn a_light_behind_the_surface_is_not_even_asked_for() {
    let mut world = View::one_ray().world();
    world.spawn((Sphere { radius: 2.0 }, colored(0.1, 0.3), shiny(0.2, 0.0)));
    world.spawn(lamp(0.0, 30.0, 0.0));
    assert_eq!(seen(&mut world), (times(0.1), 0));
}

#[test]
fn a_light_in_the_surface_or_on_the_point_gives_nothing() {
    for (x, y, z) in [(3.0, 0.0, 4.0), (0.0, 0.0, 0.0)] {
        let mut world = View::one_ray().world();
        world.spawn((wall_ahead(0.0), colored(0.1, 0.3), shiny(0.2, 0.0)));
        world.spawn(lamp(x, y, z));
        assert_eq!(seen(&mut world), (times(0.1), 0));
    }
}

#[test]
fn a_slanting_light_gives_its_cosine_and_the_power_of_it() {
    // Towards the light: (4, -3, 0) / 5. The viewing ray comes back along the normal.
    let mut world = View::one_ray().world();
    world.spawn((wall_ahead(0.0), colored(0.1, 0.3), shiny(0.2, 3.0)));
    world.spawn((lamp(4.0, -3.0, 0.0), Falloff(0.01)));
    let fade = (-25.0_f64 * 0.01).exp();
    let (color, _) = seen(&mut world);
    assert_close(color, times(0.1 + 0.3 * 0.6 * fade + 0.2 * 0.216 * fade));
}

#[test]
fn the_highlight_follows_the_mirrored_viewing_ray() {
    // The viewing ray (3, 4, 0) / 5 leaves as (3, -4, 0) / 5: one light stands there, one on the normal.
    let view =
        View { position: DVec3::new(-6.0, -8.0, 0.0), look: DVec3::new(3.0, 4.0, 0.0), ..View::one_ray() };
    for (light, cosine) in [(lamp(6.0, -8.0, 0.0), 1.0), (lamp(0.0, -8.0, 0.0), 0.8)] {
        let mut world = view.world();
        world.spawn((wall_ahead(0.0), colored(0.0, 0.0), shiny(1.0, 2.0)));
        world.spawn(light);
        let (color, _) = seen(&mut world);
        assert_close(color, times(cosine * cosine));
    }
}

#[test]
fn a_highlight_needs_the_mirrored_ray_on_the_side_of_the_light() {
    // Mirrored (3, -4, 0) / 5, light towards (-4, -3, 0) / 5: at a right angle; and further round.
    let view =
        View { position: DVec3::new(-6.0, -8.0, 0.0), look: DVec3::new(3.0, 4.0, 0.0), ..View::one_ray() };
    for x in [-4.5, -40.0] {
        for shininess in [0.0, 1.0, 2.0, 7.5] {
            let mut world = view.world();
            world.spawn((wall_ahead(0.0), colored(0.5, 0.0), shiny(1.0, shininess)));
            world.spawn(lamp(x, -3.0, 0.0));
            assert_eq!(seen(&mut world), (times(0.5), 1));
        }
    }
}

#[test]
fn light_sums_are_capped_at_the_very_end_only() {
    let own = |channel| Color::new(channel, channel, channel);
    for (channel, expected) in [(0.25, 0.75), (0.5, 1.0)] {
        let mut world = View::one_ray().world();
        world.spawn((wall_ahead(0.0), own(channel), Diffuse(1.0)));
        world.spawn(lamp(0.0, -1.0, 0.0));
        world.spawn(lamp(0.0, -2.0, 0.0));
        world.spawn(lamp(0.0, -4.0, 0.0));
        assert_eq!(seen(&mut world), ([expected; 3], 3));
    }
}

#[test]
fn an_object_before_the_light_hides_it() {
    let mut world = slanting_scene();
    world.spawn((Sphere { radius: 0.5 }, Position::new(0.0, -2.0, 0.0)));
    assert_eq!(seen(&mut world), (times(0.1), 1));
}

#[test]
fn an_object_behind_the_light_hides_nothing() {
    let mut world = slanting_scene();
    world.spawn((Sphere { radius: 0.5 }, Position::new(0.0, -4.6, 0.0)));
    let (color, _) = seen(&mut world);
    assert_close(color, times(0.1 + 0.3));
}

#[test]
fn an_object_that_the_light_touches_hides_nothing() {
    let mut world = slanting_scene();
    world.spawn((Cube { side: 1.0 }, Position::new(-0.5, -5.0, -0.5)));
    let (color, _) = seen(&mut world);
    assert_close(color, times(0.1 + 0.3));
}

/// A wall at y = 0 seen from aside, and a light four units before the point seen.
fn slanting_scene() -> World {
    let view =
        View { position: DVec3::new(-6.0, -8.0, 0.0), look: DVec3::new(3.0, 4.0, 0.0), ..View::one_ray() };
    let mut world = view.world();
    world.spawn((wall_ahead(0.0), colored(0.1, 0.3)));
    world.spawn(lamp(0.0, -4.0, 0.0));
    world
}

#[test]
fn the_board_hides_lights_below_it() {
    let view = View {
        position: DVec3::new(1.0, -20.0, 9.0),
        look: DVec3::new(0.0, 2.0, -0.7),
        pixels: 64,
        ..View::one_ray()
    };
    let picture = |lit: bool| {
        let mut world = view.world();
        world.spawn((Checkerboard { cell: 3.0 }, white(0.2, 0.8)));
        world.spawn((Sphere { radius: 3.0 }, Position::new(0.0, 0.0, 3.5), colored(0.1, 0.9)));
        if lit {
            world.spawn(lamp(2.0, -3.0, -10.0));
        }
        trace::<f64>(&mut world)
    };
    let (lit, dark) = (picture(true), picture(false));
    assert_same("light below the board", &lit.picture, &dark.picture);
    assert!(lit.counts.rays.shadow > 0, "the sphere's underside asks for the light");
}

#[test]
fn an_opaque_sphere_keeps_the_light_within() {
    let mut world = View {
        position: DVec3::new(0.0, -20.0, 9.0),
        look: DVec3::new(0.0, 2.0, -0.7),
        pixels: 64,
        ..View::one_ray()
    }
    .world();
    world.spawn((Checkerboard { cell: 3.0 }, white(0.0, 1.0)));
    world.spawn((Sphere { radius: 3.0 }, Position::new(0.0, 0.0, 3.0), white(0.0, 1.0)));
    world.spawn((Cube { side: 3.0 }, Position::new(4.0, 0.0, 0.0), white(0.0, 1.0)));
    world.spawn(lamp(0.5, 0.5, 4.0));
    for traced in [trace::<f64>(&mut world), trace::<f32>(&mut world)] {
        assert!(traced.picture.pixels.iter().all(|&pixel| pixel == [0.0; 3]));
        assert!(traced.counts.rays.shadow > 1000);
    }
}

/// The ground from above, lit from (0, 0, 10) by a light with this cone.
fn pool_of_light(cone: Option<SpotCone>, lit: bool) -> (View, Picture) {
    let view = View::from_above(0.0, 0.0, 20.0, 65);
    let mut world = view.world();
    world.spawn((Checkerboard { cell: 1000.0 }, white(0.125, 0.5), Position::new(-500.0, -500.0, 0.0)));
    if lit {
        let light = world.spawn(lamp(0.0, 0.0, 10.0)).id();
        if let Some(cone) = cone {
            world.entity_mut(light).insert(cone);
        }
    }
    (view, trace::<f64>(&mut world).picture)
}

#[test]
fn a_cone_is_all_or_nothing() {
    for cutoff in [1.0_f64, 20.0, 45.0, 60.0] {
        let cone = SpotCone { target: DVec3::new(0.0, 0.0, 3.0), cutoff };
        let (view, found) = pool_of_light(Some(cone), true);
        let (_, lit) = pool_of_light(None, true);
        let (_, dark) = pool_of_light(None, false);
        let (mut inside, mut outside) = (0, 0);
        for row in 0..65 {
            for column in 0..65 {
                let distance = view.on_ground(column, row).unwrap().length();
                let angle = (distance / 10.0).atan().to_degrees();
                let (column, row) = (column as usize, row as usize);
                if angle < cutoff - 1e-9 {
                    inside += 1;
                    assert_eq!(found.at(column, row), lit.at(column, row));
                } else if angle > cutoff + 1e-9 {
                    outside += 1;
                    assert_eq!(found.at(column, row), dark.at(column, row));
                }
            }
        }
        assert_eq!(inside + outside, 65 * 65);
        assert!(inside > 0 && outside > 0);
    }
}

#[test]
fn a_cutoff_of_0_lights_the_axis_only() {
    let cone = SpotCone { target: DVec3::ZERO, cutoff: 0.0 };
    let (_, found) = pool_of_light(Some(cone), true);
    let lit = found.pixels.iter().filter(|pixel| pixel[0] > 0.125).count();
    assert_eq!(lit, 1);
    assert_close(found.middle(), [0.625; 3]);
}

#[test]
fn a_narrow_cone_lights_nothing_behind_it() {
    for cutoff in [0.0, 1e-6, 30.0, 80.0] {
        let away = SpotCone { target: DVec3::new(0.0, 0.0, 13.0), cutoff };
        let (_, found) = pool_of_light(Some(away), true);
        let (_, dark) = pool_of_light(None, false);
        assert_same(&format!("cutoff {cutoff}, looking away"), &dark, &found);
    }
}

#[test]
fn light_falls_on_the_ground_as_computed_by_hand() {
    let (view, found) = pool_of_light(None, true);
    for row in 0..65 {
        for column in 0..65 {
            let place = view.on_ground(column, row).unwrap();
            let cosine = 10.0 / (place.length_squared() + 100.0).sqrt();
            assert_close(found.at(column as usize, row as usize), [0.125 + 0.5 * cosine; 3]);
        }
    }
}

#[test]
fn without_any_light_the_ambient_part_shows() {
    let mut world = View::one_ray().world();
    world.spawn((wall_ahead(0.0), colored(0.25, 0.5), shiny(0.25, 1.0)));
    assert_eq!(seen(&mut world), (times(0.25), 0));
    // A light entity without an object lights nothing either.
    let mut empty = View::one_ray().world();
    empty.spawn((Light, Position::new(0.0, -5.0, 0.0)));
    assert_eq!(seen(&mut empty), ([0.0; 3], 0));
}

#[test]
fn a_light_as_close_as_numbers_go_lights_its_point_in_full() {
    fn check<T: Real>(distances: &[f64]) {
        for &distance in distances {
            let mut world = View::one_ray().world();
            world.spawn((wall_ahead(0.0), colored(0.1, 0.3), shiny(0.2, 9.0)));
            // The largest falloff there is takes nothing from a light so near.
            world.spawn((lamp(0.0, -distance, 0.0), Falloff(1e150)));
            world.spawn(lamp(0.0, -distance, 0.0));
            let traced = trace::<T>(&mut world);
            assert_eq!(traced.counts.non_finite, 0);
            for (found, own) in traced.picture.middle().into_iter().zip(OWN) {
                let wanted = own * (0.1 + 2.0 * (0.3 + 0.2));
                assert!((found - wanted.min(1.0)).abs() < 1e-6, "{} at {distance:e}: {found}", T::NAME);
            }
        }
    }
    check::<f64>(&[1e-100, 1e-160, 1e-200, 5e-324]);
    check::<f32>(&[1e-35, 1e-40]);
}

//! Lights of any colour, and parallel ones.

use archetrace::components::{
    Ambient, Color, Diffuse, Directional, Falloff, Gloss, Light, LightColor, Position, Sphere, SpotCone,
};
use archetrace::geometry::Real;
use bevy_ecs::prelude::*;
use glam::DVec3;

use super::{View, assert_close, lamp, wall_ahead};
use crate::paths;
use crate::support::picture::assert_same;
use crate::support::scenes::full_case;
use crate::support::tracing::trace;

const OWN: [f64; 3] = [0.9, 0.5, 0.1];

fn glossy() -> (Color, Ambient, Diffuse, Gloss) {
    let gloss = Gloss { specular: 0.2, shininess: 3.0 };
    (Color::new(OWN[0], OWN[1], OWN[2]), Ambient(0.1), Diffuse(0.3), gloss)
}

fn seen(world: &mut World) -> ([f64; 3], u64) {
    let traced = trace::<f64>(world);
    (traced.picture.middle(), traced.counts.rays.shadow)
}

/// The own colour, times what each channel gets.
fn lit(strength: impl Fn(usize) -> f64) -> [f64; 3] {
    core::array::from_fn(|channel| OWN[channel] * strength(channel))
}

fn sun(x: f64, y: f64, z: f64) -> (Light, Directional) {
    (Light, Directional { direction: DVec3::new(x, y, z) })
}

#[test]
fn colors_of_lights_multiply_and_add() {
    // One light on the normal, one at a cosine of 0.6 from it; the viewing ray comes back along the normal.
    let (warm, cold) = ([0.75, 0.5, 0.0], [0.25, 0.0, 1.5]);
    let mut world = View::one_ray().world();
    world.spawn((wall_ahead(0.0), glossy()));
    world.spawn((lamp(0.0, -5.0, 0.0), LightColor(DVec3::from_array(warm))));
    world.spawn((lamp(4.0, -3.0, 0.0), LightColor(DVec3::from_array(cold)), Falloff(0.01)));
    let fade = (-25.0_f64 * 0.01).exp();
    let (color, _) = seen(&mut world);
    assert_close(color, lit(|i| 0.1 + 0.5 * warm[i] + (0.3 * 0.6 + 0.2 * 0.216) * fade * cold[i]));
}

#[test]
fn a_black_light_casts_no_ray() {
    let mut world = View::one_ray().world();
    world.spawn((wall_ahead(0.0), glossy()));
    world.spawn((lamp(0.0, -5.0, 0.0), LightColor(DVec3::ZERO)));
    assert_eq!(seen(&mut world), (lit(|_| 0.1), 0));
}

#[test]
fn parallel_light_has_the_same_cosine_everywhere() {
    // Against the light lies (4, -3, 0) / 5.
    for length in [1e-200, 5.0, 1e60] {
        let mut world = View { pixels: 9, ..View::one_ray() }.world();
        world.spawn((wall_ahead(0.0), Color::default(), Diffuse(0.5)));
        let direction = DVec3::new(-0.8, 0.6, 0.0) * length;
        world.spawn((Light, Position::new(1.0, 2.0, 3.0), Directional { direction }));
        let found = trace::<f64>(&mut world);
        found.picture.pixels.iter().for_each(|&pixel| assert_close(pixel, [0.5 * 0.6; 3]));
        assert_eq!(found.counts.rays.shadow, 81);
    }
}

#[test]
fn parallel_light_has_highlights() {
    let mut world = View::one_ray().world();
    world.spawn((wall_ahead(0.0), glossy()));
    world.spawn(sun(-4.0, 3.0, 0.0));
    assert_close(seen(&mut world).0, lit(|_| 0.1 + 0.3 * 0.6 + 0.2 * 0.216));
}

#[test]
fn parallel_light_is_hidden_from_however_far() {
    for (distance, radius, hidden) in [(1e60, 1e59, true), (20.0, 1.0, true), (-1e3, 1e2, false)] {
        let mut world = View::one_ray().world();
        world.spawn((wall_ahead(0.0), Color::default(), Ambient(0.125), Diffuse(0.5)));
        // Beside the viewing ray, on the ray against the light.
        world.spawn((Sphere { radius }, Position(DVec3::new(0.8, -0.6, 0.0) * distance)));
        world.spawn(sun(-4.0, 3.0, 0.0));
        let expected = if hidden { 0.125 } else { 0.125 + 0.5 * 0.6 };
        assert_close(seen(&mut world).0, [expected; 3]);
    }
}

#[test]
fn parallel_light_from_behind_or_along_a_surface_casts_no_ray() {
    for light in [sun(0.0, -1.0, 0.0), sun(1.0, 0.0, 0.0), sun(3.0, -1e-9, 4.0)] {
        let mut world = View::one_ray().world();
        world.spawn((wall_ahead(0.0), glossy()));
        world.spawn(light);
        assert_eq!(seen(&mut world), (lit(|_| 0.1), 0));
    }
}

#[test]
fn position_falloff_and_cone_do_nothing_to_parallel_light() {
    fn check<T: Real>() {
        let picture = |extra: bool| {
            let mut world = full_case().world();
            let light = world.spawn(sun(2.0, 3.0, -5.0)).id();
            if extra {
                let cone = SpotCone { target: DVec3::X, cutoff: 3.0 };
                world.entity_mut(light).insert((Position::new(9.0, 8.0, -7.0), Falloff(0.5), cone));
            }
            trace::<T>(&mut world)
        };
        let (plain, other) = (picture(false), picture(true));
        assert_same(T::NAME, &plain.picture, &other.picture);
        assert_eq!(plain.counts, other.counts);
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn parallel_light_is_that_of_a_light_very_far_away() {
    let picture = |light: (Light, Position), parallel: bool| {
        let mut world = full_case().world();
        let light = world.spawn(light).id();
        if parallel {
            world.entity_mut(light).insert(Directional { direction: DVec3::new(2.0, 3.0, -5.0) });
        }
        trace::<f64>(&mut world).picture
    };
    let distant = picture(lamp(-2e12, -3e12, 5e12), false);
    let parallel = picture(lamp(0.0, 0.0, 0.0), true);
    let apart = distant.pixels.iter().zip(&parallel.pixels).filter(|(a, b)| {
        let differs = |i: usize| (a[i] - b[i]).abs() > 1e-9;
        (0..3).any(differs)
    });
    // Nothing but the edge of a shadow can run between the two.
    assert!(apart.count() <= 2);
}

#[test]
fn lights_of_every_kind_are_the_same_on_every_path() {
    fn check<T: Real>() {
        let mut world = full_case().world();
        world.spawn((sun(2.0, 3.0, -5.0), LightColor(DVec3::new(0.5, 0.25, 0.125))));
        world.spawn((lamp(-70.0, -60.0, 50.0), LightColor(DVec3::new(0.1, 0.2, 0.3)), Falloff(1e-5)));
        paths::check_world::<T>("lights of every kind", world);
    }
    check::<f64>();
    check::<f32>();
}

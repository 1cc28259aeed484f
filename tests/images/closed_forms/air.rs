//! What surrounds all objects: background and fog.

use archetrace::components::{
    Ambient, Background, Color, Diffuse, Fog, Glass, Light, Mirror, Position, Snapshot, Sphere,
};
use archetrace::geometry::Real;
use glam::DVec3;

use super::{View, assert_close, lamp, wall_ahead, wall_behind, white};
use crate::paths;
use crate::support::scenes::full_case;
use crate::support::tracing::{Traced, trace};

const BELOW: [f64; 3] = [0.1, 0.3, 0.2];
const ABOVE: [f64; 3] = [0.5, 0.6, 0.9];
const HAZE: [f64; 3] = [0.6, 0.5, 0.3];

fn sky() -> Background {
    Background { below: DVec3::from_array(BELOW), above: DVec3::from_array(ABOVE) }
}

fn fog(density: f64) -> Fog {
    Fog { density, color: DVec3::from_array(HAZE) }
}

/// The sky's colour at a height of -1 to 1.
fn sky_at(height: f64) -> [f64; 3] {
    core::array::from_fn(|i| BELOW[i] + (ABOVE[i] - BELOW[i]) * (1.0 + height) / 2.0)
}

/// What is left of a colour after a distance in fog.
fn in_fog(color: [f64; 3], density: f64, distance: f64) -> [f64; 3] {
    let left = (-density * distance).exp();
    core::array::from_fn(|i| color[i] * left + HAZE[i] * (1.0 - left))
}

#[test]
fn a_background_is_mixed_by_height() {
    fn check<T: Real>(allowed: f64) {
        let view = View { pixels: 17, ..View::one_ray() };
        let mut world = view.world();
        world.spawn(sky());
        let found = trace::<T>(&mut world);
        for (row, pixels) in (0_u32..).zip(found.picture.pixels.chunks(17)) {
            for (column, pixel) in (0_u32..).zip(pixels) {
                let share = |index: u32| (2.0 * f64::from(index) + 1.0) / 17.0 - 1.0;
                let half = 30.0_f64.to_radians().tan();
                let direction = DVec3::new(share(column) * half, 1.0, -share(row) * half).normalize();
                for (found, wanted) in pixel.iter().zip(sky_at(direction.z)) {
                    assert!((found - wanted).abs() < allowed, "{pixel:?}");
                }
            }
        }
        assert_eq!((found.counts.rays.primary, found.counts.rays.shadow), (17 * 17, 0));
    }
    check::<f64>(1e-15);
    check::<f32>(1e-6);
}

#[test]
fn the_background_shows_beyond_the_far_plane_and_not_at_level_0() {
    let mut world = View::one_ray().world();
    world.spawn(sky());
    world.spawn((Sphere { radius: 10.0 }, Position::new(0.0, 2000.0, 0.0), white(1.0, 0.0)));
    assert_close(trace::<f64>(&mut world).picture.middle(), sky_at(0.0));
    world.insert_resource(Snapshot { pixels: 1, level: 0 });
    assert_eq!(trace::<f64>(&mut world).picture.middle(), [0.0; 3]);
}

#[test]
fn mirrors_show_the_background() {
    // (0, 4, -3) / 5 leaves a wall towards -y as (0, -4, -3) / 5.
    let view =
        View { position: DVec3::new(0.0, -8.0, 6.0), look: DVec3::new(0.0, 4.0, -3.0), ..View::one_ray() };
    for (level, share) in [(1, 0.0), (2, 0.5), (9, 0.5)] {
        let mut world = View { level, ..view }.world();
        world.spawn((wall_ahead(0.0), white(0.25, 0.0), Mirror(0.5)));
        world.spawn(sky());
        let Traced { picture, counts } = trace::<f64>(&mut world);
        assert_close(picture.middle(), sky_at(-0.6).map(|channel| 0.25 + share * channel));
        assert_eq!(counts.rays.mirror, u64::from(level > 1));
    }
}

#[test]
fn fog_dims_by_distance_and_shows_its_own_color() {
    // From the near plane, a unit ahead of (0, -10, 0).
    for density in [1e-9, 0.01, 0.3, 20.0] {
        let mut world = View::one_ray().world();
        world.spawn((wall_ahead(0.0), Color::new(0.9, 0.5, 0.1), Ambient(0.25), Diffuse(0.5)));
        world.spawn(lamp(0.0, -10.0, 0.0));
        world.spawn(fog(density));
        let own = [0.9, 0.5, 0.1].map(|channel| channel * (0.25 + 0.5));
        assert_close(trace::<f64>(&mut world).picture.middle(), in_fog(own, density, 9.0));
    }
}

#[test]
fn each_ray_of_a_row_goes_through_fog_of_its_own() {
    // 9 to the mirror, 40 back to the wall behind the camera.
    let mut world = View { level: 2, ..View::one_ray() }.world();
    world.spawn((wall_ahead(0.0), white(0.125, 0.0), Mirror(0.5)));
    world.spawn((wall_behind(-40.0), white(0.75, 0.0)));
    world.spawn(fog(0.02));
    let mirrored = in_fog([0.75; 3], 0.02, 40.0);
    let expected = in_fog(mirrored.map(|channel| 0.125 + 0.5 * channel), 0.02, 9.0);
    let found = trace::<f64>(&mut world).picture.middle();
    for (found, expected) in found.into_iter().zip(expected) {
        assert!((found - expected).abs() < 1e-15, "{found} and {expected}");
    }
}

#[test]
fn fog_hides_what_is_infinitely_far_and_what_it_hides_costs_nothing() {
    for density in [1e-100, 1e3, 1e150] {
        let mut world = View::one_ray().world();
        world.spawn((fog(density), sky()));
        assert_eq!(trace::<f64>(&mut world).picture.middle(), HAZE);
    }
    let mut world = View { level: 3, ..View::one_ray() }.world();
    world.spawn((wall_ahead(0.0), white(0.5, 0.5), Mirror(0.5)));
    world.spawn(lamp(0.0, -10.0, 0.0));
    world.spawn(fog(1e150));
    let Traced { picture, counts } = trace::<f64>(&mut world);
    assert_eq!(picture.middle(), HAZE);
    assert_eq!((counts.rays.shadow, counts.rays.mirror), (0, 0));
    assert_eq!(trace::<f32>(&mut world).counts.rays, counts.rays);
}

#[test]
fn there_is_no_fog_in_glass() {
    // 9 through fog, 20 through a ball that bends nothing, 30 through fog again.
    let mut world = View { level: 3, ..View::one_ray() }.world();
    world.spawn((
        Sphere { radius: 10.0 },
        Position::new(0.0, 10.0, 0.0),
        Glass { index: 1.0, transmission: 1.0 },
    ));
    world.spawn((wall_ahead(50.0), white(0.25, 0.0)));
    world.spawn(fog(0.02));
    let expected = in_fog([0.25; 3], 0.02, 9.0 + 30.0);
    let found = trace::<f64>(&mut world).picture.middle();
    for (found, expected) in found.into_iter().zip(expected) {
        assert!((found - expected).abs() < 1e-15, "{found} and {expected}");
    }
}

#[test]
fn fog_and_sky_are_the_same_on_every_path() {
    fn check<T: Real>() {
        for density in [0.0, 0.003] {
            let mut world = full_case().world();
            world.spawn((sky(), fog(density)));
            world.spawn((Light, Position::new(9.0, -70.0, 80.0)));
            paths::check_world::<T>("fog and sky", world);
        }
    }
    check::<f64>();
    check::<f32>();
}

//! Lights with an extent.

use archetrace::components::{AreaLight, Cube, Gloss, LightColor, Position, Sphere};
use archetrace::geometry::Real;
use bevy_ecs::prelude::*;
use glam::DVec3;

use super::{View, lamp, white};
use crate::paths;
use crate::support::scenes::full_case;
use crate::support::tracing::trace;

const LIGHT: DVec3 = DVec3::new(40.0, 0.0, 120.0);
const RADIUS: f64 = 5.0;
/// The edge of a cube, along y through this point; seen from the ground beside the cube, it alone bounds the shadow.
const EDGE: DVec3 = DVec3::new(0.0, 0.0, 60.0);

/// The ground beside a cube, from above, with the light on the cube's other side.
fn penumbra(pixels: u32, samples: u32) -> (View, World) {
    let view = View::from_above(-40.0, 0.0, 20.0, pixels);
    let mut world = view.world();
    world.spawn((Cube { side: 1000.0 }, Position::new(-500.0, -500.0, -1000.0), white(0.0, 1.0)));
    world.spawn((Cube { side: 60.0 }, Position::new(0.0, -30.0, 0.0), white(0.0, 1.0)));
    world.spawn((lamp(LIGHT.x, LIGHT.y, LIGHT.z), AreaLight { radius: RADIUS, samples }));
    (view, world)
}

/// The mean, over the disk that the light shows to a point of the ground, of the cosine where it is visible: integrated
/// in strips along the shadow's edge.
fn on_paper(point: DVec3) -> f64 {
    const STRIPS: i32 = 400;
    let to_center = LIGHT - point;
    let toward = to_center.normalize();
    // Across the edge, and along it, within the disk.
    let over_edge = (EDGE - point).cross(DVec3::Y);
    let across = (over_edge - toward * over_edge.dot(toward)).normalize();
    let along = toward.cross(across);
    let midpoints = |count: i32| (0..count).map(move |i| (f64::from(2 * i + 1) / f64::from(count)) - 1.0);
    let mut sum = 0.0;
    for x in midpoints(STRIPS) {
        let half = (1.0 - x * x).sqrt();
        for y in midpoints(50) {
            let segment = to_center + (across * x + along * (y * half)) * RADIUS;
            let height_at_edge = segment.z * (-point.x / segment.x);
            if height_at_edge > EDGE.z {
                sum += segment.normalize().z * half;
            }
        }
    }
    // Over the area of the disk: each sample stands for a box of 2 / STRIPS by 2 half / 50.
    sum * (2.0 / f64::from(STRIPS)) * (2.0 / 50.0) / core::f64::consts::PI
}

#[test]
fn a_penumbra_is_as_wide_and_as_dark_as_computed_by_hand() {
    const PIXELS: u32 = 33;
    let (view, mut world) = penumbra(PIXELS, 1024);
    let found = trace::<f64>(&mut world);
    let (mut bias, mut square, mut partly) = (0.0, 0.0, 0);
    for (index, pixel) in (0_u32..).zip(&found.picture.pixels) {
        let place = view.on_ground(index % PIXELS, index / PIXELS).unwrap();
        let full = LIGHT.z / (LIGHT - place).length();
        let expected = on_paper(place);
        let off = pixel[0] - expected;
        bias += off;
        square += off * off;
        partly += i32::from((0.01..0.99).contains(&(expected / full)));
    }
    let count = f64::from(PIXELS * PIXELS);
    // 1024 points that lie one in each of 1024 equal boxes miscount only boxes that the edge runs through, about
    // sqrt(1024) of them: 1024^(-3/4), or 0.6 %, in the root mean square at most.
    let (bias, rms) = (bias / count, (square / count).sqrt());
    assert!(rms < 0.004 && bias.abs() < 5e-4, "off by {rms:.1e}, on average {bias:.1e}");
    assert!(partly > 200, "only {partly} pixels are in the penumbra");
    let shadow_rays = found.counts.rays.shadow;
    assert_eq!(shadow_rays, u64::from(PIXELS * PIXELS) * 1024);
}

#[test]
fn a_smaller_light_is_more_like_a_point() {
    // In an even picture no pixel centre lies on the very edge of the shadow.
    let mut previous = f64::INFINITY;
    for radius in [8.0, 1.0, 0.125, 1e-9] {
        let picture = |area: Option<AreaLight>| {
            let (_, mut world) = penumbra(32, 1);
            let mut lights = world.query_filtered::<Entity, With<AreaLight>>();
            let light = lights.single(&world).unwrap();
            world.entity_mut(light).remove::<AreaLight>();
            if let Some(area) = area {
                world.entity_mut(light).insert(area);
            }
            trace::<f64>(&mut world).picture
        };
        let (point, ball) = (picture(None), picture(Some(AreaLight { radius, samples: 16 })));
        let pairs = point.pixels.iter().zip(&ball.pixels);
        let apart: f64 = pairs.map(|(a, b)| (a[0] - b[0]).abs()).sum();
        assert!(apart < previous, "radius {radius}: {apart}");
        previous = apart;
    }
    assert!(previous < 1e-9 * 32.0 * 32.0, "{previous}");
}

#[test]
fn samples_of_a_pixel_continue_each_other() {
    // Sixteen samples a pixel with 16 shadow rays each are as good as 256: they are other points of the light.
    let error = |grid: u32, samples: u32| {
        let (view, mut world) = penumbra(17, samples);
        let finer = View { pixels: 17 * grid, ..view };
        world.insert_resource(archetrace::components::Sampling { side: grid });
        let picture = trace::<f64>(&mut world).picture;
        let off = (0_u32..).zip(&picture.pixels).map(|(index, pixel)| {
            let (left, top) = (index % 17 * grid, index / 17 * grid);
            let points = (0..grid * grid).map(|n| finer.on_ground(left + n % grid, top + n / grid).unwrap());
            let mean = points.map(on_paper).sum::<f64>() / f64::from(grid * grid);
            (pixel[0] - mean).powi(2)
        });
        (off.sum::<f64>() / (17.0 * 17.0)).sqrt()
    };
    let (one, four) = (error(1, 16), error(4, 16));
    assert!(four < one / 3.0, "{one:.1e} with one sample, {four:.1e} with sixteen");
}

#[test]
fn light_from_a_ball_behind_the_horizon_counts_in_part() {
    // The light's centre lies in the ground: half of its disk is above.
    let mut world = View::one_ray().world();
    world.spawn((Cube { side: 1000.0 }, Position::new(-500.0, 0.0, -500.0), white(0.0, 1.0)));
    world.spawn((lamp(50.0, 0.0, 0.0), AreaLight { radius: 10.0, samples: 4096 }));
    let found = trace::<f64>(&mut world);
    assert!((2040..=2056).contains(&found.counts.rays.shadow), "{:?}", found.counts.rays);
    // The mean over the disk of h / sqrt(50^2 + 100 rho^2), where the height h = 10 rho sin(phi) is above 0.
    let rings = (0..1000).map(|i| (f64::from(i) + 0.5) / 1000.0);
    let mean: f64 = rings.map(|rho| rho * 10.0 * rho / (2500.0 + 100.0 * rho * rho).sqrt() * 2.0).sum();
    let expected = mean / 1000.0 / core::f64::consts::PI;
    let found = found.picture.middle()[0];
    assert!((found - expected).abs() < 2e-4, "{found}, but on paper {expected}");
}

#[test]
fn a_light_around_a_point_of_a_surface_is_harmless() {
    for (x, y) in [(0.0, 0.0), (1e-200, -1e-200), (0.0, -1.0)] {
        let mut world = View::one_ray().world();
        world.spawn((Sphere { radius: 2.0 }, white(0.25, 0.5), Gloss { specular: 0.2, shininess: 9.0 }));
        world.spawn((lamp(x, -2.0 + y, 0.0), AreaLight { radius: 3.0, samples: 64 }));
        trace::<f64>(&mut world);
        trace::<f32>(&mut world);
    }
}

#[test]
fn soft_shadows_are_the_same_on_every_path() {
    fn check<T: Real>() {
        let mut world = full_case().world();
        let color = LightColor(DVec3::new(0.5, 0.25, 0.125));
        world.spawn((lamp(-70.0, -60.0, 50.0), color, AreaLight { radius: 6.0, samples: 5 }));
        paths::check_world::<T>("soft shadows", world);
    }
    check::<f64>();
    check::<f32>();
}

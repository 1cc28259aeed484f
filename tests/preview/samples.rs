//! Several samples a pixel: smooth outlines, and colours that stay pure within.

use archetrace::components::{CameraPose, Checkerboard, Color, Cube, Lens, Position, Sphere};
use archetrace::preview::PreviewStyle;
use bevy_ecs::prelude::*;

use super::canvas::{PLAIN, Shot, draw_once};

const SMOOTH: PreviewStyle = PreviewStyle { samples: 4, background: [0.0; 3], ..PLAIN };
const SIDE: usize = 200;

fn white(world: &mut World, position: Position) -> Shot {
    let camera = (CameraPose::default(), Lens { near: 1.0, far: 1000.0, fovy: 40.0, aspect: 1.0 });
    let objects: Vec<Entity> = world.query_filtered::<Entity, With<Color>>().iter(world).collect();
    for object in objects {
        world.entity_mut(object).insert(position);
    }
    draw_once(world, (&camera.0, &camera.1), &SMOOTH, SIDE)
}

/// Half the picture's height in pixels by its tangent.
fn pixels(tangent: f64) -> f64 {
    tangent / 20_f64.to_radians().tan() * SIDE as f64 / 2.0
}

fn covered(shot: &Shot) -> f64 {
    shot.pixels.iter().map(|[red, ..]| f64::from(*red) / 255.0).sum()
}

#[test]
fn a_sphere_covers_the_area_of_its_disc_and_has_a_smooth_outline() {
    let mut world = World::new();
    world.spawn(Sphere { radius: 30.0 });
    let shot = white(&mut world, Position::new(0.0, 0.0, 50.0));
    let radius = pixels((30.0_f64 / 150.0).asin().tan());
    let area = core::f64::consts::PI * radius * radius;
    let covered = covered(&shot);
    println!("radius {radius}: {area} pixels, {covered} covered");
    assert!((covered / area - 1.0).abs() < 2e-3, "{covered} of {area}");
    let edge = shot.count(|[red, ..]| red != 0 && red != 255) as f64;
    // The outline crosses about eight pixels for each of its radius, and half of them show it with four samples.
    assert!(edge > 3.0 * radius && edge < 9.0 * radius, "{edge} pixels on the outline");
}

#[test]
fn the_edges_of_a_cube_are_smooth() {
    let mut world = World::new();
    world.spawn(Cube { side: 40.0 });
    let shot = white(&mut world, Position::new(-20.3, 0.0, 30.1));
    let side = pixels(40.0 / 150.0);
    assert!((covered(&shot) / (side * side) - 1.0).abs() < 5e-3);
    assert!(shot.count(|[red, ..]| red != 0 && red != 255) as f64 > 1.5 * side);
}

#[test]
fn the_horizon_is_smooth_where_it_is_tilted() {
    let mut world = World::new();
    world.spawn(Checkerboard { cell: 1e-3 });
    let pose = CameraPose::default();
    let tilted = CameraPose::looking(pose.position, pose.l, glam::DVec3::new(0.1, 0.0, 1.0)).unwrap();
    let lens = Lens { near: 1.0, far: 1e9, fovy: 40.0, aspect: 1.0 };
    let shot = draw_once(&mut world, (&tilted, &lens), &SMOOTH, SIDE);
    let levels = shot.count(|[red, ..]| red > 10 && red < 118);
    assert!(levels > SIDE / 2, "{levels} pixels on the horizon");
}

#[test]
fn one_sample_shows_one_object_alone() {
    for samples in [0, 1] {
        let style = PreviewStyle { samples, ..SMOOTH };
        let mut world = World::new();
        world.spawn((Sphere { radius: 30.0 }, Position::new(0.0, 0.0, 50.0), Color::new(1.0, 0.0, 0.0)));
        world.spawn((Cube { side: 30.0 }, Position::new(0.0, 0.0, 50.0), Color::new(0.0, 0.0, 1.0)));
        let lens = Lens { near: 1.0, far: 1000.0, fovy: 40.0, aspect: 1.0 };
        let shot = draw_once(&mut world, (&CameraPose::default(), &lens), &style, SIDE);
        let pure = shot.count(|pixel| [[0; 3], [255, 0, 0], [0, 0, 255]].contains(&pixel));
        assert_eq!(pure, SIDE * SIDE);
    }
}

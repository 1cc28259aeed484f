//! Pictures whose answer is on paper.

mod air;
mod board_filters;
mod camera;
mod camera_effects;
mod checkerboard;
mod contacts;
mod glass;
mod insides;
mod light_effects;
mod lights;
mod mirrors;
mod motion;
mod neutral;
mod soft_shadows;
mod ties;

use archetrace::components::{Ambient, CameraPose, Color, Cube, Diffuse, Lens, Light, Position, Snapshot};
use archetrace::trace::RayCounts;
use bevy_ecs::prelude::*;
use glam::DVec3;

use crate::support::tracing::trace;

/// How a World is looked at.
#[derive(Clone, Copy)]
struct View {
    position: DVec3,
    look: DVec3,
    up: DVec3,
    lens: Lens,
    pixels: u32,
    level: u32,
}

impl View {
    /// A single ray from (0, -10, 0) along +y that starts a unit ahead, without reflection.
    fn one_ray() -> Self {
        Self {
            position: DVec3::new(0.0, -10.0, 0.0),
            look: DVec3::Y,
            up: DVec3::Z,
            lens: Lens { near: 1.0, far: 1000.0, fovy: 60.0, aspect: 1.0 },
            pixels: 1,
            level: 1,
        }
    }

    /// From `height` above a point of the ground straight down, +y at the top: as wide at the ground as it is
    /// high twice over.
    fn from_above(x: f64, y: f64, height: f64, pixels: u32) -> Self {
        Self {
            position: DVec3::new(x, y, height),
            look: DVec3::NEG_Z,
            up: DVec3::Y,
            lens: Lens { near: 0.01 * height, far: 1000.0 * height, fovy: 90.0, aspect: 1.0 },
            pixels,
            level: 1,
        }
    }

    /// A World with this camera and nothing to see.
    fn world(&self) -> World {
        let mut world = World::new();
        world.insert_resource(Snapshot { pixels: self.pixels, level: self.level });
        let pose = CameraPose::looking(self.position, self.look, self.up).unwrap();
        world.spawn((pose, self.lens));
        world
    }

    /// Where the ray through a pixel centre meets the plane z = 0, if it lies ahead.
    fn on_ground(&self, column: u32, row: u32) -> Option<DVec3> {
        let l = self.look.normalize();
        let r = l.cross(self.up).normalize();
        let u = r.cross(l);
        let half = |degrees: f64| (0.5 * degrees).to_radians().tan();
        let share = |index: u32| (2.0 * f64::from(index) + 1.0) / f64::from(self.pixels) - 1.0;
        let to_right = r * (share(column) * half(self.lens.fovx()));
        let to_top = u * (-share(row) * half(self.lens.fovy));
        let direction = l + to_right + to_top;
        let t = -self.position.z / direction.z;
        (t > 0.0).then(|| self.position + direction * t)
    }
}

/// White, with these ambient and diffuse parts.
fn white(ambient: f64, diffuse: f64) -> (Color, Ambient, Diffuse) {
    (Color::new(1.0, 1.0, 1.0), Ambient(ambient), Diffuse(diffuse))
}

fn lamp(x: f64, y: f64, z: f64) -> (Light, Position) {
    (Light, Position::new(x, y, z))
}

/// A cube of 1000 units a side whose lower face in y, towards a camera that looks along +y, lies at `y`.
fn wall_ahead(y: f64) -> (Cube, Position) {
    (Cube { side: 1000.0 }, Position::new(-500.0, y, -500.0))
}

/// A cube of 1000 units a side whose upper face in y lies at `y`.
fn wall_behind(y: f64) -> (Cube, Position) {
    (Cube { side: 1000.0 }, Position::new(-500.0, y - 1000.0, -500.0))
}

/// The middle pixel, and the rays by kind: in single precision the same up to four roundings of its own.
#[track_caller]
fn seen(world: &mut World) -> ([f64; 3], RayCounts) {
    let (double, single) = (trace::<f64>(world), trace::<f32>(world));
    assert_eq!(double.counts.rays, single.counts.rays);
    let (double_color, single_color) = (double.picture.middle(), single.picture.middle());
    for (found, expected) in single_color.into_iter().zip(double_color) {
        let allowed = 4.0 * f64::from(f32::EPSILON) * expected.abs();
        assert!((found - expected).abs() <= allowed, "f32: {single_color:?}, f64: {double_color:?}");
    }
    (double_color, double.counts.rays)
}

/// Equal up to four roundings.
#[track_caller]
fn assert_close(found: [f64; 3], expected: [f64; 3]) {
    for (found, expected) in found.into_iter().zip(expected) {
        let allowed = 4.0 * f64::EPSILON * expected.abs();
        assert!((found - expected).abs() <= allowed, "{found:?}, but on paper {expected:?}");
    }
}

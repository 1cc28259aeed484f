//! Any number of spheres over the checkerboard.

#![allow(dead_code, reason = "not every program needs the camera")]

use archetrace::components::CameraPose;
use archetrace::scene::{
    BoardDescription, Description, LightDescription, ObjectDescription, ShapeDescription, SurfaceDescription,
};
use glam::DVec3;

use crate::random::Random;

/// Where the eye is, and the point that it looks at.
pub(crate) const EYE: DVec3 = DVec3::new(0.0, -230.0, 110.0);
/// The middle of the spheres.
pub(crate) const TARGET: DVec3 = DVec3::new(0.0, 0.0, 40.0);

/// The box that holds the centres.
const SIZE: DVec3 = DVec3::new(200.0, 200.0, 100.0);
/// Spheres that a ray would meet on its way along the box, if it went on behind each.
const DEPTH: f64 = 1.5;

/// Spheres at random places, the same for the same count. Their radius falls with the square root of their number, so that
/// as many rays meet one whatever the number is. All numbers are exact in `f32`: every program gets the same.
pub(crate) fn crowd(count: u32, pixels: u32) -> Description {
    let random = &mut Random::new(12345);
    let per_volume = f64::from(count) / (SIZE.x * SIZE.y * SIZE.z);
    let radius = (DEPTH / (per_volume * core::f64::consts::PI * SIZE.x)).sqrt();
    Description {
        near: 1.0,
        far: 10_000.0,
        fovy: 50.0,
        aspect: 1.0,
        level: 3,
        pixels,
        board: BoardDescription { cell: 20.0, ambient: 0.2, diffuse: 0.5, reflection: 0.3 },
        objects: (0..count).map(|_| sphere(random, radius)).collect(),
        lights: vec![LightDescription { position: DVec3::new(-80.0, -200.0, 300.0), falloff: 2e-6 }],
        spots: Vec::new(),
    }
}

/// The camera that sees them all.
pub(crate) fn camera() -> CameraPose {
    CameraPose::looking(EYE, TARGET - EYE, DVec3::Z).unwrap_or_default()
}

fn sphere(random: &mut Random, mean_radius: f64) -> ObjectDescription {
    let radius = single(mean_radius * random.between(0.5, 1.5));
    let place = DVec3::new(random.unit(), random.unit(), random.unit()) * SIZE;
    let lift = DVec3::new(-SIZE.x / 2.0, -SIZE.y / 2.0, 1.5 * mean_radius);
    ObjectDescription {
        position: (place + lift).map(single),
        shape: ShapeDescription::Sphere { radius },
        surface: random.pick(&surfaces()),
    }
}

/// Every look that a sphere may have.
pub(crate) fn surfaces() -> [SurfaceDescription; 6] {
    COLORS.map(|color| SurfaceDescription {
        color: color.into(),
        ambient: 0.1,
        diffuse: 0.4,
        specular: 0.25,
        reflection: 0.25,
        shininess: 30.0,
    })
}

const COLORS: [[f64; 3]; 6] =
    [[1.0, 0.3, 0.2], [0.9, 0.8, 0.2], [0.3, 0.9, 0.3], [0.2, 0.8, 0.9], [0.3, 0.4, 1.0], [0.9, 0.3, 0.8]];

#[expect(clippy::cast_possible_truncation, reason = "rounding is what it is for")]
fn single(value: f64) -> f64 {
    f64::from(value as f32)
}

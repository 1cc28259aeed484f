//! Many entities from a loop: `cargo run --release --example thousand_spheres [PICTURE]`.
//!
//! Without a picture to write it opens a window.
//!
//! The seeds of a sunflower: each ball is turned by the golden angle against the one before, a little further out.

use std::env;
use std::error::Error;
use std::f64::consts::PI;
use std::path::Path;

use archetrace::components::{
    Ambient, CameraPose, Checkerboard, Color, Diffuse, Falloff, Gloss, Lens, Light, Mirror, Position,
    Snapshot, Sphere,
};
use archetrace::image_file;
use archetrace::systems::{Frame, Workers, frame_schedule, prepare};
use archetrace::viewer::Viewer;
use bevy_ecs::prelude::*;
use glam::DVec3;

const COUNT: u32 = 1000;

fn main() -> Result<(), Box<dyn Error>> {
    let mut world = World::new();
    let look = DVec3::new(0.0, 1.0, -0.85);
    let pose = CameraPose::looking(DVec3::new(0.0, -150.0, 135.0), look, DVec3::Z).ok_or("no direction")?;
    let lens = Lens { near: 1.0, far: 1000.0, fovy: 54.0, aspect: 1.0 };
    world.spawn((pose, lens));
    world.insert_resource(Snapshot { pixels: 400, level: 3 });
    world.spawn((Checkerboard { cell: 40.0 }, Ambient(0.1), Diffuse(0.5), Mirror(0.4)));
    world.spawn((Light, Position::new(-100.0, -80.0, 160.0), Falloff(1e-6)));
    for index in 0..COUNT {
        world.spawn(seed(index));
    }

    match env::args_os().nth(1) {
        Some(picture) => save(world, Path::new(&picture)),
        None => Ok(Viewer::new("thousand_spheres", world).run()?),
    }
}

fn save(mut world: World, picture: &Path) -> Result<(), Box<dyn Error>> {
    prepare::<f64>(&mut world, Workers::new(None)?);
    frame_schedule::<f64>().run(&mut world);
    let (film, _) = world.resource::<Frame>().traced()?;
    Ok(image_file::save(film, picture)?)
}

/// One ball.
fn seed(index: u32) -> impl Bundle {
    let golden_angle = PI * (3.0 - 5.0_f64.sqrt());
    let angle = f64::from(index) * golden_angle;
    // 0 in the middle, 1 at the rim; the root gives every ball the same room.
    let out = (f64::from(index) / f64::from(COUNT)).sqrt();
    let radius = 1.6 + 0.8 * out;
    // A low dome.
    let height = radius + 22.0 * (1.0 - out * out);
    (
        Sphere { radius },
        Position::new(85.0 * out * angle.cos(), 85.0 * out * angle.sin(), height),
        Color::new(1.0 - 0.5 * out, 0.35 + 0.4 * out, 0.15 + 0.75 * out),
        Ambient(0.15),
        Diffuse(0.55),
        Gloss { specular: 0.2, shininess: 30.0 },
        Mirror(0.1),
    )
}

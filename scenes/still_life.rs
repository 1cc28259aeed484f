//! A scene from entities, without a file: `cargo run --release --example still_life [PICTURE]`.
//!
//! Without a picture to write it opens a window.
//!
//! An object is an entity with a position, a shape and what its surface can do. What it does not say it does not
//! do: the plinth has no `Gloss` and no `Mirror`.

use std::env;
use std::error::Error;
use std::path::Path;

use archetrace::components::{
    Ambient, CameraPose, Checkerboard, Color, Cube, Diffuse, Falloff, Gloss, Lens, Light, Mirror, Position,
    Pyramid, Snapshot, Sphere, SpotCone,
};
use archetrace::image_file;
use archetrace::systems::{Frame, Workers, frame_schedule, prepare};
use archetrace::viewer::Viewer;
use bevy_ecs::prelude::*;
use glam::DVec3;

fn main() -> Result<(), Box<dyn Error>> {
    let mut world = World::new();
    spawn_camera(&mut world)?;
    spawn_table(&mut world);
    spawn_fruit(&mut world);
    spawn_lights(&mut world);

    match env::args_os().nth(1) {
        Some(picture) => save(world, Path::new(&picture)),
        None => Ok(Viewer::new("still_life", world).run()?),
    }
}

/// The World says what there is; the schedule makes a picture of it.
fn save(mut world: World, picture: &Path) -> Result<(), Box<dyn Error>> {
    prepare::<f64>(&mut world, Workers::new(None)?);
    frame_schedule::<f64>().run(&mut world);
    let (film, _) = world.resource::<Frame>().traced()?;
    Ok(image_file::save(film, picture)?)
}

fn spawn_camera(world: &mut World) -> Result<(), Box<dyn Error>> {
    let eye = DVec3::new(-30.0, -130.0, 70.0);
    let pose = CameraPose::looking(eye, DVec3::new(0.25, 1.0, -0.4), DVec3::Z).ok_or("no direction")?;
    let lens = Lens { near: 1.0, far: 1000.0, fovy: 56.0, aspect: 1.0 };
    world.spawn((pose, lens));
    world.insert_resource(Snapshot { pixels: 512, level: 4 });
    Ok(())
}

fn spawn_table(world: &mut World) {
    world.spawn((
        Checkerboard { cell: 16.0 },
        Color::new(0.9, 0.8, 0.65),
        Ambient(0.2),
        Diffuse(0.6),
        Mirror(0.2),
    ));
    world.spawn((
        Cube { side: 34.0 },
        Position::new(0.0, 0.0, 0.0),
        Color::new(0.35, 0.45, 0.5),
        Ambient(0.25),
        Diffuse(0.75),
    ));
}

fn spawn_fruit(world: &mut World) {
    // An orange on the plinth, a plum and a lime on the table.
    for (at, radius, color) in [
        ((17.0, 17.0, 47.0), 13.0, Color::new(1.0, 0.55, 0.1)),
        ((-18.0, -24.0, 9.0), 9.0, Color::new(0.5, 0.2, 0.55)),
        ((6.0, -36.0, 7.0), 7.0, Color::new(0.55, 0.8, 0.2)),
    ] {
        world.spawn((
            Sphere { radius },
            Position(DVec3::from(at)),
            color,
            Ambient(0.15),
            Diffuse(0.6),
            Gloss { specular: 0.25, shininess: 30.0 },
        ));
    }
    // A silver ball and a piece of cheese.
    world.spawn((
        Sphere { radius: 24.0 },
        Position::new(-38.0, 22.0, 24.0),
        Color::new(0.9, 0.95, 1.0),
        Ambient(0.05),
        Diffuse(0.1),
        Mirror(0.8),
    ));
    world.spawn((
        Pyramid { width: 30.0, height: 26.0 },
        Position::new(30.0, -36.0, 0.0),
        Color::new(1.0, 0.85, 0.4),
        Ambient(0.2),
        Diffuse(0.8),
    ));
}

fn spawn_lights(world: &mut World) {
    // A lamp shines everywhere and forever, until it carries a component that says otherwise.
    world.spawn((Light, Position::new(-90.0, -110.0, 120.0), Falloff(8e-6)));
    world.spawn((
        Light,
        Position::new(80.0, -60.0, 110.0),
        Falloff(1e-5),
        SpotCone { target: DVec3::new(10.0, -10.0, 10.0), cutoff: 22.0 },
    ));
}

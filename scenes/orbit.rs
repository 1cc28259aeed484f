//! Things that move, by a component and a system of one's own: `cargo run --release --example orbit [FOLDER]`.
//!
//! A window shows them moving. With a folder, frames go to `orbit-000.bmp` and on in there; they make one round:
//! shown again and again, the motion does not jump.

use std::env;
use std::error::Error;
use std::f64::consts::TAU;
use std::fs;
use std::path::Path;

use archetrace::components::{
    Ambient, CameraPose, Checkerboard, Color, Diffuse, FrameTime, Gloss, Lens, Light, Mirror, Position,
    Snapshot, Sphere,
};
use archetrace::image_file;
use archetrace::systems::{Frame, Stage, Workers, frame_schedule, prepare};
use archetrace::viewer::Viewer;
use bevy_ecs::prelude::*;
use glam::DVec3;

const FRAMES: u32 = 24;
/// Seconds for one round of the slower ball.
const ROUND: f64 = 8.0;

/// Moves its entity along a horizontal circle.
#[derive(Component)]
struct Orbit {
    /// Middle of the circle.
    center: DVec3,
    /// Radius of the circle in world units.
    radius: f64,
    /// Seconds for one round.
    period: f64,
}

/// Puts everything in orbit where it is now.
fn move_along_orbits(time: Res<FrameTime>, mut bodies: Query<(&Orbit, &mut Position)>) {
    for (orbit, mut position) in &mut bodies {
        let angle = TAU * time.seconds / orbit.period;
        position.0 = orbit.center + orbit.radius * DVec3::new(angle.cos(), angle.sin(), 0.0);
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut world = World::new();
    spawn_scene(&mut world)?;
    match env::args_os().nth(1) {
        Some(folder) => save_frames(world, Path::new(&folder)),
        None => Ok(Viewer::new("orbit", world).add_systems(move_along_orbits).run()?),
    }
}

fn save_frames(mut world: World, folder: &Path) -> Result<(), Box<dyn Error>> {
    fs::create_dir_all(folder)?;
    prepare::<f64>(&mut world, Workers::new(None)?);

    // The move comes first: the tables of a frame are taken from where things are then.
    let mut schedule = frame_schedule::<f64>();
    schedule.add_systems(move_along_orbits.before(Stage::Extract));
    let step = ROUND / f64::from(FRAMES);
    for frame in 0..FRAMES {
        world.insert_resource(FrameTime { seconds: step * f64::from(frame), step });
        schedule.run(&mut world);
        let (film, _) = world.resource::<Frame>().traced()?;
        image_file::save(film, &folder.join(format!("orbit-{frame:03}.bmp")))?;
    }
    Ok(())
}

fn spawn_scene(world: &mut World) -> Result<(), Box<dyn Error>> {
    let eye = DVec3::new(0.0, -170.0, 110.0);
    let pose = CameraPose::looking(eye, DVec3::new(0.0, 1.0, -0.5), DVec3::Z).ok_or("no direction")?;
    let lens = Lens { near: 1.0, far: 1000.0, fovy: 55.0, aspect: 1.0 };
    world.spawn((pose, lens));
    world.insert_resource(Snapshot { pixels: 320, level: 3 });
    world.spawn((Checkerboard { cell: 25.0 }, Ambient(0.2), Diffuse(0.5), Mirror(0.3)));
    world.spawn((Light, Position::new(-60.0, -140.0, 150.0)));

    // A mirror in the middle; two balls go round it, the inner one twice as fast and the other way.
    let center = DVec3::new(0.0, 0.0, 34.0);
    world.spawn((Sphere { radius: 28.0 }, Position(center), Ambient(0.05), Diffuse(0.15), Mirror(0.8)));
    for (radius, size, rounds, color) in
        [(48.0, 9.0, 2.0, Color::new(1.0, 0.5, 0.2)), (68.0, 12.0, -1.0, Color::new(0.2, 0.7, 0.9))]
    {
        let period = ROUND / rounds;
        world.spawn((
            Sphere { radius: size },
            Orbit { center, radius, period },
            color,
            Ambient(0.2),
            Diffuse(0.6),
            Gloss { specular: 0.2, shininess: 40.0 },
        ));
    }
    Ok(())
}

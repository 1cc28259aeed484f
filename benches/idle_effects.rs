//! One frame of a scene, for `benches/idle_effects.sh` to count instructions of.
//!
//! Usage: `idle_effects PIXELS SCENE` traces a scene file, or a picture of the gallery by its name, in one thread with one
//! sample a pixel and the instructions that every processor has, and prints the sum of all pixels; `idle_effects SCENE`
//! prints the effects that it asks for. With `assignment` or `everything` behind them it traces with a larger kernel than
//! the scene asks for.
#![allow(clippy::print_stdout, reason = "the script reads it")]

use std::error::Error;
use std::num::NonZeroUsize;

use archetrace::components::{Sampling, Snapshot};
use archetrace::effects::Effect;
use archetrace::scene::{Source, spawn};
use archetrace::systems::{Frame, Tables, Workers, extract_schedule, prepare, trace_schedule};
use archetrace::trace::{Kernel, Simd};
use bevy_ecs::prelude::*;

#[path = "../scenes/gallery/exhibits.rs"]
#[allow(dead_code, reason = "the gallery's own lists are not read here")]
mod exhibits;

use exhibits::Exhibit;

fn main() -> Result<(), Box<dyn Error>> {
    // Cargo adds arguments of its own.
    let words: Vec<String> = std::env::args().skip(1).filter(|word| word != "--bench").collect();
    match words.as_slice() {
        [scene] => {
            let world = extracted(scene, Kernel::Plain)?;
            let effects = world.resource::<Tables<f64>>().effects();
            println!("{}", effects.iter().map(Effect::name).collect::<Vec<_>>().join(" "));
        }
        [pixels, scene] => println!("{}", traced(pixels.parse()?, scene, Kernel::Plain)?),
        [pixels, scene, kernel] => println!("{}", traced(pixels.parse()?, scene, kernel_named(kernel)?)?),
        _ => println!("usage: idle_effects [PIXELS] SCENE [KERNEL] (see benches/idle_effects.sh)"),
    }
    Ok(())
}

fn kernel_named(name: &str) -> Result<Kernel, String> {
    match name {
        "assignment" => Ok(Kernel::Assignment),
        "everything" => Ok(Kernel::EVERYTHING),
        other => Err(format!("no kernel is called {other}")),
    }
}

fn extracted(scene: &str, least: Kernel) -> Result<World, Box<dyn Error>> {
    let mut world = match Exhibit::named(scene) {
        Some(exhibit) => exhibit.world(),
        None => world_of_file(scene)?,
    };
    world.insert_resource(Sampling { side: 1 });
    let workers = Workers::new(Some(NonZeroUsize::MIN))?;
    // The least is first.
    let level = Simd::available().into_iter().next().unwrap_or(Simd::detect());
    prepare::<f64>(&mut world, workers.with_simd(level).with_least_kernel(least));
    extract_schedule::<f64>().run(&mut world);
    Ok(world)
}

fn world_of_file(path: &str) -> Result<World, Box<dyn Error>> {
    let mut world = World::new();
    spawn(&mut world, &Source::read(path.as_ref())?.load()?.description);
    Ok(world)
}

fn traced(pixels: u32, scene: &str, least: Kernel) -> Result<f64, Box<dyn Error>> {
    let mut world = extracted(scene, least)?;
    world.resource_mut::<Snapshot>().pixels = pixels;
    extract_schedule::<f64>().run(&mut world);
    trace_schedule::<f64>().run(&mut world);
    let (film, _) = world.resource::<Frame>().traced()?;
    Ok(film.pixels().iter().flatten().sum())
}

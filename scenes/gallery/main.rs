//! Every effect alone, and one scene with them all: `cargo run --release --example gallery -- [NAME [PICTURE]]`.
//!
//! Without a picture to write it opens a window; without a name it lists the names. `effects NAME` says what the effects
//! of one cost, as `archetrace effects` does for a scene file.

mod exhibits;

use std::env;
use std::error::Error;
use std::ffi::OsStr;
use std::io::{Write as _, stdout};
use std::path::Path;

use archetrace::cli::effects_report;
use archetrace::image_file;
use archetrace::systems::{Frame, Workers, frame_schedule, prepare};
use archetrace::viewer::Viewer;
use bevy_ecs::prelude::*;

use exhibits::{EXHIBITS, Exhibit};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = env::args_os().skip(1);
    let Some(name) = arguments.next() else { return list() };
    if name == "effects" {
        return effects(named(&arguments.next().unwrap_or_default())?.world());
    }
    let exhibit = named(&name)?;
    match arguments.next() {
        Some(picture) => save(exhibit.world(), Path::new(&picture)),
        None => Ok(Viewer::new(exhibit.name, exhibit.world()).run()?),
    }
}

fn named(name: &OsStr) -> Result<&'static Exhibit, String> {
    let name = name.to_string_lossy();
    Exhibit::named(&name).ok_or_else(|| format!("there is no `{name}` in the gallery"))
}

fn list() -> Result<(), Box<dyn Error>> {
    let mut out = stdout().lock();
    for exhibit in EXHIBITS {
        let effects: Vec<_> = exhibit.effects.iter().map(|effect| effect.name()).collect();
        writeln!(out, "{:16}{}", exhibit.name, effects.join(", "))?;
    }
    Ok(())
}

fn save(mut world: World, picture: &Path) -> Result<(), Box<dyn Error>> {
    prepare::<f64>(&mut world, Workers::new(None)?);
    frame_schedule::<f64>().run(&mut world);
    let (film, _) = world.resource::<Frame>().traced()?;
    Ok(image_file::save(film, picture)?)
}

fn effects(mut world: World) -> Result<(), Box<dyn Error>> {
    prepare::<f64>(&mut world, Workers::new(None)?);
    let report = effects_report::<f64>(&mut world, 5)?;
    Ok(stdout().lock().write_all(report.as_bytes())?)
}

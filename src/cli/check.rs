//! `archetrace check`

use core::fmt::Write as _;
use core::num::NonZeroUsize;

use bevy_ecs::prelude::*;

use crate::components::{Lens, Light, Snapshot, SpotCone};
use crate::systems::{FrameError, Tables, Workers, extract_schedule, prepare};
use crate::trace::SceneTables;

use super::CliError;
use super::args::CheckArgs;
use super::load::load_world;

/// Validates a scene as far as rendering would, short of tracing, and prints what is in it.
pub(super) fn check(args: &CheckArgs) -> Result<(), CliError> {
    let mut world = World::new();
    let warnings = load_world(&args.scene, &mut world)?;
    prepare::<f64>(&mut world, Workers::new(Some(NonZeroUsize::MIN))?);
    extract_schedule::<f64>().run(&mut world);
    let problems = world.resource::<Tables<f64>>().problems();
    if !problems.is_empty() {
        return Err(FrameError::World(problems).into());
    }
    let verdict = match warnings {
        0 => "ok".to_owned(),
        1 => "ok, 1 warning".to_owned(),
        more => format!("ok, {more} warnings"),
    };
    super::print(&format!("{}: {verdict}\n{}", args.scene.display(), summary(&mut world)))
}

fn summary(world: &mut World) -> String {
    let mut text = String::new();
    // Writing to a string cannot fail.
    let _ = write_summary(&mut text, world);
    text
}

fn write_summary(text: &mut String, world: &mut World) -> core::fmt::Result {
    let Snapshot { pixels, level } = *world.resource::<Snapshot>();
    writeln!(text, "image    {pixels} x {pixels} pixels, level {level}")?;
    for lens in world.query::<&Lens>().iter(world) {
        let Lens { near, far, fovy, aspect } = lens;
        writeln!(text, "camera   near {near}, far {far}, fovy {fovy}, aspect {aspect}")?;
    }
    let spots = world.query_filtered::<(), (With<Light>, With<SpotCone>)>().iter(world).count();
    let tables = world.resource::<Tables<f64>>();
    let scene = &tables.scene;
    writeln!(text, "objects  {}", objects(scene))?;
    writeln!(text, "lights   {} normal, {spots} spot", scene.lights.len() - spots)?;
    writeln!(text, "effects  {}", effects(tables))
}

fn objects(scene: &SceneTables<f64>) -> String {
    let tables = scene.table_counts();
    let objects = tables.iter().filter(|count| count.table != "lights");
    let named = objects.map(|count| {
        let name = if count.rows == 1 { count.table.trim_end_matches('s') } else { count.table };
        format!("{} {name}", count.rows)
    });
    named.collect::<Vec<_>>().join(", ")
}

fn effects(tables: &Tables<f64>) -> String {
    let counts = tables.effect_counts();
    let used = counts.iter().filter(|count| count.rows > 0);
    let named: Vec<String> = used.map(|count| format!("{} ({})", count.effect.name(), count.rows)).collect();
    if named.is_empty() { "none".to_owned() } else { named.join(", ") }
}

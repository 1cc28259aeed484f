//! `archetrace effects`

use std::fmt::Write as _;
use std::time::Instant;

use bevy_ecs::prelude::*;
use indicatif::{ProgressBar, ProgressStyle};
use serde::Serialize;

use crate::components::{CameraPose, Checkerboard, Cube, Light, Position, Precision, Pyramid, Sphere};
use crate::geometry::Real;
use crate::study::{Ablation, EffectPrice, Removal, Setting, ablate, draw_bars};
use crate::systems::{FrameError, Workers, carriers_of, prepare};
use crate::whole_file::{check_writable, write_whole};

use super::args::EffectsArgs;
use super::instructions::Instructions;
use super::load::load_picture;
use super::{CliError, print};

/// Says what effects a scene asks for, and what each costs.
pub(super) fn effects(args: &EffectsArgs) -> Result<(), CliError> {
    if let Some(chart) = &args.chart {
        check_writable(chart)?;
    }
    let mut world = World::new();
    let setting = load_picture(&args.scene, &args.picture, &mut world)?;
    match setting.precision {
        Precision::F64 => report::<f64>(args, setting, world),
        Precision::F32 => report::<f32>(args, setting, world),
    }
}

/// What `archetrace effects` prints, for a World that was built in code and is [prepared](prepare) for this precision: who asks
/// for which effect, what each adds in rays, rows, bytes and milliseconds over so many rounds, and what is absent.
pub fn effects_report<T: Real>(world: &mut World, rounds: u32) -> Result<String, FrameError> {
    let start = Instant::now();
    let ablation = ablate::<T>(world, rounds, || start.elapsed().as_secs_f64() * 1e3, |_, _| ())?;
    let rows: Vec<Row> = ablation.effects.iter().map(|price| Row::new(price, world, None)).collect();
    Ok(table(&ablation, &rows).unwrap_or_default())
}

fn report<T: Real>(args: &EffectsArgs, setting: Setting, mut world: World) -> Result<(), CliError> {
    prepare::<T>(&mut world, Workers::new(args.picture.threads)?);
    let start = Instant::now();
    let clock = || start.elapsed().as_secs_f64() * 1e3;
    let progress = progress_bar();
    let ablation = ablate::<T>(&mut world, args.rounds, clock, |done, all| {
        progress.set_length(all.into());
        progress.set_position(done.into());
    })?;
    progress.finish_and_clear();
    let instructions =
        args.instructions.then(|| Instructions::measure(args, setting, &ablation)).transpose()?;
    let rows: Vec<Row> =
        ablation.effects.iter().map(|price| Row::new(price, &mut world, instructions.as_ref())).collect();
    if let Some(chart) = &args.chart {
        let title = format!("{}: what its effects cost", args.scene.display());
        write_whole(chart, draw_bars(&title, &ablation).ok_or(CliError::Chart)?.as_bytes())?;
    }
    if args.json {
        let mut text = serde_json::to_string_pretty(&rows)?;
        text.push('\n');
        return print(&text);
    }
    print(&table(&ablation, &rows).unwrap_or_default())
}

fn progress_bar() -> ProgressBar {
    let bar = ProgressBar::new(0);
    if let Ok(style) = ProgressStyle::with_template("frames {pos}/{len} {wide_bar} {eta}") {
        bar.set_style(style);
    }
    bar
}

/// One effect of the report.
#[derive(Serialize)]
struct Row {
    effect: &'static str,
    present: bool,
    entities: usize,
    rays: i64,
    rows: usize,
    bytes: usize,
    systems: u64,
    milliseconds: Option<f64>,
    milliseconds_iqr: Option<f64>,
    instructions: Option<i64>,
    without: Option<Change>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    carriers: Vec<String>,
}

/// What taking an effect away does to the picture.
#[derive(Serialize)]
struct Change {
    rmse: f64,
    worst_level: u8,
    over1: f64,
    over8: f64,
}

impl Row {
    fn new(price: &EffectPrice, world: &mut World, instructions: Option<&Instructions>) -> Self {
        let effect = price.count.effect;
        let added = price.without.map(|without| without.milliseconds);
        Self {
            effect: effect.name(),
            present: price.is_present(),
            entities: price.entities,
            rays: price.rays(),
            rows: price.count.rows,
            bytes: price.count.bytes,
            systems: price.systems,
            milliseconds: added.map(|added| added.median),
            milliseconds_iqr: added.map(|added| added.iqr),
            instructions: instructions.and_then(|instructions| instructions.of(effect)),
            without: price.without.map(|Removal { picture, .. }| Change {
                rmse: picture.rmse,
                worst_level: picture.worst_level,
                over1: picture.over1,
                over8: picture.over8,
            }),
            carriers: carriers_of(world, effect).iter().map(|entity| describe(world, *entity)).collect(),
        }
    }
}

/// What an entity is, and where.
fn describe(world: &World, entity: Entity) -> String {
    let Ok(entity) = world.get_entity(entity) else { return String::new() };
    let kinds = [
        (entity.contains::<Sphere>(), "sphere"),
        (entity.contains::<Cube>(), "cube"),
        (entity.contains::<Pyramid>(), "pyramid"),
        (entity.contains::<Checkerboard>(), "checkerboard"),
        (entity.contains::<Light>(), "light"),
        (entity.contains::<CameraPose>(), "camera"),
    ];
    let kind = kinds.iter().find(|kind| kind.0).map_or("entity", |kind| kind.1);
    match entity.get::<Position>() {
        Some(Position(at)) => format!("{kind} at {} {} {}", at.x, at.y, at.z),
        None => kind.to_owned(),
    }
}

/// The report in words: what is present with its price, then what is absent with the counts that prove it.
fn table(ablation: &Ablation, rows: &[Row]) -> Result<String, std::fmt::Error> {
    let mut text = String::new();
    let frame = ablation.frame;
    writeln!(
        text,
        "frame {:.2} ms (least {:.2}, quartiles {:.2} apart), {} rays",
        frame.median, frame.min, frame.iqr, ablation.rays
    )?;
    for row in rows.iter().filter(|row| row.present) {
        writeln!(text, "\n{}", row.effect.replace('_', " "))?;
        writeln!(text, "  asked for by  {}", list(&row.carriers, row.entities))?;
        writeln!(text, "  in the tables {} rows, {} bytes", row.rows, row.bytes)?;
        writeln!(text, "  adds          {:+} rays", row.rays)?;
        if let (Some(added), Some(iqr)) = (row.milliseconds, row.milliseconds_iqr) {
            writeln!(text, "                {added:+.2} ms (quartiles {iqr:.2} apart)")?;
        }
        if let Some(instructions) = row.instructions {
            writeln!(text, "                {instructions:+} instructions a pixel")?;
        }
        if let Some(change) = &row.without {
            writeln!(
                text,
                "  without it    {:.1} % of the pixels differ by more than 1 level, the worst by {}; RMSE {:.2e}",
                100.0 * change.over1,
                change.worst_level,
                change.rmse
            )?;
        }
    }
    let absent: Vec<&Row> = rows.iter().filter(|row| !row.present).collect();
    if !absent.is_empty() {
        writeln!(text, "\nabsent            entities  rows  bytes  rays  systems run")?;
    }
    for row in absent {
        let name = row.effect.replace('_', " ");
        let counts = format!("{:>8}{:>6}{:>7}{:>6}", row.entities, row.rows, row.bytes, row.rays);
        writeln!(text, "  {name:<16}{counts}{:>13}", row.systems)?;
    }
    Ok(text)
}

fn list(carriers: &[String], entities: usize) -> String {
    const SHOWN: usize = 4;
    let mut text = carriers.iter().take(SHOWN).cloned().collect::<Vec<_>>().join(", ");
    if entities > SHOWN {
        text.push_str(&format!(" and {} more", entities - SHOWN));
    }
    text
}

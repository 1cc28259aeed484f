//! Accuracy: one choice of every knob.

use bevy_ecs::prelude::*;
use serde::Serialize;

use crate::components::{
    Adaptive, AreaLight, CheckerFilter, Checkerboard, Cutoff, Precision, Sampling, Snapshot, TextureFilter,
    Textured,
};

/// How closely a picture is traced: every knob that trades truth for time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    /// Sample points along each side of a pixel; with a threshold the most there are.
    pub side: u32,
    /// Expected error of a pixel, 0 to 1, at which it gets no more samples; nothing where all get the same.
    pub threshold: Option<f64>,
    /// Rays that may follow each other.
    pub level: u32,
    /// Share of the light in a pixel, 0 to 1, up to which no ray is followed.
    pub cutoff: f64,
    /// Of tables and kernels.
    pub precision: Precision,
    /// Whether plain checkerboards show the mean of what a pixel covers. It is another model, and a closer one.
    pub checker_filter: bool,
    /// How images are read; nothing for the scene's own way.
    pub texture_filter: Option<TextureFilter>,
    /// Shadow rays towards each area light; nothing for the light's own number.
    pub light_samples: Option<u32>,
    /// Pixels along each side that are traced.
    pub pixels: u32,
}

/// A [`Setting`] as reports have it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Knobs {
    /// Sample points along each side of a pixel.
    pub side: u32,
    /// Threshold of adaptive sampling.
    pub threshold: Option<f64>,
    /// Level of recursion.
    pub level: u32,
    /// Contribution cutoff.
    pub cutoff: f64,
    /// `f32` or `f64`.
    pub precision: &'static str,
    /// `none`, `checker`, `bilinear`, `mip`, or the first with one of the others: `checker+mip`.
    pub filter: String,
    /// Shadow rays towards each area light, where they are not the light's own number.
    pub light_samples: Option<u32>,
    /// Pixels along each side that are traced.
    pub pixels: u32,
}

impl Setting {
    /// The one that a World has now, traced in some precision.
    pub fn of(world: &mut World, precision: Precision) -> Self {
        let boards =
            world.query_filtered::<(), (With<Checkerboard>, With<CheckerFilter>)>().iter(world).count();
        let snapshot = world.get_resource::<Snapshot>().copied().unwrap_or_default();
        Self {
            side: world.get_resource::<Sampling>().copied().unwrap_or_default().side,
            threshold: world.get_resource::<Adaptive>().map(|adaptive| adaptive.threshold),
            level: snapshot.level,
            cutoff: world.get_resource::<Cutoff>().map_or(0.0, |cutoff| cutoff.0),
            precision,
            checker_filter: boards > 0,
            texture_filter: None,
            light_samples: None,
            pixels: snapshot.pixels,
        }
    }

    /// Gives a World this setting. What it says nothing of stays as it is; the precision is for who traces it.
    pub fn apply(&self, world: &mut World) {
        world.insert_resource(Sampling { side: self.side });
        world.insert_resource(Snapshot { pixels: self.pixels, level: self.level });
        match self.threshold {
            Some(threshold) => world.insert_resource(Adaptive { threshold }),
            None => drop(world.remove_resource::<Adaptive>()),
        }
        match self.cutoff > 0.0 {
            true => world.insert_resource(Cutoff(self.cutoff)),
            false => drop(world.remove_resource::<Cutoff>()),
        }
        filter_boards(world, self.checker_filter);
        if let Some(filter) = self.texture_filter {
            filter_images(world, filter);
        }
        if let Some(samples) = self.light_samples {
            for mut light in world.query::<&mut AreaLight>().iter_mut(world) {
                light.set_if_neq(AreaLight { samples, ..*light });
            }
        }
    }

    /// The flags of `render` that give this setting to any scene.
    pub fn flags(&self) -> String {
        let mut flags = vec![format!("--samples {}", self.side * self.side)];
        flags.extend(self.threshold.map(|threshold| format!("--adaptive {threshold}")));
        flags.push(format!("--level {}", self.level));
        flags.extend((self.cutoff > 0.0).then(|| format!("--cutoff {}", self.cutoff)));
        let knobs = self.knobs();
        flags.push(format!("--precision {}", knobs.precision));
        flags.extend(self.checker_filter.then(|| "--checker-filter".to_owned()));
        flags.extend(self.texture_filter.map(|filter| format!("--texture-filter {}", name_of(filter))));
        flags.extend(self.light_samples.map(|samples| format!("--light-samples {samples}")));
        flags.push(format!("--size {}", self.pixels));
        flags.join(" ")
    }

    /// The same for a report.
    pub fn knobs(&self) -> Knobs {
        let texture = self.texture_filter.filter(|&filter| filter != TextureFilter::Nearest).map(name_of);
        let filters: Vec<&str> =
            self.checker_filter.then_some("checker").into_iter().chain(texture).collect();
        Knobs {
            side: self.side,
            threshold: self.threshold,
            level: self.level,
            cutoff: self.cutoff,
            precision: match self.precision {
                Precision::F64 => "f64",
                Precision::F32 => "f32",
            },
            filter: if filters.is_empty() { "none".to_owned() } else { filters.join("+") },
            light_samples: self.light_samples,
            pixels: self.pixels,
        }
    }
}

/// The name of a filter on the command line.
fn name_of(filter: TextureFilter) -> &'static str {
    match filter {
        TextureFilter::Nearest => "nearest",
        TextureFilter::Bilinear => "bilinear",
        TextureFilter::Mip => "mip",
    }
}

fn filter_boards(world: &mut World, on: bool) {
    let boards: Vec<Entity> =
        world.query_filtered::<Entity, (With<Checkerboard>, Without<Textured>)>().iter(world).collect();
    for board in boards {
        let mut board = world.entity_mut(board);
        match (on, board.contains::<CheckerFilter>()) {
            (true, false) => drop(board.insert(CheckerFilter)),
            (false, true) => drop(board.remove::<CheckerFilter>()),
            _ => {}
        }
    }
}

fn filter_images(world: &mut World, filter: TextureFilter) {
    let boards: Vec<Entity> = world.query_filtered::<Entity, With<Textured>>().iter(world).collect();
    for board in boards {
        if world.get::<TextureFilter>(board) != Some(&filter) {
            world.entity_mut(board).insert(filter);
        }
    }
}

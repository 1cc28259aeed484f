//! The same scene with each of its effects taken away.

use bevy_ecs::prelude::*;

use crate::effects::{Effect, EffectSet};
use crate::film::Film;
use crate::geometry::Real;
use crate::systems::{Frame, FrameError, Muted, Survey, Tables, extract_schedule, trace_schedule};
use crate::trace::{Counts, EffectCount};

use super::{Difference, Spread};

/// What the effects of a scene cost.
#[derive(Clone, Debug)]
pub struct Ablation {
    /// Milliseconds of the frame with everything that the scene asks for.
    pub frame: Spread,
    /// Rays of that frame.
    pub rays: u64,
    /// Every effect there is, in the order of [`Effect::ALL`].
    pub effects: Vec<EffectPrice>,
}

/// What one effect costs.
#[derive(Clone, Copy, Debug)]
pub struct EffectPrice {
    /// Its rows and bytes in the tables.
    pub count: EffectCount,
    /// Entities that carry it, whatever its value.
    pub entities: usize,
    /// Runs of systems that made rows of it, for the first frame.
    pub systems: u64,
    /// What is different without it; nothing where no row asks for it, and then nothing was tried.
    pub without: Option<Removal>,
}

/// A frame without one effect, compared with the frame that has it.
#[derive(Clone, Copy, Debug)]
pub struct Removal {
    /// Rays that the effect adds; below 0 where it saves some, as a spotlight's cone does.
    pub rays: i64,
    /// Milliseconds that it adds, round by round.
    pub milliseconds: Spread,
    /// What it changes in the picture.
    pub picture: Difference,
}

impl EffectPrice {
    /// Whether the trace simulates it.
    pub fn is_present(&self) -> bool {
        self.count.rows > 0
    }

    /// Rays that it adds to the frame.
    pub fn rays(&self) -> i64 {
        self.without.map_or(0, |without| without.rays)
    }
}

/// Traces a World, [prepared](crate::systems::prepare) for this precision, with all its effects and without each of them,
/// in turns, `rounds` times (at least once). `clock` tells milliseconds; `done` is told after each frame how many of how many
/// there have been.
pub fn ablate<T: Real>(
    world: &mut World,
    rounds: u32,
    mut clock: impl FnMut() -> f64,
    mut done: impl FnMut(u32, u32),
) -> Result<Ablation, FrameError> {
    let mut bench = Bench::<T>::new();
    bench.set(world, EffectSet::NONE);
    let tables = world.resource::<Tables<T>>();
    let counts = tables.effect_counts();
    let systems: EffectRuns = Effect::ALL.map(|effect| (effect, tables.systems_run(effect)));
    let present: Vec<Effect> = counts.iter().filter(|c| c.rows > 0).map(|c| c.effect).collect();
    let muted: Vec<EffectSet> = core::iter::once(EffectSet::NONE)
        .chain(present.iter().map(|&effect| EffectSet::of(&[effect])))
        .collect();

    let mut series: Vec<Series> = Vec::new();
    let rounds = rounds.max(1);
    let total = rounds.saturating_mul(u32::try_from(muted.len()).unwrap_or(u32::MAX));
    let mut traced = 0;
    for round in 0..rounds {
        for (number, &muted) in muted.iter().enumerate() {
            bench.set(world, muted);
            let milliseconds = bench.trace(world, &mut clock);
            let (film, counts) = world.resource::<Frame>().traced()?;
            if round == 0 {
                series.push(Series { film: film.clone(), counts: *counts, milliseconds: Vec::new() });
            }
            series[number].milliseconds.push(milliseconds);
            traced += 1;
            done(traced, total);
        }
    }
    bench.set(world, EffectSet::NONE);

    let survey = world.resource::<Survey>();
    let (whole, others) = series.split_first().ok_or(FrameError::Cancelled)?;
    let without = |effect| {
        let number = present.iter().position(|&other| other == effect)?;
        whole.compared_with(&others[number])
    };
    let effects = counts.into_iter().map(|count| EffectPrice {
        count,
        entities: survey.entities(count.effect),
        systems: systems.iter().filter(|run| run.0 == count.effect).map(|run| run.1).sum(),
        without: without(count.effect),
    });
    Ok(Ablation {
        frame: Spread::of(&whole.milliseconds),
        rays: whole.counts.rays.total(),
        effects: effects.collect(),
    })
}

/// Runs of systems for every effect.
type EffectRuns = [(Effect, u64); Effect::ALL.len()];

/// The frame with some setting, again and again.
struct Series {
    film: Film,
    counts: Counts,
    milliseconds: Vec<f64>,
}

impl Series {
    fn compared_with(&self, without: &Self) -> Option<Removal> {
        let added: Vec<f64> = self
            .milliseconds
            .iter()
            .zip(&without.milliseconds)
            .map(|(with, without)| with - without)
            .collect();
        Some(Removal {
            // Far fewer than 2^63.
            rays: self.counts.rays.total().wrapping_sub(without.counts.rays.total()).cast_signed(),
            milliseconds: Spread::of(&added),
            picture: Difference::between(&self.film, &without.film)?,
        })
    }
}

/// The schedules, kept so that nothing is extracted twice.
struct Bench<T> {
    extract: Schedule,
    trace: Schedule,
    precision: core::marker::PhantomData<T>,
}

impl<T: Real> Bench<T> {
    fn new() -> Self {
        Self {
            extract: extract_schedule::<T>(),
            trace: trace_schedule::<T>(),
            precision: core::marker::PhantomData,
        }
    }

    fn set(&mut self, world: &mut World, muted: EffectSet) {
        world.insert_resource(Muted(muted));
        self.extract.run(world);
    }

    fn trace(&mut self, world: &mut World, clock: &mut impl FnMut() -> f64) -> f64 {
        let start = clock();
        self.trace.run(world);
        clock() - start
    }
}

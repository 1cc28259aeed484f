//! What tracing ray by ray is made of.

use crate::effects::{Effect, EffectSet, Rgb, survey};
use crate::geometry::{Real, Vector};

use super::air::look_beyond;
use super::filtered_color::{PixelSpot, filtered_color};
use super::pixels::PixelQueue;
use super::radiance::{Depth, Radiance, Walked, follow_all};
use super::shade::{Arrival, LightSums, Lighting, gather, shine};
use super::tile::{PacketTask, trace_each};
use super::{Air, CameraRay, Counts, ObjectId, SampleId, SceneTables};

/// Code of a stage, compiled for every set of the effects that the survey says it has code for; of that, what has those that
/// are asked for.
macro_rules! compiled_for {
    ($stage:ident $code:ident $asked:ident
        { $($effect:ident $name:ident: $component:ident [$($in:ident)*] $what:literal;)* }) => {
        choose!($stage $code $asked (EffectSet::NONE) $($effect [$($in)*])*)
    };
}

/// Goes from effect to effect: where the stage is among those of an effect, there is code with it and without it.
macro_rules! choose {
    (expose $code:ident $asked:ident $set:tt $effect:ident [expose $($in:ident)*] $($others:tt)*) => {
        choose!(@ expose $code $asked $set $effect $($others)*)
    };
    (follow $code:ident $asked:ident $set:tt $effect:ident [follow $($in:ident)*] $($others:tt)*) => {
        choose!(@ follow $code $asked $set $effect $($others)*)
    };
    (look_beyond $code:ident $asked:ident $set:tt $effect:ident [look_beyond $($in:ident)*] $($others:tt)*) => {
        choose!(@ look_beyond $code $asked $set $effect $($others)*)
    };
    (paint $code:ident $asked:ident $set:tt $effect:ident [paint $($in:ident)*] $($others:tt)*) => {
        choose!(@ paint $code $asked $set $effect $($others)*)
    };
    (gather $code:ident $asked:ident $set:tt $effect:ident [gather $($in:ident)*] $($others:tt)*) => {
        choose!(@ gather $code $asked $set $effect $($others)*)
    };
    (shine $code:ident $asked:ident $set:tt $effect:ident [shine $($in:ident)*] $($others:tt)*) => {
        choose!(@ shine $code $asked $set $effect $($others)*)
    };
    (@ $stage:ident $code:ident $asked:ident ($set:expr) $effect:ident $($others:tt)*) => {
        if $asked.contains(Effect::$effect) {
            choose!($stage $code $asked ($set.with(Effect::$effect)) $($others)*)
        } else {
            choose!($stage $code $asked ($set) $($others)*)
        }
    };
    // It is the next of the effect's stages, or none of them.
    ($stage:ident $code:ident $asked:ident $set:tt $effect:ident [$other:ident $($in:ident)*] $($others:tt)*) => {
        choose!($stage $code $asked $set $effect [$($in)*] $($others)*)
    };
    ($stage:ident $code:ident $asked:ident $set:tt $effect:ident [] $($others:tt)*) => {
        choose!($stage $code $asked $set $($others)*)
    };
    ($stage:ident $code:ident $asked:ident ($set:expr)) => {
        $code::<T, { compiled($set).bits() }>
    };
}

/// What code for a set is compiled for: what the program has, and what can be without others in the set.
const fn compiled(effects: EffectSet) -> EffectSet {
    let has_glass = effects.contains(Effect::Glass);
    let possible = if has_glass { effects } else { effects.without(Effect::Absorption) };
    possible.intersection(EffectSet::COMPILED)
}

type Expose<T> = fn(&PacketTask<'_, T>, &mut dyn PixelQueue) -> Counts;
type Follow<T> = fn(Walked<'_, T>, CameraRay<T>, Depth<T>, SampleId, &mut Counts) -> Radiance<T>;
type LookBeyond<T> = fn(&Air<T>, Vector<T>, Rgb<T>, &mut Rgb<T>);
type Paint<T> = fn(&SceneTables<T>, ObjectId, Rgb<T>, PixelSpot<T>) -> Rgb<T>;
type Gather<T> = fn(&Lighting<'_, T>, &mut LightSums<T>, &mut Counts);
type Shine<T> = fn(&Lighting<'_, T>, Arrival<T>, &mut LightSums<T>, &mut Counts);

/// The stages that a frame is traced by ray by ray, chosen once: each has the code of just those of the effects that are
/// asked for, and calls the others where they are. So what nobody asks for is in no code that runs, and the code of each
/// stage is the same whatever the others know, down to the registers: an effect can be left out of the program, and no
/// frame without it runs another instruction. What has nothing to do with effects is there once.
#[derive(Clone, Copy)]
pub(super) struct Stages<T: Real> {
    /// Pixels, sample by sample.
    pub(super) expose: Expose<T>,
    /// The rays of one sample.
    pub(super) follow: Follow<T>,
    /// Light from where there is no surface, added to what was found by a ray with a share in the pixel.
    pub(super) look_beyond: LookBeyond<T>,
    /// Own colours of boards.
    pub(super) paint: Paint<T>,
    /// All lights at a surface point.
    pub(super) gather: Gather<T>,
    /// What one of them does there.
    pub(super) shine: Shine<T>,
}

impl<T: Real> Stages<T> {
    /// The stages for these effects.
    pub(super) fn of(effects: EffectSet) -> Self {
        Self {
            expose: survey!(all, compiled_for expose trace_each effects),
            follow: survey!(all, compiled_for follow follow_all effects),
            look_beyond: survey!(all, compiled_for look_beyond look_beyond effects),
            paint: survey!(all, compiled_for paint filtered_color effects),
            gather: survey!(all, compiled_for gather gather effects),
            shine: survey!(all, compiled_for shine shine effects),
        }
    }
}

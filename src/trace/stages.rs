//! What tracing ray by ray is made of.

use crate::effects::{Effect, EffectSet, Rgb};
use crate::geometry::{Real, Vector};

use super::air::look_beyond;
use super::filtered_color::{PixelSpot, filtered_color};
use super::pixels::PixelQueue;
use super::radiance::{Depth, Radiance, Walked, follow_all};
use super::shade::{Arrival, LightSums, Lighting, gather, shine};
use super::tile::{PacketTask, trace_each};
use super::{Air, CameraRay, Counts, ObjectId, SampleId, SceneTables};

/// Code of a stage, compiled for every set of the effects in the list; of that, what has those that are asked for.
macro_rules! compiled_for {
    ($code:ident, $asked:expr, [$($effect:ident)*]) => {
        compiled_for!(@ $code, $asked, [$($effect)*], EffectSet::NONE)
    };
    (@ $code:ident, $asked:expr, [$effect:ident $($others:ident)*], $chosen:expr) => {
        if $asked.contains(Effect::$effect) {
            compiled_for!(@ $code, $asked, [$($others)*], $chosen.with(Effect::$effect))
        } else {
            compiled_for!(@ $code, $asked, [$($others)*], $chosen)
        }
    };
    (@ $code:ident, $asked:expr, [], $chosen:expr) => {
        $code::<T, { compiled($chosen).bits() }>
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
            expose: compiled_for!(trace_each, effects, [Aperture Exposure]),
            follow: compiled_for!(follow_all, effects, [Gloss Mirror Fog Glass Absorption]),
            look_beyond: compiled_for!(look_beyond, effects, [Background Fog]),
            paint: compiled_for!(filtered_color, effects, [Texture TextureFilter CheckerFilter]),
            gather: compiled_for!(gather, effects, [Falloff SpotCone Directional AreaLight]),
            shine: compiled_for!(shine, effects, [Gloss LightColor]),
        }
    }
}

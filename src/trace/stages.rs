//! What tracing ray by ray is made of.

use crate::effects::{EffectSet, Rgb};
use crate::geometry::{Real, Vector};

use super::air::look_beyond;
use super::filtered_color::{PixelSpot, filtered_color};
use super::pixels::PixelQueue;
use super::radiance::{Depth, Radiance, Walked, follow_all};
use super::shade::{Lighting, shade};
use super::tile::{PacketTask, trace_each};
use super::{Air, CameraRay, Counts, ObjectId, SampleId, SceneTables, Trail};

/// Code of a stage, compiled for every set of the effects in the list; given is what it is chosen by. What makes no sense
/// without another effect stands behind that one's name.
macro_rules! compiled_for {
    ($code:ident, $asked:expr, [$($effect:ident)*]) => {
        compiled_for!(@ $code, $asked, [$($effect)*], EffectSet::NONE)
    };
    (@ $code:ident, $asked:expr, [$effect:ident $($others:ident)*], $chosen:expr) => {
        if $asked.contains(crate::effects::Effect::$effect) {
            compiled_for!(@ $code, $asked, [$($others)*], $chosen.with(crate::effects::Effect::$effect))
        } else {
            compiled_for!(@ $code, $asked, [$($others)*], $chosen)
        }
    };
    (@ $code:ident, $asked:expr, [], $chosen:expr) => {
        $code::<T, { $chosen.intersection(EffectSet::COMPILED).bits() }>
    };
}

type Expose<T> = fn(&PacketTask<'_, T>, &mut dyn PixelQueue) -> Counts;
type Follow<T> = fn(Walked<'_, T>, CameraRay<T>, Depth<T>, SampleId, &mut Counts) -> Radiance<T>;
type LookBeyond<T> = fn(&Air<T>, Vector<T>, Rgb<T>, &mut Rgb<T>);
type Paint<T> = fn(&SceneTables<T>, ObjectId, Rgb<T>, PixelSpot<T>) -> Rgb<T>;
type Shade<T> = fn(&Lighting<'_, T>, Rgb<T>, &mut Trail, &mut Counts) -> Rgb<T>;

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
    /// Light that a surface point sends back.
    pub(super) shade: Shade<T>,
}

impl<T: Real> Stages<T> {
    /// The stages for these effects.
    pub(super) fn of(effects: EffectSet) -> Self {
        Self {
            expose: compiled_for!(trace_each, effects, [Aperture Exposure]),
            follow: compiled_for!(follow_all, effects, [Gloss Mirror Fog Glass Absorption]),
            look_beyond: compiled_for!(look_beyond, effects, [Background Fog]),
            paint: compiled_for!(filtered_color, effects, [Texture TextureFilter CheckerFilter]),
            shade: compiled_for!(
                shade,
                effects,
                [Gloss Falloff SpotCone LightColor Directional AreaLight]
            ),
        }
    }
}

//! The gallery: each picture has the effects that it names and no other.

use archetrace::components::{Sampling, Snapshot};
use archetrace::effects::{Effect, EffectSet};
use archetrace::film::Film;
use archetrace::geometry::Real;
use archetrace::systems::{Frame, Monitor, Muted, Tables, extract_schedule, prepare, trace_picture};
use archetrace::trace::{Exposure, Kernel};
use bevy_ecs::prelude::*;

use crate::support::picture::Picture;
use crate::support::tracing::{trace, workers};

#[path = "../../scenes/gallery/exhibits.rs"]
pub(crate) mod exhibits;

use exhibits::{EXHIBITS, Exhibit};

/// An exhibit, for a small picture.
pub(crate) fn small(exhibit: &Exhibit) -> World {
    let mut world: World = exhibit.world();
    world.resource_mut::<Snapshot>().pixels = 40;
    world.insert_resource(Sampling { side: 1 });
    world
}

/// A small picture of an exhibit, and the effects that its tables and camera have.
fn shown<T: Real>(exhibit: &Exhibit) -> (Picture, EffectSet) {
    let mut world = small(exhibit);
    let picture = trace::<T>(&mut world).picture;
    (picture, world.resource::<Tables<T>>().effects())
}

#[test]
fn each_picture_has_the_effects_that_it_names() {
    for exhibit in EXHIBITS {
        let (picture, effects) = shown::<f64>(exhibit);
        assert_eq!(effects, EffectSet::of(exhibit.effects), "{}", exhibit.name);
        assert_eq!(shown::<f32>(exhibit).1, effects, "{}", exhibit.name);
        assert!(picture.variety() > 50, "{} shows next to nothing", exhibit.name);
    }
}

#[test]
fn every_effect_is_shown_by_itself_and_with_all_others() {
    for effect in Effect::ALL {
        let exhibit = Exhibit::named(effect.name()).unwrap();
        assert!(exhibit.effects.contains(&effect));
    }
    assert_eq!(EffectSet::of(Exhibit::named("all").unwrap().effects), EffectSet::ALL);
    assert!(Exhibit::named("nothing").is_none());
}

#[test]
fn every_effect_shows() {
    let plain = shown::<f64>(Exhibit::named("plain").unwrap()).0;
    for exhibit in EXHIBITS.iter().filter(|exhibit| exhibit.effects != [Effect::Srgb]) {
        let is_plain = exhibit.effects.is_empty();
        assert_eq!(shown::<f64>(exhibit).0 == plain, is_plain, "{}", exhibit.name);
    }
}

/// The picture by some kernel, whether it has what the exhibit asks for or not.
fn by_kernel(exhibit: &Exhibit, kernel: Kernel) -> Film {
    let mut world = small(exhibit);
    prepare::<f64>(&mut world, workers(2));
    extract_schedule::<f64>().run(&mut world);
    let tables = world.resource::<Tables<f64>>();
    let camera = tables.camera.as_ref().unwrap();
    let level = world.resource::<Snapshot>().level;
    let exposure = Exposure { kernel, ..Exposure::new(&tables.scene, camera, level) };
    let mut film = Film::new(camera.pixels()).unwrap();
    trace_picture(&exposure, &mut film, &workers(2), &Monitor::default());
    film
}

#[test]
fn every_kernel_that_has_enough_traces_the_same_bits() {
    for exhibit in EXHIBITS {
        let effects = EffectSet::of(exhibit.effects);
        let picture = by_kernel(exhibit, Kernel::smallest_for(effects));
        for kernel in Kernel::all_for(effects).chain(with_one_more(effects)) {
            assert!(by_kernel(exhibit, kernel) == picture, "{}, {kernel:?}", exhibit.name);
        }
    }
}

fn with_one_more(effects: EffectSet) -> impl Iterator<Item = Kernel> {
    Effect::ALL.into_iter().map(move |effect| Kernel::Stages(effects.with(effect)))
}

#[test]
fn a_kernel_for_a_set_that_lacks_an_effect_traces_another_picture() {
    // Objects are moved before a kernel, and light becomes bytes after it.
    let of_kernels = EffectSet::ALL.without(Effect::MotionBlur).without(Effect::Srgb);
    for effect in of_kernels.iter() {
        let exhibit = Exhibit::named(effect.name()).unwrap();
        let effects = EffectSet::of(exhibit.effects);
        let [whole, lacking] = [effects, effects.without(effect)].map(Kernel::Stages);
        assert!(by_kernel(exhibit, lacking) != by_kernel(exhibit, whole), "{}", exhibit.name);
    }
}

/// The bytes of the picture with an effect switched off, and whether anything of the effect is left.
fn without(exhibit: &Exhibit, muted: EffectSet) -> Vec<u8> {
    let mut world = small(exhibit);
    world.insert_resource(Muted(muted));
    trace::<f64>(&mut world);
    for count in world.resource::<Tables<f64>>().effect_counts() {
        let is_left = !muted.contains(count.effect) && exhibit.effects.contains(&count.effect);
        let nothing = (count.rows, count.bytes) == (0, 0);
        // What works on another effect alone goes with it.
        assert!(nothing || is_left, "{}: {count:?}", exhibit.name);
    }
    world.resource::<Frame>().traced().unwrap().0.to_rgb8()
}

#[test]
fn an_effect_that_the_survey_misses_is_missed_in_the_picture() {
    for effect in Effect::ALL {
        let exhibit = Exhibit::named(effect.name()).unwrap();
        let whole = without(exhibit, EffectSet::NONE);
        assert!(without(exhibit, EffectSet::of(&[effect])) != whole, "{}", exhibit.name);
    }
}

//! The gallery: each picture has the effects that it names and no other.

use archetrace::components::{Sampling, Snapshot};
use archetrace::effects::{Effect, EffectSet};
use archetrace::geometry::Real;
use archetrace::systems::Tables;
use bevy_ecs::prelude::*;

use crate::support::picture::Picture;
use crate::support::tracing::trace;

#[path = "../../scenes/gallery/exhibits.rs"]
mod exhibits;

use exhibits::{EXHIBITS, Exhibit};

/// A small picture of an exhibit, and the effects that its tables and camera have.
fn shown<T: Real>(exhibit: &Exhibit) -> (Picture, EffectSet) {
    let mut world: World = exhibit.world();
    world.resource_mut::<Snapshot>().pixels = 40;
    world.insert_resource(Sampling { side: 1 });
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

//! Effects set to do nothing: the picture is that without them, bit for bit.

use archetrace::components::{
    Absorption, AreaLight, Background, CameraPose, Color, Falloff, Fog, Glass, Gloss, Light, LightColor,
    Mirror, Snapshot, SpotCone,
};
use archetrace::effects::Effect;
use archetrace::geometry::Real;
use archetrace::systems::Tables;
use bevy_ecs::prelude::*;
use glam::DVec3;

use crate::support::parts::scene_entities;
use crate::support::picture::assert_same;
use crate::support::scenes::full_case;
use crate::support::tracing::trace;

/// The full scene, with something done to every entity of it.
fn scene(change: impl Fn(&mut EntityWorldMut<'_>)) -> World {
    let mut world = full_case().world();
    for entity in scene_entities(&mut world) {
        change(&mut world.entity_mut(entity));
    }
    world
}

fn remove<C: Component>(entity: &mut EntityWorldMut<'_>) {
    entity.remove::<C>();
}

fn insert_no_mirror(entity: &mut EntityWorldMut<'_>) {
    entity.insert(Mirror(0.0));
}

fn assert_neutral<T: Real>(
    name: &str,
    without: impl Fn(&mut EntityWorldMut<'_>),
    neutral: impl Fn(&mut EntityWorldMut<'_>),
) {
    let (without, neutral) = (trace::<T>(&mut scene(without)), trace::<T>(&mut scene(neutral)));
    let name = format!("{} {name}", T::NAME);
    assert_same(&name, &without.picture, &neutral.picture);
    assert_eq!(without.counts, neutral.counts, "{name}");
    assert_ne!(
        without.picture,
        trace::<T>(&mut full_case().world()).picture,
        "{name}: the scene has none to take away"
    );
}

fn check<T: Real>() {
    assert_neutral::<T>("mirror of 0", remove::<Mirror>, |entity| {
        if entity.contains::<Mirror>() {
            entity.insert(Mirror(0.0));
        }
    });
    assert_neutral::<T>("gloss of 0", remove::<Gloss>, |entity| {
        if let Some(gloss) = entity.get::<Gloss>().copied() {
            entity.insert(Gloss { specular: 0.0, ..gloss });
        }
    });
    assert_neutral::<T>("falloff of 0", remove::<Falloff>, |entity| {
        if entity.contains::<Light>() {
            entity.insert(Falloff(0.0));
        }
    });
    let everywhere = SpotCone { target: DVec3::new(1.0, 2.0, 3.0), cutoff: 180.0 };
    assert_neutral::<T>("cutoff of 180", remove::<SpotCone>, |entity| {
        if entity.contains::<Light>() {
            entity.insert(everywhere);
        }
    });
}

/// An effect that the full scene has none of.
fn assert_adds_nothing<T: Real>(effect: Effect, neutral: impl Fn(&mut EntityWorldMut<'_>)) {
    let name = format!("{} {}", T::NAME, effect.name());
    let mut world = scene(neutral);
    let (plain, neutral) = (trace::<T>(&mut full_case().world()), trace::<T>(&mut world));
    assert_same(&name, &plain.picture, &neutral.picture);
    assert_eq!(plain.counts, neutral.counts, "{name}");
    assert!(!world.resource::<Tables<T>>().scene.effects().contains(effect), "{name} has a row");
}

fn check_additions<T: Real>() {
    assert_adds_nothing::<T>(Effect::LightColor, |entity| {
        if entity.contains::<Light>() {
            entity.insert(LightColor(DVec3::ONE));
        }
    });
    assert_adds_nothing::<T>(Effect::AreaLight, |entity| {
        if entity.contains::<Light>() {
            entity.insert(AreaLight { radius: 0.0, samples: 16 });
        }
    });
    assert_adds_nothing::<T>(Effect::Background, |entity| {
        if entity.contains::<CameraPose>() {
            entity.insert(Background { below: DVec3::ZERO, above: DVec3::ZERO });
        }
    });
    assert_adds_nothing::<T>(Effect::Fog, |entity| {
        if entity.contains::<CameraPose>() {
            entity.insert(Fog { density: 0.0, color: DVec3::ONE });
        }
    });
    for effect in [Effect::Glass, Effect::Absorption] {
        assert_adds_nothing::<T>(effect, |entity| {
            if entity.contains::<Color>() {
                entity.insert((Glass { index: 1.5, transmission: 0.0 }, Absorption(DVec3::ONE)));
            }
        });
    }
}

#[test]
fn an_effect_of_0_leaves_no_row_behind() {
    check_additions::<f64>();
    check_additions::<f32>();
}

#[test]
fn an_effect_of_0_is_as_good_as_none() {
    check::<f64>();
    check::<f32>();
}

#[test]
fn without_mirrors_the_level_does_not_show() {
    let picture = |level: u32| {
        let mut world = scene(insert_no_mirror);
        world.resource_mut::<Snapshot>().level = level;
        trace::<f64>(&mut world)
    };
    let usual = picture(1);
    for level in [2, 5, 1000] {
        let other = picture(level);
        assert_same(&format!("level {level}"), &usual.picture, &other.picture);
        assert_eq!(usual.counts, other.counts);
    }
}

#[test]
fn with_mirrors_the_level_shows() {
    let picture = |level: u32| {
        let mut world = full_case().world();
        world.resource_mut::<Snapshot>().level = level;
        trace::<f64>(&mut world).picture
    };
    let pictures: Vec<_> = (0..5).map(picture).collect();
    for pair in pictures.windows(2) {
        assert_ne!(pair[0], pair[1]);
        // Every level adds light.
        let channels = |index: usize| pair[index].pixels.iter().flatten();
        assert!(channels(0).zip(channels(1)).all(|(less, more)| less <= more));
    }
}

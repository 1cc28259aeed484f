//! Effects of surfaces, lights and air in a World: what is refused, what follows edits, and what can be switched off.

use archetrace::components::{
    Absorption, AreaLight, Background, CameraPose, Cube, Directional, Fog, Glass, Gloss, Light, LightColor,
    Mirror, Position, Shutter, Sphere, Velocity,
};
use archetrace::effects::{Effect, EffectSet};
use archetrace::systems::{Muted, Survey, Tables, extract_schedule, frame_schedule, prepare, take_away};
use bevy_ecs::prelude::*;
use glam::DVec3;

use crate::support::picture::assert_same;
use crate::support::scenes::{full_case, textured_case};
use crate::support::tracing::{run, trace, workers};

/// Effects that this page is about.
const HERE: [Effect; 7] = [
    Effect::LightColor,
    Effect::Directional,
    Effect::AreaLight,
    Effect::Background,
    Effect::Fog,
    Effect::Glass,
    Effect::Absorption,
];

/// A small scene with every effect of a scene file, and of this page.
fn rich_world() -> World {
    let mut case = textured_case();
    case.description.pixels = 32;
    let mut world = case.world();
    world.spawn((
        Light,
        Directional { direction: DVec3::new(2.0, 3.0, -5.0) },
        LightColor(DVec3::splat(0.3)),
    ));
    world.spawn((Light, Position::new(-70.0, -60.0, 50.0), AreaLight { radius: 6.0, samples: 4 }));
    world.spawn(Background { below: DVec3::ZERO, above: DVec3::new(0.2, 0.4, 0.9) });
    world.spawn(Fog { density: 0.001, color: DVec3::splat(0.5) });
    let glass = Glass { index: 1.5, transmission: 0.9 };
    world.spawn((
        Sphere { radius: 21.0 },
        Position::new(20.0, -70.0, 40.0),
        glass,
        Absorption(DVec3::X * 0.03),
    ));
    world
}

fn refusal(spoil: impl Fn(&mut World) -> Entity) -> String {
    let mut world = full_case().world();
    let entity = spoil(&mut world);
    prepare::<f64>(&mut world, workers(1));
    let error = run(&mut world, &mut frame_schedule::<f64>()).unwrap_err();
    error.to_string().replace(&format!("entity {entity}: "), "")
}

#[test]
fn values_must_be_in_their_ranges() {
    fn check<B: Bundle>(bundle: impl Fn() -> B, message: &str) {
        assert_eq!(refusal(|world| world.spawn(bundle()).id()), message);
    }
    let area = |radius, samples| (Light, AreaLight { radius, samples });
    check(|| area(-1.0, 1), "AreaLight.radius is -1, but must be a length from 0 to 1e70");
    check(|| area(1.0, 0), "AreaLight.samples is 0, but must be a number from 1 to 4096");
    let light = |red| (Light, LightColor(DVec3::new(red, 1.0, 1.0)));
    check(|| light(-0.5), "LightColor is -0.5, but must be a number from 0 to 1e6");
    check(
        || (Light, Directional { direction: DVec3::ZERO }),
        "Directional.direction is zero, which is no direction",
    );
    let cube = |index, transmission| (Cube { side: 1.0 }, Glass { index, transmission });
    check(|| cube(0.0, 1.0), "Glass.index is 0, but must be a number from 0.1 to 10");
    check(|| cube(1.5, 1.25), {
        "Glass.transmission is 1.25, but must be a number from 0 to 1\n\
         Mirror and Glass.transmission add up to 1.25, but must not exceed 1"
    });
    check(
        || (cube(1.5, 0.75), Mirror(0.5)),
        "Mirror and Glass.transmission add up to 1.25, but must not exceed 1",
    );
    check(
        || (cube(1.5, 1.0), Absorption(DVec3::new(0.0, -1.0, 0.0))),
        "Absorption is -1, but must be a number from 0 to 1e150",
    );
    let fog = |density| Fog { density, color: DVec3::splat(0.5) };
    check(|| fog(f64::NAN), "Fog.density is NaN, but must be a number from 0 to 1e150");
    let background = Background { below: DVec3::ZERO, above: DVec3::splat(2.0) };
    check(|| background, "Background.above is 2, but must be a number from 0 to 1\n".repeat(3).trim_end());
}

#[test]
fn there_is_one_background_and_one_fog_at_most() {
    let background = Background { below: DVec3::ZERO, above: DVec3::ONE };
    let twice = refusal(|world| {
        world.spawn(background);
        world.spawn(background).id()
    });
    assert_eq!(twice, "the World must have no more than one Background, but has 2");
    let fog = Fog { density: 0.1, color: DVec3::ZERO };
    let thrice = refusal(|world| {
        world.spawn_batch([fog, fog]);
        world.spawn(fog).id()
    });
    assert_eq!(thrice, "the World must have no more than one Fog, but has 3");
}

#[test]
fn air_follows_every_edit() {
    let mut world = full_case().world();
    prepare::<f64>(&mut world, workers(1));
    let mut schedule = frame_schedule::<f64>();
    let plain = run(&mut world, &mut schedule).unwrap().picture;
    let revision = |world: &World| world.resource::<Tables<f64>>().revision();
    let before = revision(&world);
    world.insert_resource(Muted(EffectSet::of(&[Effect::Fog])));
    world.insert_resource(Muted::default());
    let fog = world.spawn(Fog { density: 0.01, color: DVec3::ONE }).id();
    let thin = run(&mut world, &mut schedule).unwrap().picture;
    assert_ne!(plain, thin);
    world.get_mut::<Fog>(fog).unwrap().density = 0.02;
    let thick = run(&mut world, &mut schedule).unwrap().picture;
    assert_ne!(thin, thick);
    world.despawn(fog);
    let gone = run(&mut world, &mut schedule).unwrap().picture;
    assert_same("fog that is gone", &plain, &gone);
    assert!(revision(&world) > before);
    let settled = revision(&world);
    run(&mut world, &mut schedule).unwrap();
    assert_eq!(revision(&world), settled, "nothing was left to extract");
}

#[test]
fn lights_and_surfaces_follow_every_edit() {
    let mut world = full_case().world();
    let light = world.query_filtered::<Entity, With<Light>>().iter(&world).next().unwrap();
    let object = world.query_filtered::<Entity, With<Sphere>>().iter(&world).next().unwrap();
    prepare::<f64>(&mut world, workers(1));
    let mut schedule = frame_schedule::<f64>();
    let plain = run(&mut world, &mut schedule).unwrap().picture;
    fn toggled<C: Component + Copy>(
        world: &mut World,
        schedule: &mut Schedule,
        entity: Entity,
        component: C,
    ) -> [bool; 2] {
        let before = run(world, schedule).unwrap().picture;
        world.entity_mut(entity).insert(component);
        let with = run(world, schedule).unwrap().picture;
        world.entity_mut(entity).remove::<C>();
        [with != before, run(world, schedule).unwrap().picture == before]
    }
    let schedule = &mut schedule;
    let color = LightColor(DVec3::new(0.5, 1.0, 0.2));
    assert_eq!(toggled(&mut world, schedule, light, color), [true; 2]);
    let directional = Directional { direction: DVec3::new(1.0, 2.0, -3.0) };
    assert_eq!(toggled(&mut world, schedule, light, directional), [true; 2]);
    assert_eq!(toggled(&mut world, schedule, light, AreaLight { radius: 20.0, samples: 4 }), [true; 2]);
    world.entity_mut(object).remove::<Mirror>();
    let glass = Glass { index: 1.5, transmission: 1.0 };
    assert_eq!(toggled(&mut world, schedule, object, glass), [true; 2]);
    world.entity_mut(object).insert(glass);
    assert_eq!(toggled(&mut world, schedule, object, Absorption(DVec3::ONE)), [true; 2]);
    assert_ne!(run(&mut world, schedule).unwrap().picture, plain);
}

#[test]
fn what_is_switched_off_is_as_good_as_taken_away() {
    let file = [Effect::Gloss, Effect::Mirror, Effect::Texture, Effect::Falloff, Effect::SpotCone];
    let mut world = rich_world();
    prepare::<f64>(&mut world, workers(2));
    let mut schedule = frame_schedule::<f64>();
    let mut muting = |world: &mut World, effects: &[Effect]| {
        world.insert_resource(Muted(EffectSet::of(effects)));
        run(world, &mut schedule).unwrap()
    };
    let everything = muting(&mut world, &[]);
    for effect in file.into_iter().chain(HERE) {
        assert!(world.resource::<Survey>().entities(effect) > 0, "the scene has no {}", effect.name());
        // Fog would hide the background.
        let others: &[Effect] = if effect == Effect::Background { &[Effect::Fog] } else { &[] };
        let all = [others, &[effect]].concat();
        let mut without = rich_world();
        all.iter().for_each(|&effect| take_away(&mut without, effect));
        let without = trace::<f64>(&mut without);
        let with = muting(&mut world, others);
        let muted = muting(&mut world, &all);
        assert_same(effect.name(), &without.picture, &muted.picture);
        assert_eq!(without.counts, muted.counts, "{}", effect.name());
        assert_ne!(muted.picture, with.picture, "{} does nothing", effect.name());
        let survey = world.resource::<Survey>();
        assert!(!survey.asked().contains(effect) && survey.entities(effect) > 0);
        assert!(!world.resource::<Tables<f64>>().effects().contains(effect));
    }
    let again = muting(&mut world, &[]);
    assert_same("all switched on again", &everything.picture, &again.picture);
}

#[test]
fn a_camera_can_carry_the_air() {
    let mut world = full_case().world();
    let camera = world.query_filtered::<Entity, With<CameraPose>>().single(&world).unwrap();
    let plain = trace::<f64>(&mut world).picture;
    world.entity_mut(camera).insert(Background { below: DVec3::ONE, above: DVec3::ONE });
    assert_ne!(plain, trace::<f64>(&mut world).picture);
    world.entity_mut(camera).remove::<Background>();
    world.entity_mut(camera).insert(Gloss { specular: 1.0, shininess: 1.0 });
    assert_same("gloss of nothing", &plain, &trace::<f64>(&mut world).picture);
}

#[test]
fn systems_run_for_the_effects_that_are_there_and_for_no_other() {
    let mut world = rich_world();
    prepare::<f64>(&mut world, workers(1));
    let mut schedule = extract_schedule::<f64>();
    let runs = |world: &World| Effect::ALL.map(|effect| world.resource::<Tables<f64>>().systems_run(effect));
    schedule.run(&mut world);
    let asked = world.resource::<Tables<f64>>().effects();
    let first = runs(&world);
    for (effect, runs) in Effect::ALL.into_iter().zip(first) {
        assert_eq!(runs > 0, asked.contains(effect), "{effect:?} {runs}");
    }
    schedule.run(&mut world);
    assert_eq!(runs(&world), first, "nothing changed");

    let camera = world.query_filtered::<Entity, With<CameraPose>>().single(&world).unwrap();
    let ball = world.query_filtered::<Entity, With<Sphere>>().iter(&world).next().unwrap();
    world.entity_mut(camera).insert(Shutter { open: 0.0, close: 1.0 });
    schedule.run(&mut world);
    assert_eq!(runs(&world), first, "a shutter alone moves nothing");
    world.entity_mut(ball).insert(Velocity(DVec3::X));
    schedule.run(&mut world);
    assert_eq!(world.resource::<Tables<f64>>().systems_run(Effect::MotionBlur), 1);
}

#[test]
fn every_effect_is_left_out_of_two_programs() {
    let script = include_str!("../../benches/idle_effects.sh");
    let words = script.split_once("all_words=(").unwrap().1.split_once(')').unwrap().0;
    let words: Vec<&str> =
        words.split(|character: char| character == '"' || character.is_whitespace()).collect();
    for effect in Effect::ALL {
        let times = words.iter().filter(|&&word| word == effect.name()).count();
        assert_eq!(times, 2, "{}", effect.name());
    }
}

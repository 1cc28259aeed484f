//! Effects that are given to entities, edited within what is allowed, and taken back.

use std::num::NonZeroUsize;
use std::sync::Arc;

use bevy_ecs::prelude::*;
use egui::Key;
use glam::DVec3;

use super::screen::Screen;
use crate::components::{
    Absorption, Aperture, AreaLight, Background, CameraPose, CheckerFilter, Directional, ExposureStops, Fog,
    Glass, LightColor, Mirror, Shutter, SrgbTransfer, Texture, TextureFilter, Textured, Velocity,
};
use crate::effects::{Effect, EffectSet};
use crate::systems::{Tables, Workers, extract_schedule, prepare};

/// The official scene with an entity selected by its name, and the effects that its tables hold.
fn selected(name: &str) -> (Screen, Entity, EffectSet) {
    let mut screen = Screen::of_file("official.txt");
    prepare::<f64>(&mut screen.world, Workers::new(NonZeroUsize::new(1)).unwrap());
    screen.click_on(name);
    let entity = screen.editor.selected().unwrap();
    let before = effects(&mut screen);
    (screen, entity, before)
}

/// The effects that a trace would show. Whatever is edited, the World can be traced.
fn effects(screen: &mut Screen) -> EffectSet {
    extract_schedule::<f64>().run(&mut screen.world);
    let tables = screen.world.resource::<Tables<f64>>();
    assert!(tables.problems().is_empty(), "{:?}", tables.problems());
    tables.effects()
}

fn enter(screen: &mut Screen, label: &str, column: usize, text: &str) {
    let number = screen.numbers(label)[column];
    screen.click(number.center());
    screen.type_text(text);
    screen.key(Key::Enter);
    screen.settle();
}

fn undo_all(screen: &mut Screen) -> usize {
    std::iter::from_fn(|| screen.editor.undo(&mut screen.world)).count()
}

#[test]
fn a_light_is_given_a_colour_a_direction_and_an_extent() {
    let (mut screen, light, before) = selected("light 1");
    screen.click_on("Light colour");
    enter(&mut screen, "intensity", 2, "2.5");
    assert_eq!(screen.world.get(light), Some(&LightColor(DVec3::new(1.0, 0.8, 2.5))));
    screen.click_on("Area light");
    enter(&mut screen, "extent", 0, "5");
    enter(&mut screen, "shadow rays", 0, "5000");
    assert_eq!(screen.world.get(light), Some(&AreaLight { radius: 5.0, samples: 4096 }));
    let colored = before.union(EffectSet::of(&[Effect::LightColor]));
    assert_eq!(effects(&mut screen), colored.union(EffectSet::of(&[Effect::AreaLight])));
    screen.click_on("Directional");
    enter(&mut screen, "direction", 2, "0");
    assert_eq!(screen.world.get(light), Some(&Directional { direction: DVec3::NEG_Z }), "zero is none");
    enter(&mut screen, "direction", 0, "1");
    assert_eq!(screen.world.get(light), Some(&Directional { direction: DVec3::new(1.0, 0.0, -1.0) }));
    assert_eq!(effects(&mut screen), colored.union(EffectSet::of(&[Effect::Directional])));
    assert_eq!(undo_all(&mut screen), 7);
    assert_eq!(effects(&mut screen), before);
}

#[test]
fn a_body_becomes_glass_that_sends_on_no_more_than_it_receives() {
    let (mut screen, sphere, before) = selected("sphere 1");
    assert!(!screen.has("Absorption"), "only glass absorbs");
    screen.world.entity_mut(sphere).insert(Mirror(0.4));
    screen.settle();
    screen.click_on("Glass");
    assert_eq!(screen.world.get(sphere), Some(&Glass { index: 1.5, transmission: 0.6 }));
    enter(&mut screen, "index", 0, "99");
    enter(&mut screen, "transmission", 0, "1");
    assert_eq!(screen.world.get(sphere), Some(&Glass { index: 10.0, transmission: 0.6 }));
    enter(&mut screen, "transmission", 0, "0.7");
    enter(&mut screen, "reflection", 0, "0.9");
    assert_eq!(screen.world.get(sphere), Some(&Mirror(0.4)), "the one that is edited gives way");
    screen.click_on("Absorption");
    enter(&mut screen, "absorption", 1, "0.25");
    let Absorption(absorption) = *screen.world.get(sphere).unwrap();
    assert!(absorption.y == 0.25 && absorption.z > absorption.x, "{absorption}");
    let glass = EffectSet::of(&[Effect::Mirror, Effect::Glass, Effect::Absorption]);
    assert_eq!(effects(&mut screen), before.union(glass));
    undo_all(&mut screen);
    assert_eq!(effects(&mut screen), before.union(EffectSet::of(&[Effect::Mirror])));
}

#[test]
fn what_moves_shows_while_the_camera_has_a_shutter() {
    let (mut screen, sphere, before) = selected("sphere 1");
    screen.click_on("Velocity");
    enter(&mut screen, "velocity", 1, "-30");
    assert_eq!(screen.world.get::<Velocity>(sphere).unwrap().0.y, -30.0);
    assert_eq!(effects(&mut screen), before);
    screen.click_on("Camera");
    screen.click_on("Shutter");
    enter(&mut screen, "opens", 0, "1");
    enter(&mut screen, "closes", 0, "-1");
    let camera = screen.first::<CameraPose>();
    assert_eq!(screen.world.get(camera), Some(&Shutter { open: 0.04, close: 0.04 }), "in this order");
    enter(&mut screen, "closes", 0, "0.5");
    assert_eq!(effects(&mut screen), before.union(EffectSet::of(&[Effect::MotionBlur])));
    undo_all(&mut screen);
    assert_eq!(effects(&mut screen), before);
    assert_eq!(screen.world.get::<Shutter>(camera), None);
}

#[test]
fn a_board_is_given_the_filter_that_fits_it() {
    let (mut screen, board, before) = selected("checkerboard 5");
    assert!(!screen.has("Texture filter"), "it has no images");
    screen.click_on("Checker filter");
    assert!(screen.world.get::<CheckerFilter>(board).is_some());
    assert_eq!(effects(&mut screen), before.union(EffectSet::of(&[Effect::CheckerFilter])));
    undo_all(&mut screen);
    let image = Texture::new(1, 1, vec![[9, 9, 9]]).map(Arc::new).unwrap();
    screen.world.entity_mut(board).insert(Textured { white: image.clone(), black: image });
    screen.settle();
    screen.click_on("Texture filter");
    assert_eq!(screen.world.get(board), Some(&TextureFilter::Mip));
    screen.click_on("bilinear");
    assert_eq!(screen.world.get(board), Some(&TextureFilter::Bilinear));
    let filtered = EffectSet::of(&[Effect::Texture, Effect::TextureFilter]);
    assert_eq!(effects(&mut screen), before.union(filtered));
    assert_eq!(undo_all(&mut screen), 2);
}

#[test]
fn the_camera_is_given_a_lens_an_exposure_and_a_curve() {
    let (mut screen, _, before) = selected("sphere 1");
    screen.click_on("Camera");
    let camera = screen.first::<CameraPose>();
    screen.click_on("Aperture");
    enter(&mut screen, "lens", 0, "1e9");
    let aperture = *screen.world.get::<Aperture>(camera).unwrap();
    assert!(aperture.radius == aperture.focus && aperture.focus > 0.0, "{aperture:?}");
    enter(&mut screen, "lens", 0, "2");
    enter(&mut screen, "focus", 0, "1");
    assert_eq!(screen.world.get(camera), Some(&Aperture { radius: 2.0, focus: 2.0 }));
    screen.click_on("Exposure");
    enter(&mut screen, "stops", 0, "-500");
    assert_eq!(screen.world.get(camera), Some(&ExposureStops(-100.0)));
    screen.click_on("sRGB");
    assert!(screen.world.get::<SrgbTransfer>(camera).is_some());
    let all = EffectSet::of(&[Effect::Aperture, Effect::Exposure, Effect::Srgb]);
    assert_eq!(effects(&mut screen), before.union(all));
    undo_all(&mut screen);
    assert_eq!(effects(&mut screen), before);
}

#[test]
fn surroundings_are_edited_wherever_they_are() {
    let (mut screen, _, before) = selected("sphere 1");
    screen.click_on("Surroundings");
    screen.click_on("Background");
    enter(&mut screen, "below", 0, "0.5");
    let camera = screen.first::<CameraPose>();
    assert_eq!(screen.world.get::<Background>(camera).unwrap().below.x, 0.5);
    let own = screen.world.spawn(Fog { density: 0.25, color: DVec3::ONE }).id();
    screen.settle();
    enter(&mut screen, "density", 0, "-1");
    enter(&mut screen, "fog", 1, "0.5");
    assert_eq!(screen.world.get(own), Some(&Fog { density: 0.0, color: DVec3::new(1.0, 0.5, 1.0) }));
    enter(&mut screen, "density", 0, "0.01");
    assert_eq!(effects(&mut screen), before.union(EffectSet::of(&[Effect::Background, Effect::Fog])));
    assert_eq!(undo_all(&mut screen), 5);
    assert_eq!(screen.world.get(own), Some(&Fog { density: 0.25, color: DVec3::ONE }));
}

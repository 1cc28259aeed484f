//! Values that are dragged, typed and clicked.

use std::num::NonZeroUsize;

use bevy_ecs::prelude::*;
use egui::{Event, Key, pos2, vec2};

use super::screen::Screen;
use crate::components::{
    Ambient, Color, Gloss, Lens, Mirror, Position, Sampling, Snapshot, Sphere, SpotCone,
};
use crate::effects::{Effect, EffectSet};
use crate::systems::{Muted, Tables, Workers, extract_schedule, prepare};

/// The first sphere of the official scene, selected.
fn sphere() -> (Screen, Entity) {
    let mut screen = Screen::of_file("official.txt");
    screen.click_on("sphere 1");
    let sphere = screen.editor.selected().unwrap();
    (screen, sphere)
}

fn steps(screen: &mut Screen) -> usize {
    std::iter::from_fn(|| screen.editor.undo(&mut screen.world)).count()
}

fn type_into(screen: &mut Screen, label: &str, column: usize, text: &str) {
    let number = screen.numbers(label)[column];
    screen.click(number.center());
    screen.type_text(text);
}

fn enter(screen: &mut Screen) {
    screen.key(Key::Enter);
    screen.settle();
}

#[test]
fn a_drag_of_a_number_is_one_step() {
    let (mut screen, sphere) = sphere();
    let before = *screen.world.get::<Position>(sphere).unwrap();
    let [_, y, _] = screen.numbers("position")[..] else { panic!("three numbers") };
    screen.drag(y.center(), 60.0);
    let after = *screen.world.get::<Position>(sphere).unwrap();
    assert!(after.0.y > before.0.y + 10.0, "{before:?} to {after:?}");
    assert_eq!((after.0.x, after.0.z), (before.0.x, before.0.z));
    screen.drag(y.center(), -30.0);
    assert!(screen.world.get::<Position>(sphere).unwrap().0.y < after.0.y);
    screen.editor.undo(&mut screen.world);
    assert_eq!(screen.world.get(sphere), Some(&after), "each drag is a step of its own");
    screen.editor.undo(&mut screen.world);
    assert_eq!(screen.world.get(sphere), Some(&before));
    assert_eq!(steps(&mut screen), 0);
}

#[test]
fn drags_without_a_pause_between_them_are_steps_of_their_own() {
    let (mut screen, _) = sphere();
    let mut at = screen.numbers("position")[1].center();
    screen.press(at);
    for _ in 0..2 {
        for _ in 0..5 {
            at.x += 8.0;
            screen.event(Event::PointerMoved(at));
        }
        screen.release(at);
        screen.button(at, true);
    }
    screen.release(at);
    screen.settle();
    assert_eq!(steps(&mut screen), 2);
}

#[test]
fn a_drag_of_a_slider_is_one_step() {
    let (mut screen, sphere) = sphere();
    let slider = screen.sliders("ambient")[0];
    screen.drag(pos2(slider.left() + 10.0, slider.center().y), 60.0);
    let Ambient(ambient) = *screen.world.get(sphere).unwrap();
    assert!((0.3..0.6).contains(&ambient), "{ambient}");
    screen.drag(slider.center(), 1000.0);
    assert_eq!(screen.world.get(sphere), Some(&Ambient(1.0)));
    assert_eq!(steps(&mut screen), 2);
}

#[test]
fn a_length_that_is_dragged_stays_a_length() {
    let (mut screen, sphere) = sphere();
    let radius = screen.numbers("radius")[0];
    screen.drag(radius.center(), -900.0);
    let Sphere { radius } = *screen.world.get(sphere).unwrap();
    assert!(radius > 0.0 && radius < 46.0, "{radius}");
}

#[test]
fn a_typed_number_counts_when_it_is_complete() {
    let (mut screen, sphere) = sphere();
    type_into(&mut screen, "radius", 0, "12");
    screen.event(Event::Text(",5".to_owned()));
    assert_eq!(screen.world.get(sphere), Some(&Sphere { radius: 46.0 }), "while it is typed");
    enter(&mut screen);
    assert_eq!(screen.world.get(sphere), Some(&Sphere { radius: 12.5 }));
    type_into(&mut screen, "radius", 0, "99");
    screen.key(Key::Escape);
    screen.settle();
    assert_eq!(screen.world.get(sphere), Some(&Sphere { radius: 12.5 }), "given up");
    for nonsense in ["nan", "abc", ""] {
        type_into(&mut screen, "radius", 0, nonsense);
        enter(&mut screen);
        assert_eq!(screen.world.get(sphere), Some(&Sphere { radius: 12.5 }), "`{nonsense}`");
    }
    type_into(&mut screen, "radius", 0, "-3");
    enter(&mut screen);
    assert_eq!(screen.world.get(sphere), Some(&Sphere { radius: 1e-70 }), "the closest that is allowed");
    assert_eq!(steps(&mut screen), 2);
}

#[test]
fn numbers_of_one_component_that_are_typed_one_after_the_other_are_steps_of_their_own() {
    let (mut screen, sphere) = sphere();
    type_into(&mut screen, "position", 0, "1");
    screen.key(Key::Tab);
    screen.settle();
    screen.type_text("2");
    // A press elsewhere ends the typing, and begins a drag of the same component.
    let z = screen.numbers("position")[2];
    screen.drag(z.center(), 60.0);
    let position = screen.world.get::<Position>(sphere).unwrap().0;
    assert_eq!((position.x, position.y), (1.0, 2.0));
    assert!(position.z > 46.0);
    screen.editor.undo(&mut screen.world);
    assert_eq!(screen.world.get(sphere), Some(&Position::new(1.0, 2.0, 46.0)));
    screen.editor.undo(&mut screen.world);
    assert_eq!(screen.world.get(sphere), Some(&Position::new(1.0, 40.0, 46.0)));
    assert_eq!(steps(&mut screen), 1);
}

#[test]
fn looking_at_a_number_keeps_all_its_digits() {
    let (mut screen, sphere) = sphere();
    let value = Position::new(0.1 + 0.2, 1.0 / 3.0, -1e-9 / 7.0);
    let color = Color::new(0.1 + 0.2, 1.0 / 3.0, 0.7);
    screen.world.entity_mut(sphere).insert((value, color));
    screen.settle();
    assert!(screen.has("0.333333"), "{:?}", screen.texts());
    for (label, columns) in [("position", 3), ("color", 3), ("radius", 1), ("ambient", 1)] {
        for column in 0..columns {
            let number = screen.numbers(label)[column];
            screen.click(number.center());
            enter(&mut screen);
        }
    }
    let swatch = screen.numbers("color")[0].left_center() - vec2(18.0, 0.0);
    screen.click(swatch);
    assert!(screen.texts().len() > 20);
    screen.key(Key::Escape);
    screen.settle();
    assert_eq!(screen.world.get(sphere), Some(&value));
    assert_eq!(screen.world.get(sphere), Some(&color));
    assert_eq!(steps(&mut screen), 0);
}

#[test]
fn a_number_that_is_being_typed_does_not_move_to_another_entity() {
    let (mut screen, first) = sphere();
    type_into(&mut screen, "radius", 0, "7");
    screen.click_on("sphere 2");
    let second = screen.editor.selected().unwrap();
    assert_ne!(first, second);
    assert_eq!(screen.world.get(first), Some(&Sphere { radius: 7.0 }), "a click elsewhere ends the typing");
    assert_ne!(screen.world.get(second), Some(&Sphere { radius: 7.0 }));
    assert_eq!(steps(&mut screen), 1);
}

#[test]
fn effects_are_added_and_removed() {
    let mut screen = Screen::of_file("official.txt");
    screen.click_on("checkerboard 5");
    let board = screen.editor.selected().unwrap();
    assert!(screen.has("reflection") && !screen.has("specular"));
    let remove = pos2(screen.numbers("cell")[0].right() - 8.0, screen.all_of("Mirror")[0].center().y);
    screen.click(remove);
    assert_eq!(screen.world.get::<Mirror>(board), None);
    assert!(!screen.has("reflection"));
    screen.click_on("Gloss");
    assert_eq!(screen.world.get(board), Some(&Gloss { specular: 0.3, shininess: 30.0 }));
    screen.click_on("Mirror");
    assert_eq!(screen.world.get(board), Some(&Mirror(0.3)));
    assert_eq!(steps(&mut screen), 3);
    assert_ne!(screen.world.get(board), Some(&Mirror(0.3)));

    screen.click_on("light 1");
    let light = screen.editor.selected().unwrap();
    screen.click_on("Cone");
    assert!(screen.world.get::<SpotCone>(light).is_some());
    assert!(screen.has("spotlight 1"), "a light with a cone is a spotlight");
}

#[derive(Component)]
struct Orbiting;

#[test]
fn components_of_a_program_are_listed_by_name() {
    let (mut screen, sphere) = sphere();
    assert!(!screen.has("also"));
    screen.world.entity_mut(sphere).insert(Orbiting);
    screen.settle();
    assert!(screen.has("Orbiting"), "{:?}", screen.texts());
}

#[test]
fn lens_and_picture_are_edited_within_what_is_allowed() {
    let mut screen = Screen::of_file("official.txt");
    screen.click_on("Camera");
    let camera = screen.first::<Lens>();
    let before = *screen.world.get::<Lens>(camera).unwrap();
    type_into(&mut screen, "far", 0, "0");
    enter(&mut screen);
    let lens = *screen.world.get::<Lens>(camera).unwrap();
    assert_eq!(lens.far, before.near.next_up(), "beyond the near plane");
    type_into(&mut screen, "aspect", 0, "1000");
    enter(&mut screen);
    let fovx = screen.world.get::<Lens>(camera).unwrap().fovx();
    assert!(fovx < 180.0 && fovx > 179.99, "{fovx}");
    assert_eq!(steps(&mut screen), 2);
    assert_eq!(screen.world.get(camera), Some(&before));

    type_into(&mut screen, "pixels", 0, "99999");
    enter(&mut screen);
    type_into(&mut screen, "level", 0, "7");
    enter(&mut screen);
    assert_eq!(*screen.world.resource::<Snapshot>(), Snapshot { pixels: 8192, level: 7 });
    assert!(screen.editor.is_modified());
    steps(&mut screen);
    type_into(&mut screen, "samples", 0, "3");
    enter(&mut screen);
    assert_eq!(*screen.world.resource::<Sampling>(), Sampling { side: 3 });
    assert!(!screen.editor.is_modified(), "a file holds no sampling");
    assert!(screen.has("² = 9"));
}

#[test]
fn an_effect_is_switched_off_and_undo_switches_it_on() {
    let mut screen = Screen::of_file("official.txt");
    prepare::<f64>(&mut screen.world, Workers::new(NonZeroUsize::new(1)).unwrap());
    extract_schedule::<f64>().run(&mut screen.world);
    screen.status.effects = screen.world.resource::<Tables<f64>>().effect_counts();
    screen.click_on("Effects in use");
    assert!(screen.switches("glass").is_empty(), "nobody asks for it");
    screen.click(screen.switches("mirror")[0].center());
    assert_eq!(screen.world.resource::<Muted>().0, EffectSet::of(&[Effect::Mirror]));
    extract_schedule::<f64>().run(&mut screen.world);
    assert!(!screen.world.resource::<Tables<f64>>().effects().contains(Effect::Mirror));
    assert!(!screen.switches("mirror").is_empty(), "it can be switched on again");
    screen.editor.undo(&mut screen.world);
    assert_eq!(*screen.world.resource::<Muted>(), Muted::default());
}

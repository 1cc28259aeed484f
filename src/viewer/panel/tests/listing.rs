//! The list of entities.

use bevy_ecs::prelude::*;

use super::screen::Screen;
use crate::components::{Order, Sphere};

#[test]
fn a_click_selects() {
    let mut screen = Screen::of_file("official.txt");
    assert!(screen.has("Nothing is selected: click on an object in the scene or in the list."));
    screen.click_on("pyramid 3");
    let pyramid = screen.first::<crate::components::Pyramid>();
    assert_eq!(screen.editor.selected(), Some(pyramid));
    assert!(screen.has("width") && screen.has("height") && !screen.has("radius"));
    screen.click_on("spotlight 2");
    assert!(screen.has("cutoff") && !screen.has("width"));
}

#[test]
fn a_name_of_its_own_is_shown() {
    let mut world = World::new();
    let moon = world.spawn((Sphere { radius: 1.0 }, Name::new("moon"))).id();
    let mut screen = Screen::new(world);
    screen.click_on("moon");
    assert_eq!(screen.editor.selected(), Some(moon));
}

#[test]
fn of_very_many_entities_few_rows_are_made() {
    let mut world = World::new();
    let spheres: Vec<Entity> =
        (0..50_000).map(|place| world.spawn((Sphere { radius: 1.0 }, Order(place))).id()).collect();
    let mut screen = Screen::new(world);
    let rows = |screen: &Screen| screen.texts().iter().filter(|text| text.starts_with("sphere ")).count();
    assert!(screen.has("sphere 1") && rows(&screen) < 15);
    screen.editor.select(Some(spheres[30_000]));
    screen.settle();
    assert!(screen.has("sphere 30001"), "what is selected in the scene comes into sight");
    assert!(rows(&screen) < 15);
    screen.click_on("sphere 30003");
    assert_eq!(screen.editor.selected(), Some(spheres[30_002]));
    assert!(screen.has("sphere 30001"), "what is selected in the list stays where it is");
}

#[test]
fn the_selected_entity_is_duplicated_and_deleted() {
    let mut screen = Screen::of_file("official.txt");
    screen.click_on("cube 4");
    screen.click_on("Duplicate");
    assert!(screen.has("cube 5") && screen.has("checkerboard 6"));
    assert_eq!(screen.editor.undoes(), Some("duplicate"));
    screen.click_on("Delete");
    assert!(!screen.has("cube 5") && screen.has("cube 4"));
    assert_eq!(screen.editor.selected(), None);
}

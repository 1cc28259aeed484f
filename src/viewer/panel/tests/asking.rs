//! What the panel asks of the program, and what it shows of it.

use core::time::Duration;

use bevy_ecs::prelude::*;
use egui::Key;

use super::super::{Messages, Request};
use super::screen::Screen;
use crate::components::{Snapshot, Sphere};
use crate::preview::Layout;
use crate::viewer::live::Shows;

fn sections() -> [&'static str; 7] {
    ["Entities", "Selected", "Camera", "Picture", "Effects in use", "Figures", "Keys"]
}

#[test]
fn every_scene_is_shown_and_showing_edits_nothing() {
    let folder = format!("{}/scenes", env!("CARGO_MANIFEST_DIR"));
    let names = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name());
    let scenes: Vec<String> = names.filter_map(|name| name.into_string().ok()).collect();
    let scenes: Vec<&String> = scenes.iter().filter(|name| name.ends_with(".txt")).collect();
    assert!(scenes.len() > 10);
    for scene in scenes {
        let mut screen = Screen::of_file(scene);
        for section in ["Camera", "Effects in use", "Figures", "Keys"] {
            screen.click_on(section);
        }
        let entities: Vec<Entity> = screen.state.listing.update(&mut screen.world, 0).to_vec();
        assert!(!entities.is_empty());
        for entity in entities {
            screen.editor.select(Some(entity));
            assert_eq!(screen.settle(), []);
            assert!(screen.has(&super::super::name_of(&screen.world, entity)), "{scene}: {entity}");
        }
        assert!(sections().iter().all(|section| screen.has(section)), "{scene}");
        assert!(screen.has("fovx") && screen.has("threads"), "{scene}");
        assert_eq!(screen.editor.newest(), None, "{scene}");
        assert!(!screen.editor.is_modified(), "{scene}");
    }
}

#[test]
fn a_world_that_cannot_be_traced_is_shown_as_well() {
    let mut world = World::new();
    world.insert_resource(Snapshot { pixels: 0, level: 5000 });
    let sphere = world.spawn(Sphere { radius: f64::NAN }).id();
    let mut screen = Screen::new(world);
    screen.editor.select(Some(sphere));
    screen.status.problems = (1..=20).map(|number| format!("problem {number}")).collect();
    screen.click_on("Camera");
    assert!(screen.has("problem 1") && screen.has("and 12 more") && !screen.has("problem 9"));
    assert_eq!(screen.editor.newest(), None, "what is out of range is shown as it is");
    assert_eq!(*screen.world.resource::<Snapshot>(), Snapshot { pixels: 0, level: 5000 });
}

#[test]
fn buttons_ask_for_what_they_say() {
    let mut screen = Screen::of_file("official.txt");
    screen.status.scene = Some("scenes/official.txt".into());
    screen.settle();
    assert!(screen.has("official.txt") && !screen.has("modified"));
    assert_eq!(screen.click_on("Reload"), [Request::Reload]);
    assert_eq!(screen.click_on("traced"), [Request::SetMode(Layout::Traced)]);
    assert_eq!(screen.click_on("split"), [Request::SetMode(Layout::Split)]);
    assert_eq!(screen.click_on("errors"), [Request::SetShows(Shows::Errors)]);
    assert_eq!(screen.click_on("Trace"), [Request::Trace]);
    assert_eq!(screen.click_on("Undo"), [], "there is nothing to undo");
    assert_eq!(screen.click_on("sphere"), [], "an entity is added at once");
    assert!(screen.has("modified") && screen.has("sphere 5"));
    assert_eq!(screen.click_on("Undo"), [Request::Undo]);
    screen.editor.undo(&mut screen.world);
    screen.settle();
    assert!(!screen.has("modified"));
    assert_eq!(screen.click_on("Redo"), [Request::Redo]);
    screen.status.progress = Some(0.5);
    screen.settle();
    assert_eq!(screen.click_on("Cancel"), [Request::CancelTrace]);
    let texture = screen.find("texture").right_center() + egui::vec2(48.0, 0.0);
    assert_eq!(screen.click(texture), [Request::ToggleTexture]);
}

#[test]
fn the_keyboard_stays_with_the_camera() {
    let mut screen = Screen::of_file("official.txt");
    for text in ["sphere 2", "sphere", "traced", "Trace", "Entities", "Entities"] {
        screen.click_on(text);
        assert!(!screen.ctx.egui_wants_keyboard_input(), "after a click on `{text}`");
    }
    screen.click_on("sphere 1");
    let slider = screen.sliders("ambient")[0];
    screen.drag(slider.center(), 20.0);
    assert!(!screen.ctx.egui_wants_keyboard_input(), "after a slider was dragged");
    let selected = screen.editor.selected();
    let newest = screen.editor.newest();
    for key in
        [Key::ArrowDown, Key::ArrowUp, Key::ArrowRight, Key::PageDown, Key::Space, Key::Num1, Key::Home]
    {
        assert_eq!(screen.key(key), []);
    }
    assert_eq!((screen.editor.selected(), screen.editor.newest()), (selected, newest));
    let radius = screen.numbers("radius")[0];
    screen.click(radius.center());
    assert!(screen.ctx.egui_wants_keyboard_input(), "while a number is typed");
    screen.key(Key::Enter);
    screen.settle();
    assert!(!screen.ctx.egui_wants_keyboard_input(), "after a number was typed");
}

#[test]
fn nothing_covers_the_scene_when_there_is_nothing_to_say() {
    let mut screen = Screen::of_file("official.txt");
    screen.is_panel_open = false;
    screen.settle();
    let (requests, output) = screen.draw();
    assert_eq!(requests, []);
    let drawn = output.shapes.iter().filter(|shape| shape.shape != egui::Shape::Noop).count();
    assert_eq!(drawn, 0);
    output.drop_without_applying_deltas();
}

#[test]
fn messages_and_progress_are_shown_without_the_panel() {
    let mut screen = Screen::of_file("official.txt");
    screen.is_panel_open = false;
    let mut messages = Messages::default();
    messages.tell("file", "wrote room-001.bmp".to_owned(), Duration::ZERO);
    messages.complain("scene", "the scene is bad".to_owned(), "  --> room.txt:6:16".to_owned());
    screen.status.messages = messages.list().to_vec();
    screen.status.progress = Some(0.25);
    screen.settle();
    for text in ["wrote room-001.bmp", "the scene is bad", "  --> room.txt:6:16", "Esc cancels", "tracing"] {
        assert!(screen.has(text), "`{text}` among {:?}", screen.texts());
    }
    let cross = |text: &str| screen.find(text).right_center() + egui::vec2(14.0, 0.0);
    let [first, second] = ["wrote room-001.bmp", "the scene is bad"].map(cross);
    assert_eq!(screen.click(second), [Request::Dismiss(1)]);
    assert_eq!(screen.click(first), [Request::Dismiss(0)]);
    let cancel = screen.find("Esc cancels").left_center() - egui::vec2(14.0, 0.0);
    assert_eq!(screen.click(cancel), [Request::CancelTrace]);
}

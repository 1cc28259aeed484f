//! Saving: never over a file by one click.

use std::fs;
use std::path::{Path, PathBuf};

use super::super::save::SaveName;
use super::super::{Request, unused_name};
use super::folder;
use super::screen::Screen;

fn opened(folder: &Path) -> Screen {
    let mut screen = Screen::of_file("official.txt");
    screen.status.scene = Some(folder.join("room.txt"));
    fs::write(folder.join("room.txt"), "").unwrap();
    screen.settle();
    screen
}

fn save(path: PathBuf, overwrite: bool) -> Request {
    Request::Save { path, overwrite }
}

fn set_name(screen: &mut Screen, path: &Path) {
    let field = screen.numbers("save as")[0];
    screen.click(field.center());
    screen.type_text(path.to_str().unwrap());
    screen.key(egui::Key::Enter);
    screen.settle();
}

#[test]
fn names_are_never_taken() {
    let folder = folder();
    let scene = folder.path().join("room.txt");
    let expect = |name: &str| assert_eq!(unused_name(Some(&scene)), folder.path().join(name));
    expect("room-edited.txt");
    fs::write(folder.path().join("room-edited.txt"), "").unwrap();
    expect("room-edited-2.txt");
    fs::create_dir(folder.path().join("room-edited-2.txt")).unwrap();
    expect("room-edited-3.txt");
    let nowhere = unused_name(None);
    assert!(nowhere.to_str().unwrap().starts_with("scene-edited"));
}

#[test]
fn an_unused_name_follows_what_is_written_and_a_typed_one_stays() {
    let folder = folder();
    let scene = folder.path().join("room.txt");
    let mut name = SaveName::default();
    let first = name.path(Some(&scene), None);
    fs::write(&first, "").unwrap();
    let second = name.path(Some(&scene), Some(&first));
    assert_ne!(first, second);
    name.is_armed = true;
    name.set("other.txt".to_owned());
    assert!(!name.is_armed);
    assert_eq!(name.path(Some(&scene), Some(&second)), Path::new("other.txt"));
}

#[test]
fn a_new_name_is_saved_by_one_click() {
    let folder = folder();
    let mut screen = opened(folder.path());
    let edited = folder.path().join("room-edited.txt");
    assert_eq!(screen.click_on("Save"), [save(edited.clone(), false)]);
    fs::write(&edited, "").unwrap();
    screen.status.written = Some(edited);
    screen.settle();
    assert!(screen.has("Replace room-edited.txt…"), "the name stays: {:?}", screen.texts());
}

#[test]
fn the_next_name_is_offered_if_another_program_took_one() {
    let folder = folder();
    let edited = folder.path().join("room-edited.txt");
    fs::write(&edited, "").unwrap();
    let mut screen = opened(folder.path());
    assert_eq!(screen.click_on("Save"), [save(folder.path().join("room-edited-2.txt"), false)]);
}

#[test]
fn a_file_is_replaced_by_two_clicks_only() {
    let folder = folder();
    let mut screen = opened(folder.path());
    let room = folder.path().join("room.txt");
    set_name(&mut screen, &room);
    assert!(!screen.has("Save"));
    assert_eq!(screen.click_on("Replace room.txt…"), []);
    assert_eq!(screen.click_on("Keep it"), []);
    assert_eq!(screen.click_on("Replace room.txt…"), []);
    set_name(&mut screen, &folder.path().join("other.txt"));
    set_name(&mut screen, &room);
    assert!(!screen.has("Replace it"), "what was agreed to for one name does not count for the next");
    assert_eq!(screen.click_on("Replace room.txt…"), []);
    assert_eq!(screen.click_on("Replace it"), [save(room, true)]);
    assert!(!screen.has("Replace it"), "and only once");
}

#[test]
fn no_name_is_no_file() {
    let folder = folder();
    let mut screen = opened(folder.path());
    set_name(&mut screen, Path::new(""));
    assert_eq!(screen.click_on("Save"), []);
}

//! `archetrace write`: the World as a scene file again.

use crate::program::{Folder, SCENE};

#[test]
fn writing_what_was_written_changes_nothing() {
    let folder = Folder::with_scene();
    folder.run("write scene.txt -o once.txt").quiet();
    folder.run("write once.txt -o twice.txt").quiet();
    assert_eq!(folder.read("once.txt"), folder.read("twice.txt"));
    assert_ne!(folder.read("once.txt"), SCENE.as_bytes());
    assert_eq!(folder.names(), ["once.txt", "scene.txt", "twice.txt"]);
}

#[test]
fn what_was_written_renders_the_same_picture() {
    let folder = Folder::with_scene();
    folder.run("write scene.txt -o written.txt").quiet();
    folder.run("render written.txt -o written.bmp").quiet();
    assert_eq!(folder.read("written.bmp"), folder.render(""));
    let summary = |name: &str| {
        let said = folder.run(&format!("check {name}")).quiet();
        said.split_once('\n').unwrap().1.to_owned()
    };
    assert_eq!(summary("written.txt"), summary("scene.txt"));
}

#[test]
fn without_a_file_it_goes_to_standard_output() {
    let folder = Folder::with_scene();
    let printed = folder.run("write scene.txt").quiet();
    folder.run("write scene.txt -o written.txt").quiet();
    assert_eq!(folder.read("written.txt"), printed.as_bytes());
    assert!(printed.starts_with("1 1000  # near, far\n"), "{printed}");
}

#[test]
fn a_scene_may_be_written_over_itself() {
    let folder = Folder::with_scene();
    let printed = folder.run("write scene.txt").quiet();
    folder.run("write scene.txt -o scene.txt").quiet();
    assert_eq!(folder.read("scene.txt"), printed.as_bytes());
}

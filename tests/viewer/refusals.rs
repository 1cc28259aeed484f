//! What keeps a window from opening.

use crate::program::{Folder, Run};
use crate::scenes::folder;
use crate::window::program;

/// Runs the program without a window to be seen.
fn view(folder: &Folder, arguments: &str, display: Option<&str>) -> Run {
    let mut command = program(folder);
    command.arg("view").args(arguments.split_whitespace());
    if let Some(display) = display {
        command.env("DISPLAY", display);
    }
    Run::from(command.output().unwrap())
}

#[test]
fn without_a_display_the_message_names_what_needs_none() {
    let folder = folder(32);
    for display in [None, Some(""), Some(":54321"), Some("nonsense")] {
        let refusal = view(&folder, "scene.txt", display).refusal();
        assert!(refusal.contains("`archetrace render`"), "{display:?}: {refusal}");
    }
    assert_eq!(folder.names(), ["scene.txt"]);
}

#[test]
fn a_display_that_only_wayland_has_heard_of_is_refused_as_well() {
    let folder = folder(32);
    let mut command = program(&folder);
    command.args(["view", "scene.txt"]).env("WAYLAND_DISPLAY", "nowhere");
    let refusal = Run::from(command.output().unwrap()).refusal();
    assert!(refusal.contains("`archetrace render`"), "{refusal}");
}

#[test]
fn a_bad_scene_is_told_before_any_window() {
    let folder = folder(32);
    let text = String::from_utf8(folder.read("scene.txt")).unwrap();
    folder.put("scene.txt", text.replacen("sphere   10  20 15  12", "sphere   10  20 15  -12", 1));
    let Run { code, stdout, stderr } = view(&folder, "scene.txt", None);
    assert_eq!((code, stdout.as_str()), (Some(1), ""));
    assert!(stderr.starts_with("error: the sphere's radius is `-12`"), "{stderr}");
    assert!(stderr.contains("--> scene.txt:6:"), "{stderr}");
}

#[test]
fn a_scene_that_is_not_there_is_told_before_any_window() {
    let refusal = view(&folder(32), "nowhere.txt", None).refusal();
    assert!(refusal.contains("nowhere.txt") && !refusal.contains("window"), "{refusal}");
}

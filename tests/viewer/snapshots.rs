//! Key 0: the view as it stands is in a file, and the line that is printed writes the same file again.

use std::fs;

use crate::picture::Picture;
use crate::program::Folder;
use crate::scenes::{folder, scene};
use crate::window::{Window, program};

/// Keys to a view that nobody would type.
const ODD_VIEW: &str = "1 1 3 Up Up 6 w shift+Right ctrl+5 ctrl+Next s s shift+4 3 3 3";

/// What key 0 wrote, and what it printed.
struct Written {
    path: String,
    command: String,
}

#[track_caller]
fn trace(window: &mut Window) -> Written {
    window.key("0");
    window.event("tracing");
    let path = window.words("wrote ");
    Written { path, command: window.words("archetrace render ") }
}

impl Written {
    /// The file, and the one that a shell writes with the printed line, have the same bytes.
    #[track_caller]
    fn check(&self, folder: &Folder) -> Vec<u8> {
        let Self { path, command } = self;
        let again = command.replacen(&format!("--output={path}"), "--output=again.bmp", 1);
        assert_ne!(&again, command);
        folder.bash(&format!("\"$P\" render {again}")).quiet();
        let bytes = folder.read(path);
        assert!(bytes == folder.read("again.bmp"), "{command}");
        fs::remove_file(folder.path("again.bmp")).unwrap();
        bytes
    }
}

/// Presses keys and waits for the view they lead to.
#[track_caller]
fn go(window: &mut Window, keys: &str) {
    for key in keys.split(' ') {
        window.step(key);
    }
}

#[test]
fn the_file_holds_the_view_and_the_line_repeats_it() {
    let folder = folder(64);
    let mut window = Window::open(&folder, "scene.txt");
    let first = trace(&mut window);
    assert_eq!(first.path, "scene-001.bmp");
    assert!(first.check(&folder) == folder.render(""), "the start is what `render` renders");

    go(&mut window, ODD_VIEW);
    let second = trace(&mut window);
    assert_eq!(second.path, "scene-002.bmp");
    let odd = second.check(&folder);
    assert!(odd == folder.render(&window.pose.flags()), "the printed pose is the one of the picture");
    assert!(odd != folder.read("scene-001.bmp"));

    window.key("space");
    window.event("switched");
    let textured = trace(&mut window);
    assert!(textured.command.contains(" --texture"), "{}", textured.command);
    assert!(textured.check(&folder) != odd);
    window.key("space");
    window.event("switched");
    assert!(trace(&mut window).check(&folder) == odd);
    window.close();

    first.check(&folder);
    let pictures =
        ["rendered.bmp", "scene-001.bmp", "scene-002.bmp", "scene-003.bmp", "scene-004.bmp", "scene.txt"];
    assert_eq!(folder.names(), pictures);
}

#[test]
fn single_precision_has_its_own_bytes() {
    let folder = folder(64);
    let mut window = Window::open(&folder, "scene.txt --precision f32 --threads 1");
    let single = trace(&mut window).check(&folder);
    assert!(single == folder.render("--precision f32"));
    assert!(single != folder.render(""), "this view has pixels on the edges of cells");
    go(&mut window, ODD_VIEW);
    let single = trace(&mut window).check(&folder);
    assert!(single == folder.render(&format!("{} --precision f32", window.pose.flags())));
    window.close();
}

#[test]
fn named_textures_are_in_the_line() {
    let folder = folder(64);
    let image = |color| image::RgbImage::from_pixel(2, 2, image::Rgb(color));
    image([200, 30, 10]).save(folder.path("light.bmp")).unwrap();
    image([10, 60, 90]).save(folder.path("dark.bmp")).unwrap();
    let flags = "--texture --white light.bmp --black dark.bmp";
    let mut window = Window::open(&folder, &format!("scene.txt {flags}"));
    let textured = trace(&mut window).check(&folder);
    assert!(textured == folder.render(flags));
    window.key("space");
    assert_eq!(window.event("switched")["on"], false);
    assert!(trace(&mut window).check(&folder) == folder.render(""));
    window.close();
}

#[test]
fn a_file_that_is_there_stays_as_it_is() {
    let folder = folder(32);
    folder.put("scene-001.bmp", "mine");
    folder.put("scene-003.bmp", "mine, too");
    let mut window = Window::open(&folder, "scene.txt");
    let paths = [trace(&mut window), trace(&mut window)].map(|written| written.path);
    assert_eq!(paths, ["scene-002.bmp", "scene-004.bmp"]);
    window.close();
    assert_eq!(
        (folder.read("scene-001.bmp"), folder.read("scene-003.bmp")),
        (b"mine".into(), b"mine, too".into())
    );
}

#[test]
fn the_folder_is_the_one_that_was_named_and_odd_names_are_quoted() {
    let folder = Folder::empty();
    let [place, name] = ["scenes of $HOME", "it's; a \"scene\".txt"];
    fs::create_dir(folder.path(place)).unwrap();
    fs::create_dir(folder.path("out put")).unwrap();
    fs::write(folder.path(place).join(name), scene(32)).unwrap();
    let path = format!("{place}/{name}");
    let mut window = Window::open_with(&[&path, "--out", "out put"], &mut program(&folder));
    window.key("0");
    assert_eq!(window.words("wrote "), "out put/it's; a \"scene\"-001.bmp");
    let command = window.words("archetrace render ");
    window.close();
    let picture = folder.read("out put/it's; a \"scene\"-001.bmp");
    fs::remove_file(folder.path("out put/it's; a \"scene\"-001.bmp")).unwrap();
    folder.bash(&format!("\"$P\" render {command}")).quiet();
    assert!(folder.read("out put/it's; a \"scene\"-001.bmp") == picture);
}

#[test]
fn a_picture_holds_what_was_pressed_before_it_and_nothing_later() {
    let folder = folder(200);
    let mut window = Window::open(&folder, "scene.txt");
    // All of it is there at once when the program goes on.
    window.signal("STOP");
    window.key("Up space 0 Up Up space");
    window.signal("CONT");
    let path = window.words("wrote ");
    let picture = Picture::read(&folder.read(&path));
    let expected = Picture::rendered(&folder, "--eye=0,-145,50 --texture");
    assert!(picture == expected);
    let command = window.words("archetrace render ");
    Written { path, command }.check(&folder);
    window.close();
}

#[test]
fn a_folder_that_is_not_there_is_told_at_once() {
    let folder = folder(32);
    let mut window = Window::open(&folder, "scene.txt --out nowhere");
    window.key("0");
    let event = window.event("failed");
    assert_eq!(event["what"], "trace");
    assert!(event["message"].as_str().unwrap().contains("nowhere"), "{event}");
    // The window goes on.
    window.step("Up");
    assert_eq!(window.unasked(), []);
    window.close();
    assert_eq!(folder.names(), ["scene.txt"]);
}

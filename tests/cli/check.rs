//! `archetrace check`

use crate::program::{Folder, SCENE};

#[test]
fn a_good_scene_is_summed_up() {
    let folder = Folder::with_scene();
    let expected = "\
scene.txt: ok
image    32 x 32 pixels, level 3
camera   near 1, far 1000, fovy 60, aspect 1
objects  1 sphere, 1 cube, 1 pyramid, 1 checkerboard
lights   1 normal, 1 spot
effects  gloss (1), mirror (3), falloff (1), spot_cone (1)
";
    assert_eq!(folder.run("check scene.txt").quiet(), expected);
    assert_eq!(folder.names(), ["scene.txt"]);
}

#[test]
fn an_empty_world_is_summed_up() {
    let folder = Folder::empty();
    folder.put("scene.txt", "0.5 2.25 60.5 1e-6 0 1  1 1 0 0  0 0 0");
    let expected = "\
scene.txt: ok
image    1 x 1 pixels, level 0
camera   near 0.5, far 2.25, fovy 60.5, aspect 0.000001
objects  0 spheres, 0 cubes, 0 pyramids, 1 checkerboard
lights   0 normal, 0 spot
effects  none
";
    assert_eq!(folder.run("check scene.txt").quiet(), expected);
}

#[test]
fn warnings_are_counted() {
    let folder = Folder::empty();
    let one = SCENE.replace("0.2 0.5 0.3", "0.2 0.5 0.4");
    folder.put("one.txt", &one);
    folder.put("two.txt", one.replace("0.3 0.7 0 0", "0.3 0.6 0 0"));
    let run = folder.run("check one.txt");
    assert_eq!(run.code, Some(0));
    assert!(run.stdout.starts_with("one.txt: ok, 1 warning\nimage "), "{run:?}");
    let run = folder.run("check two.txt");
    assert_eq!(run.code, Some(0));
    assert!(run.stdout.starts_with("two.txt: ok, 2 warnings\n"), "{run:?}");
    assert_eq!(run.stderr.matches("warning: ").count(), 2, "{run:?}");
}

#[test]
fn the_error_is_shown_with_its_place() {
    let folder = Folder::empty();
    folder.put("bad.txt", SCENE.replace("12 ", "-12"));
    let run = folder.run("check bad.txt");
    let expected = "\
error: the sphere's radius is `-12`
  --> bad.txt:6:21
  |
6 | sphere   10  20 15  -12    1 0.4 0.2    0.2 0.4 0.3 0.1  20
  |                     ^^^ must be a length from 1e-70 to 1e70
";
    assert_eq!(run.stderr, expected);
    assert_eq!((run.code, run.stdout.as_str()), (Some(1), ""));
}

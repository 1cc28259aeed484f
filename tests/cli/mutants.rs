//! Three hundred broken scenes through the whole program.

use std::fs;

use crate::mutant::mutant;
use crate::program::{Folder, Run, SCENE};

/// Whether a text names a place in a file: `NAME:line:column`.
fn names_a_place(text: &str, name: &str) -> bool {
    text.split(&format!("{name}:")).skip(1).any(|rest| {
        let mut numbers = rest.lines().next().unwrap_or("").split(':');
        let mut number = || numbers.next().is_some_and(|part| part.parse::<usize>().is_ok());
        number() && number()
    })
}

#[test]
fn a_place_is_recognised() {
    assert!(names_a_place(" --> a.txt:12:3\n", "a.txt"));
    for text in ["a.txt: ok", "a.txt:12", "a.txt:x:3", "b.txt:1:2", "a.txt:1: 2"] {
        assert!(!names_a_place(text, "a.txt"), "{text}");
    }
}

/// Renders one mutant; whether it could be.
fn render_mutant(folder: &Folder, seed: u64) -> bool {
    folder.put("mutant.txt", mutant(seed, SCENE));
    // `run` fails on a panic, on a signal and after 20 seconds.
    let Run { code, stdout, stderr } = folder.run("render mutant.txt -o out.bmp --size 16");
    assert_eq!(stdout, "", "seed {seed}");
    if code == Some(0) {
        let picture =
            image::open(folder.path("out.bmp")).unwrap_or_else(|error| panic!("seed {seed}: {error}"));
        assert_eq!((picture.width(), picture.height()), (16, 16), "seed {seed}");
        assert_eq!(folder.read("out.bmp").len(), 54 + 16 * 16 * 3, "seed {seed}");
        assert!(!stderr.contains("error"), "seed {seed}: {stderr}");
        assert_eq!(folder.names(), ["mutant.txt", "out.bmp"], "seed {seed}");
        fs::remove_file(folder.path("out.bmp")).unwrap();
        return true;
    }
    assert_eq!(code, Some(1), "seed {seed}: {stderr}");
    assert!(stderr.starts_with("error: "), "seed {seed}: {stderr}");
    assert!(names_a_place(&stderr, "mutant.txt"), "seed {seed}: {stderr}");
    assert_eq!(folder.names(), ["mutant.txt"], "seed {seed}");
    false
}

#[test]
fn three_hundred_broken_scenes_are_rendered_or_refused_with_a_place() {
    let folder = Folder::empty();
    let rendered = (10_000..10_300).filter(|&seed| render_mutant(&folder, seed)).count();
    // Were all of them rendered, or none, this test would show little.
    assert!((20..200).contains(&rendered), "{rendered} rendered");
}

//! Threads and precision: the first changes no byte, the second next to nothing.

use crate::program::Folder;

#[test]
fn the_number_of_threads_changes_no_byte() {
    let folder = Folder::with_scene();
    // Several tiles, the last ones cut off.
    let one = folder.render("--size 101 --threads 1");
    for threads in [2, 5, 64] {
        assert!(one == folder.render(&format!("--size 101 --threads {threads}")), "{threads} threads");
    }
    assert!(one == folder.render("--size 101"), "as many as there are processors");
    let sampled = folder.render("--size 67 --samples 9 --threads 1");
    assert!(sampled == folder.render("--size 67 --samples 9 --threads 5"), "with samples");
}

#[test]
fn single_precision_gives_nearly_the_same_picture() {
    let folder = Folder::with_scene();
    let double = folder.render("--size 100 --precision f64");
    let single = folder.render("--size 100 --precision f32");
    assert_eq!(double, folder.render("--size 100"));
    assert_eq!(double[..54], single[..54]);
    assert_ne!(double, single, "single precision must differ somewhere");
    let far_off = double.iter().zip(&single).filter(|(a, b)| a.abs_diff(**b) > 2).count();
    assert!(far_off < double.len() / 100, "{far_off} of {}", double.len());
}

#[test]
fn single_precision_is_the_same_for_every_number_of_threads() {
    let folder = Folder::with_scene();
    let one = folder.render("--size 67 --precision f32 --threads 1");
    assert!(one == folder.render("--size 67 --precision f32 --threads 4"));
}

#[test]
fn what_only_double_precision_can_trace_is_refused_by_the_other() {
    let folder = Folder::empty();
    folder.put("scene.txt", "1 1e60 60 1 1 4  1e50 1 0 0  1 sphere 0 1e60 0 1e59 1 1 1 1 0 0 0 1  0 0");
    folder.run("render scene.txt -o out.bmp").quiet();
    let run = folder.run("render scene.txt -o single.bmp --precision f32");
    assert_eq!(run.code, Some(1));
    assert!(run.stderr.starts_with("error: "), "{run:?}");
    assert!(run.stderr.contains("f32"), "{run:?}");
    assert_eq!(folder.names(), ["out.bmp", "scene.txt"]);
}

//! `archetrace preview`: files, exit statuses, messages.

use super::program::{Folder, PROGRAM};

/// Without a display server, whatever this test runs in.
fn run(folder: &Folder, line: &str) -> super::program::Run {
    folder.bash(&format!("unset DISPLAY WAYLAND_DISPLAY; {line}"))
}

#[test]
fn a_picture_is_written_in_both_formats_with_the_same_pixels() {
    let folder = Folder::with_scene();
    run(&folder, "$P preview scene.txt -o a.png && $P preview scene.txt -o b.bmp").quiet();
    let open = |name: &str| image::open(folder.path(name)).unwrap().into_rgb8();
    let (png, bmp) = (open("a.png"), open("b.bmp"));
    assert_eq!(png.dimensions(), (32, 32));
    assert_eq!(png, bmp);
    assert_eq!(folder.names(), ["a.png", "b.bmp", "scene.txt"]);
}

#[test]
fn every_flag_changes_the_picture_as_it_says() {
    let folder = Folder::with_scene();
    let draw = |flags: &str| {
        run(&folder, &format!("$P preview scene.txt -o p.png --size 120 {flags}")).quiet();
        image::open(folder.path("p.png")).unwrap().into_rgb8()
    };
    let usual = draw("");
    assert_eq!(usual.dimensions(), (120, 120));
    for flags in
        ["--eye 0,-150,80", "--look=0.1,1,-0.2", "--up 0.2,0,1", "--texture", "--lights", "--axes", "--plain"]
    {
        assert_ne!(draw(flags), usual, "{flags}");
    }
    // One sample a pixel: own colours of the scene, and greys of the board.
    let own: [[u8; 3]; 3] = [[255, 102, 51], [76, 204, 102], [51, 102, 255]];
    let plain = draw("--plain");
    for pixel in plain.pixels() {
        let [red, green, blue] = pixel.0;
        assert!(own.contains(&pixel.0) || (red == green && green == blue), "{pixel:?}");
    }
    assert_eq!(draw(""), usual, "the same flags give the same picture");
}

#[test]
fn the_camera_is_that_of_render() {
    let folder = Folder::with_scene();
    let camera = "--eye=90,-60,70 --look=-1,0.8,-0.6 --up 0,0.1,1 --size 160";
    run(&folder, &format!("$P preview scene.txt -o p.png --plain {camera}")).quiet();
    run(&folder, &format!("$P render scene.txt -o r.png --level 1 {camera}")).quiet();
    let open = |name: &str| image::open(folder.path(name)).unwrap().into_rgb8();
    let (preview, traced) = (open("p.png"), open("r.png"));
    // Where the trace is black the preview shows nothing or a black cell, and nothing of the objects.
    let dark = traced.pixels().zip(preview.pixels()).filter(|(traced, _)| traced.0 == [0; 3]);
    let (dark, coloured) = dark.fold((0, 0), |(dark, coloured), (_, preview)| {
        let [red, green, blue] = preview.0;
        (dark + 1, coloured + u32::from(red != green || green != blue))
    });
    assert!(dark > 2000 && coloured == 0, "{dark} dark, {coloured} of them coloured");
}

#[test]
fn what_cannot_be_done_is_refused_before_a_file_is_touched() {
    let folder = Folder::with_scene();
    folder.put("bad.txt", "nonsense");
    let failed = run(&folder, "$P preview bad.txt -o p.png");
    assert_eq!(failed.code, Some(1));
    assert!(failed.stderr.contains("bad.txt:1:1"), "{failed:?}");
    let missing = run(&folder, "$P preview none.txt -o p.png").refusal();
    assert!(missing.contains("cannot read none.txt"), "{missing}");
    let nowhere = run(&folder, "$P preview scene.txt -o none/p.png").refusal();
    assert!(nowhere.contains("cannot write none/p.png"), "{nowhere}");
    assert_eq!(folder.names(), ["bad.txt", "scene.txt"]);
}

#[test]
fn arguments_that_make_no_sense_are_misuse() {
    let folder = Folder::with_scene();
    for arguments in [
        "",
        "scene.txt",
        "scene.txt -o p.jpg",
        "scene.txt -o p.png --size 0",
        "scene.txt -o p.png --size 8193",
        "scene.txt -o p.png --look 0,0,0",
        "scene.txt -o p.png --white w.bmp",
        "scene.txt -o p.png --level 3",
    ] {
        run(&folder, &format!("$P preview {arguments}")).misuse();
    }
    assert_eq!(folder.names(), ["scene.txt"]);
}

#[test]
fn without_a_driver_the_message_names_what_to_do() {
    let folder = Folder::with_scene();
    // No vendor's library is found there.
    let message = run(&folder, "__EGL_VENDOR_LIBRARY_DIRS=/none $P preview scene.txt -o p.png").refusal();
    assert!(message.contains("cannot draw off screen"), "{message}");
    assert!(message.contains("`archetrace render`"), "{message}");
    assert_eq!(folder.names(), ["scene.txt"]);
    assert!(std::path::Path::new(PROGRAM).exists());
}

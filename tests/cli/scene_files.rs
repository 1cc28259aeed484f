//! Scene files that cannot be used: status 1, quickly, in little memory, with one clear message, and no picture.

use std::fs::File;
use std::process::Command;

use crate::program::{Folder, Run, SCENE};

/// Every command on a scene.
fn commands(scene: &str) -> [String; 3] {
    [format!("check {scene}"), format!("write {scene} -o out.txt"), format!("render {scene} -o out.bmp")]
}

/// Runs the program with so many kilobytes of address space and ten seconds of processor time: whatever else the machine
/// does, no more is taken.
fn bounded(folder: &Folder, kilobytes: u32, arguments: &str) -> Run {
    folder.bash(&format!("ulimit -v {kilobytes}; ulimit -t 10; exec $P {arguments}"))
}

/// Runs every command on a scene that is no file; each must say so in one line that ends like this.
fn refused_by_all(folder: &Folder, scene: &str, reason: &str) {
    let before = folder.names();
    for command in commands(scene) {
        let line = bounded(folder, 1_000_000, &command).refusal();
        assert_eq!(line, format!("error: cannot read {scene}: {reason}"), "{command}");
    }
    assert_eq!(folder.names(), before);
}

#[test]
fn a_missing_scene_is_refused() {
    refused_by_all(&Folder::empty(), "none.txt", "No such file or directory (os error 2)");
}

#[test]
fn a_folder_is_no_scene() {
    refused_by_all(&Folder::empty(), ".", "not a regular file");
}

#[test]
fn a_pipe_is_no_scene_and_nobody_waits_for_it() {
    let folder = Folder::empty();
    let made = Command::new("mkfifo").arg(folder.path("pipe")).status().unwrap();
    assert!(made.success());
    refused_by_all(&folder, "pipe", "not a regular file");
}

#[test]
fn a_device_is_no_scene() {
    refused_by_all(&Folder::empty(), "/dev/zero", "not a regular file");
}

#[test]
fn a_file_in_a_file_is_no_scene() {
    refused_by_all(&Folder::with_scene(), "scene.txt/scene.txt", "Not a directory (os error 20)");
}

#[test]
fn a_file_of_gigabytes_is_no_scene() {
    let folder = Folder::empty();
    let file = File::create(folder.path("large.txt")).unwrap();
    file.set_len(10 << 30).unwrap();
    refused_by_all(&folder, "large.txt", "larger than 268435456 bytes");
}

#[test]
fn a_hundred_megabytes_that_are_no_scene_are_refused_in_bounded_memory() {
    let folder = Folder::empty();
    let noise = |index: u32| index.wrapping_mul(0x9E37_79B9).to_le_bytes()[3];
    let noise: Vec<u8> = (0..100_000_000).map(noise).collect();
    for content in [noise, b"1 ".repeat(50_000_000)] {
        folder.put("large.txt", content);
        let run = bounded(&folder, 1_000_000, "render large.txt -o out.bmp");
        assert_eq!(run.code, Some(1));
        assert!(run.stderr.starts_with("error: "), "{}", &run.stderr[..200]);
        assert!(run.stderr.len() < 20_000);
    }
    assert_eq!(folder.names(), ["large.txt"]);
}

/// A scene that is refused for what it holds, by every command with the same words.
fn malformed(content: &[u8]) -> String {
    let folder = Folder::empty();
    folder.put("scene.txt", content);
    let runs = commands("scene.txt").map(|command| folder.run(&command));
    assert_eq!(folder.names(), ["scene.txt"]);
    for Run { code, stdout, stderr } in &runs {
        assert_eq!((*code, stdout.as_str()), (Some(1), ""));
        assert_eq!(*stderr, runs[0].stderr);
        assert!(stderr.starts_with("error: ") && stderr.ends_with('\n'), "{stderr}");
    }
    runs[0].stderr.clone()
}

#[test]
fn an_empty_scene_is_refused() {
    for content in ["", "\n", "# nothing\n", "\u{feff}"] {
        let said = malformed(content.as_bytes());
        assert_eq!(said.matches("error: ").count(), 1, "{said}");
        assert!(
            said.starts_with("error: the file ends where the distance of the near plane should be\n"),
            "{said}"
        );
        assert!(said.contains("scene.txt:1:"), "{said}");
    }
}

#[test]
fn a_scene_that_is_not_text_is_refused_where_it_is_not() {
    let said = malformed(b"1 1000\n60 \xff\xfe\x00\x80 3\n");
    assert!(said.contains("scene.txt:2:4\n"), "{said}");
    assert!(!said.contains('\0'), "{said:?}");
    malformed(&[0xff; 100_000]);
    malformed(&[0; 100_000]);
}

#[test]
fn prose_that_is_not_text_is_no_matter() {
    let folder = Folder::with_scene();
    let mut content = SCENE.as_bytes().to_vec();
    content.extend(b"\nErkl\xe4rung \xff\x00");
    folder.put("prose.txt", content);
    folder.run("render prose.txt -o prose.bmp").quiet();
    assert_eq!(folder.read("prose.bmp"), folder.render(""));
}

#[test]
fn absurd_counts_cost_no_memory() {
    let folder = Folder::empty();
    for (content, place) in [
        ("1 2 60 1 0 1\n1 1 0 0\n4000000000", "scene.txt:3:1"),
        ("1 2 60 1 0 1\n1 1 0 0\n2000000", "scene.txt:3:8"),
        ("1 2 60 1 0 1\n1 1 0 0\n0 4294967295", "scene.txt:3:3"),
        ("1 2 60 1 0 4294967295\n1 1 0 0\n0 0 0", "scene.txt:1:12"),
        ("1 2 60 1 4294967295 1\n1 1 0 0\n0 0 0", "scene.txt:1:10"),
    ] {
        folder.put("scene.txt", content);
        // 200 MB of address space is enough to say no.
        let run = bounded(&folder, 200_000, "render scene.txt -o out.bmp");
        assert_eq!(run.code, Some(1), "{run:?}");
        assert!(run.stderr.contains(place), "{content}: {run:?}");
    }
    assert_eq!(folder.names(), ["scene.txt"]);
}

#[test]
fn warnings_do_not_keep_the_picture_from_being_made() {
    let folder = Folder::with_scene();
    folder.put("warned.txt", SCENE.replace("0.2 0.5 0.3", "0.2 0.5 0.4"));
    let run = folder.run("render warned.txt -o warned.bmp");
    assert_eq!((run.code, run.stdout.as_str()), (Some(0), ""));
    assert_eq!(run.stderr.matches("warning: ").count(), 1, "{run:?}");
    assert!(run.stderr.starts_with("warning: the coefficients add up to 1.1\n"), "{run:?}");
    assert!(run.stderr.contains("warned.txt:4:5\n"), "{run:?}");
    assert!(!run.stderr.contains("error"), "{run:?}");
    assert_eq!(folder.read("warned.bmp").len(), folder.render("").len());
    let run = folder.run("write warned.txt");
    assert_eq!(run.code, Some(0));
    assert_eq!(run.stderr.matches("warning: ").count(), 1, "{run:?}");
    assert!(!run.stdout.contains("warning"), "{run:?}");
}

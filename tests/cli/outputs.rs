//! Files that cannot be written: status 1, one line, and the folder is as it was before.

use std::fs;
use std::os::unix::fs::{FileTypeExt, PermissionsExt};
use std::process::Command;

use crate::program::Folder;

/// A folder with a scene and an old picture that must survive.
fn folder_with_old_picture() -> Folder {
    let folder = Folder::with_scene();
    folder.put("old.bmp", "an old picture");
    folder
}

#[track_caller]
fn assert_untouched(folder: &Folder) {
    assert_eq!(folder.names(), ["old.bmp", "scene.txt"]);
    assert_eq!(folder.read("old.bmp"), b"an old picture");
}

/// One line that names the file asked for, and no other.
#[track_caller]
fn assert_about(line: &str, path: &str) {
    assert!(line.starts_with(&format!("error: cannot write {path}: ")), "{line}");
    assert!(!line.contains(".archetrace-"), "names a temporary file: {line}");
}

#[test]
fn a_missing_folder_is_refused() {
    let folder = folder_with_old_picture();
    for command in [
        "render scene.txt -o none/out.bmp",
        "render scene.txt -o out.bmp --stats none/out.bmp",
        "write scene.txt -o none/out.bmp",
    ] {
        let line = folder.run(command).refusal();
        assert_about(&line, "none/out.bmp");
        assert!(line.contains("No such file or directory"), "{command}: {line}");
        assert_untouched(&folder);
    }
}

#[test]
fn a_folder_that_takes_no_files_is_refused() {
    let folder = folder_with_old_picture();
    for command in ["render scene.txt -o /proc/out.bmp", "write scene.txt -o /proc/out.bmp"] {
        assert_about(&folder.run(command).refusal(), "/proc/out.bmp");
        assert_untouched(&folder);
    }
}

#[test]
fn a_file_is_no_folder() {
    let folder = folder_with_old_picture();
    let line = folder.run("render scene.txt -o scene.txt/out.bmp").refusal();
    assert_about(&line, "scene.txt/out.bmp");
    assert!(line.to_lowercase().contains("not a directory"), "{line}");
    assert_untouched(&folder);
}

#[test]
fn a_folder_is_no_target() {
    let folder = Folder::with_scene();
    fs::create_dir(folder.path("out.bmp")).unwrap();
    for command in [
        "render scene.txt -o out.bmp",
        "render scene.txt -o pic.bmp --stats out.bmp",
        "write scene.txt -o out.bmp",
    ] {
        let line = folder.run(command).refusal();
        assert_eq!(line, "error: cannot write out.bmp: is a directory", "{command}");
        assert_eq!(folder.names(), ["out.bmp", "scene.txt"]);
    }
    assert_eq!(fs::read_dir(folder.path("out.bmp")).unwrap().count(), 0);
}

#[test]
fn a_protected_file_is_left_alone() {
    let folder = folder_with_old_picture();
    fs::set_permissions(folder.path("old.bmp"), PermissionsExt::from_mode(0o444)).unwrap();
    for command in [
        "render scene.txt -o old.bmp",
        "render scene.txt -o out.bmp --stats old.bmp",
        "write scene.txt -o old.bmp",
    ] {
        let line = folder.run(command).refusal();
        assert_eq!(line, "error: cannot write old.bmp: is read-only", "{command}");
        assert_untouched(&folder);
    }
}

#[test]
fn a_pipe_is_not_replaced_by_a_file() {
    // Were it, then `-o /dev/null` by root would put a file where the device was.
    let folder = Folder::with_scene();
    let made = Command::new("mkfifo").arg(folder.path("pipe.bmp")).status().unwrap();
    assert!(made.success());
    for command in [
        "render scene.txt -o pipe.bmp",
        "render scene.txt -o out.bmp --stats pipe.bmp",
        "write scene.txt -o pipe.bmp",
    ] {
        folder.run(command);
        let kind = fs::symlink_metadata(folder.path("pipe.bmp")).unwrap().file_type();
        assert!(kind.is_fifo(), "{command}: is now {kind:?}");
    }
}

#[test]
fn a_disk_that_fills_up_leaves_nothing_behind() {
    let folder = folder_with_old_picture();
    // No file may grow beyond 1 KiB; without the trap the signal would end the process.
    for command in [
        "render scene.txt -o out.bmp",
        "render scene.txt -o out.png --size 100",
        "render scene.txt -o old.bmp",
    ] {
        let run = folder.bash(&format!("trap '' XFSZ; ulimit -f 1; exec $P {command}"));
        let line = run.refusal();
        let target = command.split(' ').nth(3).unwrap();
        assert_about(&line, target);
        assert!(line.contains("File too large"), "{line}");
        assert_untouched(&folder);
    }
}

#[test]
fn a_scene_that_fails_leaves_an_old_picture_alone() {
    let folder = folder_with_old_picture();
    folder.put("scene.txt", "nonsense");
    assert_eq!(folder.run("render scene.txt -o old.bmp").code, Some(1));
    assert_eq!(folder.run("write scene.txt -o old.bmp").code, Some(1));
    assert_untouched(&folder);
}

#[test]
fn wrong_arguments_leave_an_old_picture_alone() {
    let folder = folder_with_old_picture();
    folder.run("render scene.txt -o old.bmp --size 0").misuse();
    assert_untouched(&folder);
}

#[test]
fn an_old_picture_is_replaced_whole() {
    let folder = folder_with_old_picture();
    folder.put("old.bmp", vec![7; 100_000]);
    folder.run("render scene.txt -o old.bmp").quiet();
    assert_eq!(folder.names(), ["old.bmp", "scene.txt"]);
    assert_eq!(folder.read("old.bmp"), folder.render(""));
}

#[test]
fn a_target_may_be_anywhere() {
    let folder = Folder::with_scene();
    fs::create_dir(folder.path("deeper")).unwrap();
    let expected = folder.render("");
    for target in ["here.bmp", "./here2.bmp", "deeper/there.bmp", "deeper/../back.bmp"] {
        folder.run(&format!("render scene.txt -o {target}")).quiet();
        assert_eq!(folder.read(target), expected, "{target}");
    }
    let absolute = folder.path("absolute.bmp");
    folder.run(&format!("render scene.txt -o {}", absolute.display())).quiet();
    assert_eq!(folder.read("absolute.bmp"), expected);
    let spaced = "a name with blanks é.bmp";
    folder.run_list(&["render", "scene.txt", "-o", spaced]).quiet();
    assert_eq!(folder.read(spaced), expected);
}

#[test]
fn the_umask_decides_who_may_read() {
    let folder = Folder::with_scene();
    for (umask, mode) in [("022", 0o644), ("077", 0o600), ("002", 0o664)] {
        let line = format!(
            "umask {umask}; $P render scene.txt -o {umask}.bmp --stats {umask}.json && $P write scene.txt -o {umask}.txt"
        );
        folder.bash(&line).quiet();
        for ending in ["bmp", "json", "txt"] {
            let path = folder.path(&format!("{umask}.{ending}"));
            let found = fs::metadata(path).unwrap().permissions().mode();
            assert_eq!(found & 0o7777, mode, "umask {umask}, {ending}");
        }
    }
}

//! Standard output and standard error: what goes where, and what if nobody reads.

use std::process::{Command, Stdio};

use crate::program::{Folder, PROGRAM, Run, SCENE};

#[test]
fn without_a_terminal_there_is_no_progress_bar() {
    let folder = Folder::with_scene();
    // Long enough that a bar would be drawn.
    let run = folder.run("render scene.txt -o out.bmp --size 300");
    assert_eq!((run.stdout.as_str(), run.stderr.as_str()), ("", ""));
}

#[test]
fn on_a_terminal_there_is_a_progress_bar_that_goes_away() {
    let folder = Folder::with_scene();
    let run = folder.bash("script -qec \"$P render scene.txt -o out.bmp --size 300\" /dev/null </dev/null");
    assert_eq!(run.code, Some(0), "{run:?}");
    assert!(run.stdout.contains("tracing "), "{run:?}");
    let last = run.stdout.rsplit('\r').next().unwrap();
    assert!(!last.contains("tracing"), "the bar is left behind: {last:?}");
}

/// Runs the program with a standard output that nobody reads any more.
fn unread(folder: &Folder, arguments: &str) -> Run {
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    let child = Command::new(PROGRAM)
        .args(arguments.split(' '))
        .current_dir(folder.path(""))
        .stdout(writer)
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    child.wait_with_output().unwrap().into()
}

#[test]
fn output_that_nobody_reads_is_no_failure() {
    let folder = Folder::with_scene();
    for arguments in ["check scene.txt", "write scene.txt", "--help", "render --help", "--version"] {
        let run = unread(&folder, arguments);
        assert_eq!((run.code, run.stderr.as_str()), (Some(0), ""), "{arguments}");
    }
}

#[test]
fn a_reader_may_stop_early() {
    let folder = Folder::empty();
    let object = "sphere 0 0 0 1  1 1 1  1 0 0 0  1\n";
    folder.put("scene.txt", format!("1 2 60 1 0 1  1 1 0 0  20000 {} 0 0", object.repeat(20_000)));
    let run = folder.bash("$P write scene.txt | head -1; echo ${PIPESTATUS[0]}");
    assert_eq!(run.stdout, "1 2  # near, far\n0\n");
    assert_eq!(run.stderr, "");
    let run = folder.bash("$P check scene.txt | true; echo ${PIPESTATUS[0]}");
    assert_eq!((run.stdout.as_str(), run.stderr.as_str()), ("0\n", ""));
}

#[test]
fn a_full_device_as_output_is_a_failure() {
    let folder = Folder::with_scene();
    for command in ["check scene.txt", "write scene.txt"] {
        let line = folder.bash(&format!("$P {command} >/dev/full")).refusal();
        assert!(
            line.starts_with("error: cannot write to standard output: No space left on device"),
            "{line}"
        );
    }
}

#[test]
fn nobody_listening_to_errors_changes_no_status() {
    let folder = Folder::with_scene();
    folder.put("bad.txt", "@");
    folder.put("warned.txt", SCENE.replace("0.2 0.5 0.3", "0.2 0.5 0.4"));
    for end in ["2>/dev/full", "2>&-", "2> >(true)", ">&- 2>&-", "<&- >&- 2>&-"] {
        for (command, status) in [
            ("check bad.txt", 1),
            ("render bad.txt -o out.bmp", 1),
            ("render none.txt -o out.bmp", 1),
            ("render warned.txt -o out.bmp", 0),
            ("render warned.txt", 2),
        ] {
            let run = folder.bash(&format!("$P {command} {end}"));
            assert_eq!(run.code, Some(status), "{command} {end}: {run:?}");
        }
    }
}

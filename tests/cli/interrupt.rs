//! Ctrl-C and a request to end, during a long render.

use std::io::Read;
use std::process::{Child, Command, Stdio};
use std::sync::Mutex;
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::program::{Folder, PROGRAM};

/// One at a time: each fills more than a gigabyte.
static TURN: Mutex<()> = Mutex::new(());

/// Minutes of work, unless somebody ends it; back when the tracing has begun.
fn long_render(folder: &Folder) -> Child {
    let child = Command::new(PROGRAM)
        .args("render scene.txt -o big.bmp --size 8192 --samples 256 --level 3 --stats big.json".split(' '))
        .current_dir(folder.path(""))
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // Getting the memory for the film alone may take two seconds.
    sleep(Duration::from_secs(3));
    child
}

fn send(child: &Child, signal: &str) {
    let sent = Command::new("kill").args([signal, &child.id().to_string()]).status().unwrap();
    assert!(sent.success());
}

/// Waits for the end, which must come within seconds; the exit status and how long it took.
fn wait(child: &mut Child) -> (Option<i32>, Duration) {
    let start = Instant::now();
    loop {
        if let Some(status) = child.try_wait().unwrap() {
            return (status.code(), start.elapsed());
        }
        if start.elapsed() > Duration::from_secs(20) {
            child.kill().unwrap();
            panic!("did not end");
        }
        sleep(Duration::from_millis(5));
    }
}

/// Interrupts a render; gives back how long it took to end.
fn interrupt(signal: &str) -> Duration {
    let _turn = TURN.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    let folder = Folder::with_scene();
    folder.put("big.bmp", "an old picture");
    let mut child = long_render(&folder);
    assert!(child.try_wait().unwrap().is_none(), "the render was over too soon");
    send(&child, signal);
    let (code, taken) = wait(&mut child);
    assert_eq!(code, Some(1));
    let (mut said, mut printed) = (String::new(), String::new());
    child.stderr.take().unwrap().read_to_string(&mut said).unwrap();
    child.stdout.take().unwrap().read_to_string(&mut printed).unwrap();
    assert_eq!(said, "error: interrupted; big.bmp was not written\n");
    assert_eq!(printed, "");
    assert_eq!(folder.names(), ["big.bmp", "scene.txt"]);
    assert_eq!(folder.read("big.bmp"), b"an old picture");
    taken
}

#[test]
fn a_request_to_end_leaves_one_line_and_no_file() {
    interrupt("-TERM");
}

#[test]
fn ctrl_c_leaves_one_line_and_no_file_promptly() {
    let taken = interrupt("-INT");
    assert!(taken < Duration::from_secs(2), "took {taken:?}");
}

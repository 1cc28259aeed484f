use std::fs;
use std::time::{Duration, Instant};

use tempfile::TempDir;

use crate::components::Precision::{self, F32, F64};

use super::super::live::{Live, LiveRequest, Shows};
use super::super::test_views::{heavy, official, rendered, view, workers};
use super::*;
use crate::components::{Adaptive, Cutoff};
use crate::trace::SampleGrid;

const PIXELS: u32 = 90;

fn request(folder: &TempDir, precision: Precision, grid: u32) -> SnapshotRequest {
    SnapshotRequest {
        view: view(&mut official(), precision),
        pixels: PIXELS,
        samples: Samples::of(SampleGrid::new(grid)),
        folder: folder.path().to_owned(),
        stem: "scene".into(),
    }
}

/// Of seconds: whatever is done meanwhile is done first.
fn heavy_request(folder: &TempDir) -> SnapshotRequest {
    SnapshotRequest { view: view(&mut heavy(), F64), pixels: 1024, ..request(folder, F64, 8) }
}

fn snapshots() -> Snapshots {
    Snapshots::new(&workers(), || ())
}

fn names_in(folder: &TempDir) -> Vec<String> {
    let entries = fs::read_dir(folder.path()).unwrap();
    let mut names: Vec<String> =
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

/// Waits for the end, looking at the progress.
fn wait(snapshots: &mut Snapshots) -> Outcome {
    let start = Instant::now();
    let mut progress = 0.0;
    loop {
        let now = snapshots.progress().expect("something is being traced");
        assert!((progress..=1.0).contains(&now), "{now} after {progress}");
        progress = now;
        if let Some(outcome) = snapshots.finished() {
            assert_eq!(snapshots.progress(), None);
            assert_eq!(snapshots.finished(), None);
            return outcome;
        }
        assert!(start.elapsed() < Duration::from_secs(60), "no end, at {now}");
        thread::sleep(Duration::from_millis(1));
    }
}

fn written(snapshots: &mut Snapshots, request: SnapshotRequest) -> PathBuf {
    snapshots.start(request).unwrap();
    match wait(snapshots) {
        Outcome::Written(path) => path,
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_file_holds_the_bytes_that_render_writes() {
    let folder = tempfile::tempdir().unwrap();
    let mut snapshots = snapshots();
    for (number, (precision, grid)) in (1..).zip([(F64, 1), (F32, 1), (F64, 3), (F32, 2)]) {
        let path = written(&mut snapshots, request(&folder, precision, grid));
        assert_eq!(path, folder.path().join(format!("scene-00{number}.bmp")));
        let (film, _) = rendered(official(), precision, PIXELS, grid);
        let expected = encode(&film, &path).unwrap();
        assert!(fs::read(&path).unwrap() == expected, "{precision:?}, {grid} by {grid} samples");
    }
    assert_eq!(names_in(&folder).len(), 4);
}

#[test]
fn adaptive_samples_and_a_cutoff_are_those_of_render() {
    let folder = tempfile::tempdir().unwrap();
    let mut world = official();
    world.insert_resource(Adaptive { threshold: 1.0 / 128.0 });
    world.insert_resource(Cutoff(0.1));
    let samples = Samples { grid: SampleGrid::new(5), threshold: Some(1.0 / 128.0) };
    let what = SnapshotRequest { view: view(&mut world, F64), samples, ..request(&folder, F64, 1) };
    let path = written(&mut snapshots(), what);
    let (film, _) = rendered(world, F64, PIXELS, 5);
    assert!(fs::read(&path).unwrap() == encode(&film, &path).unwrap());
}

#[test]
fn no_file_is_replaced() {
    let folder = tempfile::tempdir().unwrap();
    let taken = folder.path().join("scene-001.bmp");
    fs::write(&taken, "an old picture").unwrap();
    let path = written(&mut snapshots(), request(&folder, F64, 1));
    assert_eq!(path, folder.path().join("scene-002.bmp"));
    assert_eq!(fs::read(taken).unwrap(), b"an old picture");
}

#[test]
fn the_names_count_on() {
    let all: Vec<OsString> = names(OsStr::new("a b")).take(1001).collect();
    assert_eq!([&all[0], &all[98], &all[999]], ["a b-001.bmp", "a b-099.bmp", "a b-1000.bmp"]);
}

#[test]
fn one_is_traced_at_a_time_and_can_be_cancelled() {
    let folder = tempfile::tempdir().unwrap();
    let mut snapshots = snapshots();
    snapshots.start(heavy_request(&folder)).unwrap();
    let refusal = snapshots.start(request(&folder, F64, 1)).unwrap_err();
    assert_eq!(refusal.to_string(), "a picture is being traced already");
    let start = Instant::now();
    snapshots.cancel();
    assert_eq!(wait(&mut snapshots), Outcome::Cancelled);
    assert!(start.elapsed() < Duration::from_secs(2), "took {:?}", start.elapsed());
    assert_eq!(names_in(&folder), [""; 0]);
    written(&mut snapshots, request(&folder, F64, 1));
}

#[test]
fn dropping_it_leaves_no_file_and_no_thread() {
    let folder = tempfile::tempdir().unwrap();
    let (sender, wakes) = mpsc::channel::<()>();
    let wake = move || {
        let _ = sender.send(());
    };
    let mut snapshots = Snapshots::new(&workers(), wake);
    snapshots.start(heavy_request(&folder)).unwrap();
    let start = Instant::now();
    drop(snapshots);
    assert!(start.elapsed() < Duration::from_secs(2), "took {:?}", start.elapsed());
    assert_eq!(names_in(&folder), [""; 0]);
    // Only the thread had the other end.
    while wakes.try_recv().is_ok() {}
    assert_eq!(wakes.try_recv(), Err(TryRecvError::Disconnected));
}

#[test]
fn a_folder_that_takes_no_file_is_told_before_the_tracing() {
    let folder = tempfile::tempdir().unwrap();
    let nowhere = folder.path().join("none");
    let refusal = snapshots().start(SnapshotRequest { folder: nowhere.clone(), ..heavy_request(&folder) });
    let message = refusal.unwrap_err().to_string();
    assert!(message.starts_with(&format!("cannot write {}: ", nowhere.display())), "{message}");
}

#[test]
fn a_folder_that_goes_away_meanwhile_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let inner = folder.path().join("inner");
    fs::create_dir(&inner).unwrap();
    let mut snapshots = snapshots();
    let what = SnapshotRequest { folder: inner.clone(), pixels: 600, ..request(&folder, F64, 3) };
    snapshots.start(what).unwrap();
    fs::remove_dir(&inner).unwrap();
    let Outcome::Failed(message) = wait(&mut snapshots) else { panic!("written to nowhere") };
    assert!(message.starts_with(&format!("cannot write {}: ", inner.display())), "{message}");
}

#[test]
fn a_picture_too_large_for_the_memory_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let mut snapshots = snapshots();
    snapshots.start(SnapshotRequest { pixels: u32::MAX, ..request(&folder, F64, 1) }).unwrap();
    let Outcome::Failed(message) = wait(&mut snapshots) else { panic!("so much memory there is nowhere") };
    assert!(message.starts_with("no memory for a picture of 4294967295 x 4294967295"), "{message}");
    assert_eq!(names_in(&folder), [""; 0]);
}

#[test]
fn the_window_is_woken_by_progress_and_not_by_every_tile() {
    let folder = tempfile::tempdir().unwrap();
    let (sender, wakes) = mpsc::channel::<()>();
    let wake = move || {
        let _ = sender.send(());
    };
    let mut snapshots = Snapshots::new(&workers(), wake);
    written(&mut snapshots, SnapshotRequest { pixels: 640, ..request(&folder, F64, 3) });
    // 3600 tiles; one more after the last hundredth.
    assert_eq!(wakes.iter().take(101).count(), 101);
    drop(snapshots);
    assert_eq!(wakes.iter().count(), 0);
}

#[test]
fn the_live_trace_goes_on_meanwhile() {
    let folder = tempfile::tempdir().unwrap();
    let mut snapshots = snapshots();
    snapshots.start(heavy_request(&folder)).unwrap();
    let live = Live::new(workers(), || ()).unwrap();
    let (samples, shows) = (Samples::of(SampleGrid::new(3)), Shows::Picture);
    live.request(LiveRequest { view: view(&mut official(), F64), side: PIXELS, samples, shows });
    let mut last = None;
    while let Some(shown) = live.wait(Duration::from_secs(10)) {
        last = Some(shown.unwrap());
    }
    assert!(last.is_some_and(|last| last.is_final && last.side == PIXELS));
    assert!(snapshots.progress().is_some_and(|progress| progress < 1.0), "the picture was there first");
}

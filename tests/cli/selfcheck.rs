//! `archetrace selfcheck`: one line a group and precision, all good on this machine.

use crate::program::Folder;

#[test]
fn every_group_is_good_in_both_precisions() {
    let folder = Folder::empty();
    let run = folder.run("selfcheck");
    assert_eq!((run.code, run.stderr.as_str()), (Some(0), ""), "{}", run.stdout);
    let lines: Vec<&str> = run.stdout.lines().collect();
    assert!(lines[0].starts_with("seed 0x"), "{}", run.stdout);
    assert!(lines[1].contains("leaks"), "{}", run.stdout);
    let groups = &lines[2..];
    assert_eq!(groups.len(), 18, "{}", run.stdout);
    assert!(groups.iter().all(|line| line.ends_with("  good")), "{}", run.stdout);
    for precision in [" f64 ", " f32 "] {
        assert_eq!(groups.iter().filter(|line| line.contains(precision)).count(), 9);
    }
    assert!(groups.iter().any(|line| line.starts_with("pixels, on every path")));
    assert!(folder.names().is_empty());
}

#[test]
fn it_says_the_same_again() {
    let folder = Folder::empty();
    assert_eq!(folder.run("selfcheck").stdout, folder.run("selfcheck").stdout);
}

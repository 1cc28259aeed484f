//! The list of hard cases in `hard_cases.md` is whole, and every test that it names is there.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on should say so and stop")]

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// Groups and the numbers of their cases.
const GROUPS: [(char, u32); 9] =
    [('S', 25), ('B', 12), ('P', 10), ('C', 15), ('R', 12), ('L', 18), ('K', 10), ('Q', 8), ('E', 6)];

/// Id and text of each row.
fn rows(list: &str) -> Vec<(&str, &str)> {
    let cells = |line: &str| line.strip_prefix("| ").is_some_and(|row| row.starts_with(char::is_uppercase));
    list.lines().filter(|line| cells(line)).filter_map(|line| line[2..].split_once(" | ")).collect()
}

/// The tests that a row names, as file and function.
fn named_tests(row: &str) -> Vec<(&str, &str)> {
    row.split('`').skip(1).step_by(2).filter_map(|name| name.split_once("::")).collect()
}

/// Whether a file of this folder has a test of this name.
fn has_test(file: &str, name: &str) -> bool {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests").join(file);
    let source = fs::read_to_string(path).unwrap_or_default();
    source.contains(&format!("#[test]\nfn {name}()"))
}

const LIST: &str = include_str!("hard_cases.md");

#[test]
fn every_case_is_listed_once() {
    let listed: Vec<&str> = rows(LIST).into_iter().map(|(id, _)| id).collect();
    let ids = GROUPS.iter().flat_map(|&(group, count)| (1..=count).map(move |n| format!("{group}{n:02}")));
    let expected: BTreeSet<String> = ids.collect();
    assert_eq!(listed.iter().map(|&id| id.to_owned()).collect::<BTreeSet<_>>(), expected);
    assert_eq!(listed.len(), expected.len());
}

#[test]
fn every_case_has_its_tests() {
    for (id, row) in rows(LIST) {
        let tests = named_tests(row);
        assert!(!tests.is_empty(), "{id} has no test");
        for (file, name) in tests {
            assert!(has_test(file, name), "{id}: no test `{name}` in tests/{file}");
        }
    }
}

#[test]
fn what_is_not_there_is_not_found() {
    assert!(!has_test("hard_cases.rs", "every_case"));
    assert!(!has_test("none.rs", "every_case_is_listed_once"));
    assert!(has_test("hard_cases.rs", "every_case_is_listed_once"));
}

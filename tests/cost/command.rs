//! The report of the program itself, opened.

use std::fs;
use std::process::Command;

use serde_json::json;

use crate::browser::Opened;
use crate::page::has_numbers_of;
use crate::tables::problems;

#[test]
fn the_program_writes_a_page_that_is_as_promised() {
    let folder = tempfile::tempdir().unwrap();
    let scene = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes/official.txt");
    let mut command = Command::new(env!("CARGO_BIN_EXE_archetrace"));
    command.args(["cost", scene, "--quick", "--size", "16", "--rounds", "1", "-o"]).arg(folder.path());
    let output = command.output().unwrap();
    assert!(output.status.success(), "{output:?}");
    let read = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap();

    assert_eq!(problems(&serde_json::from_str(&read("cost.json")).unwrap()), Vec::<String>::new());
    let found = Opened::new(&read("cost.html")).look();
    has_numbers_of(&found, &read("cost.csv"));
    for nothing in ["overlapping", "cut", "dangling", "requests", "tooWide"] {
        assert_eq!(found[nothing], json!([]), "{nothing}");
    }
    let pressed = found["pressed"].as_array().unwrap();
    assert!(pressed.len() > 4, "{pressed:?}");
    for button in pressed {
        assert_eq!(button["shown"], json!([button["pressed"]]), "{button}");
    }
}

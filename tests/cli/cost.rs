//! `archetrace cost`: the files it writes, the same on every run but for times.

use serde_json::Value;

use crate::program::Folder;

/// Columns that are not times.
fn timeless(csv: &[u8]) -> Vec<Vec<String>> {
    let text = String::from_utf8(csv.to_vec()).unwrap();
    let rows: Vec<Vec<&str>> = text.lines().map(|line| line.split(',').collect()).collect();
    let kept: Vec<usize> = (0..rows[0].len()).filter(|&column| !rows[0][column].starts_with("ms_")).collect();
    // Only names can hold a comma, and those of the quick version's knobs do.
    let is_plain = |row: &&Vec<&str>| row.len() == rows[0].len();
    rows.iter()
        .filter(is_plain)
        .map(|row| kept.iter().map(|&column| row[column].to_owned()).collect())
        .collect()
}

#[test]
fn a_study_writes_its_files_and_a_rerun_the_same_but_for_times() {
    let folder = Folder::with_scene();
    let arguments = "cost scene.txt --quick --size 16 --rounds 2";
    let told = folder.run(arguments).quiet();
    assert!(told.contains("assignment") && told.contains("written: scene-cost/cost.html"), "{told}");
    let first = folder.read("scene-cost/cost.csv");
    folder.run(&format!("{arguments} -o other --threads 1")).quiet();
    let second = folder.read("other/cost.csv");
    let rows = timeless(&first);
    assert!(rows.len() > 12, "{rows:?}");
    assert_eq!(rows, timeless(&second));
    assert_eq!(rows[1][0], "assignment");

    let report: Value = serde_json::from_slice(&folder.read("scene-cost/cost.json")).unwrap();
    assert_eq!(
        (&report["pixels"], &report["rounds"], &report["interrupted"]),
        (&16.into(), &2.into(), &false.into())
    );
    for picture in report["pictures"].as_array().unwrap() {
        for kind in ["picture", "error", "rays"] {
            if let Some(file) = picture[kind].as_str() {
                assert!(!folder.read(&format!("scene-cost/{file}")).is_empty(), "{file}");
            }
        }
    }
    assert!(folder.read("scene-cost/cost.svg").starts_with(b"<svg"));
}

#[test]
fn what_a_study_says_of_a_setting_is_what_render_does() {
    let folder = Folder::with_scene();
    folder.run("cost scene.txt --quick --size 16 --rounds 1").quiet();
    let report: Value = serde_json::from_slice(&folder.read("scene-cost/cost.json")).unwrap();
    let rows = report["rows"].as_array().unwrap();
    for row in rows.iter().filter(|row| row["knobs"].is_null()).take(8) {
        let flags = row["flags"].as_str().unwrap();
        folder.run(&format!("render scene.txt -o out.png --stats out.json {flags}")).quiet();
        let stats: Value = serde_json::from_slice(&folder.read("out.json")).unwrap();
        for kind in ["primary", "shadow", "mirror", "refracted"] {
            assert_eq!(stats["rays"][kind], row[kind], "{flags}");
        }
    }
    let draft =
        report["pictures"].as_array().unwrap().iter().find(|entry| entry["setting"] == "draft").unwrap();
    folder.run("render scene.txt -o out.png --preset draft --size 16").quiet();
    assert!(
        folder.read("out.png") == folder.read(&format!("scene-cost/{}", draft["picture"].as_str().unwrap()))
    );
}

#[test]
fn bad_scenes_and_folders_are_refused() {
    let folder = Folder::with_scene();
    folder.put("file", "");
    for arguments in
        ["cost none.txt", "cost /dev/zero", "cost scene.txt -o file", "cost scene.txt -o file/within"]
    {
        let line = folder.run(arguments).refusal();
        assert!(["none.txt", "/dev/zero", "file"].iter().any(|name| line.contains(name)), "{line}");
    }
    folder.run("cost scene.txt --rounds 0").misuse();
    folder.run("cost scene.txt --size 4").misuse();
}

/// What is done when Ctrl-C comes is kept. Before the reference is done there is nothing to keep.
#[test]
fn an_interrupted_study_keeps_what_is_done() {
    let folder = Folder::with_scene();
    let interrupted_after = |seconds: u32| {
        folder.bash(&format!(
            "$P cost scene.txt --quick --size 48 --rounds 1000 -o out & sleep {seconds}; kill -INT $!; wait $!"
        ))
    };
    // A busy machine needs longer for the reference.
    let run = [3, 6, 12, 24, 48].into_iter().map(interrupted_after).find(|run| run.code == Some(0));
    let run = run.expect("the reference is done within 48 s");
    assert!(run.stderr.contains("warning: interrupted"), "{run:?}");
    let report: Value = serde_json::from_slice(&folder.read("out/cost.json")).unwrap();
    assert_eq!(report["interrupted"], true);
    assert!(!report["rows"].as_array().unwrap().is_empty());
}

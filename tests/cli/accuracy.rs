//! Settings of accuracy: by flags, by name, and by wish.

use serde_json::Value;

use crate::program::Folder;

fn stats(folder: &Folder, arguments: &str) -> Value {
    folder.run(&format!("render scene.txt -o out.bmp --stats out.json {arguments}")).succeeded();
    serde_json::from_slice(&folder.read("out.json")).unwrap()
}

fn picture(folder: &Folder, arguments: &str) -> Vec<u8> {
    folder.run(&format!("render scene.txt -o out.bmp {arguments}")).succeeded();
    folder.read("out.bmp")
}

#[test]
fn the_preset_assignment_is_what_render_does() {
    let folder = Folder::with_scene();
    let plain = picture(&folder, "");
    assert!(picture(&folder, "--preset assignment") == plain);
    let flags = "--samples 1 --level 3 --cutoff 0 --precision f64 --size 32";
    assert!(picture(&folder, flags) == plain);
    for preset in ["draft", "fine", "reference"] {
        assert!(picture(&folder, &format!("--preset {preset}")) != plain, "{preset}");
    }
}

#[test]
fn flags_go_on_from_a_preset() {
    let folder = Folder::with_scene();
    let fine = stats(&folder, "--preset fine --size 16");
    let setting = &fine["setting"];
    assert_eq!(
        (&setting["side"], &setting["threshold"], &setting["level"]),
        (&5.into(), &0.0078125.into(), &8.into())
    );
    let mean = fine["mean_samples"].as_f64().unwrap();
    assert!(mean > 1.0 && mean < 25.0, "{fine}");
    assert_eq!(fine["rays"]["primary"].as_f64(), Some(mean * 256.0));
    let other = stats(&folder, "--preset fine --size 16 --samples 9 --precision f32 --level 2");
    let setting = &other["setting"];
    assert_eq!((&setting["side"], &setting["threshold"]), (&3.into(), &Value::Null));
    assert_eq!((&setting["precision"], &setting["level"]), (&"f32".into(), &2.into()));
    assert_eq!(setting["cutoff"], 1.0 / 512.0);
}

#[test]
fn a_wish_is_granted_or_said_to_be_impossible() {
    let folder = Folder::with_scene();
    let told = folder.run("render scene.txt -o out.bmp --target 30dB --stats out.json").succeeded();
    assert!(told.stderr.contains("chosen: --samples "), "{}", told.stderr);
    let stats: Value = serde_json::from_slice(&folder.read("out.json")).unwrap();
    assert_eq!(stats["wish_met"], true);
    assert!(stats["predicted_psnr_db"].as_f64() >= Some(30.0), "{stats}");
    assert!(stats["predicted_ms"].as_f64() > Some(0.0), "{stats}");
    assert!(stats["phases_ms"]["choose"].as_f64() > Some(0.0), "{stats}");

    for wish in ["--target 199dB", "--target-level 0.00001", "--budget 0.000001ms"] {
        let told = folder.run(&format!("render scene.txt -o out.bmp {wish} --stats out.json")).succeeded();
        assert!(told.stderr.contains("warning: nothing tried meets"), "{wish}: {}", told.stderr);
        let stats: Value = serde_json::from_slice(&folder.read("out.json")).unwrap();
        assert_eq!(stats["wish_met"], false, "{wish}");
    }
}

#[test]
fn a_target_in_levels_is_one_in_decibels() {
    let folder = Folder::with_scene();
    // 20 log(255 / 8.06) = 30 dB.
    let levels = stats(&folder, "--target-level 8.0638");
    let predicted = levels["predicted_psnr_db"].as_f64();
    assert!(levels["wish_met"] == true && predicted >= Some(30.0), "{levels}");
    // More than 99 dB stand for an error of 0.003 levels.
    assert_eq!(stats(&folder, "--target-level 0.0001")["wish_met"], false);
}

#[test]
fn what_is_set_by_hand_is_not_chosen() {
    let folder = Folder::with_scene();
    let fixed = stats(&folder, "--target 25dB --precision f64 --level 2");
    assert_eq!((&fixed["setting"]["precision"], &fixed["setting"]["level"]), (&"f64".into(), &2.into()));
}

#[test]
fn nonsense_is_refused_with_what_is_allowed() {
    let folder = Folder::with_scene();
    for (arguments, words) in [
        ("--adaptive 2", "must be a number from 0 to 1"),
        ("--cutoff -0.5", "must be a number from 0 to 1"),
        ("--preset good", "possible values: draft, assignment, fine, reference"),
        ("--budget 20", "must be a time above 0, as 200ms or 1.5s"),
        ("--target loud", "must be a number of decibels"),
        ("--target-level 0", "must be a number of levels"),
        ("--target 30 --budget 1s", "cannot be used with"),
        ("--target 30 --samples 4", "cannot be used with"),
    ] {
        let told = folder.run(&format!("render scene.txt -o out.bmp {arguments}")).misuse();
        assert!(told.contains(words), "{arguments}: {told}");
    }
    assert_eq!(folder.names(), ["scene.txt"]);
}

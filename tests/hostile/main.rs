//! Hostile bytes, as many as fit into some seconds: scene files, images, and Worlds of any finite values. Nothing panics,
//! and every picture is one. `fuzz/` has the same as fuzz targets.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::print_stdout,
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    reason = "a test that cannot go on should say so and stop, and random bytes are cut from wider numbers"
)]

#[path = "../../fuzz/bodies/mod.rs"]
mod bodies;
#[path = "../scenes/mutant.rs"]
mod mutant;
#[allow(dead_code, reason = "shared with tests that use more of it")]
#[path = "../support/random.rs"]
mod random;

use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};

use bodies::Outcome;
use mutant::mutant;
use random::Random;

/// The files of a folder of the repository with this ending, in order.
fn files(folder: &str, ending: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let mut files: Vec<PathBuf> =
        entries.filter(|path| path.extension().is_some_and(|e| e == ending)).collect();
    files.sort();
    assert!(!files.is_empty());
    files
}

/// How often each outcome came of some inputs; an input that panics is told with its number.
fn count(inputs: impl Iterator<Item = Vec<u8>>, body: fn(&[u8]) -> Outcome) -> [usize; 3] {
    let mut counts = [0; 3];
    for (number, bytes) in inputs.enumerate() {
        let outcome = catch_unwind(AssertUnwindSafe(|| body(&bytes)));
        let outcome = outcome.unwrap_or_else(|_| panic!("input {number}: {bytes:?}"));
        counts[outcome as usize] += 1;
    }
    println!("refused {}, read {}, traced {}", counts[0], counts[1], counts[2]);
    counts
}

#[test]
fn scene_files_broken_in_many_places() {
    let scenes: Vec<String> = [files("scenes", "txt"), files("scenes/bad", "txt")]
        .iter()
        .flatten()
        .map(|path| String::from_utf8_lossy(&fs::read(path).unwrap()).into_owned())
        .filter(|text| text.len() < 4_000)
        .collect();
    let whole = scenes.iter().map(|text| text.clone().into_bytes());
    let broken = (0..3_000).map(|seed| mutant(seed, &scenes[seed as usize % scenes.len()]));
    let [refused, _, traced] = count(whole.chain(broken), bodies::scene);
    assert!(refused > 1_000 && traced > 100);
}

#[test]
fn images_broken_in_many_places() {
    let mut images: Vec<Vec<u8>> =
        files("scenes", "bmp").iter().map(|path| fs::read(path).unwrap()).collect();
    let picture = image::load_from_memory(&images[0]).unwrap();
    let mut png = std::io::Cursor::new(Vec::new());
    picture.write_to(&mut png, image::ImageFormat::Png).unwrap();
    images.push(png.into_inner());
    let broken = (0..1_500).map(|seed| {
        let random = &mut Random::new(seed);
        let mut bytes = images[random.below(images.len())].clone();
        for _ in 0..=random.below(8) {
            // Most of what can go wrong is said by the header.
            let end = if random.one_in(3) { bytes.len() } else { 64 };
            let at = random.below(end);
            bytes[at] = random.bits() as u8;
        }
        if random.one_in(4) {
            bytes.truncate(random.below(bytes.len()));
        }
        bytes
    });
    let [refused, read, _] = count(images.iter().cloned().chain(broken), bodies::texture);
    assert!(refused > 200 && read > 200);
}

#[test]
fn worlds_of_any_finite_values() {
    let seeds = files("fuzz/seeds/world", "bin").into_iter().map(|path| fs::read(path).unwrap());
    let random = (0..6_000).map(|seed| {
        let random = &mut Random::new(0xF0_0000 + seed);
        (0..random.below(500)).map(|_| random.bits() as u8).collect()
    });
    let [refused, _, traced] = count(seeds.chain(random), bodies::world);
    assert!(refused > 100 && traced > 1_000);
}

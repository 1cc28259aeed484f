//! Pixel by pixel the preview shows the object that the trace meets first, on every scene and from many sides.

use std::fs;
use std::path::{Path, PathBuf};

use archetrace::scene::{Source, spawn};
use bevy_ecs::prelude::*;

use super::cameras::views;
use super::canvas::Canvas;
use super::maps::{Labelled, Tally, assert_agrees};
use super::support::case::only;
use super::support::scenes::random_case;
use archetrace::components::Lens;

/// Pixels along each side: a size that is no power of two, so that no pixel centre falls on a symmetry by accident of
/// binary fractions.
const SIDE: usize = 150;

fn scene_files() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes");
    let files = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let mut scenes: Vec<PathBuf> =
        files.filter(|path| path.extension().is_some_and(|end| end == "txt")).collect();
    scenes.sort();
    scenes
}

#[test]
fn every_scene_is_seen_as_it_is_traced() {
    let canvas = &mut Canvas::new();
    let scenes = scene_files();
    assert!(scenes.len() >= 20, "{scenes:?}");
    let mut all = Tally::default();
    for (seed, path) in (0..).zip(scenes) {
        let mut world = World::new();
        spawn(&mut world, &Source::read(&path).unwrap().load().unwrap().description);
        let views = views(&mut world, seed);
        let labelled = &mut Labelled::new(world);
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        let mut tally = Tally::default();
        for (number, (what, pose, lens)) in views.iter().enumerate() {
            tally += assert_agrees(&format!("{name} {number} {what}"), canvas, labelled, (pose, lens), SIDE);
        }
        println!("{name}: {} views, {tally:?}", views.len());
        all += tally;
    }
    println!("all scenes: {all:?}");
    // The comparison is one of objects, not of outlines alone, and outlines hardly differ either.
    assert!(all.outline_differing * 1000 < all.outline, "{all:?}");
    assert!(all.outline * 5 < all.pixels, "{all:?}");
    assert!(all.cells * 20 > all.pixels, "{all:?}");
}

#[test]
fn random_worlds_are_seen_as_they_are_traced() {
    let canvas = &mut Canvas::new();
    let mut all = Tally::default();
    for seed in 0..60 {
        let case = random_case(seed, SIDE as u32);
        let mut world = case.world();
        let lens = *only::<Lens>(&mut world);
        let labelled = &mut Labelled::new(world);
        all += assert_agrees(&format!("random {seed}"), canvas, labelled, (&case.pose, &lens), SIDE);
    }
    println!("random worlds: {all:?}");
    assert!(all.outline_differing * 1000 < all.outline, "{all:?}");
    assert!(all.outline * 5 < all.pixels, "{all:?}");
}

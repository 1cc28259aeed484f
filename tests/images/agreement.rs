//! The tracer against the naive renderer, pixel by pixel.
//!
//! A pixel on a knife edge (of an object, a shadow, a cell, a cone) is left out: there the naive renderer itself
//! changes by more than a level when its sample moves by a hundred-thousandth of a pixel, or when its epsilon
//! grows tenfold. How many are left out is counted, printed and bounded.

use std::path::Path;

use archetrace::scene::Source;
use rayon::prelude::*;

use crate::naive::Naive;
use crate::support::case::Case;
use crate::support::picture::{Picture, differing, explain};
use crate::support::scenes::random_case;
use crate::support::tracing::trace;

/// How far the naive renderer's secondary rays start from a surface.
const EPSILON: f64 = 1e-7;
const SCENES: u64 = 160;
const SHIFT: f64 = 1e-5;
const SHIFTS: [(f64, f64); 4] = [(SHIFT, 0.0), (-SHIFT, 0.0), (0.0, SHIFT), (0.0, -SHIFT)];

/// What comparing some pixels gave.
#[derive(Clone, Copy, Default)]
struct Tally {
    pixels: usize,
    knife_edges: usize,
    wrong: usize,
    /// Pictures of at least 30 colours.
    rich: usize,
}

impl core::ops::AddAssign for Tally {
    fn add_assign(&mut self, other: Self) {
        self.pixels += other.pixels;
        self.knife_edges += other.knife_edges;
        self.wrong += other.wrong;
        self.rich += other.rich;
    }
}

impl Tally {
    fn show(&self, name: &str) {
        let Self { pixels, knife_edges, wrong, rich } = self;
        println!(
            "{name}: {pixels} pixels, {knife_edges} on knife edges left out, {wrong} of the rest differ \
             ({rich} pictures of 30 colours or more)"
        );
    }
}

/// The naive picture, and which of its pixels are on knife edges.
fn naive_picture(case: &Case) -> (Vec<[u8; 3]>, Vec<bool>) {
    let usual = Naive::new(case, EPSILON);
    let coarse = Naive::new(case, 10.0 * EPSILON);
    let side = case.description.pixels;
    let pixels = (0..side * side).into_par_iter().map(|index| {
        let (column, row) = (index % side, index / side);
        let color = usual.pixel(column, row, (0.0, 0.0));
        let stays = |other: [u8; 3]| (0..3).all(|i| color[i].abs_diff(other[i]) <= 1);
        let firm = SHIFTS.iter().all(|&shift| stays(usual.pixel(column, row, shift)))
            && stays(coarse.pixel(column, row, (0.0, 0.0)));
        (color, !firm)
    });
    pixels.unzip()
}

/// Compares one scene, and draws it if it differs.
fn compare(name: &str, case: &Case) -> Tally {
    let traced = trace::<f64>(&mut case.world()).picture;
    let (naive, knife_edges) = naive_picture(case);
    let mut wrong = differing(&traced.levels(), &naive, 1);
    wrong.retain(|&index| !knife_edges[index]);
    if !wrong.is_empty() {
        let naive = Picture {
            side: traced.side,
            pixels: naive.iter().map(|pixel| pixel.map(|level| f64::from(level) / 255.0)).collect(),
        };
        println!("{}", explain(name, &traced, &naive, &wrong));
    }
    Tally {
        pixels: naive.len(),
        knife_edges: knife_edges.iter().filter(|&&edge| edge).count(),
        wrong: wrong.len(),
        rich: usize::from(traced.variety() >= 30),
    }
}

#[test]
fn random_scenes_agree() {
    let mut sum = Tally::default();
    for seed in 1..=SCENES {
        sum += compare(&format!("random scene of seed {seed}"), &random_case(seed, 96));
    }
    sum.show("random scenes");
    assert_eq!(sum.wrong, 0, "pixels differ that are on no knife edge");
    assert!(sum.knife_edges * 1000 < sum.pixels, "too many knife edges");
    // Some views show nothing, as some views of users do; most must show something.
    assert!(sum.rich * 2 > SCENES as usize, "too many dull pictures");
}

#[test]
fn scene_files_agree() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes");
    let entries = folder.read_dir().expect("the repository has scenes");
    let mut paths: Vec<_> = entries.map(|entry| entry.expect("readable").path()).collect();
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "txt"));
    assert!(!paths.is_empty(), "no scene file in {}", folder.display());
    for path in paths {
        let name = path.display().to_string();
        let mut loaded = Source::read(&path).and_then(|source| source.load()).expect(&name);
        loaded.description.pixels = 128;
        let tally = compare(&name, &Case::new(loaded.description));
        tally.show(&name);
        assert_eq!(tally.wrong, 0, "{name} differs");
        assert!(tally.knife_edges * 100 < 3 * tally.pixels, "{name}: knife edges");
    }
}

#[test]
fn a_deviation_would_be_noticed() {
    // The comparison itself must be able to fail: one coefficient changed by a hundredth.
    let case = random_case(1, 96);
    let mut changed = case.clone();
    changed.description.board.ambient += 0.01;
    let traced = trace::<f64>(&mut changed.world()).picture;
    let (naive, _) = naive_picture(&case);
    let share = differing(&traced.levels(), &naive, 1).len();
    assert!(share > 500, "only {share} pixels noticed");
}

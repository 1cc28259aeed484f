//! Thousands of broken files: each is read or refused with a place, quickly, and none makes it panic.

use std::time::{Duration, Instant};

use archetrace::scene::{Source, parse};

use crate::mutant::mutant;
use crate::sample::{SAMPLE, place};

const NAME: &str = "mutant.txt";

/// The places that a shown text names: `NAME:line:column`.
fn named_places(shown: &str) -> Vec<(usize, usize)> {
    let number = |text: &str| text.parse().ok();
    let place = |rest: &str| {
        let mut parts = rest.lines().next()?.split(':');
        Some((number(parts.next()?)?, number(parts.next()?)?))
    };
    shown.split(&format!("{NAME}:")).skip(1).filter_map(place).collect()
}

#[test]
fn two_thousand_broken_files_are_read_or_refused_with_a_place() {
    let (mut read, mut refused) = (0, 0);
    for seed in 0..2000 {
        let text = String::from_utf8_lossy(&mutant(seed, SAMPLE)).into_owned();
        let start = Instant::now();
        match Source::new(NAME, text.as_str()).load() {
            Ok(_) => read += 1,
            Err(error) => {
                refused += 1;
                let problems = parse(&text).unwrap_err();
                let expected: Vec<(usize, usize)> =
                    problems.iter().map(|problem| place(&text, problem.span.start)).collect();
                let shown = error.to_string();
                assert_eq!(named_places(&shown), expected, "seed {seed}: {shown}\nfor\n{text}");
                assert!(!expected.is_empty(), "seed {seed}");
                assert!(shown.len() < 20_000, "seed {seed}: {} bytes", shown.len());
            }
        }
        let taken = start.elapsed();
        assert!(taken < Duration::from_secs(60), "seed {seed} took {taken:?}");
    }
    // Were all of them read, or all refused, this test would show little.
    assert!(read > 100 && refused > 1000, "{read} read, {refused} refused");
}

#[test]
fn warnings_name_places_too() {
    let text = SAMPLE.replace("0.2 0.5 0.3", "0.2 0.5 0.4");
    let loaded = Source::new(NAME, text).load().unwrap();
    let places: Vec<_> = loaded.warnings.iter().flat_map(|warning| named_places(warning)).collect();
    assert_eq!(places, [(7, 1)]);
}

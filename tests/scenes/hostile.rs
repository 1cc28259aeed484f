//! Files made to hurt: refused before they cost time or memory.

use std::time::{Duration, Instant};

use archetrace::scene::{MAX_BYTES, Source};

use crate::sample::{Kind, kinds, place, refused, sample_with, words};

/// The error text of a file, which must come quickly: what is not linear in megabytes takes hours.
fn refusal(text: &str) -> String {
    let source = Source::new("hostile.txt", text);
    let start = Instant::now();
    let error = source.load().unwrap_err().to_string();
    let taken = start.elapsed();
    assert!(taken < Duration::from_secs(60), "took {taken:?}");
    error
}

#[test]
fn absurd_counts_are_refused_at_the_count() {
    let counted = [Kind::Level, Kind::Pixels, Kind::Objects, Kind::Lights];
    for (index, kind) in kinds().into_iter().enumerate() {
        if !counted.contains(&kind) {
            continue;
        }
        for count in
            ["4294967295", "4000000000", "1e9", "-1", "99999999999999999999999999", "18446744073709551616"]
        {
            let text = sample_with(&[(index, count)]);
            let problems = refused(&text);
            assert_eq!(problems.len(), 1, "{kind:?} {count}");
            assert_eq!(&text[problems[0].span.clone()], count);
            assert!(problems[0].message.ends_with(&format!(" is `{count}`")), "{}", problems[0].message);
            let (line, column) = place(&text, problems[0].span.start);
            assert!(refusal(&text).contains(&format!("hostile.txt:{line}:{column}")));
        }
    }
}

#[test]
fn announced_but_absent_things_cost_nothing() {
    for text in [
        "1 2 60 1 0 1  1 1 0 0  2000000",
        "1 2 60 1 0 1  1 1 0 0  0 10000",
        "1 2 60 1 0 1  1 1 0 0  0 0 10000",
    ] {
        assert!(refusal(text).contains("the file ends where"), "{text}");
    }
}

#[test]
fn of_a_line_of_megabytes_only_a_part_is_quoted() {
    let far = " ".repeat(5_000_000);
    let long_word = "x".repeat(5_000_000);
    let wide_word = "é€𝄞".repeat(600_000);
    let numbers = "1 ".repeat(2_500_000);
    let object = "sphere 0 0 0 1 1 1 1 1 0 0 0 1 ";
    let many = format!("1 2 60 1 0 1  1 1 0 0  150001 {}@", object.repeat(150_000));
    for (text, column) in [
        (format!("1{far}@"), 5_000_002),
        (format!("1 {long_word} 60"), 3),
        (format!("1 {wide_word} 60"), 3),
        (format!("1 @ {numbers}"), 3),
        (format!("1{far}@{far}"), 5_000_002),
        (many.clone(), many.len()),
    ] {
        let shown = refusal(&text);
        assert!(shown.contains(&format!("hostile.txt:1:{column}\n")), "{shown}");
        let longest = shown.lines().map(|line| line.chars().count()).max().unwrap();
        assert!(longest < 300, "a line of {longest} characters: {shown}");
        assert!(shown.len() < 20_000, "{} bytes", shown.len());
    }
}

#[test]
fn a_warning_quotes_only_a_part_as_well() {
    let gap = " ".repeat(1_000_000);
    let text = words().join(&gap).replacen("0.3", "0.4", 1);
    let loaded = Source::new("hostile.txt", text).load().unwrap();
    assert_eq!(loaded.warnings.len(), 1);
    let shown = &loaded.warnings[0];
    assert!(shown.len() < 2_000, "{} bytes", shown.len());
    assert!(shown.contains("hostile.txt:1:"), "{shown}");
}

#[test]
fn a_file_too_large_to_be_a_scene_is_refused() {
    let file = tempfile::NamedTempFile::new().unwrap();
    file.as_file().set_len(MAX_BYTES + 1).unwrap();
    let error = Source::read(file.path()).unwrap_err().to_string();
    assert!(error.ends_with("larger than 268435456 bytes"), "{error}");
}

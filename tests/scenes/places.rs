//! What is wrong is said where it is wrong.

use archetrace::scene::Source;

use crate::sample::{SAMPLE, place, refused, replaced, tokens, words};

/// The text that a user sees for a scene that must be refused.
pub(crate) fn shown(text: &str) -> String {
    Source::new("sample.txt", text).load().unwrap_err().to_string()
}

#[test]
fn a_wrong_token_is_named_with_its_line_and_column() {
    let layouts = [
        SAMPLE.to_owned(),
        words().join(" "),
        words().join("\n"),
        words().join("\r\n"),
        words().join("\t\t"),
        words().join(" # é\n  "),
        format!("\n\n{SAMPLE}"),
    ];
    for layout in layouts {
        for token in tokens(&layout) {
            let text = replaced(&layout, token, "@");
            let problems = refused(&text);
            assert_eq!(problems.len(), 1, "{token:?}: {problems:?}");
            assert_eq!(problems[0].span, token.start..token.start + 1, "{token:?}: {problems:?}");
            assert!(problems[0].message.starts_with("found `@` where "), "{problems:?}");
            let (line, column) = place(&text, token.start);
            let shown = shown(&text);
            assert!(shown.contains(&format!("sample.txt:{line}:{column}\n")), "{line}:{column} in\n{shown}");
        }
    }
}

#[test]
fn the_line_is_quoted_with_a_marker_below() {
    let text = SAMPLE.replace("2.5\n", "2.5e\n");
    let expected = "\
error: found `2.5e` where the cube's side should be
   --> sample.txt:20:1
   |
20 | 2.5e
   | ^^^^ must be a length from 1e-70 to 1e70";
    let shown = shown(&text);
    let plain =
        |text: &str| text.lines().map(str::trim).filter(|line| *line != "|").collect::<Vec<_>>().join("\n");
    assert_eq!(plain(&shown), plain(expected), "{shown}");
    let marker = |text: &str, what: &str| text.lines().find_map(|line| line.find(what)).unwrap();
    assert_eq!(marker(&shown, "2.5e\n".trim()), marker(&shown, "`2.5e`") + 1, "first mention is the message");
    let quoted = shown.lines().find(|line| line.ends_with("| 2.5e")).unwrap();
    let marked = shown.lines().find(|line| line.contains("^^^^")).unwrap();
    assert_eq!(quoted.find("2.5e"), marked.find("^^^^"), "{shown}");
}

#[test]
fn columns_count_characters_not_bytes() {
    let text = "1 äöü€𝄞 @";
    let problems = refused(text);
    let places: Vec<(usize, usize)> =
        problems.iter().map(|problem| place(text, problem.span.start)).collect();
    assert_eq!(places[..2], [(1, 3), (1, 9)]);
    let shown = shown(text);
    assert!(shown.contains("sample.txt:1:3\n") && shown.contains("sample.txt:1:9\n"), "{shown}");
}

#[test]
fn a_byte_order_mark_moves_no_line() {
    let shown = shown(&format!("\u{feff}{}", SAMPLE.replace("64", "@")));
    assert!(shown.contains("sample.txt:4:1\n"), "{shown}");
}

#[test]
fn a_file_that_stops_early_is_refused_at_its_end() {
    for token in tokens(SAMPLE) {
        let text = &SAMPLE[..token.start];
        let end = text.trim_end().len();
        let problems = refused(text);
        assert_eq!(problems.len(), 1, "before {token:?}: {problems:?}");
        assert_eq!(problems[0].span, end..end, "before {token:?}: {problems:?}");
        assert!(problems[0].message.starts_with("the file ends where "), "{problems:?}");
        assert!(problems[0].label.ends_with(" is missing"), "{problems:?}");
        let (line, column) = place(text, end);
        let shown = shown(text);
        assert!(shown.contains(&format!("sample.txt:{line}:{column}\n")), "{line}:{column} in\n{shown}");
    }
}

#[test]
fn a_file_cut_anywhere_is_refused_or_read_but_never_a_panic() {
    let last = tokens(SAMPLE).last().unwrap().start;
    for end in 0..=SAMPLE.len() {
        let outcome = Source::new("sample.txt", &SAMPLE[..end]).load();
        assert_eq!(outcome.is_ok(), end > last, "cut at byte {end}");
    }
}

#[test]
fn several_problems_are_told_at_once() {
    let text = SAMPLE
        .replace("60 1.5", "x 1.5")
        .replace("2.5", "-2.5")
        .replace("1.25 2.75", "1.25 0")
        .replace("-10 10 11  30", "-10 ten 11  300");
    let problems = refused(&text);
    let found: Vec<&str> = problems.iter().map(|problem| &text[problem.span.clone()]).collect();
    assert_eq!(found, ["x", "-2.5", "0", "ten", "300"]);
    let shown = shown(&text);
    assert_eq!(shown.matches("error: ").count(), 5, "{shown}");
    assert_eq!(shown.matches("sample.txt:").count(), 5, "{shown}");
}

#[test]
fn a_missing_value_does_not_hide_the_next_object() {
    // The sphere lacks its shininess, the cube has a bad colour: both are told.
    let text = SAMPLE.replace("0.4\n5\n", "0.4\n").replace("0.4 0.5 0.6", "0.4 2 0.6");
    let problems = refused(&text);
    let found: Vec<&str> = problems.iter().map(|problem| &text[problem.span.clone()]).collect();
    assert_eq!(found, ["cube", "2"]);
}

#[test]
fn one_object_more_than_announced_is_said_with_the_line_of_the_count() {
    let text = SAMPLE.replace("\n3\n\nsphere", "\n2\n\nsphere");
    let problems = refused(&text);
    assert_eq!(&text[problems[0].span.clone()], "pyramid");
    assert_eq!(problems[0].label, "one object more than announced");
    assert_eq!(problems[0].note.as_deref(), Some("the number of objects is given as 2 in line 9"));
}

#[test]
fn one_object_less_than_announced_is_refused_where_the_object_should_start() {
    let text = SAMPLE.replace("\n3\n\nsphere", "\n4\n\nsphere");
    let problems = refused(&text);
    assert_eq!(problems.len(), 1);
    assert_eq!(problems[0].message, "found `1` where object 4 of 4 should start");
}

#[test]
fn no_more_than_twenty_problems_are_told() {
    let text = SAMPLE.replace(|c: char| c.is_ascii_digit(), "x");
    assert!(refused(&text).len() <= 20);
    let objects = "sphere x x x x x x x x x x x x ".repeat(100);
    let text = format!("1 2 60 1 0 1  1 1 0 0  100 {objects} 0 0");
    let problems = refused(&text);
    assert_eq!(problems.len(), 20);
    assert_eq!(problems[19].note.as_deref(), Some("too many problems: what follows was not read"));
}

#[test]
fn no_more_than_twenty_warnings_are_told() {
    let object = "sphere 0 0 0 1 1 1 1 0.5 0 0 0 1 ";
    let text = format!("1 2 60 1 0 1  1 1 0 0  30 {} 0 0", object.repeat(30));
    let loaded = Source::new("sample.txt", text).load().unwrap();
    assert_eq!(loaded.warnings.len(), 20);
    assert!(loaded.warnings[19].contains("10 more warnings are not shown"), "{}", loaded.warnings[19]);
    assert!(loaded.warnings[0].contains("sample.txt:1:"), "{}", loaded.warnings[0]);
}

#[test]
fn what_would_move_the_cursor_is_not_shown_as_it_is() {
    let shown = shown("1 \u{1b}[31mred\u{7}\u{8}\0 60");
    assert!(shown.chars().all(|c| c == '\n' || !c.is_control()), "{shown:?}");
    assert!(shown.contains("sample.txt:1:3\n"), "{shown}");
}

//! How numbers are written, and the ends of their ranges.

use archetrace::scene::parse;

use crate::sample::{Kind, kinds, refused, sample_with, token_at, words};

/// The first token of this kind.
fn first(kind: Kind) -> usize {
    kinds().iter().position(|other| *other == kind).unwrap()
}

#[test]
fn numbers_are_read_in_every_usual_form() {
    let at = first(Kind::Coordinate);
    for (written, value) in [
        ("+5", 5.0),
        ("5.", 5.0),
        (".5", 0.5),
        ("-.5", -0.5),
        ("+.5e1", 5.0),
        ("1e2", 100.0),
        ("1E2", 100.0),
        ("1e+2", 100.0),
        ("1.5e-2", 0.015),
        ("005", 5.0),
        ("0.1", 0.1),
        ("1e-400", 0.0),
        ("123456789012345678901234567890", 123_456_789_012_345_680_000_000_000_000.0),
        ("0.1000000000000000055511151231257827021181583404541015625", 0.1),
    ] {
        let (scene, _) = parse(&sample_with(&[(at, written)])).unwrap();
        assert_eq!(scene.objects[0].position.x, value, "{written}");
    }
    let (scene, _) = parse(&sample_with(&[(at, "-0")])).unwrap();
    assert_eq!(scene.objects[0].position.x.to_bits(), (-0.0_f64).to_bits());
}

#[test]
fn what_is_no_number_is_refused() {
    for at in [first(Kind::Coordinate), first(Kind::Level), first(Kind::Objects)] {
        for word in [
            "inf",
            "-inf",
            "nan",
            "NaN",
            "infinity",
            "1e",
            "e5",
            ".",
            "+",
            "-",
            "--1",
            "1-",
            "1,5",
            "0x10",
            "1f",
            "1_000",
            "1d0",
            "1e1.5",
            "½",
            "٣",
            "1\u{200b}",
            "five",
            "\0",
            "1/2",
        ] {
            let text = sample_with(&[(at, word)]);
            let problem = &refused(&text)[0];
            assert_eq!(token_at_start(&text, at), problem.span.start, "{word}");
            assert!(problem.message.starts_with("found `"), "{word}: {}", problem.message);
            assert!(problem.label.starts_with("must be "), "{word}: {}", problem.label);
        }
    }
}

#[test]
fn a_number_too_large_to_hold_is_a_number_all_the_same() {
    let at = first(Kind::Coordinate);
    for word in ["1e400", "-1e400"] {
        let problem = &refused(&sample_with(&[(at, word)]))[0];
        assert!(problem.message.ends_with(&format!(" is `{word}`")), "{}", problem.message);
    }
}

/// Where the token of this number starts in a text of words with single blanks.
fn token_at_start(text: &str, index: usize) -> usize {
    text.split(' ').take(index).map(|word| word.len() + 1).sum()
}

#[test]
fn counts_are_whole_numbers() {
    for kind in [Kind::Level, Kind::Pixels, Kind::Objects, Kind::Lights] {
        let at = first(kind);
        let same = words()[at];
        for written in [format!("+{same}"), format!("00{same}")] {
            assert!(parse(&sample_with(&[(at, &written)])).is_ok(), "{kind:?} {written}");
        }
        for written in ["3.0", "3.", "3e0", "1e1", "-0.5", "0x3"] {
            let text = sample_with(&[(at, written)]);
            let problem = &refused(&text)[0];
            assert_eq!(token_at(&text, problem.span.start), Some(at), "{kind:?} {written}");
            assert!(problem.label.starts_with("must be a whole number from "), "{}", problem.label);
        }
    }
}

/// Values just inside and just outside what a kind allows in the sample.
struct Ends {
    inside: Vec<String>,
    outside: Vec<String>,
    /// What the error must say.
    allowed: &'static str,
}

fn closed(low: f64, high: f64, allowed: &'static str) -> Ends {
    Ends {
        inside: vec![shown(low), shown(high), shown(low.next_up()), shown(high.next_down())],
        outside: vec![shown(low.next_down()), shown(high.next_up()), "-1e300".into(), "1e300".into()],
        allowed,
    }
}

fn whole(low: u32, high: u32, allowed: &'static str) -> Ends {
    let too_low = i64::from(low) - 1;
    Ends {
        inside: vec![low.to_string(), high.to_string()],
        outside: vec![too_low.to_string(), (high + 1).to_string(), "4294967295".into(), "4294967296".into()],
        allowed,
    }
}

fn shown(value: f64) -> String {
    format!("{value:e}")
}

/// The ranges of every kind, written down a second time. The relations between near, far, field of view and aspect
/// are tested below.
fn ends(kind: Kind) -> Option<Ends> {
    let length = "must be a length from 1e-70 to 1e70";
    Some(match kind {
        Kind::Near => Ends {
            inside: vec![shown(1e-70), shown(1000_f64.next_down())],
            outside: vec![shown(1e-70_f64.next_down()), "0".into(), "-1".into()],
            allowed: length,
        },
        Kind::Far => Ends {
            inside: vec![shown(1_f64.next_up()), shown(1e70)],
            outside: vec![shown(1e70_f64.next_up()), "0".into(), "-1".into()],
            allowed: length,
        },
        // The sample's aspect ratio is 1.5.
        Kind::FieldOfView => Ends {
            inside: vec![shown(1e-300), shown(120_f64.next_down())],
            outside: vec!["0".into(), "-0".into(), "-1".into(), "180".into(), "200".into()],
            allowed: "must be an angle above 0 and below 180 degrees",
        },
        // The sample's field of view is 60.
        Kind::Aspect => Ends {
            inside: vec![shown(1e-6), shown(3_f64.next_down())],
            outside: vec![shown(1e-6_f64.next_down()), shown(1e6_f64.next_up()), "0".into(), "-1".into()],
            allowed: "must be a ratio from 1e-6 to 1e6",
        },
        Kind::Level => whole(0, 1000, "must be a whole number from 0 to 1000"),
        Kind::Pixels => whole(1, 8192, "must be a whole number from 1 to 8192"),
        Kind::Length => closed(1e-70, 1e70, length),
        Kind::Coefficient | Kind::Color => closed(0.0, 1.0, "must be a number from 0 to 1"),
        Kind::Objects => whole(0, 2_000_000, "must be a whole number from 0 to 2000000"),
        Kind::Lights => whole(0, 10_000, "must be a whole number from 0 to 10000"),
        Kind::Coordinate => closed(-1e70, 1e70, "must be a number from -1e70 to 1e70"),
        Kind::Shininess => closed(0.0, 1e9, "must be a number from 0 to 1e9"),
        Kind::Falloff => closed(0.0, 1e150, "must be a number from 0 to 1e150"),
        Kind::Cutoff => closed(0.0, 180.0, "must be an angle from 0 to 180 degrees"),
        Kind::Word => return None,
    })
}

#[test]
fn every_range_ends_where_it_should() {
    let mut checked = 0;
    for (index, kind) in kinds().into_iter().enumerate() {
        let Some(ends) = ends(kind) else { continue };
        for value in &ends.inside {
            let text = sample_with(&[(index, value)]);
            // A count changes what must follow: then something else is wrong.
            let refused_here = parse(&text).is_err_and(|problems| {
                let here = |at| token_at(&text, at) == Some(index);
                !is_count(kind) || here(problems[0].span.start)
            });
            assert!(!refused_here, "token {index}, {kind:?}, {value}: {:?}", parse(&text));
        }
        for value in &ends.outside {
            let text = sample_with(&[(index, value)]);
            let problems = refused(&text);
            let place = token_at(&text, problems[0].span.start);
            assert_eq!(
                (place, problems[0].label.as_str()),
                (Some(index), ends.allowed),
                "token {index}, {kind:?}, {value}"
            );
            assert_eq!(problems.len(), 1, "token {index}, {kind:?}, {value}: {problems:?}");
            checked += 1;
        }
    }
    assert!(checked > 200, "only {checked} refusals");
}

fn is_count(kind: Kind) -> bool {
    matches!(kind, Kind::Objects | Kind::Lights)
}

#[test]
fn the_far_plane_is_beyond_the_near_one() {
    let (near, far) = (first(Kind::Near), first(Kind::Far));
    for (n, f) in [("5", "5"), ("6", "5"), ("1e70", "1e70"), ("1000", "1000")] {
        let text = sample_with(&[(near, n), (far, f)]);
        let problems = refused(&text);
        assert_eq!(problems.len(), 1, "{problems:?}");
        assert_eq!(token_at(&text, problems[0].span.start), Some(far));
        assert!(problems[0].label.starts_with("must be greater than "));
    }
    for (n, f) in [("5", "5.000000000000001"), ("1e-70", "1e70"), ("9.9e69", "1e70")] {
        assert!(parse(&sample_with(&[(near, n), (far, f)])).is_ok(), "near {n}, far {f}");
    }
}

#[test]
fn the_horizontal_field_of_view_is_below_180_degrees() {
    let (fovy, aspect) = (first(Kind::FieldOfView), first(Kind::Aspect));
    for (f, a) in [("90", "2"), ("120", "1.5"), ("179.9", "1.1"), ("60", "1e6")] {
        let text = sample_with(&[(fovy, f), (aspect, a)]);
        let problems = refused(&text);
        assert_eq!(problems.len(), 1, "{problems:?}");
        assert_eq!(token_at(&text, problems[0].span.start), Some(aspect));
        assert!(problems[0].label.ends_with("below 180 degrees"), "{}", problems[0].label);
    }
    for (f, a) in [("90", "1.9999999"), ("179.9", "1"), ("1e-5", "1e6"), ("179.99999999999997", "1e-6")] {
        assert!(parse(&sample_with(&[(fovy, f), (aspect, a)])).is_ok(), "fovy {f}, aspect {a}");
    }
}

#[test]
fn a_spotlight_looks_away_from_itself() {
    // The sample's spotlight is at (-70, 72, 80); its target is tokens 4 to 2 from the end.
    let count = words().len();
    let [x, y, z] = [count - 4, count - 3, count - 2];
    let text = sample_with(&[(x, "-70.0"), (y, "72"), (z, "80")]);
    let problems = refused(&text);
    assert_eq!(problems.len(), 1, "{problems:?}");
    assert_eq!(token_at(&text, problems[0].span.start), Some(x));
    assert!(text[problems[0].span.clone()].ends_with("80"), "{problems:?}");
    assert!(parse(&sample_with(&[(x, "-70"), (y, "72"), (z, "80.00000000000001")])).is_ok());
}

#[test]
fn coefficients_that_do_not_add_up_are_warned_about_once_each() {
    let index = first(Kind::Coefficient);
    let (_, warnings) = parse(&sample_with(&[(index, "0.3")])).unwrap();
    assert_eq!(warnings.len(), 1);
    assert_eq!(warnings[0].message, "the coefficients add up to 1.1");
    assert_eq!(warnings[0].label, "ambient + diffuse + reflection should be 1");
    for (place, kind) in kinds().into_iter().enumerate() {
        if kind == Kind::Coefficient {
            let (_, warnings) = parse(&sample_with(&[(place, "0.95")])).unwrap();
            assert_eq!(warnings.len(), 1, "token {place}");
        }
    }
}

#[test]
fn coefficients_that_add_up_but_for_rounding_are_fine() {
    // 0.1 + 0.2 + 0.3 + 0.4 is not 1 in binary; thirds are not in decimal.
    let text = "1 2 60 1 0 1  1 0.3333333 0.3333333 0.3333333  0 0 0";
    assert_eq!(parse(text).unwrap().1, []);
    let text = "1 2 60 1 0 1  1 0.333 0.333 0.333  0 0 0";
    assert_eq!(parse(text).unwrap().1.len(), 1);
}

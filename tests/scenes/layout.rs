//! How a file may be laid out: lines, blanks, comments and prose mean nothing.

use std::io::Write;

use archetrace::scene::{ShapeDescription, Source, parse};

use crate::sample::{SAMPLE, read, replaced, tokens, words};

#[test]
fn each_value_lands_in_its_field() {
    let scene = read(SAMPLE);
    assert_eq!([scene.near, scene.far, scene.fovy, scene.aspect], [1.0, 1000.0, 60.0, 1.5]);
    assert_eq!([scene.level, scene.pixels], [3, 64]);
    let board = scene.board;
    assert_eq!([board.cell, board.ambient, board.diffuse, board.reflection], [10.0, 0.2, 0.5, 0.3]);
    let shapes: Vec<ShapeDescription> = scene.objects.iter().map(|object| object.shape).collect();
    assert_eq!(
        shapes,
        [
            ShapeDescription::Sphere { radius: 4.0 },
            ShapeDescription::Cube { side: 2.5 },
            ShapeDescription::Pyramid { width: 1.25, height: 2.75 },
        ]
    );
    let positions: Vec<[f64; 3]> = scene.objects.iter().map(|object| object.position.to_array()).collect();
    assert_eq!(positions, [[1.0, 2.0, 3.0], [-1.0, -2.0, -3.0], [7.0, 8.0, 9.0]]);
    let surface = scene.objects[0].surface;
    assert_eq!(surface.color.to_array(), [0.1, 0.2, 0.3]);
    assert_eq!(
        [surface.ambient, surface.diffuse, surface.specular, surface.reflection, surface.shininess],
        [0.1, 0.2, 0.3, 0.4, 5.0]
    );
    let light = scene.lights[0];
    assert_eq!(light.position.to_array(), [70.0, 71.0, 100.0]);
    assert_eq!(light.falloff, 0.001);
    let spot = scene.spots[0];
    assert_eq!(spot.light.position.to_array(), [-70.0, 72.0, 80.0]);
    assert_eq!(spot.light.falloff, 0.002);
    assert_eq!(spot.target.to_array(), [-10.0, 10.0, 11.0]);
    assert_eq!(spot.cutoff, 30.0);
    assert_eq!([scene.objects.len(), scene.lights.len(), scene.spots.len()], [3, 1, 1]);
}

#[test]
fn lines_and_blanks_mean_nothing() {
    let scene = read(SAMPLE);
    for gap in [" ", "\n", "\t", "\r\n", "  \n\n\n ", "\r", " \t \r\n\t", "\u{b}", "\u{c}"] {
        assert_eq!(read(&words().join(gap)), scene, "gap {gap:?}");
        let framed = format!("{gap}{}{gap}", words().join(gap));
        assert_eq!(read(&framed), scene, "framed by {gap:?}");
    }
    assert_eq!(read(&SAMPLE.replace('\n', "\r\n")), scene);
    assert_eq!(read(&SAMPLE.replace('\n', "  \n")), scene);
}

#[test]
fn a_byte_order_mark_is_passed_over() {
    assert_eq!(read(&format!("\u{feff}{SAMPLE}")), read(SAMPLE));
    assert_eq!(read(&format!("\u{feff}# note\n{SAMPLE}")), read(SAMPLE));
}

#[test]
fn a_comment_may_stand_anywhere() {
    let scene = read(SAMPLE);
    for comment in ["#\n", " # x\n", "#x sphere 1 @ #\n", "#é\r\n", "\n#\n"] {
        assert_eq!(read(&words().join(comment)), scene, "{comment:?}");
        assert_eq!(read(&format!("{comment}{SAMPLE}{comment}")), scene, "{comment:?}");
    }
    for token in tokens(SAMPLE) {
        let glued = replaced(SAMPLE, token, &format!("{}#x\n", token.text));
        assert_eq!(read(&glued), scene, "after {token:?}");
    }
}

#[test]
fn a_comment_ends_the_word_before_it() {
    assert_eq!(read(&SAMPLE.replace("64\n", "64#5\n")).pixels, 64);
    // The rest of the number is in the comment: 6, not 64.
    assert_eq!(read(&SAMPLE.replace("64\n", "6#4\n")).pixels, 6);
}

#[test]
fn a_comment_without_a_line_end_closes_the_file() {
    assert_eq!(read(&format!("{}#x", words().join(" "))), read(SAMPLE));
}

#[test]
fn prose_after_the_last_number_is_ignored() {
    let scene = read(SAMPLE);
    for prose in
        [" the end", "\ninput explanation:\n1 1000 \t distances", " sphere 1 2 3", " @ \0 \u{1} \u{fffd}"]
    {
        assert_eq!(read(&format!("{SAMPLE}{prose}")), scene, "{prose:?}");
    }
}

#[test]
fn a_number_after_the_last_number_is_warned_about() {
    for prose in ["5 5 5", "5", "-1e3 sphere", "7# note"] {
        let text = format!("{SAMPLE}{prose}");
        let (scene, warnings) = parse(&text).unwrap();
        assert_eq!(scene, read(SAMPLE), "{prose}");
        assert_eq!(warnings.len(), 1, "{prose}: {warnings:?}");
        assert_eq!(warnings[0].span.start, SAMPLE.len(), "{prose}");
        assert_eq!(warnings[0].label, "this and all that follows is not read");
    }
}

#[test]
fn prose_may_be_in_any_encoding() {
    let mut bytes = SAMPLE.as_bytes().to_vec();
    bytes.extend(b"\nEingabe-Erkl\xe4rung: \xff\xfe\x80\xc0\xaf \x00\x01");
    assert_eq!(load(&bytes), Ok(read(SAMPLE)));
}

#[test]
fn comments_may_be_in_any_encoding() {
    let mut bytes = b"# Szene f\xfcr \xff\n".to_vec();
    bytes.extend(SAMPLE.as_bytes());
    assert_eq!(load(&bytes), Ok(read(SAMPLE)));
}

#[test]
fn a_number_in_another_encoding_is_refused_where_it_stands() {
    let text = b"1 \xff\xff 60";
    let error = load(text).unwrap_err();
    assert!(error.contains(":1:3"), "{error}");
}

/// Bytes in a file on disk, read as a scene; the error is the text that would be shown.
fn load(bytes: &[u8]) -> Result<archetrace::scene::Description, String> {
    let mut file = tempfile::NamedTempFile::new().unwrap();
    file.write_all(bytes).unwrap();
    let loaded = Source::read(file.path()).unwrap().load();
    loaded.map(|loaded| loaded.description).map_err(|error| error.to_string())
}

#[test]
fn lists_may_be_empty() {
    let scene = read("1 2 60 1 0 1  1 1 0 0  0 0 0");
    assert_eq!((scene.objects.len(), scene.lights.len(), scene.spots.len()), (0, 0, 0));
}

#[test]
fn object_words_are_exact() {
    for word in ["Sphere", "SPHERE", "spheres", "spher", "\"sphere\"", "sphere:", "plane"] {
        let text = SAMPLE.replace("sphere", word);
        let problems = crate::sample::refused(&text);
        assert_eq!(problems.len(), 1, "{word}: {problems:?}");
        assert_eq!(problems[0].label, "must be sphere, cube or pyramid");
        assert_eq!(problems[0].message, format!("found `{word}` where object 1 of 3 should start"));
    }
}

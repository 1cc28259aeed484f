//! The guard itself is tested on small texts: what is wrong is found, what only looks wrong is not.

use super::{dependencies, is_any_dependency_section, is_dependency_section, judge, known_crates};

/// What the table says to one file with this text.
fn verdict(file: &str, text: &str) -> Vec<String> {
    judge(file, text, &known_crates())
}

#[test]
fn a_crate_in_a_wrong_room_is_found_with_its_place() {
    let text = "//! A room.\n\nuse bevy_ecs::prelude::*;\n";
    let findings = verdict("src/geometry/ray.rs", text);
    assert_eq!(
        findings,
        [
            "src/geometry/ray.rs:3: names the crate bevy_ecs; src/geometry may name: glam, libm (in basis.rs, unit.rs only)"
        ]
    );
}

#[test]
fn a_crate_in_a_wrong_file_of_its_room_is_found() {
    let text = "fn f() -> f64 { libm::exp(1.0) }";
    assert!(verdict("src/effects/spot_cone.rs", text).is_empty());
    assert_eq!(verdict("src/effects/rgb.rs", text).len(), 1);
    assert!(verdict("src/trace/camera.rs", text).is_empty());
    assert_eq!(verdict("src/trace/shade.rs", text).len(), 1);
}

#[test]
fn every_way_to_name_a_crate_is_found() {
    for text in [
        "use image;",
        "use image as pictures;",
        "use ::image::Rgb;",
        "pub(crate) use image::Rgb;",
        "use {std::fmt, image::Rgb};",
        "extern crate image;",
        "let a = image::open(p);",
        "let a = ::image::open(p);",
        "fn f(a: &image::Rgb<u8>) {}",
        "fn f() -> Vec<image::Rgb<u8>> {}",
        "impl From<image::ImageError> for E {}",
        "#[derive(image::Thing)] struct S;",
        "let a = <image::Rgb<u8> as Pixel>::CHANNELS;",
        "let a = b as image::Pixel;",
        "return ::image::open(p);",
        "'a: { image::open(p) }",
    ] {
        let findings = verdict("src/film.rs", text);
        assert_eq!(findings.len(), 1, "{text}: {findings:?}");
        assert!(findings[0].starts_with("src/film.rs:1: names the crate image;"), "{findings:?}");
    }
}

#[test]
fn what_only_looks_like_a_crate_is_not_found() {
    for text in [
        "// use image::Rgb;",
        "/// use image::Rgb;",
        "//! image::open(p)",
        "/* image::open(p) /* image:: */ image::open(p) */ fn f() {}",
        r#"let a = "image::open(p)";"#,
        r#"let a = "\"image::open(p)";"#,
        r##"let a = r#""image::open(p)"#;"##,
        r#"let a = b"image::open(p)"; let b = br"image::open";"#,
        "let image = 1; f(image);",
        "let a = self.image::<u8>();",
        "use crate::film::image::Rgb;",
        "let a = my_image::open(p);",
        "fn f<'image>(a: &'image str) {}",
        "fn f() -> impl Sized + use<'a, image> {}",
        "let a = '\"'; // image::open(\"",
    ] {
        assert_eq!(verdict("src/film.rs", text), [""; 0], "{text}");
    }
}

#[test]
fn code_between_strings_and_characters_is_still_read() {
    for text in [
        "let a = '\"'; image::open(p); let b = '\"';",
        "let a = '\\''; image::open(p); let b = '\\'';",
        "let a = b'\"'; image::open(p); let b = '\"';",
        "let a = r\"\\\"; image::open(p); let b = \"\";",
        "let a = r#\"\" \"#; image::open(p); let b = \"\";",
        "let a = \"\\\\\"; image::open(p); let b = \"\";",
        "/* a /* b */ c */ image::open(p); /* */",
        "fn f<'a>(x: &'a u8) { image::open(p); let c = 'x'; }",
    ] {
        assert_eq!(verdict("src/film.rs", text).len(), 1, "{text}");
    }
}

#[test]
fn lines_are_counted_through_comments_and_strings() {
    let text = "/*\n\n*/ const A: &str = \"\n\\\"\n\";\nimage::open(p);";
    assert_eq!(verdict("src/film.rs", text).len(), 1);
    assert!(verdict("src/film.rs", text)[0].starts_with("src/film.rs:6:"));
}

#[test]
fn a_room_that_looks_back_is_found() {
    for (file, text, other) in [
        ("src/geometry/ray.rs", "use crate::components::Mirror;", "components"),
        ("src/geometry/ray.rs", "use super::super::trace::Hit;", "trace"),
        ("src/geometry/mod.rs", "use super::effects;", "effects"),
        ("src/film.rs", "fn f(a: &super::cli::Args) {}", "cli"),
        ("src/trace/hit.rs", "use crate::{film::Film, scene::parse};", "scene"),
        ("systems/trace.rs", "let a = crate::whole_file::write_whole;", "whole_file"),
        ("systems/mod.rs", "use super::image_file;", "image_file"),
        ("src/scene/parser.rs", "use archetrace::systems::Frame;", "systems"),
        ("src/effects/rgb.rs", "use crate::*;", "*"),
    ] {
        let findings = verdict(file, text);
        let start = format!("{file}:1: names crate::{other};");
        assert!(findings.len() == 1 && findings[0].starts_with(&start), "{text}: {findings:?}");
    }
}

#[test]
fn a_room_may_name_itself_and_what_comes_before_it() {
    for (file, text) in [
        ("src/geometry/ray.rs", "use super::Real; use crate::geometry::Vec3;"),
        ("src/film.rs", "mod tests { use super::quantize; }"),
        ("src/trace/hit.rs", "use crate::{components::Order, effects, film::Film};"),
        ("systems/trace.rs", "use super::Frame; use crate::trace::Exposure;"),
        ("src/cli/render.rs", "use super::args; use crate::systems::Frame;"),
    ] {
        assert_eq!(verdict(file, text), [""; 0], "{text}");
    }
}

#[test]
fn files_and_clocks_are_found_where_they_do_not_belong() {
    for text in ["use std::fs;", "use std::{fmt, path::Path};", "std::fs::read(p);"] {
        for file in ["systems/trace.rs", "src/trace/hit.rs", "src/geometry/ray.rs"] {
            assert_eq!(verdict(file, text).len(), 1, "{file}: {text}");
        }
        for file in ["src/effects/rgb.rs", "src/components/camera.rs"] {
            assert_eq!(verdict(file, text).len(), 1, "{file}: {text}");
        }
        assert!(verdict("src/whole_file.rs", text).is_empty(), "{text}");
    }
    let clock = "use std::time::Instant;";
    assert_eq!(verdict("systems/trace.rs", clock).len(), 1);
    assert_eq!(verdict("src/scene/source.rs", clock).len(), 1);
    assert!(verdict("src/cli/stats.rs", clock).is_empty());
}

#[test]
fn a_tolerance_is_found_where_there_must_be_none() {
    for number in
        ["1e-3", "1e-12", "2.5E-9", "1_0e-9_f64", "0.001", "0.0001f32", "f64::EPSILON", "RAY_EPSILON"]
    {
        let text = format!("const A: f64 = {number};");
        for file in ["src/trace/hit.rs", "src/effects/rgb.rs", "systems/trace.rs", "src/components/light.rs"]
        {
            let findings = verdict(file, &text);
            assert_eq!(findings.len(), 1, "{file}: {text}: {findings:?}");
        }
        assert!(verdict("src/geometry/ray.rs", &text).is_empty());
        assert!(verdict("src/components/range.rs", &text).is_empty());
    }
}

#[test]
fn an_ordinary_number_is_no_tolerance() {
    for text in [
        "let a = 1e-2 + 0.5 + 1e3 + 0.0 + 0e-9;",
        "let a = 0x1e-3;",
        "let a = 1.max(3) - t.0;",
        "for i in 0..3 {}",
        "// 1e-9\nlet a = \"1e-9\";",
    ] {
        assert_eq!(verdict("src/trace/hit.rs", text), [""; 0], "{text}");
    }
}

#[test]
fn a_file_without_a_room_is_found() {
    assert_eq!(verdict("src/attic.rs", "").len(), 1);
    assert_eq!(verdict("src/geometry_too/ray.rs", "").len(), 1);
    assert!(verdict("src/geometry/deeper/ray.rs", "").is_empty());
}

#[test]
fn dependencies_are_read_however_they_are_written() {
    let manifest = "\
[package]
name = \"x\"
[dependencies] # note
# c = \"1\"
a-b = \"1\"
d = { version = \"1\", features = [\"e\"] }
f.version = \"1\"
[dependencies.g]
version = \"2\"
[target.'cfg(unix)'.dependencies]
h = \"1\"
[dev-dependencies]
i = \"1\"
[features]
j = []
";
    let normal = dependencies(manifest, is_dependency_section);
    assert_eq!(normal, ["a_b", "d", "f", "g", "h"]);
    let all = dependencies(manifest, is_any_dependency_section);
    assert_eq!(all, ["a_b", "d", "f", "g", "h", "i"]);
}

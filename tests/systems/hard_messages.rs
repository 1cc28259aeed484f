//! Hard cases that are refused, by their id: the exact message, in both precisions, and that the World traces again when it
//! is mended. The same values in a scene file are among `scenes/bad`.

use archetrace::components::{
    CameraPose, Checkerboard, Cube, Diffuse, Falloff, Gloss, Lens, Light, Position, Pyramid, Snapshot,
    Sphere, SpotCone,
};
use bevy_ecs::prelude::*;
use glam::DVec3;

use crate::problems::{assert_bundle_refused, error_of, small_case};
use crate::support::case::only;
use crate::support::picture::assert_same;
use crate::support::tracing::trace;

const LENGTH: &str = "must be a length from 1e-70 to 1e70";

/// An entity that cannot be traced in either precision, and the end of its message.
fn check<B: Bundle>(bundle: impl Fn() -> B, message: &str) {
    let message = format!("entity {{entity}}: {message}");
    assert_bundle_refused::<f64, _>(&bundle, &message);
    assert_bundle_refused::<f32, _>(&bundle, &message);
}

/// A change to the camera that makes it useless in either precision, and the end of its message.
fn check_lens(change: fn(&mut Lens), message: &str) {
    let mut world = small_case().world();
    change(&mut only::<Lens>(&mut world));
    let camera = world.query_filtered::<Entity, With<Lens>>().single(&world).unwrap();
    let message = message.replace("{entity}", &camera.to_string());
    assert_eq!(error_of::<f64>(&mut world).to_string(), format!("entity {camera}: {message}"));
    assert_eq!(error_of::<f32>(&mut world).to_string(), format!("entity {camera}: {message}"));
}

#[test]
fn s22_s24_a_radius_is_a_length() {
    let radii = [(1e-200, "1e-200"), (0.0, "0"), (-2.0, "-2"), (f64::NAN, "NaN"), (f64::INFINITY, "inf")];
    for (radius, found) in radii {
        check(|| Sphere { radius }, &format!("Sphere.radius is {found}, but {LENGTH}"));
    }
}

#[test]
fn s24_a_center_has_coordinates() {
    for (x, found) in [(f64::INFINITY, "inf"), (f64::NEG_INFINITY, "-inf"), (f64::NAN, "NaN"), (1e71, "1e71")]
    {
        let body = move || (Sphere { radius: 1.0 }, Position::new(x, 0.0, 0.0));
        check(body, &format!("Position is {found}, but must be a number from -1e70 to 1e70"));
    }
}

#[test]
fn s25_a_camera_looks_somewhere() {
    for l in [DVec3::ZERO, DVec3::NAN] {
        let mut world = small_case().world();
        only::<CameraPose>(&mut world).l = l;
        let camera = world.query_filtered::<Entity, With<Lens>>().single(&world).unwrap();
        let message = format!(
            "entity {camera}: CameraPose l, r and u must be unit vectors at right angles, with u = r x l"
        );
        assert_eq!(error_of::<f64>(&mut world).to_string(), message);
        assert_eq!(error_of::<f32>(&mut world).to_string(), message);
    }
}

#[test]
fn b12_a_side_is_a_length() {
    for (side, found) in [(0.0, "0"), (-1.0, "-1"), (f64::NAN, "NaN"), (f64::INFINITY, "inf")] {
        check(|| Cube { side }, &format!("Cube.side is {found}, but {LENGTH}"));
    }
}

#[test]
fn p09_width_and_height_are_lengths() {
    for (length, found) in [(0.0, "0"), (-1.0, "-1"), (f64::NAN, "NaN"), (f64::INFINITY, "inf")] {
        let flat = || Pyramid { width: 1.0, height: length };
        check(flat, &format!("Pyramid.height is {found}, but {LENGTH}"));
        let empty = || Pyramid { width: length, height: 1.0 };
        check(empty, &format!("Pyramid.width is {found}, but {LENGTH}"));
    }
}

#[test]
fn c10_a_cell_is_a_length() {
    for (cell, found) in [(0.0, "0"), (-1.0, "-1"), (f64::NAN, "NaN")] {
        check(|| Checkerboard { cell }, &format!("Checkerboard.cell is {found}, but {LENGTH}"));
    }
}

#[test]
fn l05_a_falloff_is_not_below_zero() {
    for (falloff, found) in [(-1.0, "-1"), (f64::NAN, "NaN"), (f64::INFINITY, "inf")] {
        let message = format!("Falloff is {found}, but must be a number from 0 to 1e150");
        check(|| (Light, Falloff(falloff)), &message);
    }
}

#[test]
fn l10_a_cutoff_is_at_most_half_a_turn() {
    for (cutoff, found) in [(180.5, "180.5"), (-1.0, "-1"), (f64::NAN, "NaN")] {
        let message = format!("SpotCone.cutoff is {found}, but must be an angle from 0 to 180 degrees");
        check(|| (Light, SpotCone { target: DVec3::X, cutoff }), &message);
    }
}

#[test]
fn l11_a_spotlight_has_a_direction() {
    let target = DVec3::new(1.0, 2.0, 3.0);
    let blind = || (Light, Position(target), SpotCone { target, cutoff: 20.0 });
    let message = |precision: &str| {
        let end = "the light's own position: the cone has no direction";
        format!("entity {{entity}}: SpotCone.target is, in {precision}, {end}")
    };
    assert_bundle_refused::<f64, _>(blind, &message("f64"));
    assert_bundle_refused::<f32, _>(blind, &message("f32"));
}

#[test]
fn l15_a_shininess_is_not_below_zero() {
    for (shininess, found) in [(-1.0, "-1"), (f64::NAN, "NaN"), (f64::INFINITY, "inf")] {
        let body = move || (Sphere { radius: 1.0 }, Gloss { specular: 0.2, shininess });
        check(body, &format!("Gloss.shininess is {found}, but must be a number from 0 to 1e9"));
    }
}

#[test]
fn k03_the_near_plane_is_ahead_and_the_far_one_behind_it() {
    check_lens(|lens| lens.near = 0.0, &format!("Lens.near is 0, but {LENGTH}"));
    check_lens(|lens| lens.near = -1.0, &format!("Lens.near is -1, but {LENGTH}"));
    let message = "Lens.far is 1, but must be greater than Lens.near, 2";
    check_lens(|lens| (lens.near, lens.far) = (2.0, 1.0), message);
    check_lens(|lens| (lens.near, lens.far) = (2.0, 2.0), &message.replace("is 1", "is 2"));
}

#[test]
fn k05_both_fields_of_view_are_below_half_a_turn() {
    let angle = "must be an angle above 0 and below 180 degrees";
    let both = |fovy: &str| {
        format!(
            "Lens.fovy is {fovy}, but {angle}\nentity {{entity}}: Lens.fovy * aspect is {fovy}, but {angle}"
        )
    };
    check_lens(|lens| (lens.fovy, lens.aspect) = (180.0, 1.0), &both("180"));
    check_lens(|lens| (lens.fovy, lens.aspect) = (360.0, 1.0), &both("360"));
    check_lens(|lens| (lens.fovy, lens.aspect) = (0.0, 1.0), &both("0"));
    let wide = format!("Lens.fovy * aspect is 180, but {angle}");
    check_lens(|lens| (lens.fovy, lens.aspect) = (90.0, 2.0), &wide);
}

#[test]
fn k06_a_picture_has_pixels() {
    let mut world = small_case().world();
    world.insert_resource(Snapshot { pixels: 0, level: 3 });
    let message = "Snapshot.pixels is 0, but must be from 1 to 8192";
    assert_eq!(error_of::<f64>(&mut world).to_string(), message);
    assert_eq!(error_of::<f32>(&mut world).to_string(), message);
}

#[test]
fn e02_a_light_without_a_position_and_an_object_without_a_surface_are_told() {
    let mut world = small_case().world();
    let light = world.query_filtered::<Entity, With<Light>>().iter(&world).min().unwrap();
    world.entity_mut(light).remove::<Position>();
    let message = format!("entity {light}: a Light needs Position, and not all of that is there");
    assert_eq!(error_of::<f64>(&mut world).to_string(), message);
    let mut world = small_case().world();
    let cube = world.query_filtered::<Entity, With<Cube>>().iter(&world).min().unwrap();
    world.entity_mut(cube).remove::<Diffuse>();
    let message = format!(
        "entity {cube}: a Cube needs Position, Color, Ambient and Diffuse, and not all of that is there"
    );
    assert_eq!(error_of::<f32>(&mut world).to_string(), message);
}

#[test]
fn e02_of_two_boards_the_upper_one_is_seen_from_above() {
    let with_board = |z: f64| {
        let mut world = small_case().world();
        world.spawn((Checkerboard { cell: 7.0 }, Position::new(0.0, 0.0, z), Diffuse(0.6)));
        trace::<f64>(&mut world).picture
    };
    let one = trace::<f64>(&mut small_case().world()).picture;
    assert_same("a board far below", &with_board(-60.0), &one);
    assert_ne!(with_board(1.0), one);
}

//! Markers of lights, cones, axes and outlines.

use archetrace::components::{CameraPose, Checkerboard, Color, Lens, Light, Position, Sphere, SpotCone};
use archetrace::preview::{DrawList, PreviewStyle};
use bevy_ecs::prelude::*;
use glam::DVec3;

use super::canvas::{Canvas, PLAIN, Shot, draw_once};

const LENS: Lens = Lens { near: 1.0, far: 1000.0, fovy: 60.0, aspect: 1.0 };
const SIDE: usize = 201;
const LIGHTS: PreviewStyle = PreviewStyle { lights: true, background: [0.0; 3], ..PLAIN };
const AXES: PreviewStyle = PreviewStyle { axes: true, background: [0.0; 3], ..PLAIN };

fn draw(world: &mut World, style: &PreviewStyle) -> Shot {
    draw_once(world, (&CameraPose::default(), &LENS), style, SIDE)
}

fn with_light(y: f64) -> World {
    let mut world = World::new();
    world.spawn((Light, Position::new(0.0, y, 50.0)));
    world
}

/// Pixels that show anything.
fn shown(shot: &Shot) -> usize {
    shot.count(|pixel| pixel != [0; 3])
}

#[test]
fn a_light_has_the_same_marker_at_every_distance() {
    let near = draw(&mut with_light(-140.0), &LIGHTS);
    assert_eq!(near, draw(&mut with_light(700.0), &LIGHTS));
    // A disc of five pixels around the middle, warm white.
    assert!((70..90).contains(&shown(&near)), "{}", shown(&near));
    assert_eq!(near.at(100, 100), [255, 237, 191]);
}

#[test]
fn a_light_is_hidden_by_what_is_in_front_and_by_the_switch() {
    assert_eq!(shown(&draw(&mut with_light(0.0), &PreviewStyle { lights: false, ..LIGHTS })), 0);
    for (y, visible) in [(-60.0, true), (60.0, false)] {
        let mut world = with_light(y);
        world.spawn((Sphere { radius: 20.0 }, Position::new(0.0, 0.0, 50.0), Color::new(0.0, 0.0, 1.0)));
        let marker = draw(&mut world, &LIGHTS).count(|[red, ..]| red > 0);
        assert_eq!(marker > 0, visible, "light at y = {y}");
    }
}

#[test]
fn a_light_before_the_near_or_beyond_the_far_plane_is_not_there() {
    for y in [-149.5, -200.0, 900.0] {
        assert_eq!(shown(&draw(&mut with_light(y), &LIGHTS)), 0, "light at y = {y}");
    }
}

#[test]
fn a_spotlight_shows_its_cone_and_a_cone_of_180_degrees_shows_none() {
    let shown_with = |cutoff: f64| {
        let mut world = World::new();
        let cone = SpotCone { target: DVec3::new(10.0, 0.0, 10.0), cutoff };
        world.spawn((Light, Position::new(0.0, 0.0, 80.0), cone));
        shown(&draw(&mut world, &LIGHTS))
    };
    let marker = shown_with(180.0);
    assert!((70..90).contains(&marker), "{marker}");
    for cutoff in [0.0, 20.0, 90.0, 150.0] {
        assert!(shown_with(cutoff) > marker + 60, "{cutoff}: {}", shown_with(cutoff));
    }
}

/// Which axes a picture shows: pixels mostly red, green, blue.
fn axes_of(shot: &Shot) -> [usize; 3] {
    let of = |axis: usize| {
        shot.count(|pixel| {
            pixel[axis] > 150 && (0..3).all(|other| other == axis || pixel[other] < pixel[axis])
        })
    };
    [of(0), of(1), of(2)]
}

#[test]
fn axes_lie_where_they_are_and_on_the_board_too() {
    let mut world = with_light(100.0);
    let position = DVec3::new(90.0, -150.0, 120.0);
    let pose = CameraPose::looking(position, DVec3::new(30.0, 30.0, 20.0) - position, DVec3::Z).unwrap();
    let bare = draw_once(&mut world, (&pose, &LENS), &AXES, SIDE);
    world.spawn(Checkerboard { cell: 20.0 });
    let boarded = draw_once(&mut world, (&pose, &LENS), &AXES, SIDE);
    for (axis, (bare, boarded)) in axes_of(&bare).into_iter().zip(axes_of(&boarded)).enumerate() {
        println!("axis {axis}: {bare} pixels, {boarded} on the board");
        assert!(bare > 60, "axis {axis}: {bare}");
        assert!(boarded * 10 > bare * 8, "axis {axis}: {bare} alone, {boarded} on the board");
    }
    // Their ends, where the light's distance of 100 units puts them.
    for (axis, end) in [DVec3::X, DVec3::Y, DVec3::Z].into_iter().enumerate() {
        let [inside, outside] = [97.0, 103.0].map(|length| {
            let seen = end * length - pose.position;
            let extent = 30_f64.to_radians().tan() * seen.dot(pose.l);
            let pixel = |along: f64| ((1.0 + along / extent) * 0.5 * SIDE as f64) as usize;
            bare.at(pixel(seen.dot(pose.r)), pixel(-seen.dot(pose.u)))
        });
        assert!(inside[axis] > 150, "axis {axis}: {inside:?}");
        assert_eq!(outside, [0; 3], "axis {axis}");
    }
    let off = draw_once(&mut world, (&pose, &LENS), &PreviewStyle { axes: false, ..AXES }, SIDE);
    assert_eq!(axes_of(&off), [0; 3]);
}

#[test]
fn a_line_that_passes_the_eye_is_cut_at_the_near_plane() {
    // The y axis runs from before the camera to behind it, half a unit below.
    let mut world = with_light(100.0);
    let pose = CameraPose::looking(DVec3::new(0.0, 50.0, 0.5), DVec3::Y, DVec3::Z).unwrap();
    let shot = draw_once(&mut world, (&pose, &Lens { near: 0.1, ..LENS }), &AXES, SIDE);
    let column: Vec<usize> = (0..SIDE).filter(|&row| shot.at(100, row)[1] > 150).collect();
    assert_eq!(column.last(), Some(&(SIDE - 1)), "{column:?}");
    assert!(column.len() > 90, "{column:?}");
    assert!(column.windows(2).all(|rows| rows[1] == rows[0] + 1), "{column:?}");
}

#[test]
fn an_outline_is_drawn_until_it_is_taken_away() {
    let canvas = &mut Canvas::new();
    let mut list = DrawList::default();
    let mut shown_now = |list: &DrawList| {
        let style = PreviewStyle { background: [0.0; 3], ..PLAIN };
        shown(&canvas.draw_list(list, (&CameraPose::default(), &LENS), &style, SIDE))
    };
    assert_eq!(shown_now(&list), 0);
    list.set_outline(Some([DVec3::new(-20.0, 0.0, 30.0), DVec3::new(20.0, 40.0, 70.0)]));
    let edges = shown_now(&list);
    assert!(edges > 300, "{edges}");
    list.set_outline(Some([DVec3::splat(f64::NAN), DVec3::ONE]));
    assert_eq!(shown_now(&list), 0);
}

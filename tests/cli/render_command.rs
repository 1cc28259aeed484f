//! The command line that the window prints for a view: run by a shell, it writes the bytes of that very view.

use std::ffi::{OsStr, OsString};
use std::fs;
use std::os::unix::ffi::OsStrExt;
use std::path::Path;

use archetrace::components::{CameraPose, Precision, Sampling, Snapshot};
use archetrace::effects::{Effect, EffectSet};
use archetrace::geometry::Real;
use archetrace::image_file::encode;
use archetrace::scene::{Source, spawn};
use archetrace::study::Setting;
use archetrace::systems::{Frame, Muted, Workers, frame_schedule, prepare};
use archetrace::viewer::RenderCommand;
use bevy_ecs::prelude::*;
use glam::{DQuat, DVec3};

use crate::program::{Folder, SCENE};
use crate::random::Random;

/// A camera near the scene whose basis turns have rounded, as they do in the window.
fn turned_pose(seed: u64) -> CameraPose {
    let mut random = Random::new(seed);
    let position = random.point(20.0) + DVec3::new(0.0, -80.0, 40.0);
    let start = CameraPose::looking(position, random.point(20.0) - position, random.direction()).unwrap();
    (0..9).fold(start, |CameraPose { position, l, r, u }, _| {
        let turn = DQuat::from_axis_angle(random.direction(), random.between(-0.05, 0.05));
        CameraPose { position, l: turn * l, r: turn * r, u: turn * u }
    })
}

fn command<'a>(scene: &'a Path, output: &'a Path, pose: &'a CameraPose) -> RenderCommand<'a> {
    RenderCommand { scene, output, pose, setting: None, muted: EffectSet::NONE, texture: &[] }
}

/// Runs the line in a shell, with the program's name replaced by its place.
#[track_caller]
fn run(folder: &Folder, command: &RenderCommand<'_>) {
    let line = command.to_string();
    let arguments = line.strip_prefix("archetrace ").unwrap();
    folder.bash(&format!("$P {arguments}")).quiet();
}

/// The bytes of the picture of [`SCENE`] that the library makes from this pose.
fn picture<T: Real>(pose: &CameraPose, snapshot: Snapshot, sampling: Sampling, muted: EffectSet) -> Vec<u8> {
    let mut world = World::new();
    spawn(&mut world, &Source::new("scene", SCENE).load().unwrap().description);
    for mut camera in world.query::<&mut CameraPose>().iter_mut(&mut world) {
        *camera = CameraPose::looking(pose.position, pose.l, pose.u).unwrap();
    }
    world.insert_resource(snapshot);
    world.insert_resource(sampling);
    world.insert_resource(Muted(muted));
    prepare::<T>(&mut world, Workers::new(None).unwrap());
    frame_schedule::<T>().run(&mut world);
    encode(world.resource::<Frame>().traced().unwrap().0, Path::new("picture.bmp")).unwrap()
}

#[test]
fn the_line_writes_the_bytes_of_the_view() {
    let folder = Folder::with_scene();
    let of_the_scene = Snapshot { pixels: 32, level: 3 };
    let (scene, output) = (Path::new("scene.txt"), Path::new("out.bmp"));
    for seed in 1..=30 {
        let pose = turned_pose(seed);
        run(&folder, &command(scene, output, &pose));
        let expected = picture::<f64>(&pose, of_the_scene, Sampling::default(), EffectSet::NONE);
        assert!(folder.read("out.bmp") == expected, "seed {seed}");
    }
}

#[test]
fn what_differs_from_the_scene_is_in_the_line() {
    let folder = Folder::with_scene();
    let pose = turned_pose(31);
    let sampling = Sampling { side: 3 };
    let muted = EffectSet::of(&[Effect::Mirror, Effect::Falloff]);
    let setting = Setting {
        side: 3,
        threshold: None,
        level: 2,
        cutoff: 0.0,
        precision: Precision::F32,
        checker_filter: false,
        texture_filter: None,
        light_samples: None,
        pixels: 40,
    };
    let with_everything = RenderCommand {
        setting: Some(setting),
        muted,
        ..command(Path::new("scene.txt"), Path::new("out.bmp"), &pose)
    };
    run(&folder, &with_everything);
    let expected = picture::<f32>(&pose, Snapshot { pixels: 40, level: 2 }, sampling, muted);
    assert!(folder.read("out.bmp") == expected);
}

#[test]
fn it_reads_well() {
    let pose = CameraPose::default();
    let line = command(Path::new("scenes/official.txt"), Path::new("official-001.bmp"), &pose).to_string();
    let expected = "archetrace render scenes/official.txt --output=official-001.bmp --eye=0,-150,50 --look=0,1,0 \
                    --up=0,0,1";
    assert_eq!(line, expected);
}

#[test]
fn texture_arguments_are_passed_on() {
    let folder = Folder::with_scene();
    let image = |color| image::RgbImage::from_pixel(2, 2, image::Rgb(color));
    image([200, 30, 10]).save(folder.path("a light one.bmp")).unwrap();
    image([10, 60, 90]).save(folder.path("dark.bmp")).unwrap();
    let texture = ["--texture", "--white", "a light one.bmp", "--black", "dark.bmp"].map(OsString::from);
    let pose = CameraPose::default();
    let plain = command(Path::new("scene.txt"), Path::new("out.bmp"), &pose);
    run(&folder, &RenderCommand { texture: &texture, ..plain });
    let words: Vec<&str> = ["render", "scene.txt", "-o", "by_hand.bmp"]
        .into_iter()
        .chain(texture.iter().map(|word| word.to_str().unwrap()))
        .collect();
    folder.run_list(&words).quiet();
    assert!(folder.read("out.bmp") == folder.read("by_hand.bmp"));
    assert!(folder.read("out.bmp") != folder.render(""));
}

#[test]
fn names_of_every_kind_come_through_the_shell() {
    let folder = Folder::empty();
    let pose = CameraPose::default();
    let expected =
        picture::<f64>(&pose, Snapshot { pixels: 32, level: 3 }, Sampling::default(), EffectSet::NONE);
    for stem in [
        "two words",
        "-starts_with_a_dash",
        "--help",
        "it's",
        "a\"b",
        "$HOME `id` $(id) !",
        "back\\slash",
        "tab\tline\nescape\u{1b}[31m'\\x41",
        "~",
        "*?[a]{b,c};&|<>#",
        "Käse 猫",
    ] {
        check_name(&folder, OsStr::new(stem), &expected);
    }
    check_name(&folder, OsStr::from_bytes(b"no \xff text\xc3"), &expected);
}

fn check_name(folder: &Folder, stem: &OsStr, expected: &[u8]) {
    let (mut scene, mut output) = (stem.to_owned(), stem.to_owned());
    scene.push(".txt");
    output.push(".bmp");
    fs::write(folder.path("").join(&scene), SCENE).unwrap();
    let pose = CameraPose::default();
    let command = command(Path::new(&scene), Path::new(&output), &pose);
    let line = command.to_string();
    assert!(!line.chars().any(char::is_control), "{line:?}");
    run(folder, &command);
    assert!(fs::read(folder.path("").join(&output)).unwrap() == expected, "{line}");
}

//! Writes spheres over the checkerboard for every program that `benches/peers.sh` runs: the scene file with the flags of
//! our camera, and what POV-Ray and tachyon read.
//!
//! ```text
//! cargo run --release --example spheres -- COUNT PIXELS FOLDER
//! ```

#[path = "support/crowd.rs"]
mod crowd;
#[path = "../tests/support/random.rs"]
#[allow(
    dead_code,
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    reason = "shared with the tests: small whole numbers, and not all of it is used here"
)]
mod random;

use std::error::Error;
use std::fs::{File, create_dir_all, write};
use std::io::{self, BufWriter, Write};
use std::path::Path;

use archetrace::components::CameraPose;
use archetrace::scene::{Description, LightDescription, ShapeDescription};
use glam::DVec3;

use crowd::{EYE, TARGET, camera, crowd, surfaces};

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [count, pixels, folder] = words.as_slice() else { return Err("give COUNT PIXELS FOLDER".into()) };
    let folder = Path::new(folder);
    let scene = crowd(count.parse()?, pixels.parse()?);
    create_dir_all(folder)?;
    write(folder.join("scene.txt"), scene.to_string())?;
    let look = TARGET - EYE;
    write(folder.join("scene.cam"), format!("--eye {} --look {}\n", list(EYE, ","), list(look, ",")))?;
    to_file(&folder.join("scene.pov"), |out| povray(out, &scene, camera()))?;
    to_file(&folder.join("scene.dat"), |out| tachyon(out, &scene, camera()))?;
    Ok(())
}

fn to_file(path: &Path, text: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>) -> io::Result<()> {
    let mut out = BufWriter::new(File::create(path)?);
    text(&mut out)?;
    out.flush()
}

/// Three numbers with something between them.
fn list(v: DVec3, between: &str) -> String {
    format!("{}{between}{}{between}{}", v.x, v.y, v.z)
}

fn povray(out: &mut impl Write, scene: &Description, camera: CameraPose) -> io::Result<()> {
    let side = 2.0 * (scene.fovy.to_radians() / 2.0).tan();
    let (right, up) = (camera.r * (side * scene.aspect), camera.u * side);
    let vector = |v| format!("<{}>", list(v, ","));
    writeln!(out, "#version 3.7;")?;
    writeln!(
        out,
        "global_settings {{ assumed_gamma 1 max_trace_level {} adc_bailout 0 ambient_light rgb 1 }}",
        scene.level
    )?;
    writeln!(
        out,
        "camera {{ perspective location {} direction {} right {} up {} }}",
        vector(camera.position),
        vector(camera.l),
        vector(right),
        vector(up)
    )?;
    for LightDescription { position, falloff } in &scene.lights {
        let distance = falloff.sqrt().recip();
        writeln!(
            out,
            "light_source {{ {} rgb 1 fade_distance {distance} fade_power 2 }}",
            vector(*position)
        )?;
    }
    let board = &scene.board;
    // The pattern is moved off the plane, where rounding would decide its colour.
    writeln!(
        out,
        "plane {{ z, 0 pigment {{ checker rgb 1, rgb 0 scale {0} translate z*{0}/2 }} finish {{ ambient {1} diffuse {2} reflection {3} }} }}",
        board.cell, board.ambient, board.diffuse, board.reflection
    )?;
    for (number, surface) in surfaces().iter().enumerate() {
        let color = vector(surface.color);
        let finish = format!("ambient {} diffuse {}", surface.ambient, surface.diffuse);
        let gloss = format!("phong {} phong_size {}", surface.specular, surface.shininess);
        writeln!(
            out,
            "#declare T{number} = texture {{ pigment {{ rgb {color} }} finish {{ {finish} {gloss} reflection {} }} }}",
            surface.reflection
        )?;
    }
    spheres(scene).try_for_each(|(center, radius, number)| {
        writeln!(out, "sphere {{ {}, {radius} texture {{ T{number} }} }}", vector(center))
    })
}

/// Its camera is left-handed and mirrors the picture, which costs no time.
fn tachyon(out: &mut impl Write, scene: &Description, camera: CameraPose) -> io::Result<()> {
    let zoom = 0.5 / (scene.fovy.to_radians() / 2.0).tan();
    let [position, look, up] = [camera.position, camera.l, camera.u].map(|v| list(v, " "));
    writeln!(out, "BEGIN_SCENE\nRESOLUTION {0} {0}", scene.pixels)?;
    writeln!(out, "CAMERA ZOOM {zoom} ASPECTRATIO 1 ANTIALIASING 0 RAYDEPTH {}", scene.level)?;
    writeln!(out, "CENTER {position} VIEWDIR {look} UPDIR {up} END_CAMERA\nBACKGROUND 0 0 0")?;
    for light in &scene.lights {
        writeln!(out, "LIGHT CENTER {} RAD 0.1 COLOR 1 1 1", list(light.position, " "))?;
    }
    let board = &scene.board;
    let texture =
        format!("AMBIENT {} DIFFUSE {} SPECULAR {}", board.ambient, board.diffuse, board.reflection);
    let pattern = format!("CENTER 0 0 {} ROTATE 0 0 0 SCALE {1} {1} {1}", board.cell / 2.0, board.cell);
    writeln!(
        out,
        "PLANE CENTER 0 0 0 NORMAL 0 0 1 TEXTURE {texture} OPACITY 1 COLOR 1 1 1 TEXFUNC 1 {pattern}"
    )?;
    for (number, surface) in surfaces().iter().enumerate() {
        let color = list(surface.color, " ");
        let finish = format!(
            "AMBIENT {} DIFFUSE {} SPECULAR {}",
            surface.ambient, surface.diffuse, surface.reflection
        );
        let gloss = format!("PHONG PLASTIC {} PHONG_SIZE {}", surface.specular, surface.shininess);
        writeln!(out, "TEXDEF T{number} {finish} OPACITY 1 {gloss} COLOR {color} TEXFUNC 0")?;
    }
    spheres(scene).try_for_each(|(center, radius, number)| {
        writeln!(out, "SPHERE CENTER {} RAD {radius} T{number}", list(center, " "))
    })?;
    writeln!(out, "END_SCENE")
}

/// Centre, radius, and the number of the surface.
fn spheres(scene: &Description) -> impl Iterator<Item = (DVec3, f64, usize)> {
    let surfaces = surfaces();
    scene.objects.iter().filter_map(move |object| match object.shape {
        ShapeDescription::Sphere { radius } => {
            Some((object.position, radius, surfaces.iter().position(|surface| *surface == object.surface)?))
        }
        _ => None,
    })
}

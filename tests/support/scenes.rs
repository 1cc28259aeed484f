//! Scenes: one that shows everything, and random ones, each a function of its seed.

use std::sync::Arc;

use archetrace::components::{CameraPose, Texture, Textured};
use archetrace::scene::{
    BoardDescription, Description, LightDescription, ObjectDescription, ShapeDescription, Source,
    SpotDescription, SurfaceDescription,
};
use glam::DVec3;

use super::case::Case;
use super::random::Random;

/// All shapes (some touching, one cut by the board), three lights, two spotlights, gloss, mirrors, four levels.
/// Coordinates and lengths are whole, so that corners are exact whichever way they are computed.
const SCENE: &str = "
    2 900 55 1.2  4  160
    32  0.21 0.33 0.3
    8
    sphere  24 18 20      20     0.3 0.9 0.5  0.11 0.4 0.4 0.3  30
    sphere -30 52 9       9      0.9 0.8 0.1  0.13 0.3 0.5 0.5  7
    sphere  3 -41 6       10     0.7 0.2 0.9  0.17 0.6 0 0.1    1
    cube   -61 -22 0      31     0.1 0.5 0.9  0.19 0.5 0.2 0.4  10
    cube   -30 -22 0      17     0.9 0.5 0.4  0.07 0.7 0 0      1
    cube    41 -35 -8     24     0.6 0.6 0.7  0.05 0.2 0.3 0.7  90
    pyramid -9 2 0        26 44  1.0 0.3 0.2  0.23 0.5 0.2 0.2  12
    pyramid 50 20 5       18 13  0.4 1.0 0.9  0.09 0.4 0 0.45   1
    3
    70 63 101   0.00002
    -83 -71 120 0
    5 -99 37    0.00004
    2
    -72 68 77   0.000003  -9 12 8   35
    60 -80 90   0         20 0 5    20
";

/// A view that runs along no axis, with no pixel centre on the edge of a cell.
pub(crate) fn full_case() -> Case {
    let description = Source::new("scene", SCENE).load().unwrap().description;
    let position = DVec3::new(37.123, -141.77, 68.31);
    let look = DVec3::new(2.31, 3.77, 5.13) - position;
    Case {
        pose: CameraPose::looking(position, look, DVec3::new(0.03, 0.02, 1.0)).unwrap(),
        ..Case::new(description)
    }
}

/// The same with images on the board.
pub(crate) fn textured_case() -> Case {
    let random = &mut Random::new(5);
    Case {
        textured: Some(Textured { white: noise(random, 7, 5), black: noise(random, 4, 9) }),
        ..full_case()
    }
}

/// A scene of up to six objects of each kind, three lights and two spotlights.
pub(crate) fn random_case(seed: u64, pixels: u32) -> Case {
    let random = &mut Random::new(seed);
    let objects = random_objects(random);
    let near = random.pick(&[0.1, 1.0, 5.0, 20.0]);
    let fovy = random.pick(&[20.0, 40.0, 60.0, 80.0, 110.0]);
    let description = Description {
        near,
        far: near + random.pick(&[100.0, 400.0, 2000.0, 2000.0]),
        fovy,
        aspect: random.pick(&[0.4, 1.0, 1.3, 1.6]),
        level: random.pick(&[0, 1, 2, 2, 3, 3, 4, 4, 4, 5, 5, 5, 5, 5]),
        pixels,
        board: random_board(random),
        lights: (0..random.below(4)).map(|_| random_light(random)).collect(),
        spots: (0..random.below(3)).map(|_| random_spot(random)).collect(),
        objects,
    };
    let textured =
        random.one_in(3).then(|| Textured { white: random_texture(random), black: random_texture(random) });
    let pose = random_pose(random, &description);
    Case { textured, pose, ..Case::new(description) }
}

fn random_objects(random: &mut Random) -> Vec<ObjectDescription> {
    let mut objects = Vec::new();
    for kind in 0..3 {
        for _ in 0..random.below(7) {
            objects.push(random_object(random, kind));
        }
    }
    random.shuffle(&mut objects);
    objects
}

fn random_object(random: &mut Random, kind: usize) -> ObjectDescription {
    let size = random.between(4.0, 35.0);
    let mut position = random.point(60.0);
    // Lowest point: on the board, through the board, or anywhere.
    let anywhere = random.between(-60.0, 60.0);
    position.z = random.pick(&[0.0, -0.3 * size, anywhere]);
    let shape = match kind {
        0 => ShapeDescription::Sphere { radius: size },
        1 => ShapeDescription::Cube { side: size },
        _ => ShapeDescription::Pyramid { width: size, height: random.between(3.0, 50.0) },
    };
    if kind == 0 {
        position.z += size;
    }
    ObjectDescription { position, shape, surface: random_surface(random) }
}

fn random_surface(random: &mut Random) -> SurfaceDescription {
    let mut coefficient = || {
        let share = random.unit();
        random.pick(&[0.0, share, share])
    };
    let [ambient, diffuse, specular, reflection] = core::array::from_fn(|_| coefficient());
    let color = DVec3::new(random.unit(), random.unit(), random.unit());
    SurfaceDescription {
        color,
        ambient: 0.6 * ambient,
        diffuse,
        specular,
        reflection,
        shininess: random.pick(&[0.0, 1.0, 2.0, 7.5, 30.0, 200.0]),
    }
}

fn random_board(random: &mut Random) -> BoardDescription {
    BoardDescription {
        cell: random.between(5.0, 60.0),
        ambient: random.between(0.05, 0.5),
        diffuse: random.unit(),
        reflection: random.pick(&[0.0, 0.0, 0.3, 0.8]),
    }
}

fn random_light(random: &mut Random) -> LightDescription {
    let mut position = random.point(130.0);
    position.z = random.pick(&[-50.0, 40.0, 90.0, 140.0]);
    LightDescription { position, falloff: random.pick(&[0.0, 1e-6, 2e-5, 1e-4]) }
}

fn random_spot(random: &mut Random) -> SpotDescription {
    SpotDescription {
        light: random_light(random),
        target: random.point(50.0),
        cutoff: random.pick(&[0.5, 8.0, 30.0, 60.0, 90.0, 120.0, 175.0, 180.0]),
    }
}

fn random_texture(random: &mut Random) -> Arc<Texture> {
    let (width, height) = random.pick(&[(1, 1), (2, 3), (5, 4), (16, 9)]);
    noise(random, width, height)
}

fn noise(random: &mut Random, width: u32, height: u32) -> Arc<Texture> {
    let texels =
        (0..width * height).map(|_| random.bits().to_le_bytes()).map(|[r, g, b, ..]| [r, g, b]).collect();
    Arc::new(Texture::new(width, height, texels).expect("as many texels as announced"))
}

/// Around the scene, level or tilted; below the board; or in the middle of an object.
fn random_pose(random: &mut Random, description: &Description) -> CameraPose {
    let mut position = random.direction() * random.between(50.0, 180.0);
    let inside = description.objects.get(random.below(description.objects.len().max(1)));
    match (random.below(6), inside) {
        (0, _) => position.z = -position.z.abs(),
        (1, Some(object)) => position = within(object),
        _ => position.z = position.z.abs(),
    }
    let target = random.point(25.0);
    let level = random.one_in(2);
    let up = if level { DVec3::Z } else { random.direction() };
    CameraPose::looking(position, target - position, up).expect("a direction that is not zero")
}

fn within(object: &ObjectDescription) -> DVec3 {
    let to_middle = match object.shape {
        ShapeDescription::Sphere { radius } => DVec3::new(0.3 * radius, 0.2 * radius, 0.1 * radius),
        ShapeDescription::Cube { side } => DVec3::splat(0.45 * side),
        ShapeDescription::Pyramid { width, height } => DVec3::new(0.52 * width, 0.49 * width, 0.25 * height),
    };
    object.position + to_middle
}

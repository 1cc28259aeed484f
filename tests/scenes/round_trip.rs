//! Description to text to description: every bit comes back.

use archetrace::scene::{
    BoardDescription, Description, LightDescription, ObjectDescription, ShapeDescription, SpotDescription,
    SurfaceDescription, parse,
};
use glam::DVec3;

use crate::random::Random;
use crate::sample::{SAMPLE, read};

const COORDINATES: [f64; 12] = [
    0.0,
    -0.0,
    1e70,
    -1e70,
    5e-324,
    -5e-324,
    2.225_073_858_507_201e-308,
    0.1,
    -123.456,
    9_007_199_254_740_993.0,
    1e-6,
    999_999_999_999_999.9,
];
const LENGTHS: [f64; 6] = [1e-70, 1e70, 1.0, 0.1, 1e22, 3.0e-7];
const SHARES: [f64; 7] = [0.0, -0.0, 1.0, 0.5, 5e-324, 0.3, 0.999_999_999_999_999_9];

fn decades(random: &mut Random, low: i32, high: i32) -> f64 {
    let span = u32::try_from(high - low).unwrap();
    10_f64.powf(f64::from(low) + random.unit() * f64::from(span))
}

fn coordinate(random: &mut Random) -> f64 {
    match random.below(3) {
        0 => random.pick(&COORDINATES),
        1 => random.unit() * 200.0 - 100.0,
        _ => decades(random, -300, 70) * random.pick(&[1.0, -1.0]),
    }
}

fn point(random: &mut Random) -> DVec3 {
    DVec3::new(coordinate(random), coordinate(random), coordinate(random))
}

fn length(random: &mut Random) -> f64 {
    match random.below(2) {
        0 => random.pick(&LENGTHS),
        _ => decades(random, -69, 69),
    }
}

fn share(random: &mut Random) -> f64 {
    match random.below(2) {
        0 => random.pick(&SHARES),
        _ => random.unit(),
    }
}

fn light(random: &mut Random) -> LightDescription {
    let falloff = match random.below(3) {
        0 => random.pick(&[0.0, -0.0, 1e150, 5e-324]),
        _ => decades(random, -200, 149),
    };
    LightDescription { position: point(random), falloff }
}

fn object(random: &mut Random) -> ObjectDescription {
    let shape = match random.below(3) {
        0 => ShapeDescription::Sphere { radius: length(random) },
        1 => ShapeDescription::Cube { side: length(random) },
        _ => ShapeDescription::Pyramid { width: length(random), height: length(random) },
    };
    let shininess = match random.below(3) {
        0 => random.pick(&[0.0, -0.0, 1e9, 5e-324]),
        _ => decades(random, -100, 8),
    };
    ObjectDescription {
        position: point(random),
        shape,
        surface: SurfaceDescription {
            color: DVec3::new(share(random), share(random), share(random)),
            ambient: share(random),
            diffuse: share(random),
            specular: share(random),
            reflection: share(random),
            shininess,
        },
    }
}

fn spot(random: &mut Random) -> SpotDescription {
    let light = light(random);
    let target = loop {
        let target = point(random);
        if target != light.position {
            break target;
        }
    };
    let cutoff = random.pick(&[0.0, -0.0, 180.0, 5e-324, 45.3, 90.0]);
    SpotDescription { light, target, cutoff }
}

fn many<T>(random: &mut Random, item: impl Fn(&mut Random) -> T) -> Vec<T> {
    (0..random.below(5)).map(|_| item(random)).collect()
}

/// A valid scene.
pub(crate) fn description(seed: u64) -> Description {
    let random = &mut Random::new(seed);
    let near = length(random).min(9e69);
    let (fovy, aspect) =
        random.pick(&[(60.0, 1.0), (179.999_999_999_999_97, 1e-6), (1e-300, 1e6), (0.1, 1.7), (89.9, 2.0)]);
    Description {
        near,
        far: random.pick(&[near.next_up(), 1e70, near * 1.1]),
        fovy,
        aspect,
        level: random.pick(&[0, 1, 7, 1000]),
        pixels: random.pick(&[1, 2, 768, 8192]),
        board: BoardDescription {
            cell: length(random),
            ambient: share(random),
            diffuse: share(random),
            reflection: share(random),
        },
        objects: many(random, object),
        lights: many(random, light),
        spots: many(random, spot),
    }
}

/// Every value in order, so that 0 and -0 differ.
pub(crate) fn bits(scene: &Description) -> Vec<u64> {
    let mut values = vec![scene.near, scene.far, scene.fovy, scene.aspect];
    values.extend([f64::from(scene.level), f64::from(scene.pixels)]);
    let board = scene.board;
    values.extend([board.cell, board.ambient, board.diffuse, board.reflection]);
    for object in &scene.objects {
        values.extend(object.position.to_array());
        values.extend(match object.shape {
            ShapeDescription::Sphere { radius } => [1.0, radius, 0.0],
            ShapeDescription::Cube { side } => [2.0, side, 0.0],
            ShapeDescription::Pyramid { width, height } => [3.0, width, height],
        });
        let surface = object.surface;
        values.extend(surface.color.to_array());
        values.extend([surface.ambient, surface.diffuse, surface.specular, surface.reflection]);
        values.push(surface.shininess);
    }
    for light in scene.lights.iter().chain(scene.spots.iter().map(|spot| &spot.light)) {
        values.extend(light.position.to_array());
        values.push(light.falloff);
    }
    for spot in &scene.spots {
        values.extend(spot.target.to_array());
        values.push(spot.cutoff);
    }
    values.into_iter().map(f64::to_bits).collect()
}

#[test]
fn a_description_comes_back_bit_by_bit() {
    for seed in 0..1000 {
        let scene = description(seed);
        let text = scene.to_string();
        let (back, _) = parse(&text).unwrap_or_else(|problems| panic!("seed {seed}: {problems:?}\n{text}"));
        assert_eq!(back, scene, "seed {seed}:\n{text}");
        assert_eq!(bits(&back), bits(&scene), "seed {seed}:\n{text}");
        assert_eq!(back.to_string(), text, "seed {seed}");
    }
}

#[test]
fn the_seeds_reach_every_part_of_a_file() {
    let scenes: Vec<Description> = (0..1000).map(description).collect();
    let objects = || scenes.iter().flat_map(|scene| &scene.objects);
    let is_negative_zero = |value: f64| value.to_bits() == (-0.0_f64).to_bits();
    assert!(objects().any(|object| is_negative_zero(object.position.x)));
    assert!(objects().any(|object| object.position.y == 5e-324));
    assert!(objects().any(|object| is_negative_zero(object.surface.reflection)));
    assert!(objects().any(|object| matches!(object.shape, ShapeDescription::Pyramid { height: 1e70, .. })));
    assert!(scenes.iter().any(|scene| scene.spots.len() == 4));
    assert!(scenes.iter().any(|scene| scene.lights.is_empty() && scene.objects.is_empty()));
}

#[test]
fn written_text_holds_no_long_row_of_zeros() {
    for seed in 0..1000 {
        let text = description(seed).to_string();
        let longest = text.split_whitespace().map(str::len).max().unwrap();
        assert!(longest <= 25, "seed {seed}: a word of {longest} characters:\n{text}");
    }
}

#[test]
fn the_sample_comes_back() {
    let scene = read(SAMPLE);
    assert_eq!(read(&scene.to_string()), scene);
}

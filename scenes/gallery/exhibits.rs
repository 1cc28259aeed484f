//! The pictures of the gallery: a stage without any effect, and what each of them adds to it.

use std::sync::Arc;

use archetrace::components::{
    Absorption, Ambient, Aperture, AreaLight, Background, CameraPose, CheckerFilter, Checkerboard, Color,
    Cube, Diffuse, Directional, ExposureStops, Falloff, Fog, Glass, Gloss, Lens, Light, LightColor, Mirror,
    Position, Pyramid, Sampling, Shutter, Snapshot, Sphere, SpotCone, SrgbTransfer, Texture, TextureFilter,
    Textured, Velocity,
};
use archetrace::effects::Effect;
use bevy_ecs::prelude::*;
use glam::DVec3;

/// A picture of the gallery.
pub(crate) struct Exhibit {
    /// What it is asked for by.
    pub(crate) name: &'static str,
    /// The effects that it has, no other.
    pub(crate) effects: &'static [Effect],
    add: fn(&mut Stage),
}

/// A World and the entities on it that effects are given to.
struct Stage {
    world: World,
    camera: Entity,
    board: Entity,
    ball: Entity,
    cube: Entity,
    pyramid: Entity,
    lamp: Entity,
}

/// Every picture, in the order in which they are listed.
pub(crate) const EXHIBITS: &[Exhibit] = &[
    Exhibit { name: "plain", effects: &[], add: |_| () },
    Exhibit { name: "gloss", effects: &[Effect::Gloss], add: gloss },
    Exhibit { name: "mirror", effects: &[Effect::Mirror], add: mirror },
    Exhibit { name: "texture", effects: &[Effect::Texture], add: texture },
    Exhibit { name: "falloff", effects: &[Effect::Falloff], add: falloff },
    Exhibit { name: "spot_cone", effects: &[Effect::SpotCone], add: spot_cone },
    Exhibit { name: "light_color", effects: &[Effect::LightColor], add: light_color },
    Exhibit { name: "directional", effects: &[Effect::Directional], add: directional },
    Exhibit { name: "area_light", effects: &[Effect::AreaLight], add: area_light },
    Exhibit { name: "background", effects: &[Effect::Background], add: background },
    Exhibit { name: "fog", effects: &[Effect::Fog], add: fog },
    Exhibit { name: "glass", effects: &[Effect::Glass], add: glass },
    Exhibit { name: "absorption", effects: &[Effect::Glass, Effect::Absorption], add: absorption },
    Exhibit { name: "aperture", effects: &[Effect::Aperture], add: aperture },
    Exhibit {
        name: "texture_filter",
        effects: &[Effect::Texture, Effect::TextureFilter],
        add: |stage| {
            texture(stage);
            stage.give(stage.board, TextureFilter::Mip);
        },
    },
    Exhibit { name: "checker_filter", effects: &[Effect::CheckerFilter], add: checker_filter },
    Exhibit { name: "motion_blur", effects: &[Effect::MotionBlur], add: motion_blur },
    Exhibit {
        name: "exposure",
        effects: &[Effect::Exposure],
        add: |s| s.give(s.camera, ExposureStops(-1.0)),
    },
    Exhibit { name: "srgb", effects: &[Effect::Srgb], add: |s| s.give(s.camera, SrgbTransfer) },
    Exhibit { name: "all", effects: &Effect::ALL, add: all },
];

impl Exhibit {
    /// The picture of this name.
    pub(crate) fn named(name: &str) -> Option<&'static Self> {
        EXHIBITS.iter().find(|exhibit| exhibit.name == name)
    }

    /// The scene.
    pub(crate) fn world(&self) -> World {
        let mut stage = Stage::empty();
        (self.add)(&mut stage);
        stage.world
    }
}

impl Stage {
    /// Three bodies on a board under a lamp: the least that a picture needs.
    fn empty() -> Self {
        let mut world = World::new();
        world.insert_resource(Snapshot { pixels: 384, level: 5 });
        world.insert_resource(Sampling { side: 3 });
        let (eye, look) = (DVec3::new(-20.0, -120.0, 55.0), DVec3::new(0.2, 1.0, -0.38));
        let pose = CameraPose::looking(eye, look, DVec3::Z).unwrap_or_default();
        let camera = world.spawn((pose, Lens { near: 1.0, far: 2000.0, fovy: 50.0, aspect: 1.0 })).id();
        let board = Checkerboard { cell: 20.0 };
        let board = world.spawn((board, Color::new(0.9, 0.85, 0.75), Ambient(0.25), Diffuse(0.6))).id();
        let mut body = |shape, at: [f64; 3], color: [f64; 3]| {
            let surface = (Color(DVec3::from(color)), Ambient(0.2), Diffuse(0.6));
            let mut entity = world.spawn((Position(DVec3::from(at)), surface));
            match shape {
                Shape::Ball(radius) => entity.insert(Sphere { radius }),
                Shape::Box(side) => entity.insert(Cube { side }),
                Shape::Tent(width, height) => entity.insert(Pyramid { width, height }),
            };
            entity.id()
        };
        let ball = body(Shape::Ball(18.0), [-28.0, -10.0, 18.0], [0.9, 0.35, 0.25]);
        let cube = body(Shape::Box(26.0), [-2.0, 20.0, 0.0], [0.3, 0.55, 0.85]);
        let pyramid = body(Shape::Tent(26.0, 30.0), [8.0, -42.0, 0.0], [0.45, 0.8, 0.4]);
        let lamp = world.spawn((Light, Position::new(-70.0, -80.0, 110.0))).id();
        Self { world, camera, board, ball, cube, pyramid, lamp }
    }

    fn give(&mut self, entity: Entity, effect: impl Bundle) {
        self.world.entity_mut(entity).insert(effect);
    }
}

/// A body and its lengths.
enum Shape {
    Ball(f64),
    Box(f64),
    Tent(f64, f64),
}

fn gloss(stage: &mut Stage) {
    stage.give(stage.ball, Gloss { specular: 0.5, shininess: 40.0 });
    stage.give(stage.cube, Gloss { specular: 0.4, shininess: 5.0 });
}

fn mirror(stage: &mut Stage) {
    stage.give(stage.board, Mirror(0.3));
    stage.give(stage.cube, Mirror(0.6));
    stage.give(stage.pyramid, Mirror(0.2));
}

fn texture(stage: &mut Stage) {
    let stripes = image(|column, row| if (column + row) % 16 < 8 { [230, 200, 120] } else { [120, 60, 40] });
    let rings = image(|column, row| {
        let [x, y] = [column, row].map(|at| i64::from(at) - 32);
        if (x * x + y * y) / 100 % 2 == 0 { [60, 90, 140] } else { [200, 215, 235] }
    });
    if let (Some(white), Some(black)) = (stripes, rings) {
        stage.give(stage.board, Textured { white, black });
    }
}

/// An image of 64 by 64 texels.
fn image(texel: impl Fn(u32, u32) -> [u8; 3]) -> Option<Arc<Texture>> {
    let texels = (0..64 * 64).map(|index| texel(index % 64, index / 64)).collect();
    Texture::new(64, 64, texels).map(Arc::new)
}

fn falloff(stage: &mut Stage) {
    stage.give(stage.lamp, Falloff(3e-5));
}

fn spot_cone(stage: &mut Stage) {
    stage.give(stage.lamp, SpotCone { target: DVec3::new(-10.0, -10.0, 10.0), cutoff: 16.0 });
}

/// The lamp turns orange, and a blue one joins it.
fn light_color(stage: &mut Stage) {
    stage.give(stage.lamp, LightColor(DVec3::new(1.0, 0.6, 0.25)));
    let blue = LightColor(DVec3::new(0.2, 0.4, 1.0));
    stage.world.spawn((Light, Position::new(90.0, -60.0, 70.0), blue));
}

fn directional(stage: &mut Stage) {
    stage.give(stage.lamp, Directional { direction: DVec3::new(0.8, 0.5, -0.7) });
}

fn area_light(stage: &mut Stage) {
    stage.give(stage.lamp, AreaLight { radius: 22.0, samples: 16 });
}

fn background(stage: &mut Stage) {
    let [below, above] = [DVec3::new(0.95, 0.8, 0.6), DVec3::new(0.15, 0.35, 0.75)];
    stage.world.spawn(Background { below, above });
}

fn fog(stage: &mut Stage) {
    stage.world.spawn(Fog { density: 0.006, color: DVec3::new(0.7, 0.75, 0.8) });
}

/// The ball is all glass.
fn glass(stage: &mut Stage) {
    let clear = (Ambient(0.0), Diffuse(0.0), Glass { index: 1.5, transmission: 1.0 });
    stage.give(stage.ball, clear);
}

fn absorption(stage: &mut Stage) {
    glass(stage);
    stage.give(stage.ball, Absorption(DVec3::new(0.005, 0.03, 0.06)));
}

/// The ball is in focus.
fn aperture(stage: &mut Stage) {
    stage.give(stage.camera, Aperture { radius: 4.0, focus: 110.0 });
    stage.world.insert_resource(Sampling { side: 8 });
}

/// Small cells seen far away, which without the filter dissolve into noise.
fn checker_filter(stage: &mut Stage) {
    stage.give(stage.board, (Checkerboard { cell: 5.0 }, CheckerFilter));
    stage.world.insert_resource(Sampling { side: 1 });
}

/// The ball flies to the right while the shutter is open.
fn motion_blur(stage: &mut Stage) {
    stage.give(stage.ball, Velocity(DVec3::new(400.0, 0.0, 120.0)));
    stage.give(stage.camera, Shutter { open: 0.0, close: 0.04 });
    stage.world.insert_resource(Sampling { side: 8 });
}

/// Everything, each where it shows: the textured board mirrors, another one behind the bodies is plain and filtered.
fn all(stage: &mut Stage) {
    for add in [gloss, mirror, texture, falloff, light_color, area_light, background, absorption, motion_blur]
    {
        add(stage);
    }
    stage.world.spawn(Fog { density: 0.001, color: DVec3::new(0.5, 0.55, 0.6) });
    stage.give(stage.board, TextureFilter::Mip);
    let ceiling = (Checkerboard { cell: 40.0 }, CheckerFilter, Position::new(0.0, 0.0, 160.0));
    stage.world.spawn((ceiling, Color::new(0.5, 0.6, 0.8), Ambient(0.5)));
    let sun = Directional { direction: DVec3::new(0.8, 0.5, -0.7) };
    stage.world.spawn((Light, sun, LightColor(DVec3::splat(0.3))));
    let spot = SpotCone { target: DVec3::new(18.0, -30.0, 10.0), cutoff: 12.0 };
    stage.world.spawn((Light, Position::new(60.0, -90.0, 90.0), spot));
    stage.give(stage.camera, (Aperture { radius: 1.5, focus: 110.0 }, ExposureStops(-0.5), SrgbTransfer));
}

//! Worlds of any finite values.

use std::sync::Arc;

use archetrace::components::range::{
    COEFFICIENT, COLOR, COORDINATE, CUTOFF, FALLOFF, FIELD_OF_VIEW, LENGTH, RATIO, SHININESS,
};
use archetrace::components::{
    Ambient, CameraPose, Checkerboard, Color, Cube, Diffuse, Falloff, Gloss, Lens, Light, Mirror, Order,
    Position, Pyramid, Snapshot, Sphere, SpotCone, Texture, Textured,
};
use bevy_ecs::prelude::{EntityWorldMut, World};

use super::bytes::Bytes;

/// Most entities beside the camera.
const MOST: usize = 24;

/// A camera, and whatever else the bytes ask for.
pub(super) fn world(bytes: &mut Bytes<'_>) -> World {
    let mut world = World::new();
    world.insert_resource(Snapshot {
        pixels: u32::from(1 + bytes.below(7)),
        level: u32::from(bytes.below(8)),
    });
    spawn_camera(bytes, &mut world);
    for _ in 0..MOST {
        if bytes.is_empty() {
            break;
        }
        spawn(bytes, &mut world);
    }
    world
}

fn spawn_camera(bytes: &mut Bytes<'_>, world: &mut World) {
    let eye = bytes.vector(&COORDINATE);
    let look = bytes.vector(&COORDINATE);
    let pose = CameraPose::looking(eye, look, bytes.vector(&COORDINATE));
    let near = bytes.within(&LENGTH);
    let far = bytes.within(&LENGTH).max(near.next_up());
    let aspect = bytes.within(&RATIO);
    let fovy = bytes.within(&FIELD_OF_VIEW).min((180.0 / aspect).next_down());
    let start = CameraPose { position: eye, ..CameraPose::default() };
    world.spawn((pose.unwrap_or(start), Lens { near, far, fovy, aspect }));
}

/// An object or a light, one time in thirty-two without its place.
fn spawn(bytes: &mut Bytes<'_>, world: &mut World) {
    let kind = bytes.below(6);
    let mut entity = world.spawn_empty();
    if bytes.below(32) != 31 {
        entity.insert(Position(bytes.vector(&COORDINATE)));
    }
    if bytes.below(2) == 0 {
        entity.insert(Order(u32::from(bytes.byte())));
    }
    match kind {
        0 => drop(entity.insert(Sphere { radius: bytes.within(&LENGTH) })),
        1 => drop(entity.insert(Cube { side: bytes.within(&LENGTH) })),
        2 => {
            let (width, height) = (bytes.within(&LENGTH), bytes.within(&LENGTH));
            entity.insert(Pyramid { width, height });
        }
        3 => board(bytes, &mut entity),
        _ => return light(bytes, &mut entity),
    }
    surface(bytes, &mut entity);
}

fn board(bytes: &mut Bytes<'_>, entity: &mut EntityWorldMut<'_>) {
    entity.insert(Checkerboard { cell: bytes.within(&LENGTH) });
    let (width, height) = (u32::from(1 + bytes.below(3)), u32::from(1 + bytes.below(3)));
    let texels = (0..width * height).map(|_| [bytes.byte(), bytes.byte(), bytes.byte()]).collect();
    if bytes.below(2) == 0
        && let Some(texture) = Texture::new(width, height, texels)
    {
        let white = Arc::new(texture);
        entity.insert(Textured { black: white.clone(), white });
    }
}

fn light(bytes: &mut Bytes<'_>, entity: &mut EntityWorldMut<'_>) {
    entity.insert(Light);
    if bytes.below(2) == 0 {
        entity.insert(Falloff(bytes.within(&FALLOFF)));
    }
    if bytes.below(2) == 0 {
        let (target, cutoff) = (bytes.vector(&COORDINATE), bytes.within(&CUTOFF));
        entity.insert(SpotCone { target, cutoff });
    }
}

fn surface(bytes: &mut Bytes<'_>, entity: &mut EntityWorldMut<'_>) {
    entity.insert((
        Color(bytes.vector(&COLOR)),
        Ambient(bytes.within(&COEFFICIENT)),
        Diffuse(bytes.within(&COEFFICIENT)),
    ));
    if bytes.below(2) == 0 {
        let (specular, shininess) = (bytes.within(&COEFFICIENT), bytes.within(&SHININESS));
        entity.insert(Gloss { specular, shininess });
    }
    if bytes.below(2) == 0 {
        entity.insert(Mirror(bytes.within(&COEFFICIENT)));
    }
}

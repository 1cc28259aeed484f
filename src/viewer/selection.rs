//! Which object lies under the pointer, and the box around it.

use bevy_ecs::prelude::*;
use glam::DVec3;

use crate::components::{CameraPose, Cube, Lens, Light, Position, Pyramid, Sphere};
use crate::geometry::Real;
use crate::systems::Tables;
use crate::trace::{CameraRays, Departure, closest_hit};

/// The entity that the ray through a pixel of a square picture of `side` pixels meets first. One ray is traced.
pub(super) fn entity_at<T: Real>(
    tables: &Tables<T>,
    pose: &CameraPose,
    lens: &Lens,
    side: u32,
    (column, row): (u32, u32),
) -> Option<Entity> {
    let start = CameraRays::<T>::in_unit(pose, lens, side, tables.scene.unit).ray(column, row);
    let hit = closest_hit(&tables.scene, &start.ray, &Departure::Free, start.reach)?;
    tables.entity(hit.object)
}

/// Opposite corners of the box around an object or light; `None` for what has no end, such as a checkerboard.
pub(super) fn bounds(world: &World, entity: Entity) -> Option<[DVec3; 2]> {
    let entity = world.get_entity(entity).ok()?;
    let Position(position) = *entity.get::<Position>()?;
    if let Some(Sphere { radius }) = entity.get() {
        Some([position - *radius, position + *radius])
    } else if let Some(Cube { side }) = entity.get() {
        Some([position, position + *side])
    } else if let Some(Pyramid { width, height }) = entity.get() {
        Some([position, position + DVec3::new(*width, *width, *height)])
    } else {
        entity.get::<Light>().map(|_| [position; 2])
    }
}

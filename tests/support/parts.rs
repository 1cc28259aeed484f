//! All components of an entity, to be taken out of one World and put into another.

use archetrace::components::{
    Ambient, Aperture, CameraPose, CheckerFilter, Checkerboard, Color, Cube, Diffuse, ExposureStops, Falloff,
    Gloss, Lens, Light, Mirror, Order, Position, Pyramid, Shutter, Snapshot, Sphere, SpotCone, SrgbTransfer,
    TextureFilter, Textured, Velocity,
};
use bevy_ecs::prelude::*;

macro_rules! parts {
    ($($field:ident: $component:ty),* $(,)?) => {
        /// What one entity carries.
        #[derive(Clone, Debug, Default)]
        pub(crate) struct Parts {
            $(pub(crate) $field: Option<$component>,)*
        }

        impl Parts {
            pub(crate) fn of(entity: EntityRef<'_>) -> Self {
                Self { $($field: entity.get::<$component>().cloned(),)* }
            }

            pub(crate) fn spawn(self, world: &mut World) -> Entity {
                let mut entity = world.spawn_empty();
                $(if let Some(component) = self.$field {
                    entity.insert(component);
                })*
                entity.id()
            }
        }
    };
}

parts! {
    position: Position,
    order: Order,
    color: Color,
    ambient: Ambient,
    diffuse: Diffuse,
    gloss: Gloss,
    mirror: Mirror,
    textured: Textured,
    sphere: Sphere,
    cube: Cube,
    pyramid: Pyramid,
    checkerboard: Checkerboard,
    light: Light,
    falloff: Falloff,
    spot_cone: SpotCone,
    camera_pose: CameraPose,
    lens: Lens,
    aperture: Aperture,
    exposure: ExposureStops,
    srgb: SrgbTransfer,
    shutter: Shutter,
    velocity: Velocity,
    texture_filter: TextureFilter,
    checker_filter: CheckerFilter,
}

/// Every entity that an object, light or camera lives on, in the World's own order.
pub(crate) fn scene_entities(world: &mut World) -> Vec<Entity> {
    type Scene = Or<(With<Position>, With<CameraPose>)>;
    world.query_filtered::<Entity, Scene>().iter(world).collect()
}

/// The parts of every such entity.
pub(crate) fn take_parts(world: &mut World) -> Vec<Parts> {
    let entities = scene_entities(world);
    entities.into_iter().map(|entity| Parts::of(world.entity(entity))).collect()
}

/// A new World of the same entities, after `change` had the list of them.
pub(crate) fn rebuilt(world: &mut World, change: impl FnOnce(&mut Vec<Parts>)) -> World {
    let mut parts = take_parts(world);
    change(&mut parts);
    let mut other = World::new();
    other.insert_resource(*world.resource::<Snapshot>());
    for part in parts {
        part.spawn(&mut other);
    }
    other
}

//! A scene as plain values, from which a World can be built that was never edited.

use bevy_ecs::prelude::*;
use glam::DVec3;

use crate::components::{
    Ambient, CameraPose, Checkerboard, Color, Cube, Diffuse, Falloff, Gloss, Lens, Light, Mirror, Order,
    Position, Pyramid, Sampling, Snapshot, Sphere, SpotCone,
};

/// An object or light, whatever it has.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Item {
    pub(super) entity: Entity,
    pub(super) order: Option<Order>,
    pub(super) position: Position,
    pub(super) shape: Shape,
    pub(super) surface: Option<(Color, Ambient, Diffuse)>,
    pub(super) gloss: Option<Gloss>,
    pub(super) mirror: Option<Mirror>,
    pub(super) falloff: Option<Falloff>,
    pub(super) cone: Option<SpotCone>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Shape {
    Sphere(Sphere),
    Cube(Cube),
    Pyramid(Pyramid),
    Board(Checkerboard),
    Light,
}

/// A whole scene.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Model {
    pub(super) items: Vec<Item>,
    pub(super) pose: CameraPose,
    pub(super) lens: Lens,
    pub(super) snapshot: Snapshot,
    pub(super) sampling: Sampling,
}

impl Model {
    /// What a World holds.
    pub(super) fn read(world: &mut World) -> Self {
        let mut things = world.query_filtered::<Entity, Or<(With<Color>, With<Light>)>>();
        let entities: Vec<Entity> = things.iter(world).collect();
        let (&pose, &lens) = world.query::<(&CameraPose, &Lens)>().single(world).unwrap();
        Self {
            items: entities.into_iter().map(|entity| Item::read(world, entity)).collect(),
            pose,
            lens,
            snapshot: *world.resource(),
            sampling: world.get_resource().copied().unwrap_or_default(),
        }
    }

    /// A World of its own with the same content.
    pub(super) fn build(&self) -> World {
        let mut world = World::new();
        world.spawn((self.pose, self.lens));
        world.insert_resource(self.snapshot);
        world.insert_resource(self.sampling);
        // Backwards, because no table depends on the order of spawning.
        self.items.iter().rev().for_each(|item| item.spawn(&mut world));
        world
    }

    pub(super) fn item(&mut self, entity: Entity) -> &mut Item {
        self.items.iter_mut().find(|item| item.entity == entity).unwrap()
    }
}

impl Item {
    pub(super) fn read(world: &World, entity: Entity) -> Self {
        let at = world.entity(entity);
        let shape = at.get().copied().map(Shape::Sphere);
        let shape = shape.or_else(|| at.get().copied().map(Shape::Cube));
        let shape = shape.or_else(|| at.get().copied().map(Shape::Pyramid));
        let shape = shape.or_else(|| at.get().copied().map(Shape::Board));
        Self {
            entity,
            order: at.get().copied(),
            position: *at.get().unwrap(),
            shape: shape.unwrap_or(Shape::Light),
            surface: at.get_components::<(&Color, &Ambient, &Diffuse)>().ok().map(|(&c, &a, &d)| (c, a, d)),
            gloss: at.get().copied(),
            mirror: at.get().copied(),
            falloff: at.get().copied(),
            cone: at.get().copied(),
        }
    }

    fn spawn(&self, world: &mut World) {
        let mut entity = world.spawn(self.position);
        match self.shape {
            Shape::Sphere(shape) => entity.insert(shape),
            Shape::Cube(shape) => entity.insert(shape),
            Shape::Pyramid(shape) => entity.insert(shape),
            Shape::Board(shape) => entity.insert(shape),
            Shape::Light => entity.insert(Light),
        };
        insert(&mut entity, self.order);
        insert(&mut entity, self.surface);
        insert(&mut entity, self.gloss);
        insert(&mut entity, self.mirror);
        insert(&mut entity, self.falloff);
        insert(&mut entity, self.cone);
    }

    pub(super) fn is_light(&self) -> bool {
        self.shape == Shape::Light
    }

    pub(super) fn is_board(&self) -> bool {
        matches!(self.shape, Shape::Board(_))
    }
}

fn insert(entity: &mut EntityWorldMut<'_>, bundle: Option<impl Bundle>) {
    if let Some(bundle) = bundle {
        entity.insert(bundle);
    }
}

/// Random numbers with a seed: splitmix64 (G. Steele, D. Lea, C. Flood, 2014).
pub(super) struct Random(pub(super) u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub(super) fn below(&mut self, end: usize) -> usize {
        usize::try_from(self.bits() % u64::try_from(end).unwrap()).unwrap()
    }

    /// One of 64 numbers from 0 up to 1, so that some come up twice.
    pub(super) fn unit(&mut self) -> f64 {
        f64::from(u32::try_from(self.bits() >> 58).unwrap()) / 64.0
    }

    pub(super) fn point(&mut self) -> DVec3 {
        DVec3::new(self.unit(), self.unit(), self.unit())
    }

    pub(super) fn one_of<T: Copy>(&mut self, all: &[T]) -> Option<T> {
        (!all.is_empty()).then(|| all[self.below(all.len())])
    }
}

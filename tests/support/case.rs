//! A scene with a view of it: what a World of the tests is built from.

use archetrace::components::{CameraPose, Checkerboard, Position, Textured};
use archetrace::scene::{Description, spawn};
use bevy_ecs::prelude::*;
use glam::DVec3;

/// A scene file, a camera pose, and images and origin of the checkerboard.
#[derive(Clone, Debug)]
pub(crate) struct Case {
    pub(crate) description: Description,
    pub(crate) pose: CameraPose,
    pub(crate) textured: Option<Textured>,
    pub(crate) board_origin: DVec3,
}

impl Case {
    /// A scene from the start camera, without images.
    pub(crate) fn new(description: Description) -> Self {
        Self { description, pose: CameraPose::default(), textured: None, board_origin: DVec3::ZERO }
    }

    pub(crate) fn world(&self) -> World {
        let mut world = World::new();
        spawn(&mut world, &self.description);
        *only::<CameraPose>(&mut world) = self.pose;
        let mut boards = world.query_filtered::<Entity, With<Checkerboard>>();
        let board = boards.single(&world).expect("a description has one board");
        let mut board = world.entity_mut(board);
        board.insert(Position(self.board_origin));
        if let Some(textured) = self.textured.clone() {
            board.insert(textured);
        }
        world
    }
}

/// The one component of its kind.
pub(crate) fn only<C: Component<Mutability = bevy_ecs::component::Mutable>>(world: &mut World) -> Mut<'_, C> {
    let mut components = world.query::<&mut C>();
    components.single_mut(world).expect("exactly one entity has this component")
}

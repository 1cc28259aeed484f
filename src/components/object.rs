//! Where an object is and what shape it has.

use bevy_ecs::prelude::*;
use glam::DVec3;

use super::{Ambient, Color, Diffuse};

/// The point that a shape or light is placed by, in world units; what it means is the shape's to say.
#[derive(Component, Clone, Copy, Debug, Default, PartialEq)]
pub struct Position(pub DVec3);

impl Position {
    /// A position from coordinates.
    pub const fn new(x: f64, y: f64, z: f64) -> Self {
        Self(DVec3::new(x, y, z))
    }
}

/// Effect of an object: its way in a second, in world units, along a straight line. Its other components say where it is
/// at second 0; how much of the way shows, the camera's [`Shutter`](super::Shutter) says, without which nothing moves.
#[derive(Component, Clone, Copy, Debug, Default, PartialEq)]
pub struct Velocity(pub DVec3);

/// A place in the scene's own order. Rows of the tables are sorted by it, ties between surfaces go to the lower
/// one, lights are summed in it; entities without it come last, sorted by their values.
///
/// The scene reader gives every entity its place in the file. Without it a picture does not depend on the order
/// of spawning either, only ties go by value.
#[derive(Component, Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Order(pub u32);

/// A sphere around its position.
#[derive(Component, Clone, Copy, Debug, PartialEq)]
#[require(Position, Color, Ambient, Diffuse)]
pub struct Sphere {
    /// Radius in world units, above 0.
    pub radius: f64,
}

/// A cube that extends from its position by `side` along +x, +y and +z.
#[derive(Component, Clone, Copy, Debug, PartialEq)]
#[require(Position, Color, Ambient, Diffuse)]
pub struct Cube {
    /// Edge length in world units, above 0.
    pub side: f64,
}

/// A closed pyramid. Its position is the corner of the square base with the least x and y; the apex is above the
/// base's middle.
#[derive(Component, Clone, Copy, Debug, PartialEq)]
#[require(Position, Color, Ambient, Diffuse)]
pub struct Pyramid {
    /// Edge length of the base in world units, above 0.
    pub width: f64,
    /// Height of the apex above the base in world units, above 0.
    pub height: f64,
}

/// An infinite, two-sided board in the horizontal plane of its position. The cell that extends from the position
/// along +x and +y is white, its neighbours are black, and so on; [`Color`] tints the white cells.
#[derive(Component, Clone, Copy, Debug, PartialEq)]
#[require(Position, Color, Ambient, Diffuse)]
pub struct Checkerboard {
    /// Edge length of a cell in world units, above 0.
    pub cell: f64,
}

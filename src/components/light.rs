//! Lights.

use bevy_ecs::prelude::*;
use glam::DVec3;

use super::Position;

/// A white light of intensity 1 at its position, shining in all directions.
#[derive(Component, Clone, Copy, Debug, Default, PartialEq)]
#[require(Position)]
pub struct Light;

/// Effect of a light: what reaches distance `d` is `exp(-d^2 * falloff)` of it, with the falloff in 1/unit^2, 0 or
/// more. Absent, distance takes nothing away.
#[derive(Component, Clone, Copy, Debug, PartialEq)]
pub struct Falloff(pub f64);

/// Effect of a light: it shines only within a cone, which makes it a spotlight.
#[derive(Component, Clone, Copy, Debug, PartialEq)]
pub struct SpotCone {
    /// The point in world units that the cone's axis runs through; not the light's own position.
    pub target: DVec3,
    /// Angle between the axis and the cone's side in degrees, 0 to 180, inclusive; 180 is as good as no cone.
    pub cutoff: f64,
}

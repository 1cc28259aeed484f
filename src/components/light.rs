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

/// Effect of a light: its colour and intensity. Absent, it is white of intensity 1.
#[derive(Component, Clone, Copy, Debug, PartialEq)]
pub struct LightColor(
    /// Linear red, green, blue, each 0 to 1e6; white, 1 in all three, is as good as no colour.
    pub DVec3,
);

/// Effect of a light: it is infinitely far away, so that its light is parallel everywhere, like that of the sun. Its
/// position means nothing then, and [`Falloff`], [`SpotCone`] and [`AreaLight`] do nothing to it.
#[derive(Component, Clone, Copy, Debug, PartialEq)]
pub struct Directional {
    /// The direction in which the light travels, of any length but 0.
    pub direction: DVec3,
}

/// Effect of a light: a ball around its position, which casts soft shadows. A point sees it as the disk through the
/// light's position that faces the point, and `samples` points of that disk share the light's intensity; each is
/// a light of its own to falloff, cone, shadow and highlight.
#[derive(Component, Clone, Copy, Debug, PartialEq)]
pub struct AreaLight {
    /// Radius in world units, 0 or more; 0 is as good as no extent.
    pub radius: f64,
    /// Shadow rays for each surface point and sample of a pixel, 1 to 4096.
    pub samples: u32,
}

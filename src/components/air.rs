//! What surrounds all objects. Each of these is an entity's own, and there is at most one of each.

use bevy_ecs::prelude::*;
use glam::DVec3;

/// Effect: light from where there is no surface, seen directly, in mirrors and through glass; it lights no surface.
/// Absent, there is nothing but black. Directions in between show a mixture, in proportion to their height; the same
/// colour twice is a background without gradient, and black twice is as good as none. It shows beyond the camera's far
/// plane, too.
#[derive(Component, Clone, Copy, Debug, PartialEq)]
pub struct Background {
    /// Linear red, green, blue straight down, each 0 to 1.
    pub below: DVec3,
    /// Linear red, green, blue straight up, each 0 to 1.
    pub above: DVec3,
}

/// Effect: fog between the objects, but not in bodies of glass. After a distance `d`, measured along every ray from the near
/// plane or from the last surface, `exp(-density * d)` of the light is left, and the fog's colour takes the place of the
/// rest; what is infinitely far, like the background, does not show at all. Light on its way from a lamp to a surface
/// is not dimmed: that is what [`Falloff`](super::Falloff) is for.
#[derive(Component, Clone, Copy, Debug, PartialEq)]
pub struct Fog {
    /// Density in 1/unit, 0 or more; 0 is as good as no fog.
    pub density: f64,
    /// Linear red, green, blue, each 0 to 1.
    pub color: DVec3,
}

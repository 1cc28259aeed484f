//! Transparent bodies.

use bevy_ecs::prelude::*;
use glam::DVec3;

/// Effect: a surface that lets light through. It adds `transmission` times what glass shows: Fresnel's share `f` of the
/// light from the mirrored direction, and `1 - f` of the light from the refracted one, which [`Absorption`] may dim.
/// Inside, beyond the critical angle, everything is reflected. Together with a [`Mirror`](super::Mirror)'s,
/// the shares must not exceed 1. Shadow rays take glass for any other body.
///
/// A checkerboard is a sheet without thickness, which light passes straight on, after the reflections of both its faces.
#[derive(Component, Clone, Copy, Debug, PartialEq)]
pub struct Glass {
    /// Index of refraction inside by that outside, 0.1 to 10: 1.5 for glass, 1.33 for water, less than 1 for a bubble.
    pub index: f64,
    /// Share of what it shows, 0 to 1; 0 is as good as no glass.
    pub transmission: f64,
}

/// Effect of glass: of light that has gone a distance `d` through it, `exp(-absorption * d)` is left in each channel. It is
/// measured from the last surface to the glass's own, so that what lies within or overlaps cuts it short. Without
/// [`Glass`] it does nothing.
#[derive(Component, Clone, Copy, Debug, PartialEq)]
pub struct Absorption(
    /// Absorption of red, green, blue in 1/unit, each 0 or more; 0 in all three is as good as none.
    pub DVec3,
);

//! The camera: an entity with a pose and a lens.

use bevy_ecs::prelude::*;
use glam::DVec3;

use crate::geometry::basis_looking;

/// Where the camera stands and how it is turned. `l`, `r`, `u` are orthonormal and `u = r x l`.
#[derive(Component, Clone, Copy, Debug, PartialEq)]
#[require(Reference)]
pub struct CameraPose {
    /// Eye position in world units.
    pub position: DVec3,
    /// Look direction, unit.
    pub l: DVec3,
    /// Direction to the right of the picture, unit.
    pub r: DVec3,
    /// Direction to the top of the picture, unit.
    pub u: DVec3,
}

impl CameraPose {
    /// The pose at `position` that looks along `look` with `up` towards the top, see
    /// [`basis_looking`]. `None` if `look` or `up` is zero or not finite.
    pub fn looking(position: DVec3, look: DVec3, up: DVec3) -> Option<Self> {
        let [l, r, u] = basis_looking(look, up)?;
        Some(Self { position, l, r, u })
    }
}

impl Default for CameraPose {
    /// The start: at (0, -150, 50), looking along +y.
    fn default() -> Self {
        Self { position: DVec3::new(0.0, -150.0, 50.0), l: DVec3::Y, r: DVec3::X, u: DVec3::Z }
    }
}

/// What the camera shows of the scene.
#[derive(Component, Clone, Copy, Debug, PartialEq)]
pub struct Lens {
    /// Distance of the near plane along `l`, in world units, above 0. Camera rays start on it.
    pub near: f64,
    /// Distance of the far plane from the near one along `l`, in world units, above `near`. It ends camera rays;
    /// shadow and mirror rays pass it.
    pub far: f64,
    /// Vertical field of view in degrees, above 0 and below 180.
    pub fovy: f64,
    /// Horizontal by vertical field of view, as a ratio of angles: the product with `fovy` is below 180.
    pub aspect: f64,
}

impl Lens {
    /// Horizontal field of view in degrees.
    pub fn fovx(&self) -> f64 {
        self.aspect * self.fovy
    }
}

/// Effect of the camera: a lens of some width instead of a pinhole, so that what is not in focus is blurred. A point at
/// distance `d` along `l` becomes a disk of radius `radius * |d - focus| / d` in the plane in focus. Each sample of a
/// pixel passes one point of the lens: a smooth blur wants many.
///
/// The near plane and the far one stay planes: each ray starts on the near plane, wherever it passes the lens.
#[derive(Component, Clone, Copy, Debug, PartialEq)]
pub struct Aperture {
    /// Radius of the lens in world units, 0 to `focus`; 0 is as good as no aperture.
    pub radius: f64,
    /// Distance of the plane in focus along `l`, in world units, above 0.
    pub focus: f64,
}

/// Effect of the camera: it sees objects that have a [`Velocity`](super::Velocity) during some time instead of at second 0.
/// Each pass over the picture, one sample of every pixel, shows one moment, evenly spaced: a smooth blur wants many.
#[derive(Component, Clone, Copy, Debug, PartialEq)]
pub struct Shutter {
    /// When it opens, in seconds, -1e9 to 1e9.
    pub open: f64,
    /// When it closes, in seconds, not before.
    pub close: f64,
}

/// Effect of the camera: all light counts `2^stops` times before it is cut off at full output, -100 to 100; 0 is as good
/// as none.
#[derive(Component, Clone, Copy, Debug, PartialEq)]
pub struct ExposureStops(pub f64);

/// Effect of the camera: its pictures become bytes by the curve of sRGB (IEC 61966-2-1), as screens expect, instead of
/// in proportion to the light.
#[derive(Component, Clone, Copy, Debug, Default, PartialEq)]
pub struct SrgbTransfer;

/// How far ahead along `l` the point lies that the camera keeps looking at while its eye is raised or lowered.
#[derive(Component, Clone, Copy, Debug, PartialEq)]
pub struct Reference {
    /// Distance in world units, above 0.
    pub distance: f64,
}

impl Default for Reference {
    /// At the start the reference point is 150 units ahead.
    fn default() -> Self {
        Self { distance: 150.0 }
    }
}

/// Where a camera goes when it is sent home; without it, to the default pose.
#[derive(Component, Clone, Copy, Debug, PartialEq)]
pub struct Home(pub CameraPose);

//! What the camera is asked to do.

use bevy_ecs::prelude::*;

/// Moves of the camera that have been asked for and not yet made, in the order in which they were asked for.
#[derive(Resource, Clone, Debug, Default, PartialEq)]
pub struct CameraInput(pub Vec<CameraMove>);

/// One move of the camera. Lengths are in world units, angles in degrees; a negative one goes the other way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CameraMove {
    /// Along `l`.
    Forward(f64),
    /// Along `r`.
    Right(f64),
    /// Along `u`.
    Up(f64),
    /// To the left: `l` and `r` about `u`.
    Turn(f64),
    /// To the left about the world's z, which keeps a level horizon level; for a camera that stands on its head, what
    /// it has on its left.
    Heading(f64),
    /// Look up: `l` and `u` about `r`.
    Pitch(f64),
    /// Counter-clockwise, as the picture turns: `u` tips towards `r`, about `l`.
    Tilt(f64),
    /// The eye along the world's z, while it keeps looking at its [`Reference`](super::Reference) point.
    Raise(f64),
    /// Back to where the camera started: its [`Home`](super::Home), or the default pose.
    Home,
}

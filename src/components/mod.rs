//! Data only: what a scene is made of.
//!
//! An object is an entity with a [`Position`] and a shape; its surface has a [`Color`], [`Ambient`] and
//! [`Diffuse`] part. Whatever it can do beyond that is a component of its own ([`Gloss`], [`Mirror`], [`Glass`],
//! [`Textured`]), and so it is with lights ([`Falloff`], [`SpotCone`], [`LightColor`],
//! [`Directional`], [`AreaLight`]): an effect that no entity carries does not
//! exist for the trace.
//!
//! Lengths are in world units, the world is right-handed, z is up. What values are allowed is said once, in
//! [`range`].

mod air;
mod camera;
mod camera_input;
mod glass;
mod light;
mod object;
pub mod range;
mod settings;
mod surface;

pub use air::{Background, Fog};
pub use camera::{Aperture, CameraPose, ExposureStops, Home, Lens, Reference, Shutter, SrgbTransfer};
pub use camera_input::{CameraInput, CameraMove};
pub use glass::{Absorption, Glass};
pub use light::{AreaLight, Directional, Falloff, Light, LightColor, SpotCone};
pub use object::{Checkerboard, Cube, Order, Position, Pyramid, Sphere, Velocity};
pub use settings::{Adaptive, Cutoff, FrameTime, Precision, Sampling, Snapshot};
pub use surface::{Ambient, CheckerFilter, Color, Diffuse, Gloss, Mirror, Texture, TextureFilter, Textured};

//! Light and colour: a hit and a light in, a number out.
//!
//! One file an effect. Nothing here searches the scene or recurses, and nothing decides whether an effect is
//! present: the trace asks only for those that the tables hold rows of.

mod area_light;
mod checker;
mod diffuse;
mod disk;
mod effect;
mod falloff;
mod gloss;
mod mirror;
mod rgb;
mod spot_cone;
mod srgb;
mod texture;

pub use area_light::Ball;
pub use checker::{CellPoint, cell_point};
pub use diffuse::lambert;
pub use disk::disk_point;
pub use effect::{Effect, EffectSet};
pub use falloff::attenuation;
pub use gloss::phong;
pub use mirror::{reflect, reflect_long};
pub use rgb::Rgb;
pub use spot_cone::Cone;
pub use srgb::{SrgbLevels, Transfer};
pub use texture::texel_index;

//! Light and colour: a hit and a light in, a number out.
//!
//! One file an effect. Nothing here searches the scene or recurses, and nothing decides whether an effect is
//! present: the trace asks only for those that the tables hold rows of.

mod absorption;
mod area_light;
mod background;
mod checker;
mod checker_filter;
mod compiled;
mod diffuse;
mod disk;
mod effect;
mod falloff;
mod fog;
mod footprint;
mod glass;
mod gloss;
mod mip_chain;
mod mirror;
mod rgb;
mod spot_cone;
mod srgb;
mod texture;

pub use absorption::left_by;
pub use area_light::Ball;
pub use background::Gradient;
pub use checker::{CellPoint, cell_point};
pub use checker_filter::white_share;
pub use diffuse::lambert;
pub use disk::disk_point;
pub use effect::{Effect, EffectSet};
pub use falloff::attenuation;
pub use fog::Haze;
pub use footprint::PixelCone;
pub use glass::{Split, split, split_at_sheet};
pub use gloss::phong;
pub use mip_chain::MipChain;
pub use mirror::{reflect, reflect_long};
pub use rgb::Rgb;
pub use spot_cone::Cone;
pub use srgb::{SrgbLevels, Transfer};
pub use texture::{bilinear_color, texel_index};

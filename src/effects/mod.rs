//! Light and colour: a hit and a light in, a number out.
//!
//! One file an effect, with what becomes of its component in the tables (`EffectComponent`), and one line an effect in the
//! survey, from which all else follows. Nothing here searches the scene or recurses, and nothing decides whether an effect
//! is present: the trace asks only for those that the tables hold rows of.

mod absorption;
mod aperture;
mod area_light;
mod background;
mod checker;
mod checker_filter;
mod compiled;
mod component;
mod diffuse;
mod directional;
mod disk;
mod effect;
mod exposure;
mod falloff;
mod fog;
mod footprint;
mod glass;
mod gloss;
mod light_color;
mod mip_chain;
mod mirror;
mod rgb;
mod spot_cone;
mod srgb;
mod survey;
mod texture;

pub use absorption::left_by;
pub use area_light::Ball;
pub use background::Gradient;
pub use checker::{CellPoint, cell_point};
pub use checker_filter::white_share;
pub use component::{Bearer, EffectComponent, Number, RowOf};
pub use diffuse::lambert;
pub use disk::disk_point;
pub use effect::{Effect, EffectSet};
pub use falloff::attenuation;
pub use fog::Haze;
pub use footprint::PixelCone;
pub use glass::{GlassRow, Split, split, split_at_sheet};
pub use gloss::{GlossRow, phong};
pub use mip_chain::MipChain;
pub use mirror::{reflect, reflect_long};
pub use rgb::Rgb;
pub use spot_cone::{Cone, cone_axis};
pub use srgb::{SrgbLevels, Transfer};
pub(crate) use survey::{lines, survey};
pub use texture::{BoardTexture, ImageFilter, bilinear_color, texel_index};

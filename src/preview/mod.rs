//! The live preview: the World as plain draw lists, and the GL that draws them.
//!
//! ```text
//! World -list_draws-> DrawList -Renderer-> a square picture in GL -present-> window
//! ```
//!
//! [`DrawList`] holds numbers alone, in the order in which they are drawn. [`gl`] is the only place that knows GL, and
//! it knows no window: whoever calls it made a context current. Every body is met by the same rays as in the trace,
//! pixel by pixel, so both pictures agree in outline; the rasteriser only says which pixels are worth asking.
//!
//! Directions are right to about 1e-7 radians, which is a tenth of a pixel in a picture of 768 pixels at a field of
//! view of 0.05 degrees. Bodies are drawn from 1e-30 to 1e30 units in size and place.

mod draw_list;
pub mod gl;
mod lines;
mod rows;
mod style;
mod view;

pub use draw_list::{DrawList, Placed};
pub use style::{Layout, PreviewStyle};

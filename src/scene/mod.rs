//! Scene files: text to [`Description`] to entities, and back.
//!
//! ```text
//! file     := near far fovy aspect  level  pixels
//!             cell  ambient diffuse reflection
//!             count  object{count}
//!             count  (x y z falloff){count}
//!             count  (x y z falloff  x y z  cutoff){count}
//! object   := "sphere"  x y z  radius        surface
//!           | "cube"    x y z  side          surface
//!           | "pyramid" x y z  width height  surface
//! surface  := red green blue  ambient diffuse specular reflection  shininess
//! ```
//!
//! Tokens are separated by white space, lines mean nothing, `#` starts a comment, and whatever follows the last
//! number is ignored. What is wrong with a file is said with its place; nothing is guessed.

mod ahead;
mod description;
mod lexer;
mod parser;
mod problem;
mod source;
mod spawn;
mod values;
mod write;

pub use description::{
    BoardDescription, Description, LightDescription, ObjectDescription, ShapeDescription, SpotDescription,
    SurfaceDescription,
};
pub use parser::{MAX_LIGHTS, MAX_OBJECTS, parse};
pub use problem::{Problem, Severity};
pub use source::{Loaded, MAX_BYTES, SceneError, Source};
pub use spawn::{DescribeError, describe, spawn};
#[cfg(feature = "viewer")]
pub(crate) use write::Number;

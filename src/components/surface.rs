//! What a surface looks like.

use std::sync::Arc;

use bevy_ecs::prelude::*;
use glam::DVec3;

/// Own colour: linear red, green, blue, each 0 to 1. White unless said otherwise.
#[derive(Component, Clone, Copy, Debug, PartialEq)]
pub struct Color(pub DVec3);

impl Color {
    /// A colour from its components.
    pub const fn new(r: f64, g: f64, b: f64) -> Self {
        Self(DVec3::new(r, g, b))
    }
}

impl Default for Color {
    fn default() -> Self {
        Self(DVec3::ONE)
    }
}

/// Share of the own colour that shows without any light, 0 to 1.
#[derive(Component, Clone, Copy, Debug, Default, PartialEq)]
pub struct Ambient(pub f64);

/// Share of the own colour that shows by light, in proportion to the cosine of its incidence, 0 to 1.
#[derive(Component, Clone, Copy, Debug, Default, PartialEq)]
pub struct Diffuse(pub f64);

/// Effect: highlights of lights after Phong. Absent, no highlight is computed.
#[derive(Component, Clone, Copy, Debug, PartialEq)]
pub struct Gloss {
    /// Share of the own colour in a highlight, 0 to 1; 0 is as good as no gloss.
    pub specular: f64,
    /// Phong exponent, 0 or more: larger is a smaller highlight.
    pub shininess: f64,
}

/// Effect: a perfect mirror that adds this share (0 to 1) of the light it receives. Absent, no ray is reflected.
#[derive(Component, Clone, Copy, Debug, PartialEq)]
pub struct Mirror(pub f64);

/// Effect of a checkerboard: images instead of plain cells. Absent, no image is read.
#[derive(Component, Clone, Debug, PartialEq)]
pub struct Textured {
    /// Image on the white cells.
    pub white: Arc<Texture>,
    /// Image on the black cells.
    pub black: Arc<Texture>,
}

/// Effect of a textured checkerboard: how its images are looked up. Without images it does nothing.
#[derive(Component, Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TextureFilter {
    /// The texel at the point itself; as good as no filter.
    #[default]
    Nearest,
    /// The nearest four texels, in proportion.
    Bilinear,
    /// The mean of what a pixel covers of the image, along the side on which it covers more: from copies of the image
    /// that are made when the board is extracted.
    Mip,
}

/// Effect of a checkerboard without images: a point shows the share of white cells in what its pixel covers, so that
/// far cells run together to the mean of both. Absent, each ray sees one cell.
#[derive(Component, Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CheckerFilter;

/// An 8-bit colour image of at least one texel; row 0 is the top row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Texture {
    width: u32,
    height: u32,
    texels: Vec<[u8; 3]>,
}

impl Texture {
    /// An image from rows of red, green, blue, top row first; `None` unless there are exactly `width * height`
    /// texels and at least one.
    pub fn new(width: u32, height: u32, texels: Vec<[u8; 3]>) -> Option<Self> {
        let count = usize::try_from(u64::from(width) * u64::from(height)).ok()?;
        (count > 0 && texels.len() == count).then_some(Self { width, height, texels })
    }

    /// Texels along x.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Texels along y.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// The texel of a column and a row from the top, both below the image's size.
    #[inline(always)]
    pub fn texel(&self, column: u32, row: u32) -> [u8; 3] {
        self.texels[row as usize * self.width as usize + column as usize]
    }

    /// Memory held by the texels, in bytes.
    pub fn bytes(&self) -> usize {
        size_of_val(self.texels.as_slice())
    }
}

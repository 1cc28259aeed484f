//! Looking up a texture.

use std::sync::Arc;

use crate::components::{Texture, TextureFilter, Textured};
use crate::geometry::Real;

use super::{Bearer, EffectComponent, MipChain, Number, Rgb};

/// The images of a textured checkerboard.
#[derive(Clone, Debug)]
pub struct BoardTexture {
    /// On white cells.
    pub white: Arc<Texture>,
    /// On black cells.
    pub black: Arc<Texture>,
}

impl EffectComponent for Textured {
    type Row<T: Real> = BoardTexture;

    fn numbers(&self) -> impl IntoIterator<Item = Number> {
        []
    }

    fn does_nothing(&self) -> bool {
        false
    }

    fn row<T: Real>(&self, _bearer: &Bearer<'_>) -> Option<BoardTexture> {
        Some(BoardTexture { white: self.white.clone(), black: self.black.clone() })
    }
}

/// How the images of a checkerboard are looked up.
#[derive(Clone, Debug)]
pub enum ImageFilter {
    /// Between the nearest four texels.
    Bilinear,
    /// From smaller copies.
    Mip {
        /// Of the image on white cells.
        white: Arc<MipChain>,
        /// Of the image on black cells.
        black: Arc<MipChain>,
    },
}

impl ImageFilter {
    /// Memory held by copies of images.
    pub fn bytes(&self) -> usize {
        match self {
            Self::Bilinear => 0,
            Self::Mip { white, black } => white.bytes() + black.bytes(),
        }
    }
}

impl EffectComponent for TextureFilter {
    type Row<T: Real> = ImageFilter;

    fn numbers(&self) -> impl IntoIterator<Item = Number> {
        []
    }

    fn does_nothing(&self) -> bool {
        *self == Self::Nearest
    }

    fn row<T: Real>(&self, bearer: &Bearer<'_>) -> Option<ImageFilter> {
        let images = bearer.images?;
        let chain = |image| Arc::new(MipChain::new(image));
        match self {
            Self::Nearest => None,
            Self::Bilinear => Some(ImageFilter::Bilinear),
            Self::Mip => Some(ImageFilter::Mip { white: chain(&images.white), black: chain(&images.black) }),
        }
    }
}

/// The texel of an image of `size` texels along one axis that covers position `along` (0 to 1).
#[inline(always)]
pub fn texel_index<T: Real>(along: T, size: u32) -> u32 {
    let index = (along * T::from_u32(size)).to_f64();
    // 1 itself, and whatever rounding makes of the last texel, belongs to the last.
    whole(index).min(size - 1)
}

/// The colour of an image at a position from the left and from the top, each 0 to 1: that of the nearest four texels,
/// in proportion to how near their centres are. Beyond the outermost centres their colours go on.
#[inline(never)]
pub fn bilinear_color<T: Real>(image: &Texture, at: [T; 2]) -> Rgb<T> {
    bilinear([image.width(), image.height()], at, |column, row| {
        byte_color(image.texel(column, row).map(f64::from))
    })
}

/// The same for whatever has texels.
#[inline(always)]
pub(super) fn bilinear<T: Real>(
    [width, height]: [u32; 2],
    [from_left, from_top]: [T; 2],
    texel: impl Fn(u32, u32) -> Rgb<T>,
) -> Rgb<T> {
    let (left, right, to_right) = neighbours(from_left, width);
    let (upper, lower, down) = neighbours(from_top, height);
    let row = |row| blend(texel(left, row), texel(right, row), to_right);
    blend(row(upper), row(lower), down)
}

/// Between the centres of which two texels a position lies, and how far from the first to the second.
#[inline(always)]
fn neighbours<T: Real>(along: T, size: u32) -> (u32, u32, T) {
    let half = T::ONE / T::TWO;
    let last = T::from_u32(size - 1);
    let from_first = (along * T::from_u32(size) - half).at_least(T::ZERO).at_most(last);
    let first = whole(from_first.to_f64());
    (first, (first + 1).min(size - 1), from_first - from_first.floor())
}

/// From one colour, at 0, to another, at 1; between equal ones nothing changes.
#[inline(always)]
pub(super) fn blend<T: Real>(from: Rgb<T>, to: Rgb<T>, share: T) -> Rgb<T> {
    let channel = |from: T, to: T| from + (to - from) * share;
    Rgb { r: channel(from.r, to.r), g: channel(from.g, to.g), b: channel(from.b, to.b) }
}

/// A colour in units of a byte: 255 is 1.
#[inline(always)]
pub(super) fn byte_color<T: Real>([r, g, b]: [f64; 3]) -> Rgb<T> {
    let scale = |channel: f64| T::from_f64(channel) / T::from_u32(255);
    Rgb { r: scale(r), g: scale(g), b: scale(b) }
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "truncation is the definition, and `as` saturates below 0"
)]
#[inline(always)]
fn whole(index: f64) -> u32 {
    index as u32
}

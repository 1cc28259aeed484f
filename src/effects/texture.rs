//! Looking up a texture.

use crate::components::Texture;
use crate::geometry::Real;

use super::Rgb;

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

//! Ever smaller copies of a texture.

use crate::components::Texture;
use crate::geometry::Real;

use super::Rgb;
use super::texture::{bilinear, bilinear_color, blend, byte_color};

/// An image and copies of it, each about half as wide and high as the one before, down to a single texel (L. Williams,
/// "Pyramidal Parametrics", SIGGRAPH 1983). Each texel is the mean of what it covers of the copy before.
#[derive(Clone, Debug)]
pub struct MipChain {
    copies: Vec<Copy>,
}

/// A copy, in units of a byte: 0 to 255.
#[derive(Clone, Debug)]
struct Copy {
    width: u32,
    height: u32,
    texels: Vec<[f32; 3]>,
}

impl MipChain {
    /// The copies of an image, all but itself.
    pub fn new(image: &Texture) -> Self {
        let mut copies = Vec::new();
        let (mut width, mut height) = (image.width(), image.height());
        while (width, height) != (1, 1) {
            let copy = match copies.last() {
                None => halved((width, height), |column, row| image.texel(column, row).map(f64::from)),
                Some(last) => halved((width, height), |column, row| Copy::texel(last, column, row)),
            };
            (width, height) = (copy.width, copy.height);
            copies.push(copy);
        }
        Self { copies }
    }

    /// Memory held by the copies, in bytes: a third of that of the image in four times its precision.
    pub fn bytes(&self) -> usize {
        self.copies.iter().map(|copy| size_of_val(copy.texels.as_slice())).sum()
    }

    /// The colour around a position from the left and from the top, each 0 to 1, averaged over about `covered` texels of
    /// the image along each axis: between the two copies whose texels are next in size.
    #[inline(never)]
    pub fn color<T: Real>(&self, image: &Texture, at: [T; 2], covered: T) -> Rgb<T> {
        let doublings = libm::log2(covered.to_f64()).clamp(0.0, f64::from(self.last()));
        let finer = doublings.floor();
        let coarser = (finer + 1.0).min(f64::from(self.last()));
        let share = T::from_f64(doublings - finer);
        blend(self.level(image, at, finer), self.level(image, at, coarser), share)
    }

    /// Number of the smallest copy; 0 is the image.
    #[inline(always)]
    fn last(&self) -> u32 {
        u32::try_from(self.copies.len()).unwrap_or(u32::MAX)
    }

    #[inline(never)]
    fn level<T: Real>(&self, image: &Texture, at: [T; 2], number: f64) -> Rgb<T> {
        let before = self.copies.iter().zip(1_u32..).find(|&(_, level)| f64::from(level) == number);
        match before {
            None => bilinear_color(image, at),
            Some((copy, _)) => {
                bilinear([copy.width, copy.height], at, |column, row| byte_color(copy.texel(column, row)))
            }
        }
    }
}

impl Copy {
    #[inline(always)]
    fn texel(&self, column: u32, row: u32) -> [f64; 3] {
        self.texels[row as usize * self.width as usize + column as usize].map(f64::from)
    }
}

/// An image of this size at half of it, but at least one texel.
fn halved((width, height): (u32, u32), texel: impl Fn(u32, u32) -> [f64; 3]) -> Copy {
    let half = [width, height].map(|size| (size / 2).max(1));
    let mut texels = Vec::with_capacity(half[0] as usize * half[1] as usize);
    for (row, column) in (0..half[1]).flat_map(|row| (0..half[0]).map(move |column| (row, column))) {
        let mut sum = [0.0; 3];
        for (from_row, high) in shares(height, half[1], row) {
            for (from_column, wide) in shares(width, half[0], column) {
                let weight = high * wide;
                for (sum, channel) in sum.iter_mut().zip(texel(from_column, from_row)) {
                    *sum += weight * channel;
                }
            }
        }
        let whole = f64::from(width) * f64::from(height);
        texels.push(sum.map(|channel| to_f32(channel / whole)));
    }
    Copy { width: half[0], height: half[1], texels }
}

/// Which of `many` texels one of `few` covers, and how much of each in units of which it covers `many`: whole numbers,
/// also where the one is not half of the other.
fn shares(many: u32, few: u32, index: u32) -> impl Iterator<Item = (u32, f64)> {
    let (start, end) = (index * many, (index + 1) * many);
    (start / few..end.div_ceil(few)).map(move |from| {
        let covered = end.min((from + 1) * few) - start.max(from * few);
        (from, f64::from(covered))
    })
}

#[expect(clippy::cast_possible_truncation, reason = "a mean of bytes, to 24 bits")]
fn to_f32(value: f64) -> f32 {
    value as f32
}

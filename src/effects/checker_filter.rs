//! The checker pattern, averaged over what a pixel covers.

use crate::components::CheckerFilter;
use crate::geometry::Real;

use super::{Bearer, CellPoint, EffectComponent, Number};

impl EffectComponent for CheckerFilter {
    type Row<T: Real> = ();

    fn numbers(&self) -> impl IntoIterator<Item = Number> {
        []
    }

    fn does_nothing(&self) -> bool {
        false
    }

    fn row<T: Real>(&self, bearer: &Bearer<'_>) -> Option<()> {
        bearer.images.is_none().then_some(())
    }
}

/// The share of white, 0 to 1, in a rectangle around a point of the checker pattern, with sides along the cells' in cells.
///
/// White cells are where the product of two square waves, one an axis, is 1, black ones where it is -1; so the mean of
/// the product is that of the means, and the integral of a square wave is a triangle wave (known from shading
/// languages: A. Apodaca and L. Gritz, "Advanced `RenderMan`", 1999, chapter 11).
#[inline(always)]
pub fn white_share<T: Real>(at: CellPoint<T>, [along_x, along_y]: [T; 2]) -> T {
    let mean = mean_wave(at.along_x, along_x) * mean_wave(at.along_y, along_y);
    let signed = if at.white { mean } else { -mean };
    ((T::ONE + signed) / T::TWO).at_least(T::ZERO).at_most(T::ONE)
}

/// The mean over `width` around `middle` (0 to 1) of the square wave that is 1 from 0 to 1 and -1 from there to 2.
#[inline(always)]
fn mean_wave<T: Real>(middle: T, width: T) -> T {
    let half = width / T::TWO;
    let (from, to) = (middle - half, middle + half);
    if T::ZERO <= from && to <= T::ONE {
        // Exactly, whatever the width: within a cell nothing is blurred.
        T::ONE
    } else if width.is_finite() {
        (integral(to) - integral(from)) / width
    } else {
        T::ZERO
    }
}

/// The integral of the square wave from 0: the distance from the nearest even number.
#[inline(always)]
fn integral<T: Real>(x: T) -> T {
    let even = T::TWO * ((x + T::ONE) / T::TWO).floor();
    (x - even).abs()
}

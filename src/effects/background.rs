//! What is seen where there is no surface.

use glam::DVec3;

use crate::components::Background;
use crate::components::range::COLOR;
use crate::geometry::{Real, Vector};

use super::{Bearer, EffectComponent, Number, Rgb};

impl EffectComponent for Background {
    type Row<T: Real> = Gradient<T>;

    fn numbers(&self) -> impl IntoIterator<Item = Number> {
        let below = Number::of_vector("Background.below", self.below, &COLOR);
        below.into_iter().chain(Number::of_vector("Background.above", self.above, &COLOR))
    }

    fn does_nothing(&self) -> bool {
        self.below == DVec3::ZERO && self.above == DVec3::ZERO
    }

    fn row<T: Real>(&self, _bearer: &Bearer<'_>) -> Option<Gradient<T>> {
        Some(Gradient { below: Rgb::from_dvec3(self.below), above: Rgb::from_dvec3(self.above) })
    }
}

/// The colour of directions, from straight down to straight up.
#[derive(Clone, Copy, Debug)]
pub struct Gradient<T> {
    /// Straight down.
    pub below: Rgb<T>,
    /// Straight up.
    pub above: Rgb<T>,
}

impl<T: Real> Gradient<T> {
    /// The colour in a unit direction: in proportion to its height. Where both ends are the same, exactly that.
    #[inline(always)]
    pub fn toward(&self, direction: Vector<T>) -> Rgb<T> {
        let height = (T::ONE + direction.z) / T::TWO;
        let part = |below: T, above: T| below + (above - below) * height;
        Rgb {
            r: part(self.below.r, self.above.r),
            g: part(self.below.g, self.above.g),
            b: part(self.below.b, self.above.b),
        }
    }
}

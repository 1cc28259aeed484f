//! How much room a shape takes, as far as a kernel can tell.

use super::{CubeShape, PyramidShape, Real, SphereShape, Vector};

/// A ball around a shape.
#[derive(Clone, Copy, Debug)]
pub struct Ball<T> {
    /// Its centre.
    pub center: Vector<T>,
    /// Its radius.
    pub radius: T,
}

/// A box around shapes.
#[derive(Clone, Copy, Debug)]
pub struct Bounds3<T> {
    /// The least coordinates.
    pub low: Vector<T>,
    /// The greatest coordinates.
    pub high: Vector<T>,
}

impl<T: Real> Bounds3<T> {
    /// Around nothing.
    pub const EMPTY: Self = Self {
        low: Vector::new(T::INFINITY, T::INFINITY, T::INFINITY),
        high: Vector::new(T::LOWEST, T::LOWEST, T::LOWEST),
    };

    /// The longest side; below 0 around nothing.
    pub fn longest_side(&self) -> T {
        let size = self.high - self.low;
        size.x.at_least(size.y).at_least(size.z)
    }

    /// Around both.
    #[inline(always)]
    #[must_use]
    pub fn with(&self, other: &Self) -> Self {
        let (a, b) = (self, other);
        Self {
            low: Vector::new(a.low.x.at_most(b.low.x), a.low.y.at_most(b.low.y), a.low.z.at_most(b.low.z)),
            high: Vector::new(
                a.high.x.at_least(b.high.x),
                a.high.y.at_least(b.high.y),
                a.high.z.at_least(b.high.z),
            ),
        }
    }
}

/// A shape of finite size.
///
/// A kernel places the planes or the sphere of a shape, seen from the ray, wrong by at most ten roundings of the distances
/// it handles. Where two planes meet at an acute angle the body grows by more than that: by the cosecant of half of
/// it. Sixteen units in the last place times that factor are allowed for, half as much again as follows.
pub trait Bounded<T: Real>: Copy {
    /// A ball that the shape fills well.
    fn ball(&self) -> Ball<T>;

    /// The least box.
    fn bounds(&self) -> Bounds3<T>;

    /// How far outside of its bounds a kernel may report a hit, as a share of the largest coordinate, size or distance
    /// in play.
    fn rounding(&self) -> T;

    /// The box in which a kernel reports hits of rays from the world's origin; for others, what [`rounding`] makes of
    /// their origin comes on top.
    ///
    /// [`rounding`]: Self::rounding
    fn padded_bounds(&self) -> Bounds3<T> {
        let Bounds3 { low, high } = self.bounds();
        let span = |low: T, high: T| low.abs() + high.abs();
        let size = (span(low.x, high.x) + span(low.y, high.y)) + span(low.z, high.z);
        let pad = self.rounding() * size;
        let pad = Vector::new(pad, pad, pad);
        Bounds3 { low: low - pad, high: high + pad }
    }
}

/// Rounding of a shape without acute angles.
#[inline(always)]
fn plain_rounding<T: Real>() -> T {
    T::from_u32(16) * T::ULP
}

impl<T: Real> Bounded<T> for SphereShape<T> {
    fn ball(&self) -> Ball<T> {
        Ball { center: self.center, radius: self.radius }
    }

    #[inline(always)]
    fn bounds(&self) -> Bounds3<T> {
        let radius = Vector::new(self.radius, self.radius, self.radius);
        Bounds3 { low: self.center - radius, high: self.center + radius }
    }

    #[inline(always)]
    fn rounding(&self) -> T {
        plain_rounding()
    }
}

impl<T: Real> Bounded<T> for CubeShape<T> {
    fn ball(&self) -> Ball<T> {
        let half = (self.max - self.min) * (T::ONE / T::TWO);
        Ball { center: self.min + half, radius: half.length() }
    }

    fn bounds(&self) -> Bounds3<T> {
        Bounds3 { low: self.min, high: self.max }
    }

    fn rounding(&self) -> T {
        plain_rounding::<T>() * T::TWO
    }
}

impl<T: Real> Bounded<T> for PyramidShape<T> {
    /// Around the point of the axis that is as far from the tip as from the corners of the base, or around the base.
    fn ball(&self) -> Ball<T> {
        let half_diagonal = self.half_width * T::TWO.sqrt();
        let rise = ((self.height - half_diagonal * (half_diagonal / self.height)) / T::TWO).at_least(T::ZERO);
        let center = Vector::new(self.apex.x, self.apex.y, self.base + rise);
        let to_corner = Vector::new(self.half_width, self.half_width, rise).length();
        let radius = to_corner.at_least((self.apex.z - center.z).abs());
        Ball { center, radius }
    }

    fn bounds(&self) -> Bounds3<T> {
        let (apex, half) = (self.apex, self.half_width);
        Bounds3 {
            low: Vector::new(apex.x - half, apex.y - half, self.base),
            high: Vector::new(apex.x + half, apex.y + half, apex.z),
        }
    }

    fn rounding(&self) -> T {
        plain_rounding::<T>() * self.sharpness()
    }
}

impl<T: Real> PyramidShape<T> {
    /// By how much more than its planes the body itself may be misplaced: through the tip and through the edges of the
    /// base.
    fn sharpness(&self) -> T {
        let steep = self.height / self.half_width;
        T::from_u32(4) * (T::ONE + steep.at_least(T::ONE / steep))
    }
}

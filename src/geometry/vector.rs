//! Three components of either precision.

use core::ops::{Add, AddAssign, Index, Mul, Neg, Sub};

use glam::DVec3;

use super::Real;

/// A point or direction in world units. Sums run as `(x + y) + z`, so that mirroring an axis or swapping x and y
/// changes no bit of a dot product or length.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vector<T> {
    /// Along world x.
    pub x: T,
    /// Along world y.
    pub y: T,
    /// Along world z, up.
    pub z: T,
}

impl<T: Real> Vector<T> {
    /// A vector from its components.
    #[inline(always)]
    pub const fn new(x: T, y: T, z: T) -> Self {
        Self { x, y, z }
    }

    /// The nearest vector of this precision.
    #[inline(always)]
    pub fn from_dvec3(v: DVec3) -> Self {
        Self::new(T::from_f64(v.x), T::from_f64(v.y), T::from_f64(v.z))
    }

    /// The same vector in `f64`, exactly.
    pub fn to_dvec3(self) -> DVec3 {
        DVec3::new(self.x.to_f64(), self.y.to_f64(), self.z.to_f64())
    }

    /// The same vector in double precision.
    pub(super) fn in_double(self) -> Vector<f64> {
        Vector::new(self.x.to_f64(), self.y.to_f64(), self.z.to_f64())
    }

    /// Scalar product.
    #[inline(always)]
    pub fn dot(self, other: Self) -> T {
        (self.x * other.x + self.y * other.y) + self.z * other.z
    }

    /// Vector product, right-handed.
    #[inline(always)]
    pub fn cross(self, other: Self) -> Self {
        Self::new(
            self.y * other.z - self.z * other.y,
            self.z * other.x - self.x * other.z,
            self.x * other.y - self.y * other.x,
        )
    }

    /// Euclidean length.
    #[inline(always)]
    pub fn length(self) -> T {
        self.dot(self).sqrt()
    }

    /// The direction of a vector that is not zero, with length 1.
    #[inline(always)]
    pub fn unit(self) -> Self {
        let square = self.dot(self);
        if square > T::SQUARE_FLOOR { self / square.sqrt() } else { self.unit_of_short() }
    }

    /// [`unit`](Self::unit), bit for bit, of a vector whose squares do not underflow.
    #[inline(always)]
    pub fn unit_of_long(self) -> Self {
        self / self.length()
    }

    /// Whether [`unit_of_long`](Self::unit_of_long) is exact.
    #[inline(always)]
    pub fn is_long(self) -> bool {
        self.dot(self) > T::SQUARE_FLOOR
    }

    /// The same where the squares underflow: a light may lie that close to a surface.
    #[cold]
    fn unit_of_short(self) -> Self {
        let largest = self.x.abs().at_least(self.y.abs()).at_least(self.z.abs());
        let scaled = self / largest;
        scaled / scaled.length()
    }

    /// Two unit vectors at right angles to this unit vector and to each other (T. Duff and others, "Building an
    /// Orthonormal Basis, Revisited", JCGT 6(1), 2017).
    #[inline(always)]
    pub fn perpendiculars(self) -> [Self; 2] {
        let Self { x, y, z } = self;
        let sign = T::ONE.copysign(z);
        let a = -T::ONE / (sign + z);
        let b = x * y * a;
        [Self::new(T::ONE + sign * (x * x * a), sign * b, -sign * x), Self::new(b, sign + y * y * a, -y)]
    }

    /// This vector with component `axis` (0, 1, 2) replaced.
    #[inline(always)]
    pub fn with(mut self, axis: usize, value: T) -> Self {
        match axis {
            0 => self.x = value,
            1 => self.y = value,
            _ => self.z = value,
        }
        self
    }

    /// Each component moved into its closed interval.
    #[inline(always)]
    pub fn clamp(self, low: Self, high: Self) -> Self {
        Self::new(
            self.x.at_least(low.x).at_most(high.x),
            self.y.at_least(low.y).at_most(high.y),
            self.z.at_least(low.z).at_most(high.z),
        )
    }
}

impl<T> Index<usize> for Vector<T> {
    type Output = T;

    #[inline(always)]
    fn index(&self, axis: usize) -> &T {
        match axis {
            0 => &self.x,
            1 => &self.y,
            _ => &self.z,
        }
    }
}

impl<T: Real> Add for Vector<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y, self.z + other.z)
    }
}

impl<T: Real> AddAssign for Vector<T> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<T: Real> Sub for Vector<T> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y, self.z - other.z)
    }
}

impl<T: Real> Neg for Vector<T> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y, -self.z)
    }
}

impl<T: Real> Mul<T> for Vector<T> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: T) -> Self {
        Self::new(self.x * factor, self.y * factor, self.z * factor)
    }
}

impl<T: Real> core::ops::Div<T> for Vector<T> {
    type Output = Self;
    #[inline(always)]
    fn div(self, divisor: T) -> Self {
        Self::new(self.x / divisor, self.y / divisor, self.z / divisor)
    }
}

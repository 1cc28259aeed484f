//! Linear colour.

use core::ops::{Add, AddAssign, Mul};

use glam::DVec3;

use crate::geometry::Real;

/// Linear red, green and blue; 1 is full output. Not clamped: only the finished picture is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rgb<T> {
    /// Red.
    pub r: T,
    /// Green.
    pub g: T,
    /// Blue.
    pub b: T,
}

impl<T: Real> Rgb<T> {
    /// No light.
    pub const BLACK: Self = Self { r: T::ZERO, g: T::ZERO, b: T::ZERO };
    /// Full output in all three.
    pub const WHITE: Self = Self { r: T::ONE, g: T::ONE, b: T::ONE };

    /// The nearest colour of this precision; x, y, z are red, green, blue.
    pub fn from_dvec3(v: DVec3) -> Self {
        Self { r: T::from_f64(v.x), g: T::from_f64(v.y), b: T::from_f64(v.z) }
    }

    /// The same in all three.
    #[inline(always)]
    pub const fn gray(value: T) -> Self {
        Self { r: value, g: value, b: value }
    }

    /// An 8-bit colour, 0..=255 to 0..=1.
    #[inline(always)]
    pub fn from_bytes([r, g, b]: [u8; 3]) -> Self {
        let scale = |byte: u8| T::from_u32(u32::from(byte)) / T::from_u32(255);
        Self { r: scale(r), g: scale(g), b: scale(b) }
    }

    /// The largest of the three, none of them NaN.
    #[inline(always)]
    pub fn largest(self) -> T {
        self.r.at_least(self.g).at_least(self.b)
    }

    /// The same colour in `f64`, exactly.
    pub fn to_f64(self) -> [f64; 3] {
        [self.r.to_f64(), self.g.to_f64(), self.b.to_f64()]
    }
}

impl<T: Real> Add for Rgb<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { r: self.r + other.r, g: self.g + other.g, b: self.b + other.b }
    }
}

impl<T: Real> AddAssign for Rgb<T> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<T: Real> Mul<T> for Rgb<T> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: T) -> Self {
        Self { r: self.r * factor, g: self.g * factor, b: self.b * factor }
    }
}

impl<T: Real> Mul for Rgb<T> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self { r: self.r * other.r, g: self.g * other.g, b: self.b * other.b }
    }
}

//! How much of a surface a pixel covers.

use crate::geometry::{Real, Vector};

/// How wide a pixel is along a ray through it: a cone, after T. Akenine-Möller et al., "Texture Level of Detail
/// Strategies for Real-Time Ray Tracing", Ray Tracing Gems, 2019. Mirrors are taken for flat, whatever their shape.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PixelCone<T> {
    /// Width where the ray starts, in world units.
    pub width: T,
    /// What each unit of the ray's length adds to it.
    pub spread: T,
}

impl<T: Real> PixelCone<T> {
    /// The cone from a point of the ray on, so far from its start.
    #[inline(always)]
    #[must_use]
    pub fn after(self, distance: T) -> Self {
        Self { width: self.width + self.spread * distance, ..self }
    }

    /// What a pixel covers of a horizontal plane around the point where a ray of this direction meets it, if the cone
    /// is `self` there: lengths along x and y in world units, of the rectangle that spreads as far along each axis as
    /// the cone's cross section does once it is laid down on the plane.
    ///
    /// A cross section of width `w`, stretched by `1 / |z|` along the direction's slope, spreads along x by
    /// `w sqrt(1 + (x / z)^2)`.
    #[inline(always)]
    pub fn on_level_plane(self, direction: Vector<T>) -> [T; 2] {
        [direction.x, direction.y].map(|along| {
            let slope = along / direction.z;
            self.width * (T::ONE + slope * slope).sqrt()
        })
    }
}

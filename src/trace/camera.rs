//! Rays of the camera.

use crate::components::{CameraPose, Lens};
use crate::geometry::{Ray, Real, Vector};

/// Rays through the pixel centres of a square picture, starting on the near plane.
#[derive(Clone, Debug)]
pub struct CameraRays<T> {
    eye: Vector<T>,
    look: Vector<T>,
    /// From the picture's middle to its right edge and to its top, at distance 1.
    right: Vector<T>,
    top: Vector<T>,
    near: T,
    far: T,
    pixels: u32,
}

/// A ray of the camera, of unit direction, and how far it reaches.
#[derive(Clone, Copy, Debug)]
pub struct CameraRay<T> {
    /// Starts on the near plane; its direction has length 1.
    pub ray: Ray<T>,
    /// Ray parameter at the far plane.
    pub reach: T,
}

impl<T: Real> CameraRays<T> {
    /// The rays of a camera for a picture of `pixels` by `pixels`. The horizontal field of view is `aspect * fovy`
    /// as an angle, whatever the picture's own shape.
    pub fn new(pose: &CameraPose, lens: &Lens, pixels: u32) -> Self {
        let half_extent = |degrees: f64| libm::tan(0.5 * degrees.to_radians());
        Self {
            eye: Vector::from_dvec3(pose.position),
            look: Vector::from_dvec3(pose.l),
            right: Vector::from_dvec3(pose.r * half_extent(lens.fovx())),
            top: Vector::from_dvec3(pose.u * half_extent(lens.fovy)),
            near: T::from_f64(lens.near),
            far: T::from_f64(lens.far),
            pixels,
        }
    }

    /// The rays of the same camera for a picture of `times` as many pixels along each side.
    #[must_use]
    pub fn refined(&self, times: u32) -> Self {
        Self { pixels: self.pixels * times, ..self.clone() }
    }

    /// Pixels along each side.
    pub fn pixels(&self) -> u32 {
        self.pixels
    }

    /// The ray through the centre of the pixel in a column from the left and a row from the top.
    #[inline(always)]
    pub fn ray(&self, column: u32, row: u32) -> CameraRay<T> {
        // From offsets, not as the difference of two points, which would cost digits far from the world's origin.
        let offset = self.right * self.centered(column) - self.top * self.centered(row);
        let direction = self.look + offset;
        let length = direction.length();
        let origin = self.eye + direction * self.near;
        CameraRay { ray: Ray { origin, direction: direction / length }, reach: self.far * length }
    }

    /// Position of a pixel centre from -1 to 1: exactly antisymmetric about the middle of the picture.
    #[inline(always)]
    fn centered(&self, index: u32) -> T {
        let doubled = T::from_u32(2 * index + 1) - T::from_u32(self.pixels);
        doubled / T::from_u32(self.pixels)
    }
}

//! Rays of the camera.

use crate::components::{Aperture, CameraPose, Lens};
use crate::effects::{Effect, EffectSet, PixelCone, disk_point};
use crate::geometry::{Ray, Real, Unit, Vector};

use super::kernel::known;
use super::{CameraEffects, Purpose, SampleId};

/// Rays through the pixel centres of a square picture, starting on the near plane.
#[derive(Clone, Debug)]
pub struct CameraRays<T> {
    eye: Vector<T>,
    look: Vector<T>,
    /// From the picture's middle to its right edge and to its top, at distance 1.
    right: Vector<T>,
    top: Vector<T>,
    /// Across the lens, unit: to the right and up.
    across_lens: [Vector<T>; 2],
    near: T,
    far: T,
    /// Width of a pixel, or its height if that is more, at distance 1.
    pixel_width: T,
    pixels: u32,
    effects: CameraEffects,
    unit: Unit,
}

/// A ray of the camera, of unit direction, and how far it reaches.
#[derive(Clone, Copy, Debug)]
pub struct CameraRay<T> {
    /// Starts on the near plane; its direction has length 1.
    pub ray: Ray<T>,
    /// Ray parameter at the far plane.
    pub reach: T,
    /// How wide the pixel is along the ray, on its wider side.
    pub cone: PixelCone<T>,
}

impl<T: Real> CameraRays<T> {
    /// The rays of a camera for a picture of `pixels` by `pixels`, in world units. The horizontal field of view is
    /// `aspect * fovy` as an angle, whatever the picture's own shape.
    pub fn new(pose: &CameraPose, lens: &Lens, pixels: u32) -> Self {
        Self::in_unit(pose, lens, pixels, Unit::WORLD)
    }

    /// The same in the unit of the tables that they are for.
    pub fn in_unit(pose: &CameraPose, lens: &Lens, pixels: u32, unit: Unit) -> Self {
        let half_extent = |degrees: f64| libm::tan(0.5 * degrees.to_radians());
        let (wide, high) = (half_extent(lens.fovx()), half_extent(lens.fovy));
        Self {
            eye: Vector::from_dvec3(unit.point(pose.position)),
            look: Vector::from_dvec3(pose.l),
            right: Vector::from_dvec3(pose.r * wide),
            top: Vector::from_dvec3(pose.u * high),
            across_lens: [pose.r, pose.u].map(Vector::from_dvec3),
            near: T::from_f64(unit.length(lens.near)),
            far: T::from_f64(unit.length(lens.far)),
            pixel_width: T::from_f64(2.0 * wide.max(high) / f64::from(pixels)),
            pixels,
            effects: CameraEffects::default(),
            unit,
        }
    }

    /// The rays of the same camera with other effects, of lengths in world units.
    #[must_use]
    pub fn with_effects(self, effects: CameraEffects) -> Self {
        Self { effects, ..self }
    }

    /// What the camera does beyond that of a pinhole.
    pub fn effects(&self) -> CameraEffects {
        self.effects
    }

    /// The rays of the same camera for a picture of `times` as many pixels along each side.
    #[must_use]
    pub fn refined(&self, times: u32) -> Self {
        let pixel_width = self.pixel_width / T::from_u32(times);
        Self { pixels: self.pixels * times, pixel_width, ..self.clone() }
    }

    /// Pixels along each side.
    pub fn pixels(&self) -> u32 {
        self.pixels
    }

    /// The ray through the centre of the pixel in a column from the left and a row from the top.
    #[inline(always)]
    pub fn ray(&self, column: u32, row: u32) -> CameraRay<T> {
        self.near_plane_ray(self.eye, self.through_pixel(column, row))
    }

    /// The ray for a sample of a pixel, through the pixel centre of this picture, which may be finer than the one that the
    /// sample is for. Through a pinhole it is [`ray`](Self::ray).
    ///
    /// A thin lens bends whatever passes it through a pixel to one point of the plane in focus, so the ray goes there
    /// from a point of the lens. It starts on the near plane and reaches to the far one as all rays do.
    pub fn sample(&self, column: u32, row: u32, sample: SampleId) -> CameraRay<T> {
        self.sample_of::<{ EffectSet::COMPILED.bits() }>(column, row, sample)
    }

    /// [`sample`](Self::sample) of a camera that has no effects but these.
    #[inline(always)]
    pub(super) fn sample_of<const EFFECTS: u32>(
        &self,
        column: u32,
        row: u32,
        sample: SampleId,
    ) -> CameraRay<T> {
        let direction = self.through_pixel(column, row);
        let Some(aperture) = known::<EFFECTS, _>(Effect::Aperture, self.effects.rows.aperture) else {
            return self.near_plane_ray(self.eye, direction);
        };
        self.through_lens(&aperture, direction, sample)
    }

    /// The ray to where a pinhole's ray would meet the plane in focus. Not inlined: pinholes would pay for its registers.
    #[inline(never)]
    fn through_lens(&self, aperture: &Aperture, direction: Vector<T>, sample: SampleId) -> CameraRay<T> {
        let on_lens = self.on_lens(aperture, sample);
        let focus = T::from_f64(self.unit.length(aperture.focus));
        self.near_plane_ray(self.eye + on_lens, direction - on_lens / focus)
    }

    /// From the eye to a pixel centre at distance 1 along the look.
    #[inline(always)]
    fn through_pixel(&self, column: u32, row: u32) -> Vector<T> {
        // From offsets, not as the difference of two points, which would cost digits far from the world's origin.
        self.look + (self.right * self.centered(column) - self.top * self.centered(row))
    }

    /// The ray that leaves `eye` along a direction with 1 along the look, from the near plane to the far one.
    #[inline(always)]
    fn near_plane_ray(&self, eye: Vector<T>, direction: Vector<T>) -> CameraRay<T> {
        let length = direction.length();
        let origin = eye + direction * self.near;
        // As wide as a pixel is at distance 1 along the look, which the ray reaches after `length`.
        let cone = PixelCone { width: self.pixel_width * self.near, spread: self.pixel_width / length };
        CameraRay { ray: Ray { origin, direction: direction / length }, reach: self.far * length, cone }
    }

    /// A point of the lens, from its middle.
    fn on_lens(&self, aperture: &Aperture, sample: SampleId) -> Vector<T> {
        let [along_right, along_up]: [T; 2] = disk_point(sample.sequence(Purpose::Lens).point(sample.index));
        let [right, up] = self.across_lens;
        let radius = T::from_f64(self.unit.length(aperture.radius));
        right * (along_right * radius) + up * (along_up * radius)
    }

    /// Position of a pixel centre from -1 to 1: exactly antisymmetric about the middle of the picture.
    #[inline(always)]
    fn centered(&self, index: u32) -> T {
        let doubled = T::from_u32(2 * index + 1) - T::from_u32(self.pixels);
        doubled / T::from_u32(self.pixels)
    }
}

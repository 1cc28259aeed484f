//! Blocks of pixels.

use crate::geometry::Real;
use crate::trace::{CameraRays, Counts, SceneTables};

use super::bounds::Bounds;
use super::lanes::{LANES, RayLanes};
use super::path::Paths;
use super::trees::Scratch;

/// Pixels along each side of a block.
pub(in crate::trace) const BLOCK_SIDE: u32 = 4;

/// What blocks of pixels are traced from.
pub(in crate::trace) struct Block<'a, T: Real> {
    pub(in crate::trace) tables: &'a SceneTables<T>,
    pub(in crate::trace) bounds: &'a Bounds<T>,
    pub(in crate::trace) camera: &'a CameraRays<T>,
    pub(in crate::trace) level: u32,
    /// Pixels of the camera's picture from one sample to the next.
    pub(in crate::trace) step: u32,
}

impl<T: Real> Block<'_, T> {
    /// One sample of each pixel of some rows, all of the same length of at most [`BLOCK_SIDE`]; the first one is at
    /// this column and row of the camera's picture. Each is given to `put` with its row and column in the block.
    #[inline(always)]
    pub(in crate::trace) fn trace<const EFFECTS: u32>(
        &self,
        (left, top): (u32, u32),
        (width, height): (u32, u32),
        scratch: &mut Scratch<T>,
        counts: &mut Counts,
        mut put: impl FnMut(usize, usize, [f64; 3]),
    ) {
        let rays = self.rays((left, top), (width, height));
        counts.rays.primary += u64::from(width * height);
        let paths = Paths { tables: self.tables, bounds: self.bounds, level: self.level };
        let colors = paths.radiance(&rays, scratch, counts);
        for row in 0..height as usize {
            for column in 0..width as usize {
                let color = colors.get(row * BLOCK_SIDE as usize + column);
                put(row, column, counts.clamp([color.x.to_f64(), color.y.to_f64(), color.z.to_f64()]));
            }
        }
    }

    #[inline(always)]
    fn rays(&self, (left, top): (u32, u32), (width, height): (u32, u32)) -> RayLanes<T> {
        let mut rays = RayLanes::idle();
        for (lane, number) in (0..LANES).zip(0..) {
            let (column, row) = (number % BLOCK_SIDE, number / BLOCK_SIDE);
            let is_inside = (column < width) & (row < height);
            let start = self.camera.ray(left + column * self.step, top + row * self.step);
            rays.origin.set(lane, start.ray.origin);
            rays.direction.set(lane, start.ray.direction);
            rays.reach[lane] = if is_inside { start.reach } else { -T::INFINITY };
        }
        rays
    }
}

//! Blocks of pixels.

use crate::geometry::{Real, Vector};
use crate::trace::{CameraRays, Counts, SceneTables};

use super::bounds::Bounds;
use super::lanes::{LANES, StartLanes, VectorLanes, any, nowhere};
use super::path::{Departing, Paths};
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
        mut put: impl FnMut(u32, u32, [f64; 3]),
    ) {
        let rays = self.rays((left, top), (width, height));
        counts.rays.primary += u64::from(width * height);
        let paths = Paths { tables: self.tables, bounds: self.bounds, level: self.level };
        let mut colors = paths.radiance::<EFFECTS>(rays, scratch, counts);
        clamp(&mut colors, counts);
        for row in 0..height {
            for column in 0..width {
                let color = colors.get((row * BLOCK_SIDE + column) as usize % LANES);
                put(row, column, [color.x.to_f64(), color.y.to_f64(), color.z.to_f64()]);
            }
        }
    }

    #[inline(always)]
    fn rays(&self, (left, top): (u32, u32), (width, height): (u32, u32)) -> Departing<T> {
        let (mut start, mut direction) = (StartLanes::free(), VectorLanes::zero());
        let mut reach = [nowhere(); LANES];
        for (lane, number) in (0..LANES).zip(0..) {
            let (column, row) = (number % BLOCK_SIDE, number / BLOCK_SIDE);
            let is_inside = (column < width) & (row < height);
            let ray = self.camera.ray(left + column * self.step, top + row * self.step);
            start.point.set(lane, ray.ray.origin);
            direction.set(lane, ray.ray.direction);
            reach[lane] = if is_inside { ray.reach } else { nowhere() };
        }
        Departing { start, direction, reach }
    }
}

/// [`Counts::clamp`] for every lane.
#[inline(always)]
fn clamp<T: Real>(colors: &mut VectorLanes<T>, counts: &mut Counts) {
    let finite = |value: T| value.abs() < T::INFINITY;
    if any(|lane| !(finite(colors.x[lane]) & finite(colors.y[lane]) & finite(colors.z[lane]))) {
        blacken_infinite(colors, counts);
    }
    for lane in 0..LANES {
        colors.x[lane] = colors.x[lane].at_least(T::ZERO).at_most(T::ONE);
        colors.y[lane] = colors.y[lane].at_least(T::ZERO).at_most(T::ONE);
        colors.z[lane] = colors.z[lane].at_least(T::ZERO).at_most(T::ONE);
    }
}

#[cold]
#[inline(never)]
fn blacken_infinite<T: Real>(colors: &mut VectorLanes<T>, counts: &mut Counts) {
    for lane in 0..LANES {
        let color = colors.get(lane);
        let [x, y, z] = counts.clamp([color.x.to_f64(), color.y.to_f64(), color.z.to_f64()]).map(T::from_f64);
        colors.set(lane, Vector::new(x, y, z));
    }
}

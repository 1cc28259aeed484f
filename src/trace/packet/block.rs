//! Packets of the camera's rays.

use crate::geometry::{Real, Vector};
use crate::trace::pixels::{PixelLanes, SampleLanes};
use crate::trace::{CameraRays, Counts, ObjectId, SamplePoint, SceneTables, Simd, Trail};

use super::bounds::Bounds;
use super::lanes::{LANES, OUTWARD, VectorLanes, any, nowhere};
use super::lights::WayLanes;
use super::path::{Departing, PathScratch, Paths};
use super::surface::SurfaceLanes;
use super::trees::TreeScratch;

/// Columns and rows of a block of pixels that is traced as one packet.
pub(in crate::trace) const BLOCK: [u32; 2] = [8, 4];

/// What packets of pixels are traced from.
pub(in crate::trace) struct Block<'a, T: Real> {
    pub(in crate::trace) tables: &'a SceneTables<T>,
    pub(in crate::trace) bounds: &'a Bounds<T>,
    pub(in crate::trace) camera: &'a CameraRays<T>,
    /// Column and row in the whole picture of the film's first pixel.
    pub(in crate::trace) corner: [u32; 2],
    pub(in crate::trace) level: u32,
    /// Share of the light up to which no ray is followed.
    pub(in crate::trace) cutoff: T,
    /// Pixels of the camera's picture from one sample to the next.
    pub(in crate::trace) step: u32,
    /// The sample of each pixel that is taken.
    pub(in crate::trace) point: SamplePoint,
    /// Whether anybody asks what the samples met.
    pub(in crate::trace) wants_trails: bool,
}

/// What packets need room for, kept from one to the next: zeros and copies of kilobytes for each packet were a tenth of the
/// instructions of a scene of few objects.
pub(in crate::trace) struct Scratch<T> {
    departing: Departing<T>,
    surface: SurfaceLanes<T>,
    ways: WayLanes<T>,
    trees: TreeScratch,
    /// Those of the packet that was traced last.
    pub(in crate::trace) samples: SampleLanes,
}

impl<T: Real> Scratch<T> {
    /// For one packet after the other.
    pub(in crate::trace) fn new(simd: Simd) -> Self {
        Self {
            departing: Departing::none(),
            surface: SurfaceLanes::none(),
            ways: WayLanes::none(),
            trees: TreeScratch::new(simd),
            samples: SampleLanes::black(),
        }
    }
}

impl<T: Real> Block<'_, T> {
    /// One sample of each of some pixels.
    #[inline(always)]
    pub(in crate::trace) fn trace<const EFFECTS: u32>(
        &self,
        pixels: &PixelLanes,
        Scratch { departing, surface, ways, trees, samples }: &mut Scratch<T>,
        counts: &mut Counts,
    ) {
        self.send(pixels, departing);
        counts.rays.primary += pixels.count as u64;
        let &Self { tables, bounds, level, cutoff, .. } = self;
        let paths = Paths { tables, bounds, level, cutoff };
        let SampleLanes { colors, trails } = samples;
        // Only where somebody asks: most pictures do without.
        let trails = if self.wants_trails {
            *trails = [Trail::default(); LANES];
            Some(trails)
        } else {
            None
        };
        let mut found =
            paths.radiance::<EFFECTS>(departing, PathScratch { surface, ways, trees }, trails, counts);
        clamp(&mut found, counts);
        for lane in 0..LANES {
            colors[lane] = [found.x[lane].to_f64(), found.y[lane].to_f64(), found.z[lane].to_f64()];
        }
    }

    #[inline(always)]
    fn send(&self, pixels: &PixelLanes, Departing { start, direction, reach }: &mut Departing<T>) {
        start.departed = [ObjectId::NOBODY; LANES];
        start.face = [OUTWARD; LANES];
        start.any_inward = false;
        for lane in 0..LANES {
            let column = (self.corner[0] + pixels.columns[lane]) * self.step + self.point.column;
            let row = (self.corner[1] + pixels.rows[lane]) * self.step + self.point.row;
            let ray = self.camera.ray(column, row);
            start.point.set(lane, ray.ray.origin);
            direction.set(lane, ray.ray.direction);
            reach[lane] = if lane < pixels.count { ray.reach } else { nowhere() };
        }
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

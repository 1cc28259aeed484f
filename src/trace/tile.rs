//! A rectangle of pixels, or some pixels here and there.

use crate::effects::Effect;
use crate::film::FilmBand;
use crate::geometry::Real;

use super::kernel::has;
use super::packet::{BLOCK, Block, Bounds, LANES, Scratch};
use super::pixels::{PixelLanes, PixelQueue, SampleLanes};
use super::radiance::{Depth, Walked};
use super::stages::Stages;
use super::{CameraRays, Counts, Kernel, SampleGrid, SampleId, SceneTables, Simd, Trail};

/// What a picture is traced from, and how.
#[derive(Clone, Copy, Debug)]
pub struct Exposure<'a, T: Real> {
    /// Objects and lights.
    pub tables: &'a SceneTables<T>,
    /// Rays through the centres of the picture's pixels.
    pub camera: &'a CameraRays<T>,
    /// Column and row in the picture of the film's first pixel: more than 0 for a film that is a part of it.
    pub corner: [u32; 2],
    /// How far paths are followed.
    pub depth: Depth<T>,
    /// Where pixels are sampled.
    pub grid: SampleGrid,
    /// What to trace with: one that has the effects of tables and camera. Which one decides about time alone.
    pub kernel: Kernel,
}

impl<'a, T: Real> Exposure<'a, T> {
    /// The whole picture, one sample a pixel, by the smallest kernel that has what tables and camera ask for.
    pub fn new(tables: &'a SceneTables<T>, camera: &'a CameraRays<T>, level: u32) -> Self {
        let kernel = Kernel::smallest_for(tables.effects().union(camera.effects().set()));
        Self {
            tables,
            camera,
            corner: [0; 2],
            depth: Depth::of_level(level),
            grid: SampleGrid::CENTER,
            kernel,
        }
    }

    /// One sample of every pixel of a band of rows, clamped to 0..=1: the first pass sets the pixels, later ones add to
    /// them, and after the last they hold the sum over the grid. The band is traced tile by tile, each as wide as it is
    /// high. `keep_going` is asked before each four rows of a tile; what comes after a no keeps what it held.
    pub fn trace_band(
        &self,
        simd: Simd,
        pass: u32,
        band: &mut FilmBand<'_>,
        keep_going: impl Fn() -> bool,
    ) -> Counts {
        self.with_task(pass, false, |task| {
            let mut counts = Counts::default();
            let mut scratch = Scratch::new(simd);
            let (side, height) = (band.side(), band.height());
            let tiles = (0..side).step_by(height.max(1) as usize);
            let strips =
                tiles.flat_map(|left| (0..height).step_by(BLOCK[1] as usize).map(move |row| (left, row)));
            for (left, row) in strips.take_while(|_| keep_going()) {
                let end = side.min(left + height);
                let mut strip = Strip { band: &mut *band, row, next: left, end, given: left, pass };
                counts += simd.trace(self.kernel, task, &mut strip, &mut scratch);
            }
            counts
        })
    }

    /// One sample of each of some pixels, named by column and row in the film, clamped to 0..=1. Each is given to
    /// `take` with its place in the list and with what it met.
    pub fn trace_listed(
        &self,
        simd: Simd,
        pass: u32,
        pixels: &[[u32; 2]],
        take: impl FnMut(usize, [f64; 3], Trail),
    ) -> Counts {
        let mut listed = Listed { pixels, taken: 0, given: 0, take };
        self.with_task(pass, true, |task| simd.trace(self.kernel, task, &mut listed, &mut Scratch::new(simd)))
    }

    fn with_task<R>(&self, pass: u32, wants_trails: bool, work: impl FnOnce(&PacketTask<'_, T>) -> R) -> R {
        // The samples of a pixel are the pixel centres of a finer picture.
        let camera = self.camera.refined(self.grid.side());
        let bounds = Bounds::new(self.tables);
        let gain = camera.effects().gain();
        let stages = Stages::of(self.kernel.effects());
        work(&PacketTask {
            exposure: self,
            camera: &camera,
            bounds: &bounds,
            stages,
            pass,
            gain,
            wants_trails,
        })
    }
}

/// What packets are traced from, or rays one by one.
pub(super) struct PacketTask<'a, T: Real> {
    exposure: &'a Exposure<'a, T>,
    camera: &'a CameraRays<T>,
    bounds: &'a Bounds<T>,
    stages: Stages<T>,
    pass: u32,
    /// What all light is multiplied by before it is cut off; packets are for cameras with 1.
    gain: f64,
    wants_trails: bool,
}

impl<T: Real> PacketTask<'_, T> {
    /// Traces pixels packet by packet, with the effects of these bits.
    #[inline(always)]
    pub(super) fn trace_packets<const EFFECTS: u32>(
        &self,
        queue: &mut dyn PixelQueue,
        scratch: &mut Scratch<T>,
    ) -> Counts {
        let mut counts = Counts::default();
        let &Exposure { tables, corner, depth, grid, .. } = self.exposure;
        if depth.level == 0 {
            return self.blacken(queue);
        }
        let block = Block {
            tables,
            bounds: self.bounds,
            camera: self.camera,
            corner,
            level: depth.level,
            cutoff: depth.cutoff,
            step: grid.side(),
            point: grid.point(self.pass),
            wants_trails: self.wants_trails,
        };
        loop {
            let pixels = queue.next();
            if pixels.count == 0 {
                return counts;
            }
            block.trace::<EFFECTS>(&pixels, scratch, &mut counts);
            queue.put(&scratch.samples);
        }
    }

    /// Traces pixels one by one.
    pub(super) fn trace_by_stages(&self, queue: &mut dyn PixelQueue) -> Counts {
        if self.exposure.depth.level == 0 { self.blacken(queue) } else { (self.stages.expose)(self, queue) }
    }

    /// At level 0 no ray is traced.
    #[inline(never)]
    fn blacken(&self, queue: &mut dyn PixelQueue) -> Counts {
        while queue.next().count > 0 {
            queue.put(&SampleLanes::black());
        }
        Counts::default()
    }

    #[inline(always)]
    fn sample<const EFFECTS: u32>(&self, column: u32, row: u32, counts: &mut Counts) -> ([f64; 3], Trail) {
        let &Exposure { tables, corner, depth, grid, .. } = self.exposure;
        let (column, row) = (corner[0] + column, corner[1] + row);
        let (side, point) = (grid.side(), grid.point(self.pass));
        let sample = SampleId { column, row, index: self.pass };
        let start =
            self.camera.sample_of::<EFFECTS>(column * side + point.column, row * side + point.row, sample);
        counts.rays.primary += 1;
        let stages = &self.stages;
        let found = (stages.follow)(Walked { tables, stages }, start, depth, sample, counts);
        let color = found.color.to_f64();
        let exposed =
            if has::<EFFECTS>(Effect::Exposure) { color.map(|channel| channel * self.gain) } else { color };
        (counts.clamp(exposed), found.trail)
    }
}

/// Traces pixels one by one, by a camera that has no effects but these.
pub(super) fn trace_each<T: Real, const EFFECTS: u32>(
    task: &PacketTask<'_, T>,
    queue: &mut dyn PixelQueue,
) -> Counts {
    let mut counts = Counts::default();
    loop {
        let pixels = queue.next();
        if pixels.count == 0 {
            return counts;
        }
        let mut samples = SampleLanes::black();
        for lane in 0..pixels.count {
            let (color, trail) = task.sample::<EFFECTS>(pixels.columns[lane], pixels.rows[lane], &mut counts);
            samples.set(lane, color, trail);
        }
        queue.put(&samples);
    }
}

/// Some rows of a tile, no more than a block has.
struct Strip<'a, 'b> {
    band: &'a mut FilmBand<'b>,
    /// Its first row in the band.
    row: u32,
    /// The columns that are left, and the first of those given out last.
    next: u32,
    end: u32,
    given: u32,
    pass: u32,
}

impl Strip<'_, '_> {
    #[inline(always)]
    fn rows(&self) -> u32 {
        (self.band.height() - self.row).min(BLOCK[1])
    }
}

impl PixelQueue for Strip<'_, '_> {
    #[inline]
    fn next(&mut self) -> PixelLanes {
        let width = (self.end - self.next).min(BLOCK[0]);
        self.given = self.next;
        self.next += width;
        PixelLanes::rectangle((self.given, self.band.top() + self.row), (width, self.rows()))
    }

    #[inline]
    fn put(&mut self, samples: &SampleLanes) {
        let width = (self.next - self.given) as usize;
        for (row, colors) in (self.row..self.row + self.rows()).zip(samples.colors.chunks(width.max(1))) {
            let pixels = self.band.pixels_mut(row, self.given..self.next);
            if self.pass == 0 {
                pixels.copy_from_slice(&colors[..width]);
            } else {
                pixels.iter_mut().zip(colors).for_each(|(pixel, &color)| add(pixel, color));
            }
        }
    }
}

/// Pixels of a list.
struct Listed<'a, F> {
    pixels: &'a [[u32; 2]],
    taken: usize,
    /// Of those taken, how many were given out last.
    given: usize,
    take: F,
}

impl<F: FnMut(usize, [f64; 3], Trail)> PixelQueue for Listed<'_, F> {
    fn next(&mut self) -> PixelLanes {
        let mut lanes = PixelLanes::NONE;
        for &[column, row] in self.pixels[self.taken..].iter().take(LANES) {
            lanes.push(column, row);
        }
        self.given = lanes.count;
        self.taken += lanes.count;
        lanes
    }

    fn put(&mut self, samples: &SampleLanes) {
        let first = self.taken - self.given;
        for lane in 0..self.given {
            (self.take)(first + lane, samples.colors[lane], samples.trails[lane]);
        }
    }
}

#[inline(always)]
fn add(pixel: &mut [f64; 3], sample: [f64; 3]) {
    for (sum, channel) in pixel.iter_mut().zip(sample) {
        *sum += channel;
    }
}

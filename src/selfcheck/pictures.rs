//! A picture by every path: packets with each kind of vector instructions, and ray after ray.

use glam::DVec3;

use crate::components::{CameraPose, Lens};
use crate::effects::{EffectSet, GlossRow, Rgb};
use crate::film::Film;
use crate::geometry::{CubeShape, PyramidShape, Real, SphereShape, Vector};
use crate::trace::{
    BoardEffects, CameraRays, Counts, Exposure, Kernel, LightEffects, LightRow, SampleId, SceneTables, Simd,
    SurfaceEffects, SurfaceRow, radiance,
};

use super::random::Random;
use super::tally::Tally;

const PIXELS: u32 = 61;
const LEVEL: u32 = 5;

/// A surface with gloss and a mirror.
fn surface<T: Real>(random: &mut Random) -> SurfaceRow<T> {
    let mut share = |most: f64| T::from_f64(most * random.share());
    SurfaceRow {
        color: Rgb { r: share(1.0), g: share(1.0), b: share(1.0) },
        ambient: share(0.3),
        diffuse: share(0.6),
        effects: SurfaceEffects {
            gloss: Some(GlossRow { specular: share(0.5), shininess: share(60.0) }),
            mirror: Some(share(0.6)),
            ..SurfaceEffects::default()
        },
    }
}

/// Four bodies of each kind about the origin, two lights, and the ground.
fn scene<T: Real>(random: &mut Random) -> SceneTables<T> {
    let mut tables = SceneTables::<T>::default();
    for order in 0..4 {
        let size = random.between(0.2, 1.2);
        let mut place = || random.point() * 3.0;
        let (sphere, cube, pyramid) = (place(), place(), place());
        let center = Vector::from_dvec3(sphere);
        tables.spheres.shapes.push(SphereShape { center, radius: T::from_f64(size) });
        tables.cubes.shapes.push(CubeShape::new(cube, size));
        tables.pyramids.shapes.push(PyramidShape::new(pyramid, size, 1.5 * size));
        tables.spheres.order.push(3 * order);
        tables.cubes.order.push(3 * order + 1);
        tables.pyramids.order.push(3 * order + 2);
        tables.spheres.surfaces.push(surface(random));
        tables.cubes.surfaces.push(surface(random));
        tables.pyramids.surfaces.push(surface(random));
        let position = Vector::from_dvec3(random.direction() * 8.0);
        let effects = LightEffects { falloff: Some(T::from_f64(0.003)), ..LightEffects::default() };
        tables.lights.push(LightRow { position, effects });
    }
    tables.boards.shapes.push(Vector::from_dvec3(DVec3::NEG_Z), T::ONE, BoardEffects::default());
    tables.boards.order.push(12);
    tables.boards.surfaces.push(surface(random));
    tables
}

fn camera<T: Real>(random: &mut Random) -> Option<CameraRays<T>> {
    let eye = random.direction() * 9.0;
    let lens = Lens { near: 0.5, far: 100.0, fovy: 50.0, aspect: 1.2 };
    Some(CameraRays::new(&CameraPose::looking(eye, -eye, DVec3::Z)?, &lens, PIXELS))
}

/// Ray after ray, every object tested.
fn ray_by_ray<T: Real>(exposure: &Exposure<'_, T>, index: u32, counts: &mut Counts) -> [f64; 3] {
    let (column, row) = (index % PIXELS, index / PIXELS);
    let sample = SampleId { column, row, index: 0 };
    let start = exposure.camera.ray(column, row);
    let color = radiance(exposure.tables, start, exposure.depth, sample, counts).color;
    color.to_f64().map(|channel| channel.clamp(0.0, 1.0))
}

/// By a kernel.
fn film<T: Real>(exposure: &Exposure<'_, T>, simd: Simd, counts: &mut Counts) -> Option<Film> {
    let mut film = Film::new(PIXELS)?;
    for mut band in film.bands_mut(32) {
        *counts += exposure.trace_band(simd, 0, &mut band, || true);
    }
    Some(film)
}

/// All vector instructions with all kernels that have some effects.
fn paths(effects: EffectSet) -> impl Iterator<Item = (Simd, Kernel)> {
    let levels = Simd::available().into_iter();
    levels.flat_map(move |simd| Kernel::all_for(effects).map(move |kernel| (simd, kernel)))
}

/// Pixels of random scenes that are not the same to the bit on every path, or not finite.
pub fn check_pictures<T: Real>(scenes: u64, seed: u64) -> Tally {
    let mut tally = Tally::new("pixels, on every path", T::NAME);
    for number in 0..scenes {
        let random = &mut Random::new(seed.wrapping_add(number));
        let tables = scene::<T>(random);
        let Some(camera) = camera::<T>(random) else { continue };
        let exposure = Exposure::new(&tables, &camera, LEVEL);
        let mut counts = Counts::default();
        let truth: Vec<_> =
            (0..PIXELS * PIXELS).map(|index| ray_by_ray(&exposure, index, &mut counts)).collect();
        for (simd, kernel) in paths(tables.effects()) {
            let found = film(&Exposure { kernel, ..exposure }, simd, &mut counts);
            let found = found.as_ref().map_or(&[][..], Film::pixels);
            tally.cases += u64::from(PIXELS * PIXELS);
            let same = found.iter().zip(&truth).filter(|(a, b)| a.map(f64::to_bits) == b.map(f64::to_bits));
            tally.wrong += u64::from(PIXELS * PIXELS) - same.count() as u64;
        }
        tally.wrong += counts.non_finite;
    }
    tally
}

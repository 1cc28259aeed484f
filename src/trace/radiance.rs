//! The recursion.

use crate::effects::{Effect, EffectSet, PixelCone, Rgb, left_by, reflect, split, split_at_sheet};
use crate::geometry::{Convex, Ray, Real, Side, SurfacePoint, Vector};

use super::filtered_color::{PixelSpot, filtered_color};
use super::kernel::{has, known};
use super::shade::{Lighting, Look, Shaded};
use super::{
    CameraRay, Counts, Departure, Hit, Kind, ObjectId, SampleId, SceneTables, ShapeColumns, SurfaceRow,
    Trail, closest_hit,
};

/// Where glass splits a ray in two, no part is followed of which less than this, in every channel, would reach the pixel.
/// The parts of a ray are together no stronger than it is, so there are never more than 3 * 4096, at any level.
const SMALLEST_PART: f64 = 1.0 / 4096.0;

/// How far a path is followed.
#[derive(Clone, Copy, Debug)]
pub struct Depth<T> {
    /// Rays that may follow each other.
    pub level: u32,
    /// Share of the light in the pixel, 0 to 1: a ray that carries no more in any channel is not followed.
    pub cutoff: T,
}

impl<T: Real> Depth<T> {
    /// As far as the level allows, as long as anything arrives.
    pub fn of_level(level: u32) -> Self {
        Self { level, cutoff: T::ZERO }
    }
}

/// What a path found.
#[derive(Clone, Copy, Debug)]
pub struct Radiance<T> {
    /// Not clamped.
    pub color: Rgb<T>,
    /// What it met.
    pub trail: Trail,
}

impl<T: Real> Default for Radiance<T> {
    /// Nothing.
    fn default() -> Self {
        Self { color: Rgb::BLACK, trail: Trail::default() }
    }
}

/// The radiance that arrives along a ray of the camera from surfaces within its reach, followed through mirrors and glass
/// for at most `depth.level` rays in a row (T. Whitted, "An Improved Illumination Model for Shaded Display", CACM 23(6), 1980).
/// Not clamped. The caller counts the ray itself.
///
/// The recursion `local + r * (local + r * ...)` is a loop that carries the product of the shares: no level overflows a
/// stack. Glass sends on two rays; one of them waits, so that at most one does for each ray in a row.
pub fn radiance<T: Real>(
    tables: &SceneTables<T>,
    start: CameraRay<T>,
    depth: Depth<T>,
    sample: SampleId,
    counts: &mut Counts,
) -> Radiance<T> {
    radiance_of::<T, { EffectSet::COMPILED.bits() }>(tables, start, depth, sample, counts)
}

/// [`radiance`] in a scene that has no effects but these.
#[inline(never)]
pub(super) fn radiance_of<T: Real, const EFFECTS: u32>(
    tables: &SceneTables<T>,
    start: CameraRay<T>,
    depth: Depth<T>,
    sample: SampleId,
    counts: &mut Counts,
) -> Radiance<T> {
    let Some(remaining) = depth.level.checked_sub(1) else { return Radiance::default() };
    let CameraRay { ray, reach, cone } = start;
    let first = Path { ray, reach, cone, departure: Departure::Free, weight: Rgb::WHITE, remaining };
    let cutoff = depth.cutoff;
    let found = Radiance::default();
    let mut walk = Walk::<T, EFFECTS> { tables, cutoff, sample, rays: 0, found, waiting: Vec::new() };
    let mut next = Some(first);
    while let Some(path) = next {
        next = walk.follow(&path, counts).or_else(|| walk.next_waiting());
    }
    walk.found
}

/// A ray on its way, and what becomes of the light that it finds.
#[derive(Clone, Copy)]
struct Path<T> {
    ray: Ray<T>,
    reach: T,
    cone: PixelCone<T>,
    departure: Departure,
    /// Share of the light in the pixel.
    weight: Rgb<T>,
    /// Rays that may follow this one in a row.
    remaining: u32,
}

/// All rays of one sample.
struct Walk<'a, T: Real, const EFFECTS: u32> {
    tables: &'a SceneTables<T>,
    cutoff: T,
    sample: SampleId,
    /// Rays so far.
    rays: u32,
    found: Radiance<T>,
    waiting: Vec<Path<T>>,
}

/// How much of the light goes on where.
struct Onward<T> {
    reflected: T,
    refracted: Option<(T, Vector<T>)>,
}

impl<T: Real, const EFFECTS: u32> Walk<'_, T, EFFECTS> {
    #[inline(always)]
    fn next_waiting(&mut self) -> Option<Path<T>> {
        if has::<EFFECTS>(Effect::Glass) { self.waiting.pop() } else { None }
    }

    /// Adds the light that one ray finds, and says how it goes on.
    #[inline(always)]
    fn follow(&mut self, path: &Path<T>, counts: &mut Counts) -> Option<Path<T>> {
        let tables = self.tables;
        self.rays += 1;
        let Some(hit) = closest_hit(tables, &path.ray, &path.departure, path.reach) else {
            self.found.color += tables.air.of_kernel::<EFFECTS>().beyond(path.ray.direction) * path.weight;
            return None;
        };
        let (surfaces, row) = tables.surface(hit.object);
        let surface = surfaces.row(row).of_kernel::<EFFECTS>();
        self.found.trail = self.found.trail.after(ObjectId::packed(hit.object.kind, hit.object.row));
        let weight = self.dim(path, &hit, &surface);
        if weight == Rgb::BLACK {
            return None;
        }
        let direction = path.ray.direction;
        let shaded = Shaded::new(&hit, locate(tables, &hit, &path.ray));
        let onward = Onward::new(&surface, &hit, shaded.normal, path);
        // One reflected direction serves gloss and mirrors; a surface with neither never computes it.
        let needs_mirrored = surface.gloss.is_some() || onward.reflected != T::ZERO;
        let mirrored = if needs_mirrored { reflect(direction, shaded.normal) } else { direction };
        let cone = path.cone.after(hit.crossing.t);
        let own = filtered_color::<T, EFFECTS>(
            tables,
            hit.object,
            surface.color,
            PixelSpot { point: shaded.point, direction, cone },
        );
        let look = Look { sample: self.sample, ray: self.rays };
        let lighting = Lighting { tables, shaded: &shaded, surface: &surface, mirrored, look };
        self.found.color += lighting.shade::<EFFECTS>(own, &mut self.found.trail, counts) * weight;

        let leave = |direction, departure, share: T| Path {
            ray: Ray { origin: shaded.point, direction },
            reach: T::INFINITY,
            cone,
            departure,
            weight: weight * share,
            remaining: path.remaining.wrapping_sub(1),
        };
        let reflected = leave(mirrored, shaded.departure, onward.reflected);
        match onward.refracted {
            None => (reflected.weight.largest() > self.cutoff)
                .then_some(reflected)
                .inspect(|_| counts.rays.mirror += 1),
            Some((share, refracted)) => self.part(reflected, leave(refracted, hit.passage(), share), counts),
        }
    }

    /// What is left of a ray's light on the way to what it met; what fog adds to it is added.
    #[inline(always)]
    fn dim(&mut self, path: &Path<T>, hit: &Hit<T>, surface: &SurfaceRow<T>) -> Rgb<T> {
        let distance = hit.crossing.t;
        if surface.glass.is_some() && hit.crossing.side == Side::Inside {
            return surface
                .absorption
                .map_or(path.weight, |absorption| path.weight * left_by(absorption, distance));
        }
        let Some(haze) = known::<EFFECTS, _>(Effect::Fog, self.tables.air.haze) else { return path.weight };
        let left = haze.left_after(distance);
        self.found.color += haze.color * path.weight * (T::ONE - left);
        path.weight * left
    }

    /// Of the two rays that glass makes of one, the first to follow; the other one waits.
    fn part(&mut self, reflected: Path<T>, refracted: Path<T>, counts: &mut Counts) -> Option<Path<T>> {
        let [has_reflected, has_refracted] =
            [&reflected, &refracted].map(|path| path.weight.largest() > self.cutoff);
        let smallest = if has_reflected && has_refracted { T::from_f64(SMALLEST_PART) } else { T::ZERO };
        let reflected = Some(reflected).filter(|path| has_reflected && path.weight.largest() >= smallest);
        let refracted = Some(refracted).filter(|path| has_refracted && path.weight.largest() >= smallest);
        counts.rays.mirror += u64::from(reflected.is_some());
        counts.rays.refracted += u64::from(refracted.is_some());
        if reflected.is_some() {
            self.waiting.extend(refracted);
            reflected
        } else {
            refracted
        }
    }
}

impl<T: Real> Onward<T> {
    #[inline(always)]
    fn new(surface: &SurfaceRow<T>, hit: &Hit<T>, normal: Vector<T>, path: &Path<T>) -> Self {
        if path.remaining == 0 {
            return Self { reflected: T::ZERO, refracted: None };
        }
        let mirror = surface.mirror.unwrap_or(T::ZERO);
        let Some(glass) = surface.glass else { return Self { reflected: mirror, refracted: None } };
        let direction = path.ray.direction;
        let parts = match (hit.object.kind, hit.crossing.side) {
            (Kind::Board, _) => split_at_sheet(direction, normal, T::ONE / glass.index),
            (_, Side::Outside) => split(direction, normal, T::ONE / glass.index),
            (_, Side::Inside) => split(direction, normal, glass.index),
        };
        let share = glass.transmission * (T::ONE - parts.reflected);
        Self {
            reflected: mirror + glass.transmission * parts.reflected,
            refracted: parts.refracted.map(|direction| (share, direction)),
        }
    }
}

/// The surface point of a hit.
#[inline(always)]
fn locate<T: Real>(tables: &SceneTables<T>, hit: &Hit<T>, ray: &Ray<T>) -> SurfacePoint<T> {
    let row = hit.object.row as usize;
    match hit.object.kind {
        Kind::Sphere => tables.spheres.shapes.shape(row).locate(ray, &hit.crossing),
        Kind::Cube => tables.cubes.shapes.shape(row).locate(ray, &hit.crossing),
        Kind::Pyramid => tables.pyramids.shapes.shape(row).locate(ray, &hit.crossing),
        Kind::Board => tables.boards.shapes.shape(row).locate(ray, &hit.crossing),
    }
}

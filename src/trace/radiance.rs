//! The recursion.

use crate::effects::{
    Effect, EffectSet, GlassRow, Haze, PixelCone, Rgb, Split, left_by, reflect, split, split_at_sheet,
};
use crate::geometry::{Convex, Ray, Real, Side, SurfacePoint, Vector};

use super::filtered_color::PixelSpot;
use super::kernel::{has, known};
use super::shade::{Lighting, Look, Shaded};
use super::stages::Stages;
use super::{
    CameraRay, Counts, Departure, Hit, Kind, ObjectId, SampleId, SceneTables, ShapeColumns, Trail,
    closest_hit,
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
    let stages = &Stages::of(EffectSet::COMPILED);
    (stages.follow)(Walked { tables, stages }, start, depth, sample, counts)
}

/// What rays walk through, and what happens to them there.
#[derive(Clone, Copy)]
pub(super) struct Walked<'a, T: Real> {
    pub(super) tables: &'a SceneTables<T>,
    pub(super) stages: &'a Stages<T>,
}

/// [`radiance`] where rays are subject to no effects but these.
pub(super) fn follow_all<T: Real, const EFFECTS: u32>(
    Walked { tables, stages }: Walked<'_, T>,
    start: CameraRay<T>,
    depth: Depth<T>,
    sample: SampleId,
    counts: &mut Counts,
) -> Radiance<T> {
    let Some(remaining) = depth.level.checked_sub(1) else { return Radiance::default() };
    let CameraRay { ray, reach, cone } = start;
    let mut path = Path { ray, reach, cone, departure: Departure::Free, weight: Rgb::WHITE, remaining };
    let cutoff = depth.cutoff;
    let found = Radiance::default();
    let mut walk = Walk::<T, EFFECTS> { tables, stages, cutoff, sample, rays: 0, found, waiting: Vec::new() };
    while walk.follow(&mut path, counts) || walk.take_waiting(&mut path) {}
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
    stages: &'a Stages<T>,
    cutoff: T,
    sample: SampleId,
    /// Rays so far.
    rays: u32,
    found: Radiance<T>,
    waiting: Vec<Path<T>>,
}

impl<T: Real, const EFFECTS: u32> Walk<'_, T, EFFECTS> {
    /// Goes on with a ray that waits, if any does.
    #[inline(always)]
    fn take_waiting(&mut self, path: &mut Path<T>) -> bool {
        let waiting = if has::<EFFECTS>(Effect::Glass) { self.waiting.pop() } else { None };
        waiting.map(|next| *path = next).is_some()
    }

    /// Adds the light that one ray finds, turns it into the ray that follows it, and says whether one does. Not inlined, so
    /// that the path stays where it is, whatever the effects: copies of it cost more than they all do.
    #[inline(never)]
    fn follow(&mut self, path: &mut Path<T>, counts: &mut Counts) -> bool {
        let tables = self.tables;
        self.rays += 1;
        let Some((hit, shaded)) = meet(tables, path) else {
            (self.stages.look_beyond)(&tables.air, path.ray.direction, path.weight, &mut self.found.color);
            return false;
        };
        let (surfaces, row) = tables.surface(hit.object);
        let surface = surfaces.row(row).of_kernel::<EFFECTS>();
        self.found.trail = self.found.trail.after(ObjectId::packed(hit.object.kind, hit.object.row));
        self.dim(path, &hit, surface.effects.glass.is_some());
        let weight = path.weight;
        if weight == Rgb::BLACK {
            return false;
        }
        let direction = path.ray.direction;
        let goes_on = path.remaining > 0;
        let glass = surface.effects.glass.filter(|_| goes_on);
        let mirror = surface.effects.mirror.filter(|_| goes_on).unwrap_or(T::ZERO);
        // One reflected direction serves gloss, mirrors and glass; a surface with none of them never computes it.
        let needs_mirrored = surface.effects.gloss.is_some() || mirror != T::ZERO || glass.is_some();
        let mirrored = if needs_mirrored { reflect(direction, shaded.normal) } else { direction };
        let cone = path.cone.after(hit.crossing.t);
        let own = match hit.object.kind {
            Kind::Board => {
                let spot = PixelSpot { point: shaded.point, direction, cone };
                (self.stages.paint)(tables, hit.object, surface.color, spot)
            }
            _ => surface.color,
        };
        let look = Look { sample: self.sample, ray: self.rays };
        let stages = self.stages;
        let lighting = Lighting { tables, stages, shaded: &shaded, surface: &surface, mirrored, look };
        self.found.color += lighting.shade(own, &mut self.found.trail, counts) * weight;

        let reflected = Path {
            ray: Ray { origin: shaded.point, direction: mirrored },
            reach: T::INFINITY,
            cone,
            departure: shaded.departure,
            weight: weight * mirror,
            remaining: path.remaining.wrapping_sub(1),
        };
        if let Some(glass) = glass {
            let cutoff = self.cutoff;
            let pane = Pane { glass, hit: &hit, normal: shaded.normal, direction, weight, cutoff };
            let part = pane.part(mirror, reflected, &mut self.waiting, counts);
            return part.map(|next| *path = next).is_some();
        }
        let is_followed = reflected.weight.largest() > self.cutoff;
        if is_followed {
            counts.rays.mirror += 1;
            *path = reflected;
        }
        is_followed
    }

    /// Takes from a ray's light what is lost on the way to what it met; what fog adds to it is added. What does that
    /// writes where the light is kept: in scenes without fog and glass nothing is moved.
    #[inline(always)]
    fn dim(&mut self, path: &mut Path<T>, hit: &Hit<T>, is_glass: bool) {
        if is_glass && hit.crossing.side == Side::Inside {
            if has::<EFFECTS>(Effect::Absorption) {
                absorb(self.tables, hit, &mut path.weight);
            }
        } else if let Some(haze) = known::<EFFECTS, _>(Effect::Fog, self.tables.air.fog.as_ref()) {
            veil(haze, hit.crossing.t, &mut path.weight, &mut self.found.color);
        }
    }
}

// What few scenes ask for stays in functions of its own: the loop around it would keep less in registers.

/// What glass leaves of a ray's light from side to side.
#[inline(never)]
fn absorb<T: Real>(tables: &SceneTables<T>, hit: &Hit<T>, weight: &mut Rgb<T>) {
    let (surfaces, row) = tables.surface(hit.object);
    if let Some(&absorption) = surfaces.effects.absorption.get(row) {
        *weight = *weight * left_by(absorption, hit.crossing.t);
    }
}

/// The light that fog adds on the way, and what it leaves of a ray's.
#[inline(never)]
fn veil<T: Real>(haze: &Haze<T>, distance: T, weight: &mut Rgb<T>, found: &mut Rgb<T>) {
    let left = haze.left_after(distance);
    *found += haze.color * *weight * (T::ONE - left);
    *weight = *weight * left;
}

/// Glass where a ray meets it.
struct Pane<'a, T> {
    glass: GlassRow<T>,
    hit: &'a Hit<T>,
    normal: Vector<T>,
    /// Of the ray.
    direction: Vector<T>,
    /// Share of the ray's light in the pixel.
    weight: Rgb<T>,
    /// See [`Depth`].
    cutoff: T,
}

impl<T: Real> Pane<'_, T> {
    /// Of the two rays that glass makes of one, the first to follow; the other one waits. The reflected one is given as a
    /// mirror alone would send it.
    #[inline(never)]
    fn part(
        &self,
        mirror: T,
        reflected: Path<T>,
        waiting: &mut Vec<Path<T>>,
        counts: &mut Counts,
    ) -> Option<Path<T>> {
        let Split { reflected: share, refracted } = self.split();
        let transmission = self.glass.transmission;
        let reflected = Path { weight: self.weight * (mirror + transmission * share), ..reflected };
        let refracted = refracted.map(|direction| Path {
            ray: Ray { direction, ..reflected.ray },
            departure: self.hit.passage(),
            weight: self.weight * (transmission * (T::ONE - share)),
            ..reflected
        });
        let [reflected, refracted] =
            [Some(reflected), refracted].map(|path| path.filter(|path| path.weight.largest() > self.cutoff));
        let smallest =
            if reflected.is_some() && refracted.is_some() { T::from_f64(SMALLEST_PART) } else { T::ZERO };
        let [reflected, refracted] =
            [reflected, refracted].map(|path| path.filter(|path| path.weight.largest() >= smallest));
        counts.rays.mirror += u64::from(reflected.is_some());
        counts.rays.refracted += u64::from(refracted.is_some());
        if reflected.is_some() {
            waiting.extend(refracted);
            reflected
        } else {
            refracted
        }
    }

    #[inline(always)]
    fn split(&self) -> Split<T> {
        let (direction, normal, index) = (self.direction, self.normal, self.glass.index);
        match (self.hit.object.kind, self.hit.crossing.side) {
            (Kind::Board, _) => split_at_sheet(direction, normal, T::ONE / index),
            (_, Side::Outside) => split(direction, normal, T::ONE / index),
            (_, Side::Inside) => split(direction, normal, index),
        }
    }
}

/// What a ray meets, and where: once for all that follow rays.
#[inline(never)]
fn meet<T: Real>(tables: &SceneTables<T>, path: &Path<T>) -> Option<(Hit<T>, Shaded<T>)> {
    let hit = closest_hit(tables, &path.ray, &path.departure, path.reach)?;
    Some((hit, Shaded::new(&hit, locate(tables, &hit, &path.ray))))
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

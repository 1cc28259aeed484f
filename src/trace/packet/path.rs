//! The recursion, for a packet.

use crate::effects::{Effect, reflect_long};
use crate::geometry::Real;
use crate::trace::{Counts, ObjectId, SceneTables, Trail};

use super::bounds::Bounds;
use super::bundle::{Bundle, Cluster};
use super::closest::closest;
use super::has;
use super::lanes::{LANES, LaneCounts, Lanes, RayLanes, Reach, StartLanes, VectorLanes, any, nowhere};
use super::lights::{LightLanes, Lighting};
use super::surface::{SurfaceLanes, gather};
use super::trees::Scratch;

/// What packets are traced in.
pub(super) struct Paths<'a, T: Real> {
    pub(super) tables: &'a SceneTables<T>,
    pub(super) bounds: &'a Bounds<T>,
    pub(super) level: u32,
    /// Share of the light up to which no ray is followed.
    pub(super) cutoff: T,
    /// Whether anybody asks what the samples met.
    pub(super) wants_trails: bool,
}

/// Rays that a packet sends out.
pub(super) struct Departing<T> {
    pub(super) start: StartLanes<T>,
    /// Of length 1.
    pub(super) direction: VectorLanes<T>,
    pub(super) reach: Reach<T>,
}

impl<T: Real> Paths<'_, T> {
    /// [`radiance`](crate::trace::radiance()) of every active lane.
    #[inline(always)]
    pub(super) fn radiance<const EFFECTS: u32>(
        &self,
        departing: Departing<T>,
        scratch: &mut Scratch<T>,
        counts: &mut Counts,
    ) -> (VectorLanes<T>, [Trail; LANES]) {
        let mut trails = [Trail::default(); LANES];
        let mut sum = VectorLanes::zero();
        let mut weight = [T::ONE; LANES];
        let Departing { mut start, mut direction, mut reach } = departing;
        let mut cluster = Cluster::of(&start.point, &reach);
        let (mut shadow_rays, mut mirror_rays) = (LaneCounts::NONE, LaneCounts::NONE);
        for remaining in (0..self.level).rev() {
            // 1. What the rays meet. A lane that meets nothing has nothing more to do.
            let bundle = Bundle::of_rays(&cluster, &direction, &reach);
            let candidates = self.bounds.near(&bundle);
            let rays = RayLanes { start: &start, direction: &direction };
            let hits = closest(self.tables, &rays, &reach, &bundle, &candidates, scratch);
            if !any(|lane| hits.name[lane] != ObjectId::NOBODY) {
                break;
            }
            let surface = gather::<T, EFFECTS>(self.tables, &rays, &hits);
            if self.wants_trails {
                meet(&mut trails, &hits.name);
            }
            // 2. Where the rays go on, for mirrors and for highlights.
            let goes_on = surface.any_mirror && remaining > 0;
            if surface.any_gloss || goes_on {
                reflect_all(&mut direction, &surface.normal);
            }
            for lane in 0..LANES {
                let is_active = hits.name[lane] != ObjectId::NOBODY;
                reach[lane] = if is_active { T::INFINITY } else { nowhere() };
            }
            cluster = Cluster::of(&surface.start.point, &reach);
            // 3. The light there.
            let lighting = Lighting {
                tables: self.tables,
                bounds: self.bounds,
                surface: &surface,
                cluster: &cluster,
                mirrored: &direction,
            };
            let trails = self.wants_trails.then_some(&mut trails);
            let light = lighting.gather::<EFFECTS>(&mut shadow_rays, scratch, trails);
            add::<T, EFFECTS>(&mut sum, &surface, &light, &weight);
            if !(has::<EFFECTS>(Effect::Mirror) && goes_on) {
                break;
            }
            // 4. The next rays.
            reflect_on(&mut reach, &mut weight, &surface, self.cutoff);
            if !any(|lane| reach[lane] >= T::ZERO) {
                break;
            }
            mirror_rays.add(&reach);
            start = surface.start;
        }
        counts.rays.shadow += shadow_rays.sum();
        counts.rays.mirror += mirror_rays.sum();
        (sum, trails)
    }
}

/// Turns every lane's ray at its surface.
#[inline(always)]
fn reflect_all<T: Real>(direction: &mut VectorLanes<T>, normal: &VectorLanes<T>) {
    for lane in 0..LANES {
        direction.set(lane, reflect_long(direction.get(lane), normal.get(lane)));
    }
}

/// Adds the light that the surfaces send back by themselves; those of idle lanes send none.
#[inline(always)]
fn add<T: Real, const EFFECTS: u32>(
    sum: &mut VectorLanes<T>,
    surface: &SurfaceLanes<T>,
    light: &LightLanes<T>,
    weight: &Lanes<T>,
) {
    for lane in 0..LANES {
        let mut share = surface.ambient[lane] + surface.diffuse[lane] * light.lambert[lane];
        if has::<EFFECTS>(Effect::Gloss) {
            share += surface.specular[lane] * light.phong[lane];
        }
        let more = sum.get(lane) + (surface.color.get(lane) * share) * weight[lane];
        let is_active = surface.start.departed[lane] != ObjectId::NOBODY;
        sum.set_if(is_active, lane, more);
    }
}

/// Notes what the active lanes met.
#[inline(always)]
fn meet(trails: &mut [Trail; LANES], name: &Lanes<u32>) {
    for lane in 0..LANES {
        let met = trails[lane].after(name[lane]);
        trails[lane] = if name[lane] == ObjectId::NOBODY { trails[lane] } else { met };
    }
}

/// Sends the lanes on that met a mirror which sends on more than the cutoff.
#[inline(always)]
fn reflect_on<T: Real>(reach: &mut Reach<T>, weight: &mut Lanes<T>, surface: &SurfaceLanes<T>, cutoff: T) {
    for lane in 0..LANES {
        weight[lane] *= surface.reflectance[lane];
        let goes_on = (reach[lane] >= T::ZERO) & (weight[lane] > cutoff);
        reach[lane] = if goes_on { T::INFINITY } else { nowhere() };
    }
}

//! The recursion, for a packet.

use crate::effects::{Effect, reflect_long};
use crate::geometry::{Real, Vector};
use crate::trace::{Counts, ObjectId, SceneTables, Trail};

use super::bounds::Bounds;
use super::bundle::{Bundle, Cluster};
use super::closest::closest;
use super::has;
use super::lanes::{LANES, LaneCounts, Lanes, RayLanes, Reach, StartLanes, VectorLanes, any, mask, nowhere};
use super::lights::{LightLanes, Lighting, WayLanes};
use super::surface::{SurfaceLanes, gather};
use super::trees::TreeScratch;

/// What packets are traced in.
pub(super) struct Paths<'a, T: Real> {
    pub(super) tables: &'a SceneTables<T>,
    pub(super) bounds: &'a Bounds<T>,
    pub(super) level: u32,
    /// Share of the light up to which no ray is followed.
    pub(super) cutoff: T,
}

/// Rays that a packet sends out.
pub(super) struct Departing<T> {
    pub(super) start: StartLanes<T>,
    /// Of length 1.
    pub(super) direction: VectorLanes<T>,
    pub(super) reach: Reach<T>,
}

impl<T: Real> Departing<T> {
    /// No rays yet.
    pub(super) fn none() -> Self {
        Self { start: StartLanes::free(), direction: VectorLanes::zero(), reach: [nowhere(); LANES] }
    }
}

/// What a path needs room for, whatever it was used for before.
pub(super) struct PathScratch<'a, T> {
    pub(super) surface: &'a mut SurfaceLanes<T>,
    pub(super) ways: &'a mut WayLanes<T>,
    pub(super) trees: &'a mut TreeScratch,
}

impl<T: Real> Paths<'_, T> {
    /// [`radiance`](crate::trace::radiance()) of every active lane. What they meet is noted in the trails, if there are any.
    #[inline(always)]
    pub(super) fn radiance<const EFFECTS: u32>(
        &self,
        departing: &mut Departing<T>,
        PathScratch { surface, ways, trees }: PathScratch<'_, T>,
        mut trails: Option<&mut [Trail; LANES]>,
        counts: &mut Counts,
    ) -> VectorLanes<T> {
        let mut sum = VectorLanes::zero();
        // Of what the next surfaces send back; nothing yet is weaker than it is.
        let mut weight: Option<Lanes<T>> = None;
        // In place: a copy, and mirror rays counted lane by lane, were half of what mirrors cost scenes without any.
        let Departing { start, direction, reach } = departing;
        // Before the loop, and again at its end: at its start, scenes without mirrors paid 1 % for those that might be there.
        let mut bundle = Bundle::of_rays(&Cluster::of(&start.point, reach), direction, reach);
        let mut shadow_rays = LaneCounts::NONE;
        for remaining in (0..self.level).rev() {
            // 1. What the rays meet. A lane that meets nothing has nothing more to do.
            let candidates = self.bounds.near(&bundle);
            let rays = RayLanes { start, direction };
            let hits = closest(self.tables, &rays, reach, &bundle, &candidates, trees);
            if !any(|lane| hits.name[lane] != ObjectId::NOBODY) {
                break;
            }
            gather::<T, EFFECTS>(self.tables, &rays, &hits, surface);
            if let Some(trails) = &mut trails {
                meet(trails, &hits.name);
            }
            // 2. Where the rays go on, for mirrors and for highlights.
            let goes_on = surface.any_mirror && remaining > 0;
            if surface.any_gloss || goes_on {
                reflect_all(direction, &surface.normal);
            }
            for lane in 0..LANES {
                let is_active = hits.name[lane] != ObjectId::NOBODY;
                reach[lane] = if is_active { T::INFINITY } else { nowhere() };
            }
            let cluster = Cluster::of(&surface.start.point, reach);
            // 3. The light there.
            let lighting = Lighting {
                tables: self.tables,
                bounds: self.bounds,
                surface,
                cluster: &cluster,
                mirrored: direction,
            };
            let light = lighting.gather::<EFFECTS>(&mut shadow_rays, ways, trees, trails.as_deref_mut());
            add::<T, EFFECTS>(&mut sum, surface, &light, weight.as_ref());
            if !(has::<EFFECTS>(Effect::Mirror) && goes_on) {
                break;
            }
            // 4. The next rays.
            reflect_on(reach, weight.get_or_insert([T::ONE; LANES]), surface, self.cutoff);
            let going_on = mask(|lane| reach[lane] >= T::ZERO).count_ones();
            if going_on == 0 {
                break;
            }
            bundle = Bundle::of_rays(&cluster, direction, reach);
            *start = surface.start;
            counts.rays.mirror += u64::from(going_on);
        }
        counts.rays.shadow += shadow_rays.sum();
        sum
    }
}

/// Turns every lane's ray at its surface.
#[inline(always)]
fn reflect_all<T: Real>(direction: &mut VectorLanes<T>, normal: &VectorLanes<T>) {
    for lane in 0..LANES {
        direction.set(lane, reflect_long(direction.get(lane), normal.get(lane)));
    }
}

/// Adds the light that the surfaces send back by themselves, weakened if need be; those of idle lanes send none.
#[inline(always)]
fn add<T: Real, const EFFECTS: u32>(
    sum: &mut VectorLanes<T>,
    surface: &SurfaceLanes<T>,
    light: &LightLanes<T>,
    weight: Option<&Lanes<T>>,
) {
    if let Some(weight) = weight {
        for lane in 0..LANES {
            let more = sum.get(lane) + sent::<T, EFFECTS>(surface, light, lane) * weight[lane];
            sum.set_if(surface.start.departed[lane] != ObjectId::NOBODY, lane, more);
        }
    } else {
        for lane in 0..LANES {
            let more = sum.get(lane) + sent::<T, EFFECTS>(surface, light, lane);
            sum.set_if(surface.start.departed[lane] != ObjectId::NOBODY, lane, more);
        }
    }
}

/// The light that a surface sends back by itself: red, green, blue as x, y, z.
#[inline(always)]
fn sent<T: Real, const EFFECTS: u32>(
    surface: &SurfaceLanes<T>,
    light: &LightLanes<T>,
    lane: usize,
) -> Vector<T> {
    let mut share = surface.ambient[lane] + surface.diffuse[lane] * light.lambert[lane];
    if has::<EFFECTS>(Effect::Gloss) {
        share += surface.specular[lane] * light.phong[lane];
    }
    surface.color.get(lane) * share
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

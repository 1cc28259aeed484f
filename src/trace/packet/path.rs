//! The recursion, for a packet.

use crate::effects::reflect_long;
use crate::geometry::Real;
use crate::trace::{Counts, ObjectId, SceneTables};

use super::bounds::{Bounds, Candidates};
use super::bundle::Bundle;
use super::closest::closest;
use super::lanes::{LANES, Lanes, OUTWARD, RayLanes, VectorLanes, mask};
use super::lights::{LightLanes, Lighting};
use super::surface::{SurfaceLanes, gather};
use super::trees::Scratch;

/// What packets are traced in.
pub(super) struct Paths<'a, T: Real> {
    pub(super) tables: &'a SceneTables<T>,
    pub(super) bounds: &'a Bounds<T>,
    pub(super) level: u32,
}

impl<T: Real> Paths<'_, T> {
    /// [`radiance`](crate::trace::radiance()) of every active lane; red, green, blue as x, y, z.
    #[inline(always)]
    pub(super) fn radiance(
        &self,
        start: &RayLanes<T>,
        scratch: &mut Scratch<T>,
        counts: &mut Counts,
    ) -> VectorLanes<T> {
        let mut sum = VectorLanes::zero();
        let mut weight = [T::ONE; LANES];
        let mut rays = *start;
        for remaining in (0..self.level).rev() {
            let hits = closest(self.tables, &rays, &self.candidates(&rays), scratch);
            let active = mask(|lane| hits.name[lane] != ObjectId::NOBODY);
            if active == 0 {
                break;
            }
            let surface = gather(self.tables, &rays, &hits, active);
            let goes_on = surface.any_mirror && remaining > 0;
            rays = leave(&rays, &hits.name, &surface, active, surface.any_gloss || goes_on);
            let lighting = Lighting {
                tables: self.tables,
                bounds: self.bounds,
                surface: &surface,
                leaving: &rays,
                active,
            };
            let (light, shadow_rays) = lighting.gather(scratch);
            counts.rays.shadow += u64::from(shadow_rays);
            add(&mut sum, &surface, &light, &weight, active);
            if !goes_on {
                break;
            }
            let mirror_rays = reflect_on(&mut rays, &mut weight, &surface, active);
            if mirror_rays == 0 {
                break;
            }
            counts.rays.mirror += u64::from(mirror_rays);
        }
        sum
    }

    #[inline(always)]
    fn candidates(&self, rays: &RayLanes<T>) -> Candidates {
        let first = rays.active().trailing_zeros() as usize % LANES;
        let (mut origin, mut direction) = (rays.origin, rays.direction);
        let (first_origin, first_direction) = (rays.origin.get(first), rays.direction.get(first));
        for lane in 0..LANES {
            let is_idle = rays.reach[lane] < T::ZERO;
            origin.set_if(is_idle, lane, first_origin);
            direction.set_if(is_idle, lane, first_direction);
        }
        self.bounds.near(&Bundle::of_rays(&origin, &direction))
    }
}

/// The rays that go on from surface points, along the mirrored direction if anyone needs it.
#[inline(always)]
fn leave<T: Real>(
    rays: &RayLanes<T>,
    names: &Lanes<u32>,
    surface: &SurfaceLanes<T>,
    active: u32,
    mirrored: bool,
) -> RayLanes<T> {
    let mut leaving = RayLanes { origin: surface.point, departed: *names, face: surface.face, ..*rays };
    leaving.any_inward = mask(|lane| surface.face[lane] != OUTWARD) & active != 0;
    if mirrored {
        for lane in 0..LANES {
            let direction = reflect_long(rays.direction.get(lane), surface.normal.get(lane));
            leaving.direction.set(lane, direction);
        }
    }
    leaving
}

/// Adds the light that the surfaces send back by themselves.
#[inline(always)]
fn add<T: Real>(
    sum: &mut VectorLanes<T>,
    surface: &SurfaceLanes<T>,
    light: &LightLanes<T>,
    weight: &Lanes<T>,
    active: u32,
) {
    for lane in 0..LANES {
        let diffuse = surface.ambient[lane] + surface.diffuse[lane] * light.lambert[lane];
        let share = diffuse + surface.specular[lane] * light.phong[lane];
        let more = sum.get(lane) + (surface.color.get(lane) * share) * weight[lane];
        sum.set_if((active >> lane) & 1 == 1, lane, more);
    }
}

/// Sends the lanes on that met a mirror, and counts them.
#[inline(always)]
fn reflect_on<T: Real>(
    rays: &mut RayLanes<T>,
    weight: &mut Lanes<T>,
    surface: &SurfaceLanes<T>,
    active: u32,
) -> u32 {
    for lane in 0..LANES {
        weight[lane] *= surface.reflectance[lane];
        let goes_on = ((active >> lane) & 1 == 1) & (weight[lane] > T::ZERO);
        rays.reach[lane] = if goes_on { T::INFINITY } else { -T::INFINITY };
    }
    rays.active().count_ones()
}

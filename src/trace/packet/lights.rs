//! The light that reaches the surface points of a packet.

use crate::effects::{attenuation, lambert, phong};
use crate::geometry::Real;
use crate::trace::{LightRow, SceneTables};

use super::bounds::Bounds;
use super::bundle::Bundle;
use super::lanes::{LANES, Lanes, RayLanes, VectorLanes, greatest};
use super::occlusion::occlude;
use super::surface::SurfaceLanes;
use super::trees::Scratch;

/// Sums over all lights that reach each point.
#[derive(Clone, Copy, Debug)]
pub(super) struct LightLanes<T> {
    pub(super) lambert: Lanes<T>,
    pub(super) phong: Lanes<T>,
}

/// What the lights do to the points of a packet.
pub(super) struct Lighting<'a, T: Real> {
    pub(super) tables: &'a SceneTables<T>,
    pub(super) bounds: &'a Bounds<T>,
    pub(super) surface: &'a SurfaceLanes<T>,
    /// How rays leave the points; these rays lead along the mirrored direction.
    pub(super) leaving: &'a RayLanes<T>,
    pub(super) active: u32,
}

impl<T: Real> Lighting<'_, T> {
    /// The sums, light by light, and the number of shadow rays.
    #[inline(always)]
    pub(super) fn gather(&self, scratch: &mut Scratch<T>) -> (LightLanes<T>, u32) {
        let mut sums = LightLanes { lambert: [T::ZERO; LANES], phong: [T::ZERO; LANES] };
        let mut shadow_rays = 0;
        for row in 0..self.tables.lights.len() {
            shadow_rays += self.add(row, &mut sums, scratch);
        }
        (sums, shadow_rays)
    }

    #[inline(always)]
    fn add(&self, row: usize, sums: &mut LightLanes<T>, scratch: &mut Scratch<T>) -> u32 {
        let light = &self.tables.lights.row(row);
        let mut segments = self.segments_to(light);
        let scale = self.scales(light, &mut segments);
        let rays = segments.active().count_ones();
        if rays == 0 {
            return 0;
        }
        let to_light = segments.direction.unit();
        let candidates = self.bounds.near(&bundle_from(light, &segments, &to_light));
        occlude(self.tables, &mut segments, &candidates, row, scratch);
        if segments.active() != 0 {
            self.shine(&segments, &to_light, &scale, sums);
        }
        rays
    }

    /// The ways to a light from points that face it and that its cone contains.
    #[inline(always)]
    fn segments_to(&self, light: &LightRow<T>) -> RayLanes<T> {
        let mut segments = *self.leaving;
        for lane in 0..LANES {
            let segment = light.position - self.surface.point.get(lane);
            let faces = segment.dot(self.surface.normal.get(lane)) > T::ZERO;
            let is_lit = faces & ((self.active >> lane) & 1 == 1);
            segments.direction.set(lane, segment);
            segments.reach[lane] = if is_lit { T::ONE } else { -T::INFINITY };
        }
        if let Some(cone) = light.cone {
            for lane in 0..LANES {
                let contains = cone.contains(-segments.direction.get(lane));
                segments.reach[lane] = if contains { segments.reach[lane] } else { -T::INFINITY };
            }
        }
        segments
    }

    /// The share of the light that arrives from so far.
    #[inline(always)]
    fn scales(&self, light: &LightRow<T>, segments: &mut RayLanes<T>) -> Lanes<T> {
        let mut scale = [T::ONE; LANES];
        if let Some(falloff) = light.falloff {
            for lane in 0..LANES {
                let segment = segments.direction.get(lane);
                scale[lane] = attenuation(segment.dot(segment), falloff);
                let arrives = !(scale[lane] == T::ZERO);
                segments.reach[lane] = if arrives { segments.reach[lane] } else { -T::INFINITY };
            }
        }
        scale
    }

    #[inline(always)]
    fn shine(
        &self,
        segments: &RayLanes<T>,
        to_light: &VectorLanes<T>,
        scale: &Lanes<T>,
        sums: &mut LightLanes<T>,
    ) {
        for lane in 0..LANES {
            let is_lit = segments.reach[lane] > T::ZERO;
            let more =
                sums.lambert[lane] + lambert(to_light.get(lane), self.surface.normal.get(lane)) * scale[lane];
            sums.lambert[lane] = if is_lit { more } else { sums.lambert[lane] };
        }
        if !self.surface.any_gloss {
            return;
        }
        for lane in 0..LANES {
            let is_lit = (segments.reach[lane] > T::ZERO) & (self.surface.specular[lane] > T::ZERO);
            let mirrored = self.leaving.direction.get(lane);
            let highlight = phong(mirrored, to_light.get(lane), self.surface.shininess[lane]);
            let more = sums.phong[lane] + highlight * scale[lane];
            sums.phong[lane] = if is_lit { more } else { sums.phong[lane] };
        }
    }
}

/// The cone from a light to the points at the near ends of segments. Idle lanes lie where an active one does.
#[inline(always)]
fn bundle_from<T: Real>(light: &LightRow<T>, segments: &RayLanes<T>, to_light: &VectorLanes<T>) -> Bundle<T> {
    let first = segments.active().trailing_zeros() as usize % LANES;
    let (stand_in, stand_in_way) = (to_light.get(first), segments.direction.get(first));
    let mut from_light = VectorLanes::zero();
    let mut squares = [T::ZERO; LANES];
    for lane in 0..LANES {
        let is_active = segments.reach[lane] > T::ZERO;
        from_light.set(lane, -stand_in);
        from_light.set_if(is_active, lane, -to_light.get(lane));
        let square = segments.direction.get(lane);
        let square = square.dot(square);
        squares[lane] = if is_active { square } else { stand_in_way.dot(stand_in_way) };
    }
    Bundle::from_point(light.position, &from_light, greatest(&squares).sqrt())
}

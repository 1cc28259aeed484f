//! The light that reaches the surface points of a packet.

use crate::effects::{Effect, attenuation, lambert, phong};
use crate::geometry::Real;
use crate::trace::{LightRow, ObjectId, SceneTables, Trail};

use super::bounds::Bounds;
use super::bundle::{Bundle, Cluster};
use super::has;
use super::lanes::{LANES, LaneCounts, Lanes, RayLanes, Reach, VectorLanes, any, nowhere};
use super::occlusion::occlude;
use super::surface::SurfaceLanes;
use super::trees::TreeScratch;

/// Sums over all lights that reach each point.
#[derive(Clone, Copy, Debug)]
pub(super) struct LightLanes<T> {
    pub(super) lambert: Lanes<T>,
    pub(super) phong: Lanes<T>,
}

/// From each point to a light.
pub(super) struct WayLanes<T> {
    segments: VectorLanes<T>,
    /// Of the segments; below 0 where no light arrives.
    reach: Reach<T>,
}

impl<T: Real> WayLanes<T> {
    /// No light yet.
    pub(super) fn none() -> Self {
        Self { segments: VectorLanes::zero(), reach: [nowhere(); LANES] }
    }
}

/// What the lights do to the points of a packet.
pub(super) struct Lighting<'a, T: Real> {
    pub(super) tables: &'a SceneTables<T>,
    pub(super) bounds: &'a Bounds<T>,
    pub(super) surface: &'a SurfaceLanes<T>,
    /// Around the points.
    pub(super) cluster: &'a Cluster<T>,
    /// Unit directions of the viewing rays after reflection, where there is gloss.
    pub(super) mirrored: &'a VectorLanes<T>,
}

impl<T: Real> Lighting<'_, T> {
    /// The sums, light by light; shadow rays are counted, and lights that arrive are noted in the trails, if there are any.
    #[inline(always)]
    pub(super) fn gather<const EFFECTS: u32>(
        &self,
        shadow_rays: &mut LaneCounts,
        ways: &mut WayLanes<T>,
        trees: &mut TreeScratch,
        mut trails: Option<&mut [Trail; LANES]>,
    ) -> LightLanes<T> {
        let mut sums = LightLanes { lambert: [T::ZERO; LANES], phong: [T::ZERO; LANES] };
        for row in 0..self.tables.lights.len() {
            self.add::<EFFECTS>(row, &mut sums, shadow_rays, ways, trees, trails.as_deref_mut());
        }
        sums
    }

    #[inline(always)]
    fn add<const EFFECTS: u32>(
        &self,
        row: usize,
        sums: &mut LightLanes<T>,
        shadow_rays: &mut LaneCounts,
        WayLanes { segments, reach }: &mut WayLanes<T>,
        trees: &mut TreeScratch,
        trails: Option<&mut [Trail; LANES]>,
    ) {
        // 1. Points that face the light, in its cone, and not so far that nothing arrives.
        let light = &self.tables.lights.row(row);
        self.find_ways::<EFFECTS>(light, segments, reach);
        if !any(|lane| reach[lane] > T::ZERO) {
            return;
        }
        let scale = scales::<T, EFFECTS>(light, segments, reach);
        if !any(|lane| reach[lane] > T::ZERO) {
            return;
        }
        shadow_rays.add(reach);
        // 2. Points that nothing hides from it.
        let bundle = Bundle::from_point(light.position, self.cluster);
        let candidates = self.bounds.near(&bundle);
        let ways = RayLanes { start: &self.surface.start, direction: segments };
        occlude(self.tables, &ways, reach, &bundle, &candidates, row, trees);
        if let Some(trails) = trails {
            note(trails, reach, row);
        }
        // 3. What it does there.
        if any(|lane| reach[lane] > T::ZERO) {
            segments.normalize();
            self.shine::<EFFECTS>(reach, segments, &scale, sums);
        }
    }

    /// The ways to a light, up to it from points that face it and that its cone contains.
    #[inline(always)]
    fn find_ways<const EFFECTS: u32>(
        &self,
        light: &LightRow<T>,
        segments: &mut VectorLanes<T>,
        reach: &mut Reach<T>,
    ) {
        let start = &self.surface.start;
        // By themselves, as in `SurfaceLanes::locate`.
        let departed = start.departed;
        for lane in 0..LANES {
            let segment = light.position - start.point.get(lane);
            let faces = segment.dot(self.surface.normal.get(lane)) > T::ZERO;
            let is_lit = faces & (departed[lane] != ObjectId::NOBODY);
            segments.set(lane, segment);
            reach[lane] = if is_lit { T::ONE } else { nowhere() };
        }
        if has::<EFFECTS>(Effect::SpotCone)
            && let Some(cone) = light.effects.spot_cone
        {
            for lane in 0..LANES {
                let contains = cone.contains(-segments.get(lane));
                reach[lane] = if contains { reach[lane] } else { nowhere() };
            }
        }
    }

    #[inline(always)]
    fn shine<const EFFECTS: u32>(
        &self,
        reach: &Reach<T>,
        to_light: &VectorLanes<T>,
        scale: &Lanes<T>,
        sums: &mut LightLanes<T>,
    ) {
        let surface = self.surface;
        for lane in 0..LANES {
            let more =
                sums.lambert[lane] + lambert(to_light.get(lane), surface.normal.get(lane)) * scale[lane];
            sums.lambert[lane] = if reach[lane] > T::ZERO { more } else { sums.lambert[lane] };
        }
        if !(has::<EFFECTS>(Effect::Gloss) && surface.any_gloss) {
            return;
        }
        for lane in 0..LANES {
            let is_lit = (reach[lane] > T::ZERO) & (surface.specular[lane] > T::ZERO);
            let highlight = phong(self.mirrored.get(lane), to_light.get(lane), surface.shininess[lane]);
            let more = sums.phong[lane] + highlight * scale[lane];
            sums.phong[lane] = if is_lit { more } else { sums.phong[lane] };
        }
    }
}

/// Notes a light in the trails of the lanes that it reaches.
#[inline(always)]
fn note<T: Real>(trails: &mut [Trail; LANES], reach: &Reach<T>, row: usize) {
    for lane in 0..LANES {
        let lit = trails[lane].lit_by(row);
        trails[lane] = if reach[lane] > T::ZERO { lit } else { trails[lane] };
    }
}

/// The share of the light that arrives from so far; lanes where nothing does become idle.
#[inline(always)]
fn scales<T: Real, const EFFECTS: u32>(
    light: &LightRow<T>,
    segments: &VectorLanes<T>,
    reach: &mut Reach<T>,
) -> Lanes<T> {
    let mut scale = [T::ONE; LANES];
    if has::<EFFECTS>(Effect::Falloff)
        && let Some(falloff) = light.effects.falloff
    {
        for lane in 0..LANES {
            let segment = segments.get(lane);
            scale[lane] = attenuation(segment.dot(segment), falloff);
            let arrives = !(scale[lane] == T::ZERO);
            reach[lane] = if arrives { reach[lane] } else { nowhere() };
        }
    }
    scale
}

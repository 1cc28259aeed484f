//! What the tables hold, counted.

use crate::effects::{Effect, EffectSet};
use crate::geometry::Real;

use super::air::size;
use super::{MovingRow, SceneTables, ShapeColumns, SurfaceTable};

/// An effect that some row asks for, or could.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EffectCount {
    /// The effect.
    pub effect: Effect,
    /// Rows that ask for it; 0 means that the trace never touches it.
    pub rows: usize,
    /// Memory that its rows take.
    pub bytes: usize,
}

/// Rows of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TableCount {
    /// Name in reports: `spheres`, `cubes`, `pyramids`, `checkerboards`, `lights`.
    pub table: &'static str,
    /// Number of rows.
    pub rows: usize,
}

impl<T: Real> SceneTables<T> {
    /// Rows of every table.
    pub fn table_counts(&self) -> [TableCount; 5] {
        [
            TableCount { table: "spheres", rows: self.spheres.shapes.len() },
            TableCount { table: "cubes", rows: self.cubes.shapes.len() },
            TableCount { table: "pyramids", rows: self.pyramids.shapes.len() },
            TableCount { table: "checkerboards", rows: self.boards.shapes.len() },
            TableCount { table: "lights", rows: self.lights.len() },
        ]
    }

    /// What every effect takes, in the order of [`Effect::ALL`].
    pub fn effect_counts(&self) -> Vec<EffectCount> {
        Effect::ALL.into_iter().map(|effect| self.effect_count(effect)).collect()
    }

    /// The effects that some row asks for.
    pub fn effects(&self) -> EffectSet {
        Effect::ALL.into_iter().filter(|&effect| self.effect_count(effect).rows > 0).collect()
    }

    fn effect_count(&self, effect: Effect) -> EffectCount {
        let (rows, bytes) = match effect {
            Effect::Gloss => self.over_surfaces(|surfaces| surfaces.gloss.size()),
            Effect::Mirror => self.over_surfaces(|surfaces| surfaces.mirror.size()),
            Effect::Texture => self.boards.shapes.textures.size(),
            Effect::Falloff => self.lights.falloff.size(),
            Effect::SpotCone => self.lights.cone.size(),
            Effect::LightColor => self.lights.color.size(),
            Effect::Directional => self.lights.toward.size(),
            Effect::AreaLight => self.lights.ball.size(),
            Effect::Background => size(self.air.background.as_ref()),
            Effect::Fog => size(self.air.haze.as_ref()),
            Effect::Glass => self.over_surfaces(|surfaces| surfaces.glass.size()),
            Effect::Absorption => self.over_surfaces(|surfaces| surfaces.absorption.size()),
            Effect::TextureFilter => self.boards.shapes.texture_filter_size(),
            Effect::CheckerFilter => self.boards.shapes.checker_filters.size(),
            Effect::MotionBlur => (self.moving.len(), self.moving.capacity() * size_of::<MovingRow<T>>()),
            // The camera's, see `CameraEffects::count`.
            Effect::Aperture | Effect::Exposure | Effect::Srgb => (0, 0),
        };
        EffectCount { effect, rows, bytes }
    }

    fn over_surfaces(&self, size: impl Fn(&SurfaceTable<T>) -> (usize, usize)) -> (usize, usize) {
        let all =
            [&self.spheres.surfaces, &self.cubes.surfaces, &self.pyramids.surfaces, &self.boards.surfaces];
        all.into_iter().map(size).fold((0, 0), |sum, size| (sum.0 + size.0, sum.1 + size.1))
    }
}

//! What the tables hold, counted.

use crate::geometry::Real;

use super::{SceneTables, ShapeColumns, ShapeTable};

/// An effect that some row asks for, or could.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EffectCount {
    /// Name in reports: `gloss`, `mirror`, `texture`, `falloff`, `spot_cone`.
    pub effect: &'static str,
    /// Rows that ask for it; 0 means that the trace never touches it.
    pub rows: usize,
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

    /// Rows that ask for each effect.
    pub fn effect_counts(&self) -> [EffectCount; 5] {
        [
            EffectCount { effect: "gloss", rows: self.over_surfaces(|counts| counts.gloss) },
            EffectCount { effect: "mirror", rows: self.over_surfaces(|counts| counts.mirror) },
            EffectCount { effect: "texture", rows: self.boards.shapes.textures.len() },
            EffectCount { effect: "falloff", rows: self.lights.falloff.len() },
            EffectCount { effect: "spot_cone", rows: self.lights.cone.len() },
        ]
    }

    fn over_surfaces(&self, part: impl Fn(SurfaceCounts) -> usize) -> usize {
        part(surface_counts(&self.spheres))
            + part(surface_counts(&self.cubes))
            + part(surface_counts(&self.pyramids))
            + part(surface_counts(&self.boards))
    }
}

struct SurfaceCounts {
    gloss: usize,
    mirror: usize,
}

fn surface_counts<T: Real, C>(table: &ShapeTable<T, C>) -> SurfaceCounts {
    SurfaceCounts { gloss: table.surfaces.gloss.len(), mirror: table.surfaces.mirror.len() }
}

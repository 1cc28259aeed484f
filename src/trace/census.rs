//! What the tables hold, counted.

use crate::effects::{Effect, EffectSet};
use crate::geometry::Real;

use super::{MovingRow, SceneTables, ShapeColumns};

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
        let tables = [
            self.spheres.surfaces.effects.size(effect),
            self.cubes.surfaces.effects.size(effect),
            self.pyramids.surfaces.effects.size(effect),
            self.boards.surfaces.effects.size(effect),
            self.boards.shapes.size(effect),
            self.lights.effects.size(effect),
            self.air.size(effect),
            self.moving_size(effect),
        ];
        let (rows, bytes) = tables.into_iter().fold((0, 0), |sum, size| (sum.0 + size.0, sum.1 + size.1));
        EffectCount { effect, rows, bytes }
    }

    fn moving_size(&self, effect: Effect) -> (usize, usize) {
        match effect {
            Effect::MotionBlur => (self.moving.len(), self.moving.capacity() * size_of::<MovingRow<T>>()),
            _ => (0, 0),
        }
    }
}

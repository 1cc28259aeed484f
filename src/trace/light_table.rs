//! Lights.

use crate::effects::{Effect, EffectSet, RowOf, survey};
use crate::geometry::{Real, Vector};

use super::EffectColumn;
use super::effect_rows::{define_columns, define_rows};
use super::kernel::known;
use super::shape_columns::VectorColumns;

survey! {
    lights, define_rows
    /// The effects of a light; what would change nothing is not there.
    #[derive(Clone, Copy, Debug)]
    LightEffects
}

survey! {
    lights, define_columns
    /// The effects of lights.
    #[derive(Clone, Debug)]
    LightEffectColumns of LightEffects
}

/// Lights.
#[derive(Clone, Debug, Default)]
pub struct LightTable<T: Real> {
    position: VectorColumns<T>,
    /// For lights that have some.
    pub effects: LightEffectColumns<T>,
}

/// One light.
#[derive(Clone, Copy, Debug, Default)]
pub struct LightRow<T: Real> {
    /// Position.
    pub position: Vector<T>,
    /// Its effects.
    pub effects: LightEffects<T>,
}

impl<T: Real> LightTable<T> {
    /// Adds a row.
    pub fn push(&mut self, light: LightRow<T>) {
        self.position.push(light.position);
        self.effects.push(light.effects);
    }

    /// Number of lights.
    pub fn len(&self) -> usize {
        self.position.len()
    }

    /// Whether there is no light.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Where a light is.
    #[inline(always)]
    pub(super) fn position(&self, row: usize) -> Vector<T> {
        self.position.get(row)
    }

    /// A row as it was added.
    #[inline(always)]
    pub fn row(&self, row: usize) -> LightRow<T> {
        LightRow { position: self.position.get(row), effects: self.effects.row(row) }
    }
}

//! Lights.

use crate::effects::Cone;
use crate::geometry::{Real, Vector};

use super::EffectColumn;
use super::shape_columns::VectorColumns;

/// Lights.
#[derive(Clone, Debug, Default)]
pub struct LightTable<T> {
    position: VectorColumns<T>,
    /// Falloff, for lights that lose some.
    pub falloff: EffectColumn<T>,
    /// Cones, for spotlights.
    pub cone: EffectColumn<Cone<T>>,
}

/// One light.
#[derive(Clone, Copy, Debug)]
pub struct LightRow<T> {
    /// Position.
    pub position: Vector<T>,
    /// Falloff, unless it would take nothing away.
    pub falloff: Option<T>,
    /// Cone, unless it would take nothing away.
    pub cone: Option<Cone<T>>,
}

impl<T: Real> LightTable<T> {
    /// Adds a row.
    pub fn push(&mut self, light: LightRow<T>) {
        self.position.push(light.position);
        self.falloff.push(light.falloff);
        self.cone.push(light.cone);
    }

    /// Number of lights.
    pub fn len(&self) -> usize {
        self.position.len()
    }

    /// Whether there is no light.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// A row as it was added.
    #[inline(always)]
    pub fn row(&self, row: usize) -> LightRow<T> {
        LightRow {
            position: self.position.get(row),
            falloff: self.falloff.get(row).copied(),
            cone: self.cone.get(row).copied(),
        }
    }
}

//! Lights.

use crate::effects::{Ball, Cone, Effect, Rgb};
use crate::geometry::{Real, Vector};

use super::EffectColumn;
use super::kernel::known;
use super::shape_columns::VectorColumns;

/// Lights.
#[derive(Clone, Debug, Default)]
pub struct LightTable<T> {
    position: VectorColumns<T>,
    /// Falloff, for lights that lose some.
    pub falloff: EffectColumn<T>,
    /// Cones, for spotlights.
    pub cone: EffectColumn<Cone<T>>,
    /// Colours, for lights that are not white.
    pub color: EffectColumn<Rgb<T>>,
    /// Directions to lights that are infinitely far away, of length 1.
    pub toward: EffectColumn<Vector<T>>,
    /// Extents, for lights that are more than a point.
    pub ball: EffectColumn<Ball<T>>,
}

/// One light.
#[derive(Clone, Copy, Debug, Default)]
pub struct LightRow<T> {
    /// Position.
    pub position: Vector<T>,
    /// Falloff, unless it would take nothing away.
    pub falloff: Option<T>,
    /// Cone, unless it would take nothing away.
    pub cone: Option<Cone<T>>,
    /// Colour, unless it is white.
    pub color: Option<Rgb<T>>,
    /// Where it is seen from everywhere (unit), if it is infinitely far away.
    pub toward: Option<Vector<T>>,
    /// Extent, unless it is a point.
    pub ball: Option<Ball<T>>,
}

impl<T: Real> LightRow<T> {
    /// What code for these effects knows of it.
    #[inline(always)]
    pub(super) fn of_kernel<const EFFECTS: u32>(self) -> Self {
        Self {
            position: self.position,
            falloff: known::<EFFECTS, _>(Effect::Falloff, self.falloff),
            cone: known::<EFFECTS, _>(Effect::SpotCone, self.cone),
            color: known::<EFFECTS, _>(Effect::LightColor, self.color),
            toward: known::<EFFECTS, _>(Effect::Directional, self.toward),
            ball: known::<EFFECTS, _>(Effect::AreaLight, self.ball),
        }
    }
}

impl<T: Real> LightTable<T> {
    /// Adds a row.
    pub fn push(&mut self, light: LightRow<T>) {
        self.position.push(light.position);
        self.falloff.push(light.falloff);
        self.cone.push(light.cone);
        self.color.push(light.color);
        self.toward.push(light.toward);
        self.ball.push(light.ball);
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
            color: self.color.get(row).copied(),
            toward: self.toward.get(row).copied(),
            ball: self.ball.get(row).copied(),
        }
    }
}

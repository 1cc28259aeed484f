//! Surfaces.

use crate::effects::{Effect, EffectSet, Rgb, RowOf, survey};
use crate::geometry::Real;

use super::EffectColumn;
use super::effect_rows::{define_columns, define_rows};
use super::kernel::known;

survey! {
    surfaces, define_rows
    /// The effects of a surface; what would show nothing is not there.
    #[derive(Clone, Copy, Debug)]
    SurfaceEffects
}

survey! {
    surfaces, define_columns
    /// The effects of surfaces.
    #[derive(Clone, Debug)]
    SurfaceEffectColumns of SurfaceEffects
}

/// Surfaces of the objects of one kind.
#[derive(Clone, Debug, Default)]
pub struct SurfaceTable<T: Real> {
    color: Vec<Rgb<T>>,
    ambient: Vec<T>,
    diffuse: Vec<T>,
    /// For surfaces that have some.
    pub effects: SurfaceEffectColumns<T>,
}

/// One surface.
#[derive(Clone, Copy, Debug)]
pub struct SurfaceRow<T: Real> {
    /// Own colour.
    pub color: Rgb<T>,
    /// Ambient coefficient.
    pub ambient: T,
    /// Diffuse coefficient.
    pub diffuse: T,
    /// Its effects.
    pub effects: SurfaceEffects<T>,
}

impl<T: Real> SurfaceRow<T> {
    /// What code for these effects knows of it.
    #[inline(always)]
    pub(super) fn of_kernel<const EFFECTS: u32>(self) -> Self {
        Self { effects: self.effects.of_kernel::<EFFECTS>(), ..self }
    }
}

impl<T: Real> SurfaceTable<T> {
    /// Adds a row.
    pub fn push(&mut self, surface: SurfaceRow<T>) {
        self.color.push(surface.color);
        self.ambient.push(surface.ambient);
        self.diffuse.push(surface.diffuse);
        self.effects.push(surface.effects);
    }

    /// Writes over a row, if it has the same effects as before.
    pub fn replace(&mut self, row: usize, surface: SurfaceRow<T>) -> bool {
        self.color[row] = surface.color;
        self.ambient[row] = surface.ambient;
        self.diffuse[row] = surface.diffuse;
        self.effects.replace(row, surface.effects)
    }

    /// Gives back memory that no row takes.
    pub fn shrink_to_fit(&mut self) {
        self.color.shrink_to_fit();
        self.ambient.shrink_to_fit();
        self.diffuse.shrink_to_fit();
        self.effects.shrink_to_fit();
    }

    /// A row as it was added.
    #[inline(always)]
    pub fn row(&self, row: usize) -> SurfaceRow<T> {
        SurfaceRow {
            color: self.color[row],
            ambient: self.ambient[row],
            diffuse: self.diffuse[row],
            effects: self.effects.row(row),
        }
    }
}

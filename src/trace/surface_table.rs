//! Surfaces.

use crate::effects::{Effect, Rgb};
use crate::geometry::Real;

use super::EffectColumn;
use super::kernel::known;

/// Surfaces of the objects of one kind.
#[derive(Clone, Debug, Default)]
pub struct SurfaceTable<T> {
    color: Vec<Rgb<T>>,
    ambient: Vec<T>,
    diffuse: Vec<T>,
    /// Gloss, for surfaces that have some.
    pub gloss: EffectColumn<GlossRow<T>>,
    /// Reflectance, for surfaces that are mirrors.
    pub mirror: EffectColumn<T>,
    /// Glass, for surfaces that light passes.
    pub glass: EffectColumn<GlassRow<T>>,
    /// Absorption in 1/unit, for glass that takes light away.
    pub absorption: EffectColumn<Rgb<T>>,
}

/// One surface.
#[derive(Clone, Copy, Debug)]
pub struct SurfaceRow<T> {
    /// Own colour.
    pub color: Rgb<T>,
    /// Ambient coefficient.
    pub ambient: T,
    /// Diffuse coefficient.
    pub diffuse: T,
    /// Gloss, unless it would show nothing.
    pub gloss: Option<GlossRow<T>>,
    /// Reflectance, unless it would show nothing.
    pub mirror: Option<T>,
    /// Glass, unless it would show nothing.
    pub glass: Option<GlassRow<T>>,
    /// Absorption in 1/unit, unless it would take nothing away.
    pub absorption: Option<Rgb<T>>,
}

impl<T: Real> SurfaceRow<T> {
    /// What code for these effects knows of it.
    #[inline(always)]
    pub(super) fn of_kernel<const EFFECTS: u32>(self) -> Self {
        Self {
            gloss: known::<EFFECTS, _>(Effect::Gloss, self.gloss),
            mirror: known::<EFFECTS, _>(Effect::Mirror, self.mirror),
            glass: known::<EFFECTS, _>(Effect::Glass, self.glass),
            absorption: known::<EFFECTS, _>(Effect::Absorption, self.absorption),
            ..self
        }
    }
}

/// Glass of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GlassRow<T> {
    /// Index of refraction inside by that outside.
    pub index: T,
    /// Share of what glass shows.
    pub transmission: T,
}

/// Gloss of a surface.
#[derive(Clone, Copy, Debug)]
pub struct GlossRow<T> {
    /// Specular coefficient.
    pub specular: T,
    /// Phong exponent.
    pub shininess: T,
}

impl<T: Real> SurfaceTable<T> {
    /// Adds a row.
    pub fn push(&mut self, surface: SurfaceRow<T>) {
        self.color.push(surface.color);
        self.ambient.push(surface.ambient);
        self.diffuse.push(surface.diffuse);
        self.gloss.push(surface.gloss);
        self.mirror.push(surface.mirror);
        self.glass.push(surface.glass);
        self.absorption.push(surface.absorption);
    }

    /// Writes over a row, if it has the same effects as before.
    pub fn replace(&mut self, row: usize, surface: SurfaceRow<T>) -> bool {
        self.color[row] = surface.color;
        self.ambient[row] = surface.ambient;
        self.diffuse[row] = surface.diffuse;
        self.gloss.replace(row, surface.gloss)
            && self.mirror.replace(row, surface.mirror)
            && self.glass.replace(row, surface.glass)
            && self.absorption.replace(row, surface.absorption)
    }

    /// Gives back memory that no row takes.
    pub fn shrink_to_fit(&mut self) {
        self.color.shrink_to_fit();
        self.ambient.shrink_to_fit();
        self.diffuse.shrink_to_fit();
        self.gloss.shrink_to_fit();
        self.mirror.shrink_to_fit();
        self.glass.shrink_to_fit();
        self.absorption.shrink_to_fit();
    }

    /// A row as it was added.
    #[inline(always)]
    pub fn row(&self, row: usize) -> SurfaceRow<T> {
        SurfaceRow {
            color: self.color[row],
            ambient: self.ambient[row],
            diffuse: self.diffuse[row],
            gloss: self.gloss.get(row).copied(),
            mirror: self.mirror.get(row).copied(),
            glass: self.glass.get(row).copied(),
            absorption: self.absorption.get(row).copied(),
        }
    }
}

//! Objects that move while the shutter is open.

use std::borrow::Cow;

use crate::geometry::{Real, Vector};

use super::{Kind, ObjectId, SceneTables, refit_tree};

/// An object that moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MovingRow<T> {
    /// Which one.
    pub object: ObjectId,
    /// Its way in a second, in the unit of the tables.
    pub velocity: Vector<T>,
}

impl<T: Real> SceneTables<T> {
    /// The tables so many seconds later: moving objects have gone their way, and trees know it. The same tables where
    /// nothing moves.
    pub fn at(&self, seconds: T) -> Cow<'_, Self> {
        if self.moving.is_empty() {
            return Cow::Borrowed(self);
        }
        let mut later = self.clone();
        for moving in &self.moving {
            later.shift(moving.object, moving.velocity * seconds);
        }
        later.refit_moving();
        Cow::Owned(later)
    }

    fn shift(&mut self, object: ObjectId, way: Vector<T>) {
        let row = object.row as usize;
        match object.kind {
            Kind::Sphere => self.spheres.shapes.shift(row, way),
            Kind::Cube => self.cubes.shapes.shift(row, way),
            Kind::Pyramid => self.pyramids.shapes.shift(row, way),
            Kind::Board => self.boards.shapes.shift(row, way),
        }
    }

    fn refit_moving(&mut self) {
        let rows = |kind| -> Vec<u32> {
            let of_kind = self.moving.iter().filter(|moving| moving.object.kind == kind);
            of_kind.map(|moving| moving.object.row).collect()
        };
        let (spheres, cubes, pyramids) = (rows(Kind::Sphere), rows(Kind::Cube), rows(Kind::Pyramid));
        refit_tree(&mut self.trees.spheres, &self.spheres.shapes, &spheres);
        refit_tree(&mut self.trees.cubes, &self.cubes.shapes, &cubes);
        refit_tree(&mut self.trees.pyramids, &self.pyramids.shapes, &pyramids);
    }
}

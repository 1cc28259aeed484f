//! The scene as the trace reads it: one structure of arrays per kind of row.

use std::sync::Arc;

use crate::effects::EffectSet;
use crate::geometry::{CubeShape, PyramidShape, Real, SphereShape, Unit};

use super::tree::{Fork, SMALLEST_TREE, Tree};

use super::{
    Air, BoardColumns, CubeColumns, Kind, LightTable, MovingRow, ObjectId, PyramidColumns, ShapeColumns,
    SphereColumns, SurfaceTable,
};

/// All tables of one frame.
#[derive(Clone, Debug, Default)]
pub struct SceneTables<T: Real> {
    /// What all lengths of these tables, of their rays and of their hits are in.
    pub unit: Unit,
    /// Spheres.
    pub spheres: ShapeTable<T, SphereColumns<T>>,
    /// Cubes.
    pub cubes: ShapeTable<T, CubeColumns<T>>,
    /// Pyramids.
    pub pyramids: ShapeTable<T, PyramidColumns<T>>,
    /// Checkerboards.
    pub boards: ShapeTable<T, BoardColumns<T>>,
    /// What makes large tables fast to search; must be dropped or built again when a table changes.
    pub trees: Trees<T>,
    /// Lights, in the order in which they are summed.
    pub lights: LightTable<T>,
    /// What surrounds the objects.
    pub air: Air<T>,
    /// Objects that move while the camera looks.
    pub moving: Vec<MovingRow<T>>,
}

/// The trees of the tables that have one. No picture depends on them, only its time.
#[derive(Clone, Debug, Default)]
pub struct Trees<T: Real> {
    /// Of the spheres.
    pub spheres: Option<Arc<Tree<T, SphereShape<T>>>>,
    /// Of the cubes.
    pub cubes: Option<Arc<Tree<T, CubeShape<T>>>>,
    /// Of the pyramids.
    pub pyramids: Option<Arc<Tree<T, PyramidShape<T>>>>,
}

impl<T: Real> Trees<T> {
    /// Whether there is none.
    #[inline(always)]
    pub fn is_empty(&self) -> bool {
        self.spheres.is_none() && self.cubes.is_none() && self.pyramids.is_none()
    }
}

impl<T: Real> SceneTables<T> {
    /// Whether a table is large enough for a tree and has none.
    pub fn lacks_trees(&self) -> bool {
        let lacks = |rows: usize, has_tree: bool| rows >= SMALLEST_TREE && !has_tree;
        lacks(self.spheres.order.len(), self.trees.spheres.is_some())
            || lacks(self.cubes.order.len(), self.trees.cubes.is_some())
            || lacks(self.pyramids.order.len(), self.trees.pyramids.is_some())
    }

    /// Builds the trees that are lacking.
    pub fn build_trees(&mut self, fork: &impl Fork) {
        let trees = &mut self.trees;
        let (spheres, cubes, pyramids) = (&self.spheres.shapes, &self.cubes.shapes, &self.pyramids.shapes);
        trees.spheres = trees.spheres.take().or_else(|| Tree::build(spheres, fork).map(Arc::new));
        trees.cubes = trees.cubes.take().or_else(|| Tree::build(cubes, fork).map(Arc::new));
        trees.pyramids = trees.pyramids.take().or_else(|| Tree::build(pyramids, fork).map(Arc::new));
    }

    /// The surface of an object.
    #[inline(always)]
    pub(super) fn surface(&self, object: ObjectId) -> (&SurfaceTable<T>, usize) {
        let surfaces = match object.kind {
            Kind::Sphere => &self.spheres.surfaces,
            Kind::Cube => &self.cubes.surfaces,
            Kind::Pyramid => &self.pyramids.surfaces,
            Kind::Board => &self.boards.surfaces,
        };
        (surfaces, object.row as usize)
    }
}

/// Objects of one kind: shapes, their place in the scene's order, and their surfaces, row by row.
#[derive(Clone, Debug, Default)]
pub struct ShapeTable<T: Real, C> {
    /// Shapes.
    pub shapes: C,
    /// Scene order, ascending: of two surfaces at the same distance the lower one shows.
    pub order: Vec<u32>,
    /// Surfaces.
    pub surfaces: SurfaceTable<T>,
}

impl<T: Real, C: ShapeColumns<T>> ShapeTable<T, C> {
    /// The effects that some object has.
    pub fn effects(&self) -> EffectSet {
        self.shapes.effects().union(self.surfaces.effects.set())
    }

    /// Gives back memory that no row takes.
    pub fn shrink_to_fit(&mut self) {
        self.shapes.shrink_to_fit();
        self.order.shrink_to_fit();
        self.surfaces.shrink_to_fit();
    }
}

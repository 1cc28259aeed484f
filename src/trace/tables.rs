//! The scene as the trace reads it: one structure of arrays per kind of row.

use crate::geometry::Real;

use super::{
    BoardColumns, CubeColumns, Kind, LightTable, ObjectId, PyramidColumns, SphereColumns, SurfaceTable,
};

/// All tables of one frame.
#[derive(Clone, Debug, Default)]
pub struct SceneTables<T: Real> {
    /// Spheres.
    pub spheres: ShapeTable<T, SphereColumns<T>>,
    /// Cubes.
    pub cubes: ShapeTable<T, CubeColumns<T>>,
    /// Pyramids.
    pub pyramids: ShapeTable<T, PyramidColumns<T>>,
    /// Checkerboards.
    pub boards: ShapeTable<T, BoardColumns<T>>,
    /// Lights, in the order in which they are summed.
    pub lights: LightTable<T>,
}

impl<T: Real> SceneTables<T> {
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

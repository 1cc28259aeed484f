//! Which shape goes to which table.

use bevy_ecs::prelude::*;
use glam::DVec3;

use crate::components::{Checkerboard, Cube, Pyramid, Sphere};
use crate::geometry::{CubeShape, PyramidShape, Real, SphereShape, Unit, Vector};
use crate::trace::{
    BoardColumns, BoardEffects, CubeColumns, PyramidColumns, SceneTables, ShapeColumns, ShapeTable,
    SphereColumns, Trees, refit_tree,
};

/// A shape component.
pub(super) trait Shape: Component + Copy {
    /// Name for messages.
    const NAME: &'static str;

    /// Its one or two lengths, with names for messages.
    fn lengths(&self) -> [Option<(&'static str, f64)>; 2];
    /// The same shape, its lengths in another unit.
    fn in_unit(self, unit: Unit) -> Self;
}

/// A shape component and the table that its entities go to, in one precision.
pub(super) trait ExtractShape<T: Real>: Shape {
    /// Columns of its table.
    type Columns: ShapeColumns<T>;

    /// Its table among all.
    fn table(scene: &mut SceneTables<T>) -> &mut ShapeTable<T, Self::Columns>;
    /// Drops the tree of its table, which is about to change.
    fn forget_tree(trees: &mut Trees<T>);
    /// Brings the tree of its table up to date with some rows that changed.
    fn refit(scene: &mut SceneTables<T>, rows: &[u32]);
    /// Writes this shape over a row, if that can be done.
    fn replace(&self, columns: &mut Self::Columns, row: usize, position: DVec3) -> bool;
    /// Adds a row for this shape. What is on its cells is asked of those that have some.
    fn push(&self, columns: &mut Self::Columns, position: DVec3, on_cells: impl FnOnce() -> BoardEffects<T>);
}

impl Shape for Sphere {
    const NAME: &'static str = "Sphere";

    fn lengths(&self) -> [Option<(&'static str, f64)>; 2] {
        [Some(("Sphere.radius", self.radius)), None]
    }

    fn in_unit(self, unit: Unit) -> Self {
        Self { radius: unit.length(self.radius) }
    }
}

impl<T: Real> ExtractShape<T> for Sphere {
    type Columns = SphereColumns<T>;

    fn table(scene: &mut SceneTables<T>) -> &mut ShapeTable<T, Self::Columns> {
        &mut scene.spheres
    }

    fn forget_tree(trees: &mut Trees<T>) {
        trees.spheres = None;
    }

    fn refit(scene: &mut SceneTables<T>, rows: &[u32]) {
        refit_tree(&mut scene.trees.spheres, &scene.spheres.shapes, rows);
    }

    fn replace(&self, columns: &mut Self::Columns, row: usize, position: DVec3) -> bool {
        columns.replace(
            row,
            SphereShape { center: Vector::from_dvec3(position), radius: T::from_f64(self.radius) },
        );
        true
    }

    fn push(
        &self,
        columns: &mut Self::Columns,
        position: DVec3,
        _on_cells: impl FnOnce() -> BoardEffects<T>,
    ) {
        let center = Vector::from_dvec3(position);
        columns.push(SphereShape { center, radius: T::from_f64(self.radius) });
    }
}

impl Shape for Cube {
    const NAME: &'static str = "Cube";

    fn lengths(&self) -> [Option<(&'static str, f64)>; 2] {
        [Some(("Cube.side", self.side)), None]
    }

    fn in_unit(self, unit: Unit) -> Self {
        Self { side: unit.length(self.side) }
    }
}

impl<T: Real> ExtractShape<T> for Cube {
    type Columns = CubeColumns<T>;

    fn table(scene: &mut SceneTables<T>) -> &mut ShapeTable<T, Self::Columns> {
        &mut scene.cubes
    }

    fn forget_tree(trees: &mut Trees<T>) {
        trees.cubes = None;
    }

    fn refit(scene: &mut SceneTables<T>, rows: &[u32]) {
        refit_tree(&mut scene.trees.cubes, &scene.cubes.shapes, rows);
    }

    fn replace(&self, columns: &mut Self::Columns, row: usize, position: DVec3) -> bool {
        columns.replace(row, CubeShape::new(position, self.side));
        true
    }

    fn push(
        &self,
        columns: &mut Self::Columns,
        position: DVec3,
        _on_cells: impl FnOnce() -> BoardEffects<T>,
    ) {
        columns.push(CubeShape::new(position, self.side));
    }
}

impl Shape for Pyramid {
    const NAME: &'static str = "Pyramid";

    fn lengths(&self) -> [Option<(&'static str, f64)>; 2] {
        [Some(("Pyramid.width", self.width)), Some(("Pyramid.height", self.height))]
    }

    fn in_unit(self, unit: Unit) -> Self {
        Self { width: unit.length(self.width), height: unit.length(self.height) }
    }
}

impl<T: Real> ExtractShape<T> for Pyramid {
    type Columns = PyramidColumns<T>;

    fn table(scene: &mut SceneTables<T>) -> &mut ShapeTable<T, Self::Columns> {
        &mut scene.pyramids
    }

    fn forget_tree(trees: &mut Trees<T>) {
        trees.pyramids = None;
    }

    fn refit(scene: &mut SceneTables<T>, rows: &[u32]) {
        refit_tree(&mut scene.trees.pyramids, &scene.pyramids.shapes, rows);
    }

    fn replace(&self, columns: &mut Self::Columns, row: usize, position: DVec3) -> bool {
        columns.replace(row, PyramidShape::new(position, self.width, self.height));
        true
    }

    fn push(
        &self,
        columns: &mut Self::Columns,
        position: DVec3,
        _on_cells: impl FnOnce() -> BoardEffects<T>,
    ) {
        columns.push(PyramidShape::new(position, self.width, self.height));
    }
}

impl Shape for Checkerboard {
    const NAME: &'static str = "Checkerboard";

    fn lengths(&self) -> [Option<(&'static str, f64)>; 2] {
        [Some(("Checkerboard.cell", self.cell)), None]
    }

    fn in_unit(self, unit: Unit) -> Self {
        Self { cell: unit.length(self.cell) }
    }
}

impl<T: Real> ExtractShape<T> for Checkerboard {
    type Columns = BoardColumns<T>;

    fn table(scene: &mut SceneTables<T>) -> &mut ShapeTable<T, Self::Columns> {
        &mut scene.boards
    }

    fn forget_tree(_trees: &mut Trees<T>) {}

    fn refit(_scene: &mut SceneTables<T>, _rows: &[u32]) {}

    /// There are few boards.
    fn replace(&self, _columns: &mut Self::Columns, _row: usize, _position: DVec3) -> bool {
        false
    }

    fn push(&self, columns: &mut Self::Columns, position: DVec3, on_cells: impl FnOnce() -> BoardEffects<T>) {
        columns.push(Vector::from_dvec3(position), T::from_f64(self.cell), on_cells());
    }
}

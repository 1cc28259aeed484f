//! Shapes, as columns of numbers.

use crate::effects::{Effect, EffectSet, ImageFilter, RowOf, survey};
use crate::geometry::{Convex, CubeShape, PlaneShape, PyramidShape, Real, SphereShape, Vector};

use super::effect_rows::{define_columns, define_rows};
use super::kernel::known;
use super::{EffectColumn, Kind};

/// Columns that describe the shapes of one kind.
pub trait ShapeColumns<T: Real>: Default {
    /// What one row describes.
    type Shape: Convex<T>;
    /// How hits on these rows are named.
    const KIND: Kind;

    /// Number of rows.
    fn len(&self) -> usize;
    /// Whether there is no row.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }
    /// The shape of a row below [`len`](Self::len).
    fn shape(&self, row: usize) -> Self::Shape;
    /// The effects that some row has, other than of its surface.
    fn effects(&self) -> EffectSet {
        EffectSet::NONE
    }
    /// Gives back memory that no row takes.
    fn shrink_to_fit(&mut self);
}

/// A column of vectors.
#[derive(Clone, Debug, Default)]
pub(super) struct VectorColumns<T> {
    x: Vec<T>,
    y: Vec<T>,
    z: Vec<T>,
}

impl<T: Real> VectorColumns<T> {
    pub(super) fn push(&mut self, v: Vector<T>) {
        self.x.push(v.x);
        self.y.push(v.y);
        self.z.push(v.z);
    }

    pub(super) fn replace(&mut self, row: usize, v: Vector<T>) {
        self.x[row] = v.x;
        self.y[row] = v.y;
        self.z[row] = v.z;
    }

    pub(super) fn len(&self) -> usize {
        self.x.len()
    }

    fn shrink_to_fit(&mut self) {
        self.x.shrink_to_fit();
        self.y.shrink_to_fit();
        self.z.shrink_to_fit();
    }

    #[inline(always)]
    pub(super) fn get(&self, row: usize) -> Vector<T> {
        Vector::new(self.x[row], self.y[row], self.z[row])
    }
}

/// Centre and radius of spheres.
#[derive(Clone, Debug, Default)]
pub struct SphereColumns<T> {
    center: VectorColumns<T>,
    radius: Vec<T>,
}

impl<T: Real> SphereColumns<T> {
    /// Adds a row.
    pub fn push(&mut self, sphere: SphereShape<T>) {
        self.center.push(sphere.center);
        self.radius.push(sphere.radius);
    }

    /// Writes over a row.
    pub fn replace(&mut self, row: usize, sphere: SphereShape<T>) {
        self.center.replace(row, sphere.center);
        self.radius[row] = sphere.radius;
    }

    /// Moves a row.
    pub(super) fn shift(&mut self, row: usize, way: Vector<T>) {
        self.center.replace(row, self.center.get(row) + way);
    }
}

impl<T: Real> ShapeColumns<T> for SphereColumns<T> {
    type Shape = SphereShape<T>;
    const KIND: Kind = Kind::Sphere;

    fn len(&self) -> usize {
        self.radius.len()
    }

    #[inline(always)]
    fn shape(&self, row: usize) -> SphereShape<T> {
        SphereShape { center: self.center.get(row), radius: self.radius[row] }
    }

    fn shrink_to_fit(&mut self) {
        self.center.shrink_to_fit();
        self.radius.shrink_to_fit();
    }
}

/// Opposite corners of cubes.
#[derive(Clone, Debug, Default)]
pub struct CubeColumns<T> {
    min: VectorColumns<T>,
    max: VectorColumns<T>,
}

impl<T: Real> CubeColumns<T> {
    /// Adds a row.
    pub fn push(&mut self, cube: CubeShape<T>) {
        self.min.push(cube.min);
        self.max.push(cube.max);
    }

    /// Writes over a row.
    pub fn replace(&mut self, row: usize, cube: CubeShape<T>) {
        self.min.replace(row, cube.min);
        self.max.replace(row, cube.max);
    }

    /// Moves a row.
    pub(super) fn shift(&mut self, row: usize, way: Vector<T>) {
        self.min.replace(row, self.min.get(row) + way);
        self.max.replace(row, self.max.get(row) + way);
    }
}

impl<T: Real> ShapeColumns<T> for CubeColumns<T> {
    type Shape = CubeShape<T>;
    const KIND: Kind = Kind::Cube;

    fn len(&self) -> usize {
        self.min.len()
    }

    #[inline(always)]
    fn shape(&self, row: usize) -> CubeShape<T> {
        CubeShape { min: self.min.get(row), max: self.max.get(row) }
    }

    fn shrink_to_fit(&mut self) {
        self.min.shrink_to_fit();
        self.max.shrink_to_fit();
    }
}

/// Apex and measures of pyramids.
#[derive(Clone, Debug, Default)]
pub struct PyramidColumns<T> {
    apex: VectorColumns<T>,
    base: Vec<T>,
    half_width: Vec<T>,
    height: Vec<T>,
}

impl<T: Real> PyramidColumns<T> {
    /// Adds a row.
    pub fn push(&mut self, pyramid: PyramidShape<T>) {
        self.apex.push(pyramid.apex);
        self.base.push(pyramid.base);
        self.half_width.push(pyramid.half_width);
        self.height.push(pyramid.height);
    }

    /// Writes over a row.
    pub fn replace(&mut self, row: usize, pyramid: PyramidShape<T>) {
        self.apex.replace(row, pyramid.apex);
        self.base[row] = pyramid.base;
        self.half_width[row] = pyramid.half_width;
        self.height[row] = pyramid.height;
    }

    /// Moves a row.
    pub(super) fn shift(&mut self, row: usize, way: Vector<T>) {
        self.apex.replace(row, self.apex.get(row) + way);
        self.base[row] += way.z;
    }
}

impl<T: Real> ShapeColumns<T> for PyramidColumns<T> {
    type Shape = PyramidShape<T>;
    const KIND: Kind = Kind::Pyramid;

    fn len(&self) -> usize {
        self.base.len()
    }

    #[inline(always)]
    fn shape(&self, row: usize) -> PyramidShape<T> {
        PyramidShape {
            apex: self.apex.get(row),
            base: self.base[row],
            half_width: self.half_width[row],
            height: self.height[row],
        }
    }

    fn shrink_to_fit(&mut self) {
        self.apex.shrink_to_fit();
        self.base.shrink_to_fit();
        self.half_width.shrink_to_fit();
        self.height.shrink_to_fit();
    }
}

survey! {
    boards, define_rows
    /// The effects of a checkerboard's cells; what would show nothing is not there.
    #[derive(Clone, Debug)]
    BoardEffects
}

survey! {
    boards, define_columns
    /// The effects of checkerboards' cells.
    #[derive(Clone, Debug)]
    BoardEffectColumns of BoardEffects
}

/// Origin, cell width and effects of checkerboards.
#[derive(Clone, Debug, Default)]
pub struct BoardColumns<T: Real> {
    origin: VectorColumns<T>,
    cell: Vec<T>,
    /// For boards that have some.
    pub effects: BoardEffectColumns<T>,
}

impl<T: Real> BoardColumns<T> {
    /// Adds a row: the corner of a white cell with the least coordinates, the width of the cells, and what is on them.
    pub fn push(&mut self, origin: Vector<T>, cell: T, effects: BoardEffects<T>) {
        self.origin.push(origin);
        self.cell.push(cell);
        self.effects.push(effects);
    }

    /// Moves a row.
    pub(super) fn shift(&mut self, row: usize, way: Vector<T>) {
        self.origin.replace(row, self.origin.get(row) + way);
    }

    /// Whether any row has a filter.
    #[inline(always)]
    pub(super) fn has_filters(&self) -> bool {
        !(self.effects.texture_filter.is_empty() && self.effects.checker_filter.is_empty())
    }

    /// Rows that have an effect, and the memory that it takes, copies of images included.
    pub(super) fn size(&self, effect: Effect) -> (usize, usize) {
        let (rows, bytes) = self.effects.size(effect);
        let copies = match effect {
            Effect::TextureFilter => self.copied_bytes(),
            _ => 0,
        };
        (rows, bytes + copies)
    }

    fn copied_bytes(&self) -> usize {
        let filters = (0..self.cell.len()).filter_map(|row| self.effects.texture_filter.get(row));
        filters.map(ImageFilter::bytes).sum()
    }

    /// Origin and cell width of a row.
    #[inline(always)]
    pub(super) fn pattern(&self, row: usize) -> (Vector<T>, T) {
        (self.origin.get(row), self.cell[row])
    }
}

impl<T: Real> ShapeColumns<T> for BoardColumns<T> {
    type Shape = PlaneShape<T>;
    const KIND: Kind = Kind::Board;

    fn len(&self) -> usize {
        self.cell.len()
    }

    #[inline(always)]
    fn shape(&self, row: usize) -> PlaneShape<T> {
        PlaneShape { height: self.origin.get(row).z }
    }

    fn effects(&self) -> EffectSet {
        self.effects.set()
    }

    fn shrink_to_fit(&mut self) {
        self.origin.shrink_to_fit();
        self.cell.shrink_to_fit();
        self.effects.shrink_to_fit();
    }
}

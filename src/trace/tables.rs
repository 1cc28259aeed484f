//! The scene as the trace reads it: one structure of arrays per kind of row.

use std::sync::Arc;

use crate::components::Texture;
use crate::effects::{Cone, Rgb};
use crate::geometry::{Convex, CubeShape, PlaneShape, PyramidShape, Real, SphereShape, Vector};

use super::{Kind, ObjectId};

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

/// Centre and radius of spheres.
#[derive(Clone, Debug, Default)]
pub struct SphereColumns<T> {
    x: Vec<T>,
    y: Vec<T>,
    z: Vec<T>,
    radius: Vec<T>,
}

impl<T: Real> SphereColumns<T> {
    /// Adds a row.
    pub fn push(&mut self, sphere: SphereShape<T>) {
        self.x.push(sphere.center.x);
        self.y.push(sphere.center.y);
        self.z.push(sphere.center.z);
        self.radius.push(sphere.radius);
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
        let center = Vector::new(self.x[row], self.y[row], self.z[row]);
        SphereShape { center, radius: self.radius[row] }
    }
}

/// Opposite corners of cubes.
#[derive(Clone, Debug, Default)]
pub struct CubeColumns<T> {
    min: [Vec<T>; 3],
    max: [Vec<T>; 3],
}

impl<T: Real> CubeColumns<T> {
    /// Adds a row.
    pub fn push(&mut self, cube: CubeShape<T>) {
        for axis in 0..3 {
            self.min[axis].push(cube.min[axis]);
            self.max[axis].push(cube.max[axis]);
        }
    }
}

impl<T: Real> ShapeColumns<T> for CubeColumns<T> {
    type Shape = CubeShape<T>;
    const KIND: Kind = Kind::Cube;

    fn len(&self) -> usize {
        self.min[0].len()
    }

    #[inline(always)]
    fn shape(&self, row: usize) -> CubeShape<T> {
        let corner = |columns: &[Vec<T>; 3]| Vector::new(columns[0][row], columns[1][row], columns[2][row]);
        CubeShape { min: corner(&self.min), max: corner(&self.max) }
    }
}

/// Pyramids. A row is kept whole: its kernel reads every number of it for every ray.
#[derive(Clone, Debug, Default)]
pub struct PyramidColumns<T> {
    rows: Vec<PyramidShape<T>>,
}

impl<T: Real> PyramidColumns<T> {
    /// Adds a row.
    pub fn push(&mut self, pyramid: PyramidShape<T>) {
        self.rows.push(pyramid);
    }
}

impl<T: Real> ShapeColumns<T> for PyramidColumns<T> {
    type Shape = PyramidShape<T>;
    const KIND: Kind = Kind::Pyramid;

    fn len(&self) -> usize {
        self.rows.len()
    }

    #[inline(always)]
    fn shape(&self, row: usize) -> PyramidShape<T> {
        self.rows[row]
    }
}

/// Origin, cell width and images of checkerboards.
#[derive(Clone, Debug, Default)]
pub struct BoardColumns<T> {
    origin: Vec<Vector<T>>,
    cell: Vec<T>,
    /// Images on the cells, for boards that carry some.
    pub textures: EffectColumn<BoardTexture>,
}

impl<T: Real> BoardColumns<T> {
    /// Adds a row.
    pub fn push(&mut self, origin: Vector<T>, cell: T, texture: Option<BoardTexture>) {
        self.origin.push(origin);
        self.cell.push(cell);
        self.textures.push(texture);
    }

    /// The corner of a row's first white cell, and the width of its cells.
    #[inline(always)]
    pub(super) fn pattern(&self, row: usize) -> (Vector<T>, T) {
        (self.origin[row], self.cell[row])
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
        PlaneShape { height: self.origin[row].z }
    }
}

/// The images of a textured checkerboard.
#[derive(Clone, Debug)]
pub struct BoardTexture {
    /// On white cells.
    pub white: Arc<Texture>,
    /// On black cells.
    pub black: Arc<Texture>,
}

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
        }
    }
}

/// Rows of an effect, for those rows of another table that have it. It holds nothing at all while none does.
#[derive(Clone, Debug)]
pub struct EffectColumn<R> {
    /// For each row of the other table, 1 + the index in `rows`, or 0; empty while `rows` is. May be shorter than
    /// the other table: what lies beyond has no row.
    slots: Vec<u32>,
    rows: Vec<R>,
    /// Rows of the other table so far.
    pushed: usize,
}

impl<R> Default for EffectColumn<R> {
    fn default() -> Self {
        Self { slots: Vec::new(), rows: Vec::new(), pushed: 0 }
    }
}

impl<R> EffectColumn<R> {
    /// Adds the next row of the other table, with or without the effect.
    pub fn push(&mut self, row: Option<R>) {
        if let Some(row) = row {
            self.slots.resize(self.pushed, 0);
            self.rows.push(row);
            // At most one row an entity, and entities are counted in 32 bits.
            self.slots.push(u32::try_from(self.rows.len()).unwrap_or(0));
        }
        self.pushed += 1;
    }

    /// The effect of a row of the other table.
    #[inline(always)]
    pub fn get(&self, row: usize) -> Option<&R> {
        let slot = *self.slots.get(row)?;
        self.rows.get((slot as usize).wrapping_sub(1))
    }

    /// Number of rows that have the effect.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Whether no row has the effect.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }
}

/// Lights.
#[derive(Clone, Debug, Default)]
pub struct LightTable<T> {
    position: Vec<Vector<T>>,
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
        self.position.is_empty()
    }

    /// A row as it was added.
    #[inline(always)]
    pub fn row(&self, row: usize) -> LightRow<T> {
        LightRow {
            position: self.position[row],
            falloff: self.falloff.get(row).copied(),
            cone: self.cone.get(row).copied(),
        }
    }
}

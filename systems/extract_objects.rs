//! Objects of one shape kind to their table.

use core::cmp::Ordering;

use bevy_ecs::prelude::*;
use glam::DVec3;

use crate::components::range::{COEFFICIENT, COLOR, SHININESS};
use crate::components::{
    Ambient, Checkerboard, Color, Cube, Diffuse, Gloss, Mirror, Order, Position, Pyramid, Sphere, Textured,
};
use crate::effects::Rgb;
use crate::geometry::{CubeShape, PyramidShape, Real, SphereShape, Vector};
use crate::trace::{
    BoardColumns, BoardTexture, CubeColumns, GlossRow, PyramidColumns, SceneTables, ShapeTable,
    SphereColumns, SurfaceRow,
};

use super::Tables;
use super::problem::{Checks, WorldProblem};

/// A shape component and the table that its entities go to.
pub(super) trait ExtractShape<T: Real>: Component + Copy {
    /// Columns of its table.
    type Columns: Default;
    /// Name for messages.
    const NAME: &'static str;

    /// Its table among all.
    fn table(scene: &mut SceneTables<T>) -> &mut ShapeTable<T, Self::Columns>;
    /// Its one or two lengths, with names for messages.
    fn lengths(&self) -> [Option<(&'static str, f64)>; 2];
    /// Adds a row for this shape.
    fn push(&self, columns: &mut Self::Columns, position: DVec3, textured: Option<&Textured>);
}

type Objects<'w, 's, S> = Query<
    'w,
    's,
    (
        Entity,
        &'static S,
        &'static Position,
        (&'static Color, &'static Ambient, &'static Diffuse),
        Option<&'static Order>,
        (Option<&'static Gloss>, Option<&'static Mirror>, Option<&'static Textured>),
    ),
>;

type Lacking = Or<(Without<Position>, Without<Color>, Without<Ambient>, Without<Diffuse>)>;

/// Rebuilds the table of objects with shape `S`, rows sorted by scene order and then by value.
pub(super) fn extract_objects<T: Real, S: ExtractShape<T>>(
    objects: Objects<S>,
    incomplete: Query<Entity, (With<S>, Lacking)>,
    mut tables: ResMut<Tables<T>>,
) {
    let mut rows = gather(&objects);
    rows.sort_by(ObjectRow::compare::<T>);

    let mut checks = Checks::default();
    let needs = "Position, Color, Ambient and Diffuse";
    let missing = incomplete.iter().map(|entity| WorldProblem::Incomplete { entity, kind: S::NAME, needs });
    checks.problems.extend(missing);
    let table = S::table(&mut tables.scene);
    *table = ShapeTable::default();
    for row in &rows {
        row.check::<T>(&mut checks);
        row.shape.push(&mut table.shapes, row.position, row.textured.as_ref());
        table.order.push(row.order);
        table.surfaces.push(row.surface());
    }
    tables.problems.insert(S::NAME, checks.problems);
}

/// One object as the World has it.
struct ObjectRow<S> {
    entity: Entity,
    shape: S,
    position: DVec3,
    order: u32,
    color: DVec3,
    ambient: f64,
    diffuse: f64,
    gloss: Option<Gloss>,
    mirror: Option<Mirror>,
    textured: Option<Textured>,
}

/// Walks the component tables slice by slice.
fn gather<S: Component + Copy>(objects: &Objects<S>) -> Vec<ObjectRow<S>> {
    let mut rows = Vec::with_capacity(objects.iter().len());
    // All components here live in tables, so the walk cannot fail; a sparse one would show as an empty scene.
    for slices in objects.contiguous_iter().into_iter().flatten() {
        let (entities, shapes, positions, (colors, ambients, diffuses), orders, effects) = slices;
        let (gloss, mirrors, textures) = effects;
        rows.extend((0..entities.len()).map(|i| ObjectRow {
            entity: entities[i],
            shape: shapes[i],
            position: positions[i].0,
            order: orders.map_or(u32::MAX, |orders| orders[i].0),
            color: colors[i].0,
            ambient: ambients[i].0,
            diffuse: diffuses[i].0,
            gloss: gloss.map(|gloss| gloss[i]),
            mirror: mirrors.map(|mirrors| mirrors[i]),
            textured: textures.map(|textures| textures[i].clone()),
        }));
    }
    rows
}

impl<S> ObjectRow<S> {
    /// Scene order first. Rows without one are sorted by value, never by how the World happens to store them:
    /// bevy reorders its tables on despawn and insert, and the picture must not change when it does.
    fn compare<T: Real>(&self, other: &Self) -> Ordering
    where
        S: ExtractShape<T>,
    {
        let by_value = || {
            let pairs = self.values::<T>().into_iter().zip(other.values::<T>());
            pairs.map(|(a, b)| a.total_cmp(&b)).find(|order| order.is_ne()).unwrap_or(Ordering::Equal)
        };
        self.order.cmp(&other.order).then_with(by_value)
    }

    /// Every number of the row.
    fn values<T: Real>(&self) -> [f64; 13]
    where
        S: ExtractShape<T>,
    {
        let [size, second_size] = self.shape.lengths().map(|length| length.map_or(0.0, |(_, length)| length));
        let gloss = self.gloss.unwrap_or(Gloss { specular: 0.0, shininess: 0.0 });
        let mirror = self.mirror.map_or(0.0, |mirror| mirror.0);
        let (p, c) = (self.position, self.color);
        let surface = [self.ambient, self.diffuse, gloss.specular, gloss.shininess, mirror];
        let [ambient, diffuse, specular, shininess, mirror] = surface;
        [p.x, p.y, p.z, size, second_size, c.x, c.y, c.z, ambient, diffuse, specular, shininess, mirror]
    }

    fn check<T: Real>(&self, checks: &mut Checks)
    where
        S: ExtractShape<T>,
    {
        let entity = self.entity;
        checks.point::<T>(entity, "Position", self.position);
        for (name, length) in self.shape.lengths().into_iter().flatten() {
            checks.length::<T>(entity, name, length);
        }
        for component in self.color.to_array() {
            checks.value(entity, "Color", component, &COLOR);
        }
        checks.value(entity, "Ambient", self.ambient, &COEFFICIENT);
        checks.value(entity, "Diffuse", self.diffuse, &COEFFICIENT);
        if let Some(gloss) = self.gloss {
            checks.value(entity, "Gloss.specular", gloss.specular, &COEFFICIENT);
            checks.value(entity, "Gloss.shininess", gloss.shininess, &SHININESS);
        }
        if let Some(mirror) = self.mirror {
            checks.value(entity, "Mirror", mirror.0, &COEFFICIENT);
        }
    }

    /// The surface, without effects that would show nothing.
    fn surface<T: Real>(&self) -> SurfaceRow<T> {
        let visible_gloss = self.gloss.filter(|gloss| gloss.specular != 0.0);
        let visible_mirror = self.mirror.filter(|mirror| mirror.0 != 0.0);
        SurfaceRow {
            color: Rgb::from_dvec3(self.color),
            ambient: T::from_f64(self.ambient),
            diffuse: T::from_f64(self.diffuse),
            gloss: visible_gloss.map(|gloss| GlossRow {
                specular: T::from_f64(gloss.specular),
                shininess: T::from_f64(gloss.shininess),
            }),
            mirror: visible_mirror.map(|mirror| T::from_f64(mirror.0)),
        }
    }
}

impl<T: Real> ExtractShape<T> for Sphere {
    type Columns = SphereColumns<T>;
    const NAME: &'static str = "Sphere";

    fn table(scene: &mut SceneTables<T>) -> &mut ShapeTable<T, Self::Columns> {
        &mut scene.spheres
    }

    fn lengths(&self) -> [Option<(&'static str, f64)>; 2] {
        [Some(("Sphere.radius", self.radius)), None]
    }

    fn push(&self, columns: &mut Self::Columns, position: DVec3, _textured: Option<&Textured>) {
        let center = Vector::from_dvec3(position);
        columns.push(SphereShape { center, radius: T::from_f64(self.radius) });
    }
}

impl<T: Real> ExtractShape<T> for Cube {
    type Columns = CubeColumns<T>;
    const NAME: &'static str = "Cube";

    fn table(scene: &mut SceneTables<T>) -> &mut ShapeTable<T, Self::Columns> {
        &mut scene.cubes
    }

    fn lengths(&self) -> [Option<(&'static str, f64)>; 2] {
        [Some(("Cube.side", self.side)), None]
    }

    fn push(&self, columns: &mut Self::Columns, position: DVec3, _textured: Option<&Textured>) {
        columns.push(CubeShape::new(position, self.side));
    }
}

impl<T: Real> ExtractShape<T> for Pyramid {
    type Columns = PyramidColumns<T>;
    const NAME: &'static str = "Pyramid";

    fn table(scene: &mut SceneTables<T>) -> &mut ShapeTable<T, Self::Columns> {
        &mut scene.pyramids
    }

    fn lengths(&self) -> [Option<(&'static str, f64)>; 2] {
        [Some(("Pyramid.width", self.width)), Some(("Pyramid.height", self.height))]
    }

    fn push(&self, columns: &mut Self::Columns, position: DVec3, _textured: Option<&Textured>) {
        columns.push(PyramidShape::new(position, self.width, self.height));
    }
}

impl<T: Real> ExtractShape<T> for Checkerboard {
    type Columns = BoardColumns<T>;
    const NAME: &'static str = "Checkerboard";

    fn table(scene: &mut SceneTables<T>) -> &mut ShapeTable<T, Self::Columns> {
        &mut scene.boards
    }

    fn lengths(&self) -> [Option<(&'static str, f64)>; 2] {
        [Some(("Checkerboard.cell", self.cell)), None]
    }

    fn push(&self, columns: &mut Self::Columns, position: DVec3, textured: Option<&Textured>) {
        let texture = textured
            .map(|textured| BoardTexture { white: textured.white.clone(), black: textured.black.clone() });
        columns.push(Vector::from_dvec3(position), T::from_f64(self.cell), texture);
    }
}

//! Objects of one shape kind to their table.

use core::cmp::Ordering;
use std::sync::Arc;

use bevy_ecs::prelude::*;
use bevy_ecs::query::QueryData;
use bevy_ecs::system::SystemParam;
use glam::DVec3;

use crate::components::range::{COEFFICIENT, COLOR, SHININESS};
use crate::components::{Ambient, Color, Diffuse, Gloss, Mirror, Order, Position, Textured};
use crate::effects::{Effect, Rgb};
use crate::geometry::Real;
use crate::trace::{GlossRow, ShapeColumns, ShapeTable, SurfaceRow};

use super::changes::{Census, ObjectChange, ObjectGain};
use super::problem::{Checks, WorldProblem};
use super::shape_tables::{ExtractShape, Shape};
use super::{Muted, Tables};

/// An object and everything that tells it apart.
pub(super) type ObjectData<S> = (
    Entity,
    &'static S,
    &'static Position,
    (&'static Color, &'static Ambient, &'static Diffuse),
    Option<&'static Order>,
    (Option<&'static Gloss>, Option<&'static Mirror>, Option<&'static Textured>),
);
/// Objects with shape `S`.
pub(super) type Objects<'w, 's, S> = Query<'w, 's, ObjectData<S>>;

type Lacking = Or<(Without<Position>, Without<Color>, Without<Ambient>, Without<Diffuse>)>;

/// What changed since the last extraction.
#[derive(SystemParam)]
pub(super) struct Edits<'w, 's, S: Component> {
    changed: Query<'w, 's, ObjectData<S>, ObjectChange<S>>,
    gained: Query<'w, 's, (), (With<S>, ObjectGain<S>)>,
    census: Census<'w, 's, S>,
}

/// Brings the table of objects with shape `S` up to date: row by row where values changed in few objects, else anew.
pub(super) fn extract_objects<T: Real, S: ExtractShape<T>>(
    objects: Objects<S>,
    incomplete: Query<Entity, (With<S>, Lacking)>,
    mut edits: Edits<S>,
    muted: Res<Muted>,
    mut tables: ResMut<Tables<T>>,
) {
    tables.revision += 1;
    let same_components = !edits.census.differs();
    if !(same_components && replace_rows(&edits, *muted, &mut tables)) {
        rebuild(&objects, &incomplete, *muted, &mut tables);
    }
}

/// Writes changed objects over their rows. `false`, and a table to be rebuilt, if that is not all there is to do.
///
/// Nothing came to a changed object, and numbers of components are the same: so nothing went from any other.
fn replace_rows<T: Real, S: ExtractShape<T>>(edits: &Edits<S>, muted: Muted, tables: &mut Tables<T>) -> bool {
    let Some(entities) = tables.entities.get(&S::Columns::KIND) else { return false };
    if tables.problems.get(S::NAME).is_none_or(|problems| !problems.is_empty()) {
        return false;
    }
    let scene = Arc::make_mut(&mut tables.scene);
    let table = S::table(scene);
    if table.order.len() != entities.len() {
        return false;
    }
    let mut replaced = Vec::new();
    for object in edits.changed.iter().map(ObjectRow::<S>::from_data).map(|row| row.without(muted)) {
        if edits.gained.contains(object.entity) || replaced.len() > entities.len() / 8 {
            return false;
        }
        let Some(row) = row_of(&object, &table.order, entities) else { return false };
        let mut checks = Checks::default();
        object.check::<T>(&mut checks);
        let is_replaced = checks.problems.is_empty()
            && table.surfaces.replace(row, object.surface())
            && object.shape.replace(&mut table.shapes, row, object.position);
        if !is_replaced {
            return false;
        }
        // Rows are far fewer than 2^32.
        replaced.push(u32::try_from(row).unwrap_or(u32::MAX));
    }
    S::refit(scene, &replaced);
    true
}

/// The row of an object whose order says it; those without order lie by value, and may have to move.
fn row_of<S>(object: &ObjectRow<S>, order: &[u32], entities: &[Entity]) -> Option<usize> {
    if object.order == u32::MAX {
        return None;
    }
    let first = order.partition_point(|&order| order < object.order);
    let is_alone = order.get(first + 1) != Some(&object.order);
    let is_here = order.get(first) == Some(&object.order) && entities.get(first) == Some(&object.entity);
    (is_alone && is_here).then_some(first)
}

/// Rebuilds a table, rows sorted by scene order and then by value.
fn rebuild<T: Real, S: ExtractShape<T>>(
    objects: &Objects<S>,
    incomplete: &Query<Entity, (With<S>, Lacking)>,
    muted: Muted,
    tables: &mut Tables<T>,
) {
    let mut rows: Vec<_> = gather(objects).into_iter().map(|row| row.without(muted)).collect();
    rows.sort_by(ObjectRow::compare);

    let mut checks = Checks::default();
    let needs = "Position, Color, Ambient and Diffuse";
    let missing = incomplete.iter().map(|entity| WorldProblem::Incomplete { entity, kind: S::NAME, needs });
    checks.problems.extend(missing);
    tables.entities.insert(S::Columns::KIND, rows.iter().map(|row| row.entity).collect());
    let scene = Arc::make_mut(&mut tables.scene);
    S::forget_tree(&mut scene.trees);
    let table = S::table(scene);
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
pub(super) struct ObjectRow<S> {
    pub(super) entity: Entity,
    pub(super) shape: S,
    pub(super) position: DVec3,
    pub(super) order: u32,
    pub(super) color: DVec3,
    pub(super) ambient: f64,
    pub(super) diffuse: f64,
    pub(super) gloss: Option<Gloss>,
    pub(super) mirror: Option<Mirror>,
    pub(super) textured: Option<Textured>,
}

/// Walks the component tables slice by slice.
pub(super) fn gather<S: Shape>(objects: &Objects<S>) -> Vec<ObjectRow<S>> {
    let mut rows = Vec::with_capacity(objects.iter().len());
    // Fails only for components with sparse storage, and none of ours has it.
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

impl<S: Shape> ObjectRow<S> {
    fn from_data(data: <ObjectData<S> as QueryData>::Item<'_, '_>) -> Self {
        let (entity, &shape, position, (color, ambient, diffuse), order, (gloss, mirror, textured)) = data;
        Self {
            entity,
            shape,
            position: position.0,
            order: order.map_or(u32::MAX, |order| order.0),
            color: color.0,
            ambient: ambient.0,
            diffuse: diffuse.0,
            gloss: gloss.copied(),
            mirror: mirror.copied(),
            textured: textured.cloned(),
        }
    }

    /// The same without effects that are switched off.
    fn without(self, muted: Muted) -> Self {
        Self {
            gloss: muted.hear(Effect::Gloss, self.gloss),
            mirror: muted.hear(Effect::Mirror, self.mirror),
            textured: muted.hear(Effect::Texture, self.textured),
            ..self
        }
    }

    /// Scene order first. Rows without one are sorted by value, never by how the World happens to store them:
    /// bevy reorders its tables on despawn and insert, and the picture must not change when it does.
    pub(super) fn compare(&self, other: &Self) -> Ordering {
        let by_value = || {
            let pairs = self.values().into_iter().zip(other.values());
            pairs.map(|(a, b)| a.total_cmp(&b)).find(|order| order.is_ne()).unwrap_or(Ordering::Equal)
        };
        self.order.cmp(&other.order).then_with(by_value)
    }

    /// Every number of the row.
    fn values(&self) -> [f64; 13] {
        let [x, y, z] = self.position.to_array();
        let [size, second_size] = self.shape.lengths().map(|length| length.map_or(0.0, |(_, length)| length));
        let [red, green, blue] = self.color.to_array();
        let (ambient, diffuse) = (self.ambient, self.diffuse);
        let Gloss { specular, shininess } = self.gloss.unwrap_or(Gloss { specular: 0.0, shininess: 0.0 });
        let mirror = self.mirror.map_or(0.0, |mirror| mirror.0);
        [x, y, z, size, second_size, red, green, blue, ambient, diffuse, specular, shininess, mirror]
    }

    fn check<T: Real>(&self, checks: &mut Checks) {
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

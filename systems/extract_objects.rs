//! Objects of one shape kind to their table.

use std::sync::Arc;

use bevy_ecs::prelude::*;
use bevy_ecs::system::SystemParam;

use crate::components::{Ambient, Color, Diffuse, Position};
use crate::geometry::Real;
use crate::trace::{ShapeColumns, ShapeTable};

use super::changes::{Census, ObjectChange, ObjectGain};
use super::object_rows::{ObjectData, ObjectRow, Objects, gather};
use super::problem::{Checks, WorldProblem};
use super::shape_tables::ExtractShape;
use super::{Muted, Tables};

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
    tables.outdated.remove(S::NAME);
    let same_components = !edits.census.differs();
    if !(same_components && replace_rows(&edits, *muted, &mut tables)) {
        rebuild(&objects, &incomplete, *muted, &mut tables);
    }
    let made = S::table(Arc::make_mut(&mut tables.scene)).effects();
    tables.runs.note(made);
}

/// Writes changed objects over their rows. `false`, and a table to be rebuilt, if that is not all there is to do.
///
/// Nothing came to a changed object, and numbers of components are the same: so nothing went from any other.
fn replace_rows<T: Real, S: ExtractShape<T>>(edits: &Edits<S>, muted: Muted, tables: &mut Tables<T>) -> bool {
    let Some(entities) = tables.entities.get(&S::Columns::KIND) else { return false };
    if !tables.is_sound(S::NAME) || tables.is_in_old_unit(S::NAME) {
        return false;
    }
    let scene = Arc::make_mut(&mut tables.scene);
    let unit = scene.unit;
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
        object.check(&mut checks);
        let object = object.in_unit(unit);
        let is_replaced = checks.problems.is_empty()
            && table.surfaces.replace(row, object.surface(unit))
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
    let objects = gather(objects, muted);
    let mut checks = Checks::default();
    let needs = "Position, Color, Ambient and Diffuse";
    let missing = incomplete.iter().map(|entity| WorldProblem::Incomplete { entity, kind: S::NAME, needs });
    checks.problems.extend(missing);
    let mut entities = Vec::with_capacity(objects.len());
    let scene = Arc::make_mut(&mut tables.scene);
    S::forget_tree(&mut scene.trees);
    let unit = scene.unit;
    let table = S::table(scene);
    *table = ShapeTable::default();
    for row in objects.rows() {
        entities.push(row.entity);
        row.check(&mut checks);
        let row = row.in_unit(unit);
        row.shape.push(&mut table.shapes, row.position, || row.on_cells(unit));
        table.order.push(row.order);
        table.surfaces.push(row.surface(unit));
    }
    table.shrink_to_fit();
    tables.entities.insert(S::Columns::KIND, entities);
    tables.mark_extracted(S::NAME, checks.problems);
}

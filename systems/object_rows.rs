//! Objects of one shape kind as rows, in the order of their table.

use core::cmp::Ordering;

use bevy_ecs::prelude::*;
use bevy_ecs::query::QueryData;
use glam::DVec3;

use crate::components::range::{COEFFICIENT, COLOR, LENGTH};
use crate::components::{Ambient, Color, Diffuse, Order, Position};
use crate::effects::{Bearer, Rgb};
use crate::geometry::{Real, Unit};
use crate::trace::{BoardEffects, SurfaceEffects, SurfaceRow};

use super::Muted;
use super::carried::{BoardCarried, BoardData, BoardSlices, SurfaceCarried, SurfaceData, SurfaceSlices};
use super::problem::{Checks, WorldProblem};
use super::shape_tables::Shape;

/// An object and everything that tells it apart.
pub(super) type ObjectData<S> = (
    Entity,
    &'static S,
    &'static Position,
    (&'static Color, &'static Ambient, &'static Diffuse),
    Option<&'static Order>,
    SurfaceData,
    BoardData,
);
/// Objects with shape `S`.
pub(super) type Objects<'w, 's, S> = Query<'w, 's, ObjectData<S>>;

/// Objects where the World stores them, and the order of their rows. Nothing is copied but that: a million objects would
/// fill a large part of the memory once more.
pub(super) struct Gathered<'w, S> {
    tables: Vec<Columns<'w, S>>,
    muted: Muted,
    places: Vec<Place>,
}

/// The components of objects that are stored together.
struct Columns<'w, S> {
    entities: &'w [Entity],
    shapes: &'w [S],
    positions: &'w [Position],
    colors: &'w [Color],
    ambients: &'w [Ambient],
    diffuses: &'w [Diffuse],
    orders: Option<&'w [Order]>,
    on_surface: SurfaceSlices<'w>,
    on_board: BoardSlices<'w>,
}

/// Where an object is stored, and its place in the scene's order.
#[derive(Clone, Copy)]
struct Place {
    order: u32,
    table: u32,
    index: u32,
}

/// Finds objects, without effects that are switched off, and sorts them by scene order and then by value.
pub(super) fn gather<'w, S: Shape>(objects: &'w Objects<S>, muted: Muted) -> Gathered<'w, S> {
    // Fails only for components with sparse storage, and none of ours has it.
    let tables = objects.contiguous_iter().into_iter().flatten().map(|slices| {
        let (entities, shapes, positions, (colors, ambients, diffuses), orders, on_surface, on_board) =
            slices;
        Columns { entities, shapes, positions, colors, ambients, diffuses, orders, on_surface, on_board }
    });
    let mut gathered = Gathered { tables: tables.collect(), muted, places: Vec::new() };
    gathered.places = gathered.places();
    gathered
}

impl<S: Shape> Gathered<'_, S> {
    /// Number of objects.
    pub(super) fn len(&self) -> usize {
        self.places.len()
    }

    /// One object after the other, in the order of the table's rows.
    pub(super) fn rows(&self) -> impl Iterator<Item = ObjectRow<S>> {
        self.places.iter().map(|&place| self.row(place))
    }

    fn row(&self, place: Place) -> ObjectRow<S> {
        self.tables[place.table as usize].row(place.index as usize).without(self.muted)
    }

    fn places(&self) -> Vec<Place> {
        let mut places = Vec::with_capacity(self.tables.iter().map(|columns| columns.entities.len()).sum());
        for (table, columns) in (0..).zip(&self.tables) {
            let place = |index: u32| Place { order: columns.order(index as usize), table, index };
            places.extend((0..).map(place).take(columns.entities.len()));
        }
        // Scene order first. Rows without one are sorted by value, never by how the World happens to store them:
        // bevy reorders its tables on despawn and insert, and the picture must not change when it does.
        let by_value = |a: Place, b: Place| self.row(a).compare_values(&self.row(b));
        places.sort_by(|&a, &b| a.order.cmp(&b.order).then_with(|| by_value(a, b)));
        places
    }
}

impl<S: Shape> Columns<'_, S> {
    fn order(&self, index: usize) -> u32 {
        self.orders.map_or(u32::MAX, |orders| orders[index].0)
    }

    fn row(&self, index: usize) -> ObjectRow<S> {
        ObjectRow {
            entity: self.entities[index],
            shape: self.shapes[index],
            position: self.positions[index].0,
            order: self.order(index),
            color: self.colors[index].0,
            ambient: self.ambients[index].0,
            diffuse: self.diffuses[index].0,
            on_surface: SurfaceCarried::stored(self.on_surface, index),
            on_board: BoardCarried::stored(self.on_board, index),
        }
    }
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
    pub(super) on_surface: SurfaceCarried,
    pub(super) on_board: BoardCarried,
}

impl<S: Shape> ObjectRow<S> {
    /// A row of its own.
    pub(super) fn from_data(data: <ObjectData<S> as QueryData>::Item<'_, '_>) -> Self {
        let (entity, &shape, position, (color, ambient, diffuse), order, on_surface, on_board) = data;
        Self {
            entity,
            shape,
            position: position.0,
            order: order.map_or(u32::MAX, |order| order.0),
            color: color.0,
            ambient: ambient.0,
            diffuse: diffuse.0,
            on_surface: SurfaceCarried::found(on_surface),
            on_board: BoardCarried::found(on_board),
        }
    }

    /// The same without effects that are switched off.
    pub(super) fn without(self, muted: Muted) -> Self {
        Self { on_surface: self.on_surface.without(muted), on_board: self.on_board.without(muted), ..self }
    }

    /// The same, its shape and position in the unit of the tables.
    pub(super) fn in_unit(self, unit: Unit) -> Self {
        Self { shape: self.shape.in_unit(unit), position: unit.point(self.position), ..self }
    }

    /// Compares all numbers, one after the other. Not inlined: sorting is, and would have copies of it.
    #[inline(never)]
    fn compare_values(&self, other: &Self) -> Ordering {
        let pairs = self.values().into_iter().zip(other.values());
        let by_values = pairs.map(|(a, b)| a.total_cmp(&b)).find(|order| order.is_ne());
        let by_values = by_values.unwrap_or(Ordering::Equal);
        by_values
            .then_with(|| self.on_surface.compare(&other.on_surface))
            .then_with(|| self.on_board.compare(&other.on_board))
    }

    /// Every number of the row but those of effects.
    fn values(&self) -> [f64; 10] {
        let [x, y, z] = self.position.to_array();
        let [size, second_size] = self.shape.lengths().map(|length| length.map_or(0.0, |(_, length)| length));
        let [red, green, blue] = self.color.to_array();
        [x, y, z, size, second_size, red, green, blue, self.ambient, self.diffuse]
    }

    /// Notes every value that is not allowed.
    pub(super) fn check(&self, checks: &mut Checks) {
        let entity = self.entity;
        checks.point(entity, "Position", self.position);
        for (name, length) in self.shape.lengths().into_iter().flatten() {
            checks.value(entity, name, length, &LENGTH);
        }
        for component in self.color.to_array() {
            checks.value(entity, "Color", component, &COLOR);
        }
        checks.value(entity, "Ambient", self.ambient, &COEFFICIENT);
        checks.value(entity, "Diffuse", self.diffuse, &COEFFICIENT);
        self.on_surface.check(entity, checks);
        self.on_board.check(entity, checks);
        self.check_shares(checks);
    }

    /// Of what comes to a surface, no more may go on than there is.
    fn check_shares(&self, checks: &mut Checks) {
        let reflected = self.on_surface.mirror.map_or(0.0, |mirror| mirror.0);
        let found = reflected + self.on_surface.glass.map_or(0.0, |glass| glass.transmission);
        // Rays would become more and more, and none of them weaker.
        if self.on_surface.glass.is_some() && found > 1.0 {
            checks.problems.push(WorldProblem::Excess { entity: self.entity, found });
        }
    }

    /// The surface, without effects that would show nothing.
    pub(super) fn surface<T: Real>(&self, unit: Unit) -> SurfaceRow<T> {
        let mut effects: SurfaceEffects<T> = self.on_surface.rows(&self.bearer(unit));
        if effects.glass.is_none() {
            effects.absorption = None;
        }
        SurfaceRow {
            color: Rgb::from_dvec3(self.color),
            ambient: T::from_f64(self.ambient),
            diffuse: T::from_f64(self.diffuse),
            effects,
        }
    }

    /// What is on the cells of a checkerboard, without effects that would show nothing.
    pub(super) fn on_cells<T: Real>(&self, unit: Unit) -> BoardEffects<T> {
        self.on_board.rows(&self.bearer(unit))
    }

    fn bearer(&self, unit: Unit) -> Bearer<'_> {
        Bearer { position: self.position, unit, images: self.on_board.texture.as_ref() }
    }
}

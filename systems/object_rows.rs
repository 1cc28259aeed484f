//! Objects of one shape kind as rows, in the order of their table.

use core::cmp::Ordering;

use bevy_ecs::prelude::*;
use bevy_ecs::query::QueryData;
use glam::DVec3;

use crate::components::range::{COEFFICIENT, COLOR, SHININESS};
use crate::components::{Ambient, Color, Diffuse, Gloss, Mirror, Order, Position, Textured};
use crate::effects::{Effect, Rgb};
use crate::geometry::Real;
use crate::trace::{GlossRow, SurfaceRow};

use super::Muted;
use super::problem::Checks;
use super::shape_tables::Shape;

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
    gloss: Option<&'w [Gloss]>,
    mirrors: Option<&'w [Mirror]>,
    textures: Option<&'w [Textured]>,
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
        let (entities, shapes, positions, (colors, ambients, diffuses), orders, effects) = slices;
        let (gloss, mirrors, textures) = effects;
        Columns { entities, shapes, positions, colors, ambients, diffuses, orders, gloss, mirrors, textures }
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
            gloss: self.gloss.map(|gloss| gloss[index]),
            mirror: self.mirrors.map(|mirrors| mirrors[index]),
            textured: self.textures.map(|textures| textures[index].clone()),
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
    pub(super) gloss: Option<Gloss>,
    pub(super) mirror: Option<Mirror>,
    pub(super) textured: Option<Textured>,
}

impl<S: Shape> ObjectRow<S> {
    /// A row of its own.
    pub(super) fn from_data(data: <ObjectData<S> as QueryData>::Item<'_, '_>) -> Self {
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
    pub(super) fn without(self, muted: Muted) -> Self {
        Self {
            gloss: muted.hear(Effect::Gloss, self.gloss),
            mirror: muted.hear(Effect::Mirror, self.mirror),
            textured: muted.hear(Effect::Texture, self.textured),
            ..self
        }
    }

    /// Compares all numbers, one after the other.
    fn compare_values(&self, other: &Self) -> Ordering {
        let pairs = self.values().into_iter().zip(other.values());
        pairs.map(|(a, b)| a.total_cmp(&b)).find(|order| order.is_ne()).unwrap_or(Ordering::Equal)
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

    /// Notes every value that is not allowed.
    pub(super) fn check<T: Real>(&self, checks: &mut Checks) {
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
    pub(super) fn surface<T: Real>(&self) -> SurfaceRow<T> {
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

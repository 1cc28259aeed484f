//! Objects of one shape kind as rows, in the order of their table.

use core::cmp::Ordering;

use bevy_ecs::prelude::*;
use bevy_ecs::query::QueryData;
use glam::DVec3;

use crate::components::range::{COEFFICIENT, COLOR, DENSITY, INDEX, LENGTH, SHININESS};
use crate::components::{
    Absorption, Ambient, CheckerFilter, Color, Diffuse, Glass, Gloss, Mirror, Order, Position, TextureFilter,
    Textured,
};
use crate::effects::{Effect, Rgb};
use crate::geometry::{Real, Unit};
use crate::trace::{GlassRow, GlossRow, SurfaceRow};

use super::Muted;
use super::problem::{Checks, WorldProblem};
use super::shape_tables::{Paint, Shape};

/// An object and everything that tells it apart.
pub(super) type ObjectData<S> = (
    Entity,
    &'static S,
    &'static Position,
    (&'static Color, &'static Ambient, &'static Diffuse),
    Option<&'static Order>,
    (Option<&'static Gloss>, Option<&'static Mirror>, Option<&'static Textured>),
    (Option<&'static TextureFilter>, Option<&'static CheckerFilter>),
    (Option<&'static Glass>, Option<&'static Absorption>),
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
    glasses: Option<&'w [Glass]>,
    absorptions: Option<&'w [Absorption]>,
    texture_filters: Option<&'w [TextureFilter]>,
    checker_filters: Option<&'w [CheckerFilter]>,
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
        let (entities, shapes, positions, (colors, ambients, diffuses), orders, effects, filters, glass) =
            slices;
        let (gloss, mirrors, textures) = effects;
        let (texture_filters, checker_filters) = filters;
        let (glasses, absorptions) = glass;
        Columns {
            entities,
            shapes,
            positions,
            colors,
            ambients,
            diffuses,
            orders,
            gloss,
            mirrors,
            textures,
            texture_filters,
            checker_filters,
            glasses,
            absorptions,
        }
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
            texture_filter: self.texture_filters.map(|filters| filters[index]),
            checker_filter: self.checker_filters.map(|filters| filters[index]),
            glass: self.glasses.map(|glasses| glasses[index]),
            absorption: self.absorptions.map(|absorptions| absorptions[index]),
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
    pub(super) texture_filter: Option<TextureFilter>,
    pub(super) checker_filter: Option<CheckerFilter>,
    pub(super) glass: Option<Glass>,
    pub(super) absorption: Option<Absorption>,
}

impl<S: Shape> ObjectRow<S> {
    /// A row of its own.
    pub(super) fn from_data(data: <ObjectData<S> as QueryData>::Item<'_, '_>) -> Self {
        let (entity, &shape, position, (color, ambient, diffuse), order, effects, filters, glass) = data;
        let (gloss, mirror, textured) = effects;
        let (texture_filter, checker_filter) = filters;
        let (glass, absorption) = glass;
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
            texture_filter: texture_filter.copied(),
            checker_filter: checker_filter.copied(),
            glass: glass.copied(),
            absorption: absorption.copied(),
        }
    }

    /// The same without effects that are switched off.
    pub(super) fn without(self, muted: Muted) -> Self {
        Self {
            gloss: muted.hear(Effect::Gloss, self.gloss),
            mirror: muted.hear(Effect::Mirror, self.mirror),
            textured: muted.hear(Effect::Texture, self.textured),
            texture_filter: muted.hear(Effect::TextureFilter, self.texture_filter),
            checker_filter: muted.hear(Effect::CheckerFilter, self.checker_filter),
            glass: muted.hear(Effect::Glass, self.glass),
            absorption: muted.hear(Effect::Absorption, self.absorption),
            ..self
        }
    }

    /// The same in the unit of the tables.
    pub(super) fn in_unit(self, unit: Unit) -> Self {
        let per_length = |Absorption(value)| Absorption(value.map(|channel| unit.per_length(channel)));
        Self {
            shape: self.shape.in_unit(unit),
            position: unit.point(self.position),
            absorption: self.absorption.map(per_length),
            ..self
        }
    }

    /// What is on the cells of a checkerboard, without filters that have nothing to filter.
    pub(super) fn paint(&self) -> Paint<'_> {
        let textured = self.textured.as_ref();
        Paint {
            textured,
            texture_filter: self.texture_filter.filter(|_| textured.is_some()).unwrap_or_default(),
            has_checker_filter: self.checker_filter.is_some() && textured.is_none(),
        }
    }

    /// Compares all numbers, one after the other.
    fn compare_values(&self, other: &Self) -> Ordering {
        let pairs = self.values().into_iter().zip(other.values());
        pairs.map(|(a, b)| a.total_cmp(&b)).find(|order| order.is_ne()).unwrap_or(Ordering::Equal)
    }

    /// Every number of the row.
    fn values(&self) -> [f64; 18] {
        let [x, y, z] = self.position.to_array();
        let [size, second_size] = self.shape.lengths().map(|length| length.map_or(0.0, |(_, length)| length));
        let [red, green, blue] = self.color.to_array();
        let (ambient, diffuse) = (self.ambient, self.diffuse);
        let Gloss { specular, shininess } = self.gloss.unwrap_or(Gloss { specular: 0.0, shininess: 0.0 });
        let mirror = self.mirror.map_or(0.0, |mirror| mirror.0);
        let Glass { index, transmission } = self.glass.unwrap_or(Glass { index: 1.0, transmission: 0.0 });
        let [i, j, k] = self.absorption.map_or([0.0; 3], |absorption| absorption.0.to_array());
        [
            x,
            y,
            z,
            size,
            second_size,
            red,
            green,
            blue,
            ambient,
            diffuse,
            specular,
            shininess,
            mirror,
            index,
            transmission,
            i,
            j,
            k,
        ]
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
        if let Some(gloss) = self.gloss {
            checks.value(entity, "Gloss.specular", gloss.specular, &COEFFICIENT);
            checks.value(entity, "Gloss.shininess", gloss.shininess, &SHININESS);
        }
        if let Some(mirror) = self.mirror {
            checks.value(entity, "Mirror", mirror.0, &COEFFICIENT);
        }
        self.check_glass(checks);
    }

    fn check_glass(&self, checks: &mut Checks) {
        let entity = self.entity;
        if let Some(glass) = self.glass {
            checks.value(entity, "Glass.index", glass.index, &INDEX);
            checks.value(entity, "Glass.transmission", glass.transmission, &COEFFICIENT);
            let found = self.mirror.map_or(0.0, |mirror| mirror.0) + glass.transmission;
            // Rays would become more and more, and none of them weaker.
            if found > 1.0 {
                checks.problems.push(WorldProblem::Excess { entity, found });
            }
        }
        for channel in self.absorption.map_or([0.0; 3], |absorption| absorption.0.to_array()) {
            checks.value(entity, "Absorption", channel, &DENSITY);
        }
    }

    /// The surface, without effects that would show nothing.
    pub(super) fn surface<T: Real>(&self) -> SurfaceRow<T> {
        let visible_gloss = self.gloss.filter(|gloss| gloss.specular != 0.0);
        let visible_mirror = self.mirror.filter(|mirror| mirror.0 != 0.0);
        let visible_glass = self.glass.filter(|glass| glass.transmission != 0.0);
        let visible_absorption =
            self.absorption.filter(|absorption| absorption.0 != DVec3::ZERO && visible_glass.is_some());
        SurfaceRow {
            color: Rgb::from_dvec3(self.color),
            ambient: T::from_f64(self.ambient),
            diffuse: T::from_f64(self.diffuse),
            gloss: visible_gloss.map(|gloss| GlossRow {
                specular: T::from_f64(gloss.specular),
                shininess: T::from_f64(gloss.shininess),
            }),
            mirror: visible_mirror.map(|mirror| T::from_f64(mirror.0)),
            glass: visible_glass.map(|glass| GlassRow {
                index: T::from_f64(glass.index),
                transmission: T::from_f64(glass.transmission),
            }),
            // Beyond the largest number, absorption times a distance of 0 would be NaN.
            absorption: visible_absorption
                .map(|absorption| Rgb::from_dvec3(absorption.0.min(DVec3::splat(T::MAX.to_f64())))),
        }
    }
}

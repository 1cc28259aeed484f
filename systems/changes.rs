//! Run conditions: whether entities of a kind changed, came or went since the last look.
//!
//! What is changed or added is told by change ticks. What is gone is told by counts, not by `RemovedComponents`: a
//! removal is reported for two calls of `World::clear_trackers` only, and a schedule that pauses meanwhile (another
//! precision, a program of its own rhythm) would never hear of it. A count that is the same although something went
//! means that something else came, and that is a change.

use bevy_ecs::prelude::*;
use bevy_ecs::system::SystemParam;

use crate::components::{
    Absorption, Ambient, AreaLight, Background, CheckerFilter, Color, Diffuse, Directional, Falloff, Fog,
    Glass, Gloss, Light, LightColor, Mirror, Order, Position, SpotCone, TextureFilter, Textured,
};
use crate::geometry::Real;

use super::{Muted, Tables};

pub(super) type ObjectChange<S> = Or<(
    Changed<S>,
    Changed<Position>,
    Changed<Color>,
    Changed<Ambient>,
    Changed<Diffuse>,
    Changed<Gloss>,
    Changed<Mirror>,
    Changed<Glass>,
    Changed<Absorption>,
    Changed<Textured>,
    Changed<TextureFilter>,
    Changed<CheckerFilter>,
    Changed<Order>,
)>;

/// What came to an object since the last look; a value that was replaced did not.
pub(super) type ObjectGain<S> = Or<(
    Added<S>,
    Added<Position>,
    Added<Color>,
    Added<Ambient>,
    Added<Diffuse>,
    Added<Gloss>,
    Added<Mirror>,
    Added<Glass>,
    Added<Absorption>,
    Added<Textured>,
    Added<TextureFilter>,
    Added<CheckerFilter>,
    Added<Order>,
)>;

type LightChange = Or<(
    Changed<Light>,
    Changed<Position>,
    Changed<Falloff>,
    Changed<SpotCone>,
    Changed<LightColor>,
    Changed<Directional>,
    Changed<AreaLight>,
    Changed<Order>,
)>;

type Air = Or<(With<Background>, With<Fog>)>;

type AirChange = Or<(Changed<Background>, Changed<Fog>)>;

/// What an object cannot be traced without.
type Needed<'w, 's, S> = (
    Living<'w, 's, S, Position>,
    Living<'w, 's, S, Color>,
    Living<'w, 's, S, Ambient>,
    Living<'w, 's, S, Diffuse>,
);

/// Whether the table of objects with shape `S` is out of date.
pub(super) fn objects_changed<S: Component>(
    changed: Query<(), (With<S>, ObjectChange<S>)>,
    mut census: Census<S>,
) -> bool {
    census.differs() | !changed.is_empty()
}

/// How many objects with shape `S` have what components, and what is switched off.
#[derive(SystemParam)]
pub(super) struct Census<'w, 's, S: Component> {
    objects: Living<'w, 's, S, S>,
    needed: Needed<'w, 's, S>,
    effects: (Living<'w, 's, S, Gloss>, Living<'w, 's, S, Mirror>, Living<'w, 's, S, Textured>),
    filters: (Living<'w, 's, S, TextureFilter>, Living<'w, 's, S, CheckerFilter>),
    glasses: (Living<'w, 's, S, Glass>, Living<'w, 's, S, Absorption>),
    orders: Living<'w, 's, S, Order>,
    /// Absent in a World that is only drawn.
    muted: Option<Res<'w, Muted>>,
}

impl<S: Component> Census<'_, '_, S> {
    /// Whether anything is another than at the last look. Every one is taken, so that none is compared with one from
    /// longer ago: hence `|`, not `||`.
    pub(super) fn differs(&mut self) -> bool {
        let (positions, colors, ambients, diffuses) = &mut self.needed;
        let (gloss, mirrors, textures) = &mut self.effects;
        let (texture_filters, checker_filters) = &mut self.filters;
        let (glass, absorptions) = &mut self.glasses;
        self.objects.differ()
            | positions.differ()
            | colors.differ()
            | ambients.differ()
            | diffuses.differ()
            | gloss.differ()
            | mirrors.differ()
            | textures.differ()
            | texture_filters.differ()
            | checker_filters.differ()
            | glass.differ()
            | absorptions.differ()
            | self.orders.differ()
            | is_changed(self.muted.as_ref())
    }
}

/// Whether the light table is out of date.
pub(super) fn lights_changed(
    changed: Query<(), (With<Light>, LightChange)>,
    mut lights: Living<Light, Light>,
    mut positions: Living<Light, Position>,
    mut narrowing: (Living<Light, Falloff>, Living<Light, SpotCone>),
    mut other: (Living<Light, LightColor>, Living<Light, Directional>, Living<Light, AreaLight>),
    mut orders: Living<Light, Order>,
    muted: Option<Res<Muted>>,
) -> bool {
    let (falloffs, cones) = &mut narrowing;
    let (colors, directions, balls) = &mut other;
    !changed.is_empty()
        | lights.differ()
        | positions.differ()
        | falloffs.differ()
        | cones.differ()
        | colors.differ()
        | directions.differ()
        | balls.differ()
        | orders.differ()
        | is_changed(muted.as_ref())
}

fn is_changed(muted: Option<&Res<Muted>>) -> bool {
    muted.is_some_and(Res::is_changed)
}

/// Whether background or fog are out of date. While nobody asks for any and none is left in the tables, they are not.
pub(super) fn air_changed<T: Real>(
    changed: Query<(), AirChange>,
    all: Query<(), Air>,
    mut backgrounds: Living<Background, Background>,
    mut fogs: Living<Fog, Fog>,
    (muted, tables): (Res<Muted>, Res<Tables<T>>),
) -> bool {
    let is_left_over = all.is_empty() && !tables.scene.air.is_empty();
    let is_switched = muted.is_changed() && !all.is_empty();
    !changed.is_empty() | backgrounds.differ() | fogs.differ() | is_left_over | is_switched
}

/// Whether a table of objects is out of date, as those say who measured them.
pub(super) fn is_outdated<T: Real>(table: &'static str) -> impl Fn(Res<Tables<T>>) -> bool {
    move |tables| tables.outdated.contains(table) || tables.is_in_old_unit(table)
}

/// Whether a table of this name was extracted in another unit than that of now.
pub(super) fn in_old_unit<T: Real>(table: &'static str) -> impl Fn(Res<Tables<T>>) -> bool {
    move |tables| tables.is_in_old_unit(table)
}

/// How many entities of a kind have a component.
#[derive(SystemParam)]
pub(super) struct Living<'w, 's, S: Component, C: Component> {
    entities: Query<'w, 's, (), (With<S>, With<C>)>,
    before: Local<'s, usize>,
}

impl<S: Component, C: Component> Living<'_, '_, S, C> {
    /// Whether there are more or fewer than at the last look. Costs one step an archetype.
    fn differ(&mut self) -> bool {
        let now = self.entities.iter().len();
        core::mem::replace(&mut *self.before, now) != now
    }
}

//! Run conditions: whether entities of a kind changed, came or went since the last look.
//!
//! What is changed or added is told by change ticks. What is gone is told by counts, not by `RemovedComponents`: a
//! removal is reported for two calls of `World::clear_trackers` only, and a schedule that pauses meanwhile (another
//! precision, a program of its own rhythm) would never hear of it. A count that is the same although something went
//! means that something else came, and that is a change.

use bevy_ecs::prelude::*;
use bevy_ecs::system::SystemParam;

use crate::components::{self, Ambient, Color, Diffuse, Light, Order, Position};
use crate::effects::survey;
use crate::geometry::Real;

use super::{Muted, Tables};

/// Defines what tells that components in some lines of the survey changed, came or went.
macro_rules! define_looks {
    ($changed:ident $counted:ident $differ:ident
        { $($effect:ident $name:ident: $component:ident [$($stage:ident)*] $what:literal;)* }) => {
        type $changed = Or<($(Changed<components::$component>,)*)>;

        /// How many entities of a kind have each component.
        type $counted<'w, 's, S> = ($(Living<'w, 's, S, components::$component>,)*);

        /// Whether any is another than at the last look. Every one is taken, so that none is compared with one from longer
        /// ago.
        fn $differ<S: Component>(($($name,)*): &mut $counted<S>) -> bool {
            [$($name.differ(),)*].contains(&true)
        }
    };
}

macro_rules! define_gain {
    ($gained:ident { $($effect:ident $name:ident: $component:ident [$($stage:ident)*] $what:literal;)* }) => {
        type $gained = Or<($(Added<components::$component>,)*)>;
    };
}

survey!(surfaces, define_looks SurfaceChange CountedOnSurfaces surfaces_differ);
survey!(surfaces, define_gain SurfaceGain);
survey!(boards, define_looks BoardChange CountedOnBoards boards_differ);
survey!(boards, define_gain BoardGain);
survey!(lights, define_looks LightEffectChange CountedOnLights lights_differ);

pub(super) type ObjectChange<S> = Or<(
    Changed<S>,
    Changed<Position>,
    Changed<Color>,
    Changed<Ambient>,
    Changed<Diffuse>,
    Changed<Order>,
    SurfaceChange,
    BoardChange,
)>;

/// What came to an object since the last look; a value that was replaced did not.
pub(super) type ObjectGain<S> = Or<(
    Added<S>,
    Added<Position>,
    Added<Color>,
    Added<Ambient>,
    Added<Diffuse>,
    Added<Order>,
    SurfaceGain,
    BoardGain,
)>;

type LightChange = Or<(Changed<Light>, Changed<Position>, Changed<Order>, LightEffectChange)>;

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
    on_surfaces: CountedOnSurfaces<'w, 's, S>,
    on_boards: CountedOnBoards<'w, 's, S>,
    orders: Living<'w, 's, S, Order>,
    /// Absent in a World that is only drawn.
    muted: Option<Res<'w, Muted>>,
}

impl<S: Component> Census<'_, '_, S> {
    /// Whether anything is another than at the last look. Every one is taken, so that none is compared with one from
    /// longer ago: hence `|`, not `||`.
    pub(super) fn differs(&mut self) -> bool {
        let (positions, colors, ambients, diffuses) = &mut self.needed;
        self.objects.differ()
            | positions.differ()
            | colors.differ()
            | ambients.differ()
            | diffuses.differ()
            | surfaces_differ(&mut self.on_surfaces)
            | boards_differ(&mut self.on_boards)
            | self.orders.differ()
            | is_changed(self.muted.as_ref())
    }
}

/// Whether the light table is out of date.
pub(super) fn lights_changed(
    changed: Query<(), (With<Light>, LightChange)>,
    mut lights: Living<Light, Light>,
    mut positions: Living<Light, Position>,
    mut on_lights: CountedOnLights<Light>,
    mut orders: Living<Light, Order>,
    muted: Option<Res<Muted>>,
) -> bool {
    !changed.is_empty()
        | lights.differ()
        | positions.differ()
        | lights_differ(&mut on_lights)
        | orders.differ()
        | is_changed(muted.as_ref())
}

fn is_changed(muted: Option<&Res<Muted>>) -> bool {
    muted.is_some_and(Res::is_changed)
}

macro_rules! define_look_at_air {
    ({ $($effect:ident $name:ident: $component:ident [$($stage:ident)*] $what:literal;)* }) => {
        type Air = Or<($(With<components::$component>,)*)>;

        type AirChange = Or<($(Changed<components::$component>,)*)>;

        /// How many entities have each component.
        type CountedInAir<'w, 's> = ($(Living<'w, 's, components::$component, components::$component>,)*);

        fn air_differs(($($name,)*): &mut CountedInAir) -> bool {
            [$($name.differ(),)*].contains(&true)
        }
    };
}

survey!(air, define_look_at_air);

/// Whether what surrounds the objects is out of date. While nobody asks for any of it and none is left in the tables, it is
/// not.
pub(super) fn air_changed<T: Real>(
    changed: Query<(), AirChange>,
    all: Query<(), Air>,
    mut counted: CountedInAir,
    (muted, tables): (Res<Muted>, Res<Tables<T>>),
) -> bool {
    let is_left_over = all.is_empty() && !tables.scene.air.is_empty();
    let is_switched = muted.is_changed() && !all.is_empty();
    !changed.is_empty() | air_differs(&mut counted) | is_left_over | is_switched
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

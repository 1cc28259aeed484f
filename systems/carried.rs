//! The components of an entity that ask for effects, made of the lines of the survey: how they are found, checked, switched
//! off, and made rows of.

use core::cmp::Ordering;

use bevy_ecs::prelude::*;
use bevy_ecs::query::QueryData;

use crate::components;
use crate::effects::{Bearer, Effect, EffectComponent, Number, survey};
use crate::geometry::Real;
use crate::trace::{BoardEffects, CameraRows, LightEffects, SurfaceEffects};

use super::Muted;
use super::problem::Checks;

/// Defines what an entity carries of the components in some lines, and the data of a query for them.
macro_rules! define_carried {
    ($(#[$meta:meta])* $carried:ident by $data:ident
        { $($effect:ident $name:ident: $component:ident [$($stage:ident)*] $what:literal;)* }) => {
        $(#[$meta])*
        pub(super) struct $carried {
            $(pub(super) $name: Option<components::$component>,)*
        }

        pub(super) type $data = ($(Option<&'static components::$component>,)*);

        impl $carried {
            /// As a query finds them.
            pub(super) fn found(($($name,)*): <$data as QueryData>::Item<'_, '_>) -> Self {
                Self { $($name: $name.cloned(),)* }
            }

            /// The same without effects that are switched off.
            pub(super) fn without(self, muted: Muted) -> Self {
                Self { $($name: muted.hear(Effect::$effect, self.$name),)* }
            }

            /// Notes every number that is not allowed.
            pub(super) fn check(&self, entity: Entity, checks: &mut Checks) {
                $(self.$name.iter().for_each(|carried| checks.numbers(entity, carried));)*
            }
        }
    };
}

/// Defines how what is carried becomes a row of the trace: without what does nothing.
macro_rules! define_extraction {
    ($carried:ident to $rows:ty
        { $($effect:ident $name:ident: $component:ident [$($stage:ident)*] $what:literal;)* }) => {
        impl $carried {
            pub(super) fn rows<T: Real>(&self, bearer: &Bearer<'_>) -> $rows {
                let mut rows = <$rows>::default();
                $(rows.$name = visible(self.$name.as_ref()).and_then(|carried| carried.row::<T>(bearer));)*
                rows
            }
        }
    };
}

/// Defines an order of what is carried, by its numbers.
macro_rules! define_order {
    ($carried:ident
        { $($effect:ident $name:ident: $component:ident [$($stage:ident)*] $what:literal;)* }) => {
        impl $carried {
            pub(super) fn compare(&self, other: &Self) -> Ordering {
                Ordering::Equal$(.then_with(|| compare(self.$name.as_ref(), other.$name.as_ref())))*
            }
        }
    };
}

/// Defines a look at all numbers of what is carried.
macro_rules! define_numbers {
    ($carried:ident
        { $($effect:ident $name:ident: $component:ident [$($stage:ident)*] $what:literal;)* }) => {
        impl $carried {
            pub(super) fn each_number(&self, mut look: impl FnMut(Number)) {
                $(self.$name.iter().flat_map(EffectComponent::numbers).for_each(&mut look);)*
            }
        }
    };
}

/// Defines how what is carried is found where the World stores it, one table after the other.
macro_rules! define_storage {
    ($carried:ident in $slices:ident
        { $($effect:ident $name:ident: $component:ident [$($stage:ident)*] $what:literal;)* }) => {
        pub(super) type $slices<'w> = ($(Option<&'w [components::$component]>,)*);

        impl $carried {
            pub(super) fn stored(($($name,)*): $slices<'_>, index: usize) -> Self {
                Self { $($name: $name.map(|all| all[index].clone()),)* }
            }
        }
    };
}

survey! {
    surfaces, define_carried
    /// What an object's surface carries.
    #[derive(Clone)]
    SurfaceCarried by SurfaceData
}
survey!(surfaces, define_extraction SurfaceCarried to SurfaceEffects<T>);
survey!(surfaces, define_order SurfaceCarried);
survey!(surfaces, define_storage SurfaceCarried in SurfaceSlices);

survey! {
    boards, define_carried
    /// What the cells of a checkerboard carry.
    #[derive(Clone)]
    BoardCarried by BoardData
}
survey!(boards, define_extraction BoardCarried to BoardEffects<T>);
survey!(boards, define_order BoardCarried);
survey!(boards, define_storage BoardCarried in BoardSlices);

survey! {
    lights, define_carried
    /// What a light carries.
    #[derive(Clone)]
    LightCarried by LightData
}
survey!(lights, define_extraction LightCarried to LightEffects<T>);
survey!(lights, define_order LightCarried);
survey!(lights, define_numbers LightCarried);

survey! {
    camera, define_carried
    /// What a camera carries.
    #[derive(Clone)]
    CameraCarried by CameraData
}
survey!(camera, define_extraction CameraCarried to CameraRows<T>);
survey!(camera, define_numbers CameraCarried);

/// A component, unless it is as good as none.
pub(super) fn visible<C: EffectComponent>(carried: Option<&C>) -> Option<&C> {
    carried.filter(|carried| !carried.does_nothing())
}

/// By all numbers, one after the other; none, and what is as good as that, before all others.
fn compare<C: EffectComponent>(one: Option<&C>, other: Option<&C>) -> Ordering {
    let numbers = |carried| visible(carried).map(|carried: &C| carried.numbers().into_iter());
    match (numbers(one), numbers(other)) {
        (Some(one), Some(other)) => {
            let pairs = one.zip(other).map(|(one, other)| one.found.total_cmp(&other.found));
            pairs.fold(Ordering::Equal, Ordering::then)
        }
        (one, other) => one.is_some().cmp(&other.is_some()),
    }
}

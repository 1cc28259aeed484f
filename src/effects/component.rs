//! How a component asks for an effect.

use glam::DVec3;

use crate::components::Textured;
use crate::components::range::Range;
use crate::geometry::{Real, Unit};

/// A component that asks for an effect: what it holds, and what the trace reads of it. Implemented in the effect's own file.
pub trait EffectComponent {
    /// What the trace reads.
    type Row<T: Real>;

    /// Every number in it.
    fn numbers(&self) -> impl IntoIterator<Item = Number>;

    /// Whether it is as good as none, whoever carries it.
    fn does_nothing(&self) -> bool;

    /// What the trace reads; nothing where the bearer lacks what the effect works on.
    fn row<T: Real>(&self, bearer: &Bearer<'_>) -> Option<Self::Row<T>>;
}

/// What the trace reads of a component.
pub type RowOf<C, T> = <C as EffectComponent>::Row<T>;

/// A number of a component.
#[derive(Clone, Copy, Debug)]
pub struct Number {
    /// Component and field, for messages.
    pub name: &'static str,
    /// The number, in world units.
    pub found: f64,
    /// What is allowed. [`LENGTH`](crate::components::range::LENGTH), [`EXTENT`](crate::components::range::EXTENT) and
    /// [`COORDINATE`](crate::components::range::COORDINATE) are for lengths: the unit of the tables is chosen to hold them.
    pub allowed: &'static Range,
}

impl Number {
    /// A number of a component.
    pub const fn new(name: &'static str, found: f64, allowed: &'static Range) -> Self {
        Self { name, found, allowed }
    }

    /// The coordinates or channels of a vector, under one name.
    pub fn of_vector(name: &'static str, found: DVec3, allowed: &'static Range) -> [Self; 3] {
        found.to_array().map(|found| Self::new(name, found, allowed))
    }
}

/// Who carries a component, as far as an effect may depend on it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Bearer<'a> {
    /// Its position, in `unit`; the origin where it has none.
    pub position: DVec3,
    /// What lengths of rows are in.
    pub unit: Unit,
    /// The images on it.
    pub images: Option<&'a Textured>,
}

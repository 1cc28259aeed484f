//! The width of a camera's lens.

use crate::components::Aperture;
use crate::components::range::{LENGTH, OPENING};
use crate::geometry::Real;

use super::{Bearer, EffectComponent, Number};

impl EffectComponent for Aperture {
    /// In world units, as the camera has it.
    type Row<T: Real> = Self;

    fn numbers(&self) -> impl IntoIterator<Item = Number> {
        [
            Number::new("Aperture.focus", self.focus, &LENGTH),
            Number::new("Aperture.radius / focus", self.radius / self.focus, &OPENING),
        ]
    }

    fn does_nothing(&self) -> bool {
        self.radius == 0.0
    }

    fn row<T: Real>(&self, _bearer: &Bearer<'_>) -> Option<Self> {
        Some(*self)
    }
}

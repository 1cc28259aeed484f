//! Lights with an extent.

use crate::components::AreaLight;
use crate::components::range::{EXTENT, LIGHT_SAMPLES};
use crate::geometry::{Real, Vector};

use super::{Bearer, EffectComponent, Number};

impl EffectComponent for AreaLight {
    type Row<T: Real> = Ball<T>;

    fn numbers(&self) -> impl IntoIterator<Item = Number> {
        [
            Number::new("AreaLight.radius", self.radius, &EXTENT),
            Number::new("AreaLight.samples", self.samples.into(), &LIGHT_SAMPLES),
        ]
    }

    fn does_nothing(&self) -> bool {
        self.radius == 0.0
    }

    fn row<T: Real>(&self, bearer: &Bearer<'_>) -> Option<Ball<T>> {
        Some(Ball { radius: T::from_f64(bearer.unit.length(self.radius)), samples: self.samples })
    }
}

/// A ball that shines, around a light's position.
#[derive(Clone, Copy, Debug)]
pub struct Ball<T> {
    /// Radius, above 0.
    pub radius: T,
    /// Points of it that share its light, 1 or more.
    pub samples: u32,
}

impl<T: Real> Ball<T> {
    /// What each of its points shines with.
    #[inline(always)]
    pub fn share(&self) -> T {
        T::ONE / T::from_u32(self.samples)
    }

    /// The vector from a surface point to a point of the ball, for one of the unit disk: on the disk through the
    /// ball's centre that faces the surface point, `to_center` (not zero) away.
    #[inline(always)]
    pub fn point(&self, to_center: Vector<T>, [x, y]: [T; 2]) -> Vector<T> {
        let [right, up] = to_center.unit().perpendiculars();
        to_center + (right * x + up * y) * self.radius
    }
}

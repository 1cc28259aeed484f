//! Specular reflection of lights.

use crate::components::Gloss;
use crate::components::range::{COEFFICIENT, SHININESS};
use crate::geometry::{Real, Vector};

use super::{Bearer, EffectComponent, Number};

/// Gloss of a surface.
#[derive(Clone, Copy, Debug)]
pub struct GlossRow<T> {
    /// Specular coefficient.
    pub specular: T,
    /// Phong exponent.
    pub shininess: T,
}

impl EffectComponent for Gloss {
    type Row<T: Real> = GlossRow<T>;

    fn numbers(&self) -> impl IntoIterator<Item = Number> {
        [
            Number::new("Gloss.specular", self.specular, &COEFFICIENT),
            Number::new("Gloss.shininess", self.shininess, &SHININESS),
        ]
    }

    fn does_nothing(&self) -> bool {
        self.specular == 0.0
    }

    fn row<T: Real>(&self, _bearer: &Bearer<'_>) -> Option<GlossRow<T>> {
        Some(GlossRow { specular: T::from_f64(self.specular), shininess: T::from_f64(self.shininess) })
    }
}

/// Phong's highlight: the cosine between the mirrored viewing ray and the light (both unit), to the power of
/// `shininess` >= 0 (B. T. Phong, "Illumination for Computer Generated Pictures", CACM 18(6), 1975).
///
/// It is 0 wherever the cosine is not above 0, so that shininess 0 lights no back and no power of a negative
/// number is taken.
#[inline(always)]
pub fn phong<T: Real>(mirrored: Vector<T>, to_light: Vector<T>, shininess: T) -> T {
    let cosine = mirrored.dot(to_light);
    if cosine > T::ZERO { cosine.pow(shininess) } else { T::ZERO }
}

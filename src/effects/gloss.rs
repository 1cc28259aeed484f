//! Specular reflection of lights.

use crate::geometry::{Real, Vector};

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

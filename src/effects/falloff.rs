//! Loss of light over distance.

use crate::geometry::Real;

/// `exp(-distance^2 * falloff)`, for a squared distance and a falloff >= 0 in 1/unit^2: 1 near the light, exactly
/// 0 far beyond it.
#[inline(always)]
pub fn attenuation<T: Real>(distance_squared: T, falloff: T) -> T {
    (-(distance_squared * falloff)).exp()
}

//! Refraction.

use crate::components::Glass;
use crate::components::range::{COEFFICIENT, INDEX};
use crate::geometry::{Real, Vector};

use super::{Bearer, EffectComponent, Number};

/// Glass of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GlassRow<T> {
    /// Index of refraction inside by that outside.
    pub index: T,
    /// Share of what glass shows.
    pub transmission: T,
}

impl EffectComponent for Glass {
    type Row<T: Real> = GlassRow<T>;

    fn numbers(&self) -> impl IntoIterator<Item = Number> {
        [
            Number::new("Glass.index", self.index, &INDEX),
            Number::new("Glass.transmission", self.transmission, &COEFFICIENT),
        ]
    }

    fn does_nothing(&self) -> bool {
        self.transmission == 0.0
    }

    fn row<T: Real>(&self, _bearer: &Bearer<'_>) -> Option<GlassRow<T>> {
        Some(GlassRow { index: T::from_f64(self.index), transmission: T::from_f64(self.transmission) })
    }
}

/// What becomes of light that meets the boundary of glass.
#[derive(Clone, Copy, Debug)]
pub struct Split<T> {
    /// The share that is reflected, 0 to 1.
    pub reflected: T,
    /// The unit direction in which the rest goes on; `None` in total reflection.
    pub refracted: Option<Vector<T>>,
}

/// Splits a ray of unit `direction` at a boundary with unit `normal` on the ray's own side, by the laws of Snell and,
/// for light that is not polarised, Fresnel. `ratio` is the index of refraction on the ray's side by that on the other.
/// At a ratio of 1 the ray goes straight on, to the bit.
#[inline(never)]
pub fn split<T: Real>(direction: Vector<T>, normal: Vector<T>, ratio: T) -> Split<T> {
    if ratio == T::ONE {
        return Split { reflected: T::ZERO, refracted: Some(direction) };
    }
    let cosine = (-direction.dot(normal)).at_least(T::ZERO);
    // The part of the direction within the boundary; its length is the sine, without the cancellation of 1 - cosine^2.
    let across = direction + normal * cosine;
    let refracted_sine = ratio * across.length();
    if refracted_sine >= T::ONE {
        return Split { reflected: T::ONE, refracted: None };
    }
    // Factored, for the sake of angles close to the critical one.
    let refracted_cosine = ((T::ONE - refracted_sine) * (T::ONE + refracted_sine)).sqrt();
    let refracted = (across * ratio - normal * refracted_cosine).unit();
    Split { reflected: fresnel(cosine, refracted_cosine, ratio), refracted: Some(refracted) }
}

/// Splits a ray at a sheet of glass so thin that what passes it goes straight on: light is reflected to and fro between
/// its faces, and of the share `f` of one face the sum of all turns is `2 f / (1 + f)`.
#[inline(never)]
pub fn split_at_sheet<T: Real>(direction: Vector<T>, normal: Vector<T>, ratio: T) -> Split<T> {
    let Split { reflected: face, refracted } = split(direction, normal, ratio);
    Split { reflected: T::TWO * face / (T::ONE + face), refracted: refracted.map(|_| direction) }
}

/// Fresnel's share of reflected light, the mean of both polarisations.
#[inline(always)]
fn fresnel<T: Real>(cosine: T, refracted_cosine: T, ratio: T) -> T {
    let perpendicular = amplitude(ratio * cosine, refracted_cosine);
    let parallel = amplitude(ratio * refracted_cosine, cosine);
    (perpendicular * perpendicular + parallel * parallel) / T::TWO
}

#[inline(always)]
fn amplitude<T: Real>(a: T, b: T) -> T {
    (a - b) / (a + b)
}

//! The kernels without branches, so that a compiler can do many rays or many shapes at once.
//!
//! Every number is formed by the same operations in the same order as in [`Convex`], of which both sides of each
//! branch are computed and one is chosen: the answers are the same to the bit.

mod cube;
mod plane;
mod pyramid;
mod sphere;

use super::{Convex, Crossing, Ray, Real, Side, SurfacePoint};

/// A crossing, or none, in plain numbers.
#[derive(Clone, Copy, Debug)]
pub struct Meeting<T> {
    /// Ray parameter; NaN where the ray meets nothing.
    pub t: T,
    /// Which face.
    pub face: u32,
    /// Whether the ray comes from within the body.
    pub inside: bool,
    /// Whether only [`Convex::intersect`] can tell if the ray meets anything; `t` is NaN then.
    pub unsure: bool,
}

/// What a shape answers without branches.
pub trait Straight<T: Real>: Convex<T> {
    /// Whether [`meet`](Self::meet) is worth computing: false only where it finds nothing.
    fn may_meet(&self, ray: &Ray<T>) -> bool;

    /// Whether [`meet`](Self::meet) is worth computing for a ray that looks as far as `reach`, given the inverse of its
    /// direction's length and of the square of that: false only where it finds nothing, or something beyond.
    #[inline(always)]
    fn may_meet_before(&self, _ray: &Ray<T>, _inverse_length: T, _inverse_square: T, _reach: T) -> bool {
        true
    }

    /// [`Convex::intersect`], unless unsure.
    fn meet(&self, ray: &Ray<T>) -> Meeting<T>;

    /// [`Convex::intersect`] by way of [`meet`](Self::meet).
    #[inline(always)]
    fn meet_surely(&self, ray: &Ray<T>) -> Meeting<T> {
        let meeting = self.meet(ray);
        let found = if meeting.unsure { self.intersect(ray) } else { None };
        found.map_or(meeting, Meeting::from)
    }

    /// [`Convex::locate`], for lengths within [`Real::LENGTH_LIMIT`].
    fn surface(&self, ray: &Ray<T>, meeting: &Meeting<T>) -> SurfacePoint<T>;
}

impl<T: Real> Meeting<T> {
    /// The same as a crossing.
    pub fn crossing(&self) -> Option<Crossing<T>> {
        let side = if self.inside { Side::Inside } else { Side::Outside };
        let face = u8::try_from(self.face).unwrap_or(u8::MAX);
        self.t.is_finite().then_some(Crossing { t: self.t, face, side })
    }
}

impl<T: Real> From<Crossing<T>> for Meeting<T> {
    fn from(crossing: Crossing<T>) -> Self {
        let inside = crossing.side == Side::Inside;
        Self { t: crossing.t, face: crossing.face.into(), inside, unsure: false }
    }
}

/// The part of a line that is left inside all half-spaces met so far.
struct Span<T> {
    enter: T,
    enter_face: u32,
    leave: T,
    leave_face: u32,
    /// Whether the line runs outside of a half-space it is parallel to.
    outside: bool,
}

impl<T: Real> Span<T> {
    #[inline(always)]
    fn whole() -> Self {
        Self { enter: -T::INFINITY, enter_face: 0, leave: T::INFINITY, leave_face: 0, outside: false }
    }

    #[inline(always)]
    fn enter_at(&mut self, t: T, face: u32) {
        let later = t > self.enter;
        self.enter = if later { t } else { self.enter };
        self.enter_face = if later { face } else { self.enter_face };
    }

    #[inline(always)]
    fn leave_at(&mut self, t: T, face: u32) {
        let earlier = t < self.leave;
        self.leave = if earlier { t } else { self.leave };
        self.leave_face = if earlier { face } else { self.leave_face };
    }

    /// The first end ahead of `t = 0`, unless unsure.
    #[inline(always)]
    fn first_ahead(&self, unsure: bool) -> Meeting<T> {
        let outside = self.enter > T::ZERO;
        let t = if outside { self.enter } else { self.leave };
        let face = if outside { self.enter_face } else { self.leave_face };
        let is_empty = self.outside | (self.enter > self.leave);
        let meets = !is_empty & !unsure & (t > T::ZERO) & (t < T::INFINITY);
        Meeting { t: if meets { t } else { T::NAN }, face, inside: !outside, unsure }
    }
}

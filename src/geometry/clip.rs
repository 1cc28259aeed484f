//! Clipping a ray against half-spaces: the whole of box and pyramid intersection.
//!
//! A body made of half-spaces has no edges that two triangles share, so nothing can leak between them.

use super::expansion::Expansion;
use super::{Crossing, Real, Side};

/// The part of a line that is left inside all half-spaces met so far.
pub(super) struct Span<T> {
    enter: T,
    enter_face: u8,
    leave: T,
    leave_face: u8,
}

impl<T: Real> Span<T> {
    /// The whole line.
    #[inline(always)]
    pub(super) fn whole() -> Self {
        Self { enter: -T::INFINITY, enter_face: 0, leave: T::INFINITY, leave_face: 0 }
    }

    /// Cuts away what lies before `t`, where the line enters the half-space of `face`. The first face keeps a tie.
    #[inline(always)]
    pub(super) fn enter_at(&mut self, t: T, face: u8) {
        if t > self.enter {
            self.enter = t;
            self.enter_face = face;
        }
    }

    /// Cuts away what lies after `t`, where the line leaves the half-space of `face`. The first face keeps a tie.
    #[inline(always)]
    pub(super) fn leave_at(&mut self, t: T, face: u8) {
        if t < self.leave {
            self.leave = t;
            self.leave_face = face;
        }
    }

    /// Cuts by one half-space `t * slope <= room`. `None` when the line is parallel to it and outside.
    #[inline(always)]
    pub(super) fn cut(&mut self, room: T, slope: T, face: u8) -> Option<()> {
        // True division, not a reciprocal: 1/slope overflows for slopes that the quotient survives.
        if slope < T::ZERO {
            self.enter_at(room / slope, face);
        } else if slope > T::ZERO {
            self.leave_at(room / slope, face);
        } else if room < T::ZERO {
            return None;
        }
        Some(())
    }

    /// The first end of the span ahead of `t = 0`, if the span is not empty.
    #[inline(always)]
    pub(super) fn first_ahead(&self) -> Option<Crossing<T>> {
        if self.enter > self.leave { None } else { self.first_end_ahead() }
    }

    #[inline(always)]
    fn first_end_ahead(&self) -> Option<Crossing<T>> {
        if self.enter > T::ZERO {
            let crossing = Crossing { t: self.enter, face: self.enter_face, side: Side::Outside };
            return self.enter.is_finite().then_some(crossing);
        }
        (self.leave > T::ZERO && self.leave.is_finite()).then_some(self.leaving())
    }

    /// Ray parameters of both ends.
    #[inline(always)]
    pub(super) fn ends(&self) -> [T; 2] {
        [self.enter, self.leave]
    }

    /// See [`is_close`].
    #[inline(always)]
    pub(super) fn is_close(&self) -> bool {
        is_close(self.enter, self.leave)
    }

    /// The end of the span, for a line that is known to start in the body: never before the start.
    #[inline(always)]
    pub(super) fn last(&self) -> Crossing<T> {
        let leaving = self.leaving();
        Crossing { t: leaving.t.at_least(T::ZERO), ..leaving }
    }

    #[inline(always)]
    fn leaving(&self) -> Crossing<T> {
        Crossing { t: self.leave, face: self.leave_face, side: Side::Inside }
    }
}

/// Whether a line leaves, ahead of its origin, so near to where it enters that rounding may have changed their order.
#[inline(always)]
pub(super) fn is_close<T: Real>(enter: T, leave: T) -> bool {
    (enter - leave).abs() < leave * T::CLOSE
}

/// A half-space `t * slope <= room`, exactly.
pub(super) struct ExactCut {
    pub(super) room: Expansion,
    pub(super) slope: Expansion,
}

/// Whether twice the digits are at hand: what single precision cannot tell, double nearly always can.
pub(super) fn is_single<T: Real>() -> bool {
    T::ULP.to_f64() > f64::EPSILON
}

/// What the half-spaces of the faces leave of a line, decided exactly: the first end ahead of `t = 0`.
pub(super) fn first_ahead_exactly(cuts: &[ExactCut]) -> Option<Crossing<f64>> {
    if !is_any_left(cuts) {
        return None;
    }
    let mut span = Span::whole();
    for (face, cut) in (0..).zip(cuts) {
        span.cut(cut.room.nearest(), cut.slope.nearest(), face)?;
    }
    span.first_end_ahead()
}

/// Whether a line has a point that is in all half-spaces.
fn is_any_left(cuts: &[ExactCut]) -> bool {
    let is_outside = cuts.iter().any(|cut| cut.slope.sign() == 0 && cut.room.sign() < 0);
    let entering = || cuts.iter().filter(|cut| cut.slope.sign() < 0);
    let leaving = || cuts.iter().filter(|cut| cut.slope.sign() > 0);
    !is_outside && entering().all(|enter| leaving().all(|leave| is_in_order(enter, leave)))
}

/// Whether `enter.room / enter.slope <= leave.room / leave.slope`, the slopes below and above 0.
fn is_in_order(enter: &ExactCut, leave: &ExactCut) -> bool {
    (&(&enter.room * &leave.slope) - &(&leave.room * &enter.slope)).sign() >= 0
}

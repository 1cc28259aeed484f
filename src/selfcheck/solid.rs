//! Cube, pyramid and plane against their half-spaces in numbers of twice the digits.

use glam::DVec3;

use crate::geometry::{
    Convex, Crossing, CubeShape, PlaneShape, PyramidShape, Ray, Real, Side, Straight, Vector,
};

use super::double::{Double, DoubleVector};
use super::tally::Tally;

/// The points on or below a plane through a point.
pub(super) struct HalfSpace {
    normal: DVec3,
    through: DVec3,
}

/// How a ray runs towards the boundary of a half-space: it is inside where `t * slope <= room`.
struct Approach {
    room: Double,
    slope: Double,
    /// Sums of the magnitudes of the products in room and slope: what rounding is in proportion to.
    room_size: f64,
    slope_size: f64,
    /// The same sum of the coordinates of plane and ray themselves.
    place_size: f64,
}

impl HalfSpace {
    fn approach<T: Real>(&self, ray: &Ray<T>) -> Approach {
        let [normal, through] =
            [self.normal, self.through].map(|v| DoubleVector::of(Vector::<f64>::from_dvec3(v)));
        let way = through.minus(DoubleVector::of(ray.origin));
        let size = |v: DVec3| self.normal.abs().dot(v.abs());
        Approach {
            room: normal.dot(way),
            slope: normal.dot(DoubleVector::of(ray.direction)),
            room_size: size(self.through - ray.origin.to_dvec3()),
            slope_size: size(ray.direction.to_dvec3()),
            place_size: size(self.through) + size(ray.origin.to_dvec3()),
        }
    }
}

impl Approach {
    /// Whether the ray starts so close below the plane that its origin counts as a point of it, see
    /// [`PyramidShape`]'s kernel: four epsilons of each coordinate.
    fn starts_on(&self, epsilon: f64) -> bool {
        self.room >= Double::ZERO && self.room.nearest() <= 4.04 * epsilon * self.place_size
    }

    /// What an error of `t` is to be compared with: the parameters that the rounded products amount to.
    fn scale(&self, t: f64) -> f64 {
        (self.room_size + t * self.slope_size) / (2.0 * self.slope.nearest().abs())
    }
}

/// A solid as a list of half-spaces, numbered as the kernel numbers its faces.
pub(super) trait Solid<T: Real>: Straight<T> {
    /// Its half-spaces.
    fn faces(&self) -> Vec<HalfSpace>;
    /// Its size in units.
    fn corner_to_corner(&self) -> f64;
}

impl<T: Real> Solid<T> for CubeShape<T> {
    fn faces(&self) -> Vec<HalfSpace> {
        let [min, max] = [self.min, self.max].map(Vector::to_dvec3);
        let axes = [DVec3::X, DVec3::Y, DVec3::Z];
        let pair = |axis: DVec3| {
            [HalfSpace { normal: -axis, through: min }, HalfSpace { normal: axis, through: max }]
        };
        axes.into_iter().flat_map(pair).collect()
    }

    fn corner_to_corner(&self) -> f64 {
        (self.max - self.min).to_dvec3().length()
    }
}

impl<T: Real> Solid<T> for PyramidShape<T> {
    fn faces(&self) -> Vec<HalfSpace> {
        let (apex, half, height) = (self.apex.to_dvec3(), self.half_width.to_f64(), self.height.to_f64());
        let side = |x: f64, y: f64| HalfSpace { normal: DVec3::new(x, y, half), through: apex };
        let base = HalfSpace { normal: DVec3::NEG_Z, through: apex.with_z(self.base.to_f64()) };
        vec![side(-height, 0.0), side(height, 0.0), side(0.0, -height), side(0.0, height), base]
    }

    fn corner_to_corner(&self) -> f64 {
        2.0 * self.half_width.to_f64() + self.height.to_f64()
    }
}

impl<T: Real> Solid<T> for PlaneShape<T> {
    fn faces(&self) -> Vec<HalfSpace> {
        vec![HalfSpace { normal: DVec3::Z, through: DVec3::new(0.0, 0.0, self.height.to_f64()) }]
    }

    fn corner_to_corner(&self) -> f64 {
        self.height.to_f64().abs()
    }
}

/// The part of a line within a solid: parameters and faces of its ends, as far as it has any.
struct Chord {
    enter: Option<End>,
    leave: Option<End>,
}

#[derive(Clone, Copy)]
struct End {
    t: Double,
    face: usize,
}

/// Cuts a line by all half-spaces; `None` where nothing is left.
fn chord(approaches: &[Approach]) -> Option<Chord> {
    let mut chord = Chord { enter: None, leave: None };
    for (face, approach) in approaches.iter().enumerate() {
        let end = End { t: approach.room / approach.slope, face };
        if approach.slope < Double::ZERO {
            chord.enter = chord.enter.filter(|other| other.t >= end.t).or(Some(end));
        } else if approach.slope > Double::ZERO {
            chord.leave = chord.leave.filter(|other| other.t <= end.t).or(Some(end));
        } else if approach.room < Double::ZERO {
            return None;
        }
    }
    let is_empty = matches!((chord.enter, chord.leave), (Some(enter), Some(leave)) if enter.t > leave.t);
    (!is_empty).then_some(chord)
}

impl Chord {
    fn first_ahead(&self) -> Option<(End, Side)> {
        let ends = [(self.enter, Side::Outside), (self.leave, Side::Inside)];
        ends.into_iter().find_map(|(end, side)| Some((end.filter(|end| end.t > Double::ZERO)?, side)))
    }
}

/// Checks a kernel's answer for one ray.
fn judge<T: Real>(tally: &mut Tally, solid: &impl Solid<T>, ray: &Ray<T>, found: Option<Crossing<T>>) {
    let approaches: Vec<Approach> = solid.faces().iter().map(|face| face.approach(ray)).collect();
    let epsilon = T::ULP.to_f64();
    let truth = chord(&approaches).and_then(|chord| chord.first_ahead());
    tally.cases += 1;
    match (truth, found) {
        (None, None) => {}
        (Some((end, side)), None) => {
            let leaves = approaches.get(end.face).is_some_and(|face| face.starts_on(epsilon));
            tally.leaks += u64::from(!(leaves && side == Side::Inside));
        }
        (None, Some(_)) => tally.false_hits += 1,
        (Some((end, side)), Some(found)) => {
            // Next to an edge the kernel may take the other face: it is as near as rounding can tell of both.
            let scale = |face: usize| approaches.get(face).map_or(0.0, |face| face.scale(end.t.nearest()));
            let scale = scale(end.face).max(scale(found.face.into()));
            tally.measure((Double::of(found.t) - end.t).abs().nearest() / (scale * epsilon), 3.0);
            tally.wrong += u64::from(found.side != side);
        }
    }
}

/// Checks the kernel with branches, the one without, and the surface point of both.
pub(super) fn check<T: Real>(tally: &mut Tally, solid: &impl Solid<T>, ray: &Ray<T>) {
    let found = solid.intersect(ray);
    tally.wrong += u64::from(solid.meet_surely(ray).crossing() != found);
    if let Some(crossing) = found {
        let (point, other) = (solid.locate(ray, &crossing), solid.surface(ray, &crossing.into()));
        tally.wrong += u64::from(point != other);
    }
    judge(tally, solid, ray, found);
}

/// A plane is met on both sides: the half-space below it or the one above it is left ahead.
pub(super) fn check_plane<T: Real>(tally: &mut Tally, plane: &PlaneShape<T>, ray: &Ray<T>) {
    let found = plane.intersect(ray);
    tally.wrong += u64::from(plane.meet_surely(ray).crossing() != found);
    tally.cases += 1;
    let approach = plane.faces()[0].approach(ray);
    let truth = approach.room / approach.slope;
    match found {
        Some(found) => {
            let error = ((Double::of(found.t) - truth) / truth).abs().nearest();
            tally.measure(error / T::ULP.to_f64(), 1.01);
            tally.false_hits += u64::from(truth <= Double::ZERO);
        }
        None => tally.leaks += u64::from(truth > Double::ZERO),
    }
}

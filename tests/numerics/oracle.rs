//! Exact arithmetic: every finite float is a fraction of whole numbers, so nothing here rounds.

use archetrace::geometry::{Ray, Real, Side, Vector};
use dashu::base::{BitTest, SquareRoot};
use dashu::float::{FBig, round::mode::HalfEven};
use dashu::integer::{IBig, UBig};
use dashu::rational::{RBig, Relaxed};

/// A fraction. Relaxed: only common factors of 2 are taken out, which are all there are before the first division.
pub(crate) type Exact = Relaxed;

/// A float of 300 bits, for functions that no fraction can follow.
pub(crate) type Long = FBig<HalfEven, 2>;

/// A float as the fraction it is.
pub(crate) fn exact<T: Real>(value: T) -> Exact {
    Exact::try_from(value.to_f64()).unwrap()
}

/// A decimal number such as `-1.25e-3`.
pub(crate) fn decimal(text: &str) -> Exact {
    let (digits, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let (whole, part) = digits.split_once('.').unwrap_or((digits, ""));
    let mantissa: IBig = format!("{whole}{part}").parse().unwrap();
    let exponent = exponent.parse::<isize>().unwrap() - isize::try_from(part.len()).unwrap();
    Exact::from(mantissa) * Exact::from(UBig::from(10_u8)).pow(exponent)
}

/// The square root of a number not below 0, to 200 bits.
pub(crate) fn square_root(value: &Exact) -> Exact {
    assert!(*value >= Exact::ZERO);
    let denominator = value.denominator();
    let (_, product) = (value.numerator() * IBig::from(denominator.clone())).into_parts();
    let shift = 256_usize.saturating_sub(product.bit_len() / 2);
    Exact::from_parts((product << (2 * shift)).sqrt().into(), denominator << shift)
}

/// A fraction as a float of 300 bits.
pub(crate) fn long(value: &Exact) -> Long {
    let whole = |number: IBig| Long::from(number).with_precision(300).value();
    whole(value.numerator().clone()) / whole(value.denominator().clone().into())
}

/// A long float as the fraction it is.
pub(crate) fn from_long(value: Long) -> Exact {
    RBig::try_from(value).unwrap().relax()
}

/// Sine and cosine of an angle in degrees, to 80 digits.
pub(crate) fn sine_cosine(degrees: &Exact) -> (Exact, Exact) {
    let degrees = long(degrees);
    (from_long(degrees.sin_unit(360)), from_long(degrees.cos_unit(360)))
}

/// The nearest `f64`.
pub(crate) fn nearest(value: &Exact) -> f64 {
    value.to_f64().value()
}

/// The magnitude of a number.
pub(crate) fn magnitude(value: Exact) -> Exact {
    if value < Exact::ZERO { -value } else { value }
}

/// How far a float is from the truth, as a share of the truth.
pub(crate) fn relative_error<T: Real>(found: T, truth: &Exact) -> f64 {
    let error = exact(found) - truth;
    if error.is_zero() { 0.0 } else { nearest(&magnitude(error / truth)) }
}

/// Three fractions.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ExactVector(pub(crate) [Exact; 3]);

impl ExactVector {
    /// A vector of floats, as it is.
    pub(crate) fn of<T: Real>(v: Vector<T>) -> Self {
        Self([exact(v.x), exact(v.y), exact(v.z)])
    }

    /// Scalar product.
    pub(crate) fn dot(&self, other: &Self) -> Exact {
        let [x, y, z] = &self.0;
        let [u, v, w] = &other.0;
        x * u + y * v + z * w
    }

    /// Vector product.
    pub(crate) fn cross(&self, other: &Self) -> Self {
        let [x, y, z] = &self.0;
        let [u, v, w] = &other.0;
        Self([y * w - z * v, z * u - x * w, x * v - y * u])
    }

    /// Difference.
    pub(crate) fn minus(&self, other: &Self) -> Self {
        let [x, y, z] = &self.0;
        let [u, v, w] = &other.0;
        Self([x - u, y - v, z - w])
    }

    /// Sum.
    pub(crate) fn plus(&self, other: &Self) -> Self {
        let [x, y, z] = &self.0;
        let [u, v, w] = &other.0;
        Self([x + u, y + v, z + w])
    }

    /// Multiple.
    pub(crate) fn times(&self, factor: &Exact) -> Self {
        let [x, y, z] = &self.0;
        Self([x * factor, y * factor, z * factor])
    }

    /// Length, to 200 bits.
    pub(crate) fn length(&self) -> Exact {
        square_root(&self.dot(self))
    }
}

/// The angle between two vectors far below 1 radian apart: its sine.
pub(crate) fn small_angle(a: &ExactVector, b: &ExactVector) -> f64 {
    let square = a.cross(b).dot(&a.cross(b)) / (a.dot(a) * b.dot(b));
    nearest(&square).sqrt()
}

/// A ray of fractions.
pub(crate) struct ExactRay {
    /// Where it starts.
    pub(crate) origin: ExactVector,
    /// The step for `t = 1`.
    pub(crate) direction: ExactVector,
}

impl ExactRay {
    /// A ray of floats, as it is.
    pub(crate) fn of<T: Real>(ray: &Ray<T>) -> Self {
        Self { origin: ExactVector::of(ray.origin), direction: ExactVector::of(ray.direction) }
    }

    /// The point at a parameter.
    pub(crate) fn at(&self, t: &Exact) -> ExactVector {
        self.origin.plus(&self.direction.times(t))
    }
}

/// The points `p` with `normal . p <= offset`.
#[derive(Clone, Debug)]
pub(crate) struct HalfSpace {
    /// Outwards; of any length.
    pub(crate) normal: ExactVector,
    /// `normal . p` on the boundary.
    pub(crate) offset: Exact,
}

impl HalfSpace {
    /// How far a point is outside, in lengths of the normal: at most 0 within.
    pub(crate) fn outside(&self, point: &ExactVector) -> Exact {
        self.normal.dot(point) - &self.offset
    }

    /// Where a ray crosses the boundary, unless it is parallel to it.
    pub(crate) fn crossing(&self, ray: &ExactRay) -> Option<Exact> {
        let slope = self.normal.dot(&ray.direction);
        (!slope.is_zero()).then(|| -self.outside(&ray.origin) / slope)
    }
}

/// Where a ray meets a body first.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Meeting {
    /// Ray parameter, above 0.
    pub(crate) t: Exact,
    /// The lowest face among those that are crossed there.
    pub(crate) face: u8,
    /// The side it comes from.
    pub(crate) side: Side,
}

/// The part of a line within a body: parameters and faces of its two ends. An end is absent where the line has none.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Chord {
    /// Where the line enters.
    pub(crate) enter: Option<(Exact, u8)>,
    /// Where it leaves.
    pub(crate) leave: Option<(Exact, u8)>,
}

impl Chord {
    /// Whether the line has a point in the body.
    pub(crate) fn is_empty(&self) -> bool {
        matches!((&self.enter, &self.leave), (Some((enter, _)), Some((leave, _))) if enter > leave)
    }

    /// The first end ahead of the origin.
    pub(crate) fn first_ahead(self) -> Option<Meeting> {
        if self.is_empty() {
            return None;
        }
        let ends = [(self.enter, Side::Outside), (self.leave, Side::Inside)];
        ends.into_iter().find_map(|(end, side)| {
            let (t, face) = end.filter(|(t, _)| *t > Exact::ZERO)?;
            Some(Meeting { t, face, side })
        })
    }
}

/// A closed convex body: the meeting of half-spaces, numbered as the kernels number faces.
#[derive(Clone, Debug)]
pub(crate) struct Body(pub(crate) Vec<HalfSpace>);

impl Body {
    /// The box between two corners.
    pub(crate) fn cube<T: Real>(min: Vector<T>, max: Vector<T>) -> Self {
        let face = |axis: usize, sign: f64, plane: T| HalfSpace {
            normal: ExactVector::of(Vector::<f64>::default().with(axis, sign)),
            offset: exact(sign) * exact(plane),
        };
        Self((0..3).flat_map(|axis| [face(axis, -1.0, min[axis]), face(axis, 1.0, max[axis])]).collect())
    }

    /// The pyramid below an apex.
    pub(crate) fn pyramid<T: Real>(apex: Vector<T>, base: T, half_width: T, height: T) -> Self {
        let apex = ExactVector::of(apex);
        let side = |x: T, y: T| {
            let normal = ExactVector::of(Vector::new(x, y, half_width));
            HalfSpace { offset: normal.dot(&apex), normal }
        };
        let zero = T::ZERO;
        Self(vec![
            side(-height, zero),
            side(height, zero),
            side(zero, -height),
            side(zero, height),
            HalfSpace { normal: ExactVector::of(Vector::new(zero, zero, -T::ONE)), offset: -exact(base) },
        ])
    }

    /// The same body with each face moved outwards by a length of its own.
    pub(crate) fn grown(&self, by: &[f64]) -> Self {
        assert_eq!(by.len(), self.0.len());
        let moved = |(face, &by): (&HalfSpace, &f64)| HalfSpace {
            normal: face.normal.clone(),
            offset: &face.offset + exact(by) * face.normal.length(),
        };
        Self(self.0.iter().zip(by).map(moved).collect())
    }

    /// Whether a point is in the body.
    pub(crate) fn contains(&self, point: &ExactVector) -> bool {
        self.0.iter().all(|face| face.outside(point) <= Exact::ZERO)
    }

    /// What the body cuts out of a line; `None` where a face is parallel to the line and on its wrong side.
    pub(crate) fn chord(&self, ray: &ExactRay) -> Option<Chord> {
        let mut enter: Option<(Exact, u8)> = None;
        let mut leave: Option<(Exact, u8)> = None;
        for (number, face) in (0..).zip(&self.0) {
            let slope = face.normal.dot(&ray.direction);
            let room = -face.outside(&ray.origin);
            if slope.is_zero() {
                if room < Exact::ZERO {
                    return None;
                }
                continue;
            }
            let inwards = slope < Exact::ZERO;
            let t = room / slope;
            if inwards && enter.as_ref().is_none_or(|(first, _)| t > *first) {
                enter = Some((t, number));
            } else if !inwards && leave.as_ref().is_none_or(|(last, _)| t < *last) {
                leave = Some((t, number));
            }
        }
        Some(Chord { enter, leave })
    }

    /// Where a line leaves the last of its half-spaces: parameter and place of the face in the list.
    pub(crate) fn exit(&self, ray: &ExactRay) -> Option<(Exact, u8)> {
        let ends = (0..).zip(&self.0).filter(|(_, face)| face.normal.dot(&ray.direction) > Exact::ZERO);
        ends.filter_map(|(number, face)| Some((face.crossing(ray)?, number))).min_by(|a, b| a.0.cmp(&b.0))
    }

    /// Where a ray meets the body at `t > 0`.
    pub(crate) fn meet(&self, ray: &ExactRay) -> Option<Meeting> {
        self.chord(ray)?.first_ahead()
    }
}

/// A ball.
pub(crate) struct Ball {
    /// Its centre.
    pub(crate) center: ExactVector,
    /// Its radius.
    pub(crate) radius: Exact,
}

/// A line and a ball: the numbers of the quadratic `a t^2 - 2 h t + c = 0`.
pub(crate) struct Quadratic {
    /// Squared length of the direction.
    pub(crate) a: Exact,
    /// Half the sum of the roots times `a`.
    pub(crate) h: Exact,
    /// Product of the roots times `a`: above 0 outside, below 0 inside.
    pub(crate) c: Exact,
}

impl Ball {
    /// The ball of floats, as it is.
    pub(crate) fn of<T: Real>(center: Vector<T>, radius: T) -> Self {
        Self { center: ExactVector::of(center), radius: exact(radius) }
    }

    /// The quadratic of a ray.
    pub(crate) fn quadratic(&self, ray: &ExactRay) -> Quadratic {
        let offset = ray.origin.minus(&self.center);
        Quadratic {
            a: ray.direction.dot(&ray.direction),
            h: -offset.dot(&ray.direction),
            c: offset.dot(&offset) - self.radius.sqr(),
        }
    }

    /// Where a ray meets the ball at `t > 0`.
    pub(crate) fn meet(&self, ray: &ExactRay) -> Option<Meeting> {
        let (near, far) = self.quadratic(ray).roots()?;
        let (t, side) = if near > Exact::ZERO { (near, Side::Outside) } else { (far, Side::Inside) };
        (t > Exact::ZERO).then_some(Meeting { t, face: 0, side })
    }
}

impl Quadratic {
    /// `h^2 - a c`: its sign tells hit from miss.
    pub(crate) fn discriminant(&self) -> Exact {
        self.h.sqr() - &self.a * &self.c
    }

    /// Both roots, in order, to 150 bits and more; exactly 0 where one is 0.
    pub(crate) fn roots(&self) -> Option<(Exact, Exact)> {
        let discriminant = self.discriminant();
        if discriminant < Exact::ZERO {
            return None;
        }
        let root = square_root(&discriminant);
        if self.h > Exact::ZERO {
            let q = &self.h + root;
            Some((&self.c / &q, q / &self.a))
        } else {
            let q = &self.h - root;
            let far = if q.is_zero() { Exact::ZERO } else { &self.c / &q };
            Some((q / &self.a, far))
        }
    }
}

/// Whether a whole cell count `floor(x / cell)` is odd.
pub(crate) fn floor_is_odd(x: &Exact, cell: &Exact) -> bool {
    let count = (x / cell).floor();
    count % IBig::from(2) != IBig::ZERO
}

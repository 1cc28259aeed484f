//! Orthonormal camera bases `[l, r, u]`, and how a camera turns.
//!
//! Every turn ends in a basis made orthonormal anew, so errors do not pile up however many turns there were. What a
//! turn must not change (its axis, a level horizon) keeps its bits.

use glam::DVec3;

/// The basis `[l, r, u]` of a camera: `l = unit(look)`, `r = unit(look x up)`, `u = r x l`. `None` if `look` or `up`
/// is zero or not finite.
///
/// Where `look` is parallel to `up`, +y takes the part of `up`, or -x where +y is parallel as well.
pub fn basis_looking(look: DVec3, up: DVec3) -> Option<[DVec3; 3]> {
    let l = unit(look)?;
    let up = unit(up)?;
    let r = [up, DVec3::Y, DVec3::NEG_X].into_iter().find_map(|up| across(l, up))?;
    Some([l, r, r.cross(l)])
}

/// Whether `[l, r, u]` are unit vectors at right angles with `u = r x l`, up to what many turns may round away.
pub fn is_camera_basis([l, r, u]: [DVec3; 3]) -> bool {
    const SLACK: f64 = 1e-6;
    let unit = [l, r].iter().all(|axis| (axis.length() - 1.0).abs() <= SLACK);
    unit && l.dot(r).abs() <= SLACK && u.distance(r.cross(l)) <= SLACK
}

/// Turned to the left: `l` and `r` about `u`, by an angle in degrees. `None` if the angle is not finite.
pub fn turn_left([l, r, u]: [DVec3; 3], degrees: f64) -> Option<[DVec3; 3]> {
    let [r, l] = turn([r, l], u, degrees)?;
    Some([l, r, u])
}

/// Turned to look up: `l` and `u` about `r`, by an angle in degrees. `None` if the angle is not finite.
pub fn turn_up([l, r, u]: [DVec3; 3], degrees: f64) -> Option<[DVec3; 3]> {
    let [l, u] = turn([l, u], r, degrees)?;
    Some([l, r, u])
}

/// Tilted so that the picture turns counter-clockwise: `u` towards `r` about `l`, by an angle in degrees. `None` if
/// the angle is not finite.
pub fn tilt([l, r, u]: [DVec3; 3], degrees: f64) -> Option<[DVec3; 3]> {
    let [u, r] = turn([u, r], l, degrees)?;
    Some([l, r, u])
}

/// Turned to the left about the world's z, which keeps a level horizon level, by an angle in degrees. Left is where
/// the picture has it: a camera that stands on its head turns the other way. `None` if the angle is not finite.
pub fn head_left([l, r, u]: [DVec3; 3], degrees: f64) -> Option<[DVec3; 3]> {
    let (sine, cosine) = sin_cos(if u.z < 0.0 { -degrees } else { degrees });
    let about_z = |v: DVec3| DVec3::new(v.x * cosine - v.y * sine, v.y * cosine + v.x * sine, v.z);
    let turned = [r, l, u].map(about_z);
    let [r, l, u] = if sine * cosine == 0.0 { turned } else { orthonormal(turned)? };
    Some([l, r, u].map(without_minus))
}

/// Two perpendicular unit vectors turned about the third, the first towards the second.
fn turn([a, b]: [DVec3; 2], axis: DVec3, degrees: f64) -> Option<[DVec3; 2]> {
    let (sine, cosine) = sin_cos(degrees);
    let turned = [axis, a * cosine + b * sine, b * cosine - a * sine];
    // A turn by right angles puts one vector into another's place and rounds nothing.
    let [_, a, b] = if sine * cosine == 0.0 { turned } else { orthonormal(turned)? };
    Some([a, b].map(without_minus))
}

/// Sine and cosine of any angle in degrees, exact at multiples of 90; NaN if it is not finite.
fn sin_cos(degrees: f64) -> (f64, f64) {
    // Remainder and difference are exact: only radians round.
    let turn = degrees % 360.0;
    let quarters = (turn / 90.0).round();
    let rest = (turn - 90.0 * quarters).to_radians();
    let (sine, cosine) = (libm::sin(rest), libm::cos(rest));
    match quarters.rem_euclid(4.0) {
        0.0 => (sine, cosine),
        1.0 => (cosine, -sine),
        2.0 => (-sine, -cosine),
        _ => (-cosine, sine),
    }
}

/// Unit vectors at right angles from three that nearly are (Gram and Schmidt): the first keeps its direction. `None`
/// if they are not finite or do not span space.
pub(super) fn orthonormal([a, b, c]: [DVec3; 3]) -> Option<[DVec3; 3]> {
    let a = unit(a)?;
    let b = unit(b - a * a.dot(b))?;
    let c = unit(c - a * a.dot(c) - b * b.dot(c))?;
    Some([a, b, c])
}

/// The same vector with 0 for -0, which would look odd where a camera is printed.
pub(super) fn without_minus(v: DVec3) -> DVec3 {
    v + DVec3::ZERO
}

/// The unit vector along `v`, found without overflow or underflow.
fn unit(v: DVec3) -> Option<DVec3> {
    let largest = v.abs().max_element();
    if !(largest > 0.0 && v.is_finite()) {
        return None;
    }
    let scaled = v / largest;
    Some(scaled / scaled.length())
}

/// The unit vector perpendicular to two unit vectors, unless rounding is all that keeps them apart.
fn across(l: DVec3, up: DVec3) -> Option<DVec3> {
    let cross = l.cross(up);
    if cross.length() <= 4.0 * f64::EPSILON {
        return None;
    }
    // Between nearly parallel vectors the product is short, and its rounding leans towards `l`.
    let perpendicular = cross - l * cross.dot(l);
    Some(perpendicular / perpendicular.length())
}

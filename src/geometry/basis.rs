//! Orthonormal camera bases.

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

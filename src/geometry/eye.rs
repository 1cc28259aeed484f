//! The eye of a camera on the move.

use glam::DVec3;

use super::basis::{orthonormal, without_minus};

/// The point `distance` away from `position` along a direction of unit length.
pub fn along(position: DVec3, direction: DVec3, distance: f64) -> DVec3 {
    position + distance * direction
}

/// An eye that was raised while it kept looking at the same point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Raised {
    /// Where it is now.
    pub position: DVec3,
    /// How it is turned now.
    pub basis: [DVec3; 3],
    /// How far ahead the point lies now, in world units.
    pub distance: f64,
}

/// The eye at `position`, raised along the world's z by `height` while it keeps looking at the point `distance` ahead;
/// `r` and `u` follow by the smallest rotation that takes the old `l` to the new one.
///
/// `None` if the eye would not move, if it would come to lie on the point, if `l` would turn by 180 degrees, where no
/// rotation is the smallest (both to a millionth: closer by, rounding would choose the direction), or if a number is
/// not finite.
pub fn raise(position: DVec3, [l, r, _]: [DVec3; 3], distance: f64, height: f64) -> Option<Raised> {
    const NEARLY: f64 = 1e-6;
    let raised = DVec3 { z: position.z + height, ..position };
    // What is left of the height in the coordinates of an eye far away.
    let climbed = raised.z - position.z;
    // From the eye, not as the difference of two points, which would cost digits far from the world's origin.
    let sight = l * distance - DVec3::Z * climbed;
    let length = sight.length();
    let look = sight / length;
    let halfway = l + look;
    if climbed == 0.0 || distance <= 0.0 || length <= NEARLY * distance || halfway.length() <= NEARLY {
        return None;
    }
    // The rotation reflects what is perpendicular to `l` in the plane across `halfway`. The product of `r` and
    // `halfway` is that of `r` and `-climbed / length * z`: exactly 0 for a level horizon.
    let product = -climbed / length * r.z;
    let mut right = r - halfway * (2.0 * product / halfway.length_squared());
    if product != 0.0 {
        // Near half a turn `right` is off by more than the look is, which must not follow it.
        right -= look * right.dot(look);
    }
    let [r, l, u] = orthonormal([right, look, right.cross(look)])?;
    Some(Raised { position: raised, basis: [l, r, u].map(without_minus), distance: length })
}

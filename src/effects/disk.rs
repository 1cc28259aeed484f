//! Points on a disk, from points in a square.

use core::f64::consts::FRAC_PI_4;

use crate::geometry::Real;

/// A point of the disk of radius 1, evenly spread where the points of the unit square are: squares around the middle
/// become circles (P. Shirley and K. Chiu, "A Low Distortion Map Between Disk and Square", JGT 2(3), 1997).
#[inline(never)]
pub fn disk_point<T: Real>([x, y]: [T; 2]) -> [T; 2] {
    let (a, b) = (2.0 * x.to_f64() - 1.0, 2.0 * y.to_f64() - 1.0);
    let point = if a.abs() > b.abs() {
        on_circle(a, b)
    } else {
        let [along, across] = on_circle(b, a);
        [across, along]
    };
    point.map(T::from_f64)
}

/// On the circle of this radius, at an eighth of a turn for every `across` that is as large.
#[inline(always)]
fn on_circle(radius: f64, across: f64) -> [f64; 2] {
    if radius == 0.0 {
        return [0.0; 2];
    }
    let angle = FRAC_PI_4 * (across / radius);
    [radius * libm::cos(angle), radius * libm::sin(angle)]
}

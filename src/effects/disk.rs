//! Points on a disk, from points in a square.

use core::f64::consts::FRAC_PI_4;

use crate::geometry::Real;

/// A point of the disk of radius 1, evenly spread where the points of the unit square are: squares around the middle
/// become circles (P. Shirley and K. Chiu, "A Low Distortion Map Between Disk and Square", JGT 2(3), 1997).
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
fn on_circle(radius: f64, across: f64) -> [f64; 2] {
    if radius == 0.0 {
        return [0.0; 2];
    }
    let angle = FRAC_PI_4 * (across / radius);
    [radius * libm::cos(angle), radius * libm::sin(angle)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn squares_become_circles() {
        for step in 0..=64 {
            let along = f64::from(step) / 64.0;
            for (square, radius) in [
                ([along, 1.0], 1.0),
                ([0.0, along], 1.0),
                ([0.75, 0.25 + along / 2.0], 0.5),
                ([0.5, 0.5], 0.0),
            ] {
                let [x, y] = disk_point(square);
                assert!((x.hypot(y) - radius).abs() < 1e-15, "{square:?} to {x}, {y}");
            }
        }
    }

    #[test]
    fn equal_areas_stay_equal() {
        // Of a fine grid, as many points fall into a disk, half disk or ring as its share of the whole says.
        let side = 1024_u32;
        let centre = |index: u32| (f64::from(index) + 0.5) / f64::from(side);
        let points = || (0..side * side).map(|n| disk_point([centre(n % side), centre(n / side)]));
        let share = |inside: &dyn Fn(f64, f64) -> bool| {
            let found: f64 = points().filter(|&[x, y]| inside(x, y)).map(|_| 1.0).sum();
            found / f64::from(side * side)
        };
        let inner = share(&|x, y| x * x + y * y < 0.3);
        let half = share(&|x, _| x < 0.0);
        let slice = share(&|x, y| 0.0 < y && y < 0.5 * x);
        assert!((inner - 0.3).abs() < 1e-3, "{inner}");
        assert!((half - 0.5).abs() < 1e-3, "{half}");
        assert!((slice - 0.5_f64.atan() / core::f64::consts::TAU).abs() < 1e-3, "{slice}");
    }
}

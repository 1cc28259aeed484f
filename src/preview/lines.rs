//! Lines: the world's axes, cones of spotlights, the box around what is selected.

use core::f64::consts::TAU;

use glam::DVec3;

use crate::components::SpotCone;

use super::rows::{Row, is_drawable_point, pairs, tint};

/// Both ends and the colour of a segment.
pub(super) type Segment = Row<5>;

const CONE_COLOR: DVec3 = DVec3::new(0.72, 0.62, 0.36);
const OUTLINE_COLOR: DVec3 = DVec3::new(1.0, 0.55, 0.1);
const AXES: [(DVec3, DVec3); 3] = [
    (DVec3::X, DVec3::new(0.95, 0.25, 0.25)),
    (DVec3::Y, DVec3::new(0.3, 0.8, 0.3)),
    (DVec3::Z, DVec3::new(0.35, 0.5, 1.0)),
];
/// Segments of the circle at the end of a cone, and lines along its side.
const RIM: u32 = 96;
const SIDES: u32 = 4;

fn segment(start: DVec3, stop: DVec3, color: DVec3) -> Segment {
    let ([start_high, start_low], [stop_high, stop_low]) = (pairs(start, 0.0), pairs(stop, 0.0));
    [start_high, start_low, stop_high, stop_low, tint(color)]
}

/// The positive half axes, this long.
pub(super) fn axes(length: f64) -> Vec<Segment> {
    AXES.iter().map(|&(axis, color)| segment(DVec3::ZERO, axis * length, color)).collect()
}

/// The cone of a light at `apex`: as long along its side as the target is away. A cone of 180 degrees is none.
pub(super) fn cone(apex: DVec3, cone: &SpotCone) -> Vec<Segment> {
    let way = cone.target - apex;
    let Some(axis) = way.try_normalize().filter(|_| cone.cutoff < 180.0 && is_drawable_point(cone.target))
    else {
        return Vec::new();
    };
    let (across, along) = axis.any_orthonormal_pair();
    let (sine, cosine) = cone.cutoff.to_radians().sin_cos();
    // Along the side, not along the axis: a cone of 90 degrees and more has an end as well.
    let at = |step: u32| {
        let (y, x) = (TAU * f64::from(step) / f64::from(RIM)).sin_cos();
        apex + way.length() * (cosine * axis + sine * (x * across + y * along))
    };
    let rim = (0..RIM).map(|step| segment(at(step), at(step + 1), CONE_COLOR));
    let sides = (0..SIDES).map(|side| segment(apex, at(side * RIM / SIDES), CONE_COLOR));
    rim.chain(sides).collect()
}

/// The twelve edges of a box between two opposite corners.
pub(super) fn outline([low, high]: [DVec3; 2]) -> Vec<Segment> {
    let corner = |bits: usize| {
        let pick = |axis: usize| if bits >> axis & 1 == 0 { low[axis] } else { high[axis] };
        DVec3::new(pick(0), pick(1), pick(2))
    };
    let edges = (0..3)
        .flat_map(|axis| (0..8).filter(move |bits| bits >> axis & 1 == 0).map(move |bits| (bits, axis)));
    edges.map(|(bits, axis)| segment(corner(bits), corner(bits | 1 << axis), OUTLINE_COLOR)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ends(segment: &Segment) -> [DVec3; 2] {
        let point = |high: [f32; 4], low: [f32; 4]| {
            DVec3::from_array([0, 1, 2].map(|axis| f64::from(high[axis]) + f64::from(low[axis])))
        };
        [point(segment[0], segment[1]), point(segment[2], segment[3])]
    }

    #[test]
    fn a_cone_makes_its_angle_with_its_axis_whatever_the_angle() {
        let apex = DVec3::new(3.0, -4.0, 50.0);
        let target = DVec3::new(10.0, 20.0, 0.0);
        for cutoff in [0.0, 5.0, 45.0, 89.9, 90.0, 120.0, 179.0] {
            let segments = cone(apex, &SpotCone { target, cutoff });
            assert_eq!(segments.len(), (RIM + SIDES) as usize);
            for [start, stop] in segments.iter().map(ends) {
                let side = stop - apex;
                let angle = side.angle_between(target - apex).to_degrees();
                assert!((angle - cutoff).abs() < 1e-5, "{cutoff}: {angle}");
                assert!((side.length() - target.distance(apex)).abs() < 1e-9);
                assert!(start.is_finite());
            }
        }
    }

    #[test]
    fn a_cone_without_a_side_or_without_an_axis_is_not_drawn() {
        let target = DVec3::new(0.0, 0.0, 1.0);
        assert!(cone(DVec3::ZERO, &SpotCone { target, cutoff: 180.0 }).is_empty());
        assert!(cone(target, &SpotCone { target, cutoff: 20.0 }).is_empty());
    }

    #[test]
    fn an_outline_has_twelve_edges_along_the_axes() {
        let (low, high) = (DVec3::new(-1.0, 2.0, 3.0), DVec3::new(1.0, 5.0, 7.0));
        let edges = outline([low, high]);
        assert_eq!(edges.len(), 12);
        let total: f64 = edges.iter().map(ends).map(|[start, stop]| start.distance(stop)).sum();
        assert_eq!(total, 4.0 * (2.0 + 3.0 + 4.0));
    }
}

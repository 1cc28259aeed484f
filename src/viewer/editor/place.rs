//! Where something new goes: in front of the camera, at round numbers.

use bevy_ecs::prelude::*;
use glam::DVec3;

use crate::components::range::COORDINATE;
use crate::components::{CameraPose, Checkerboard, Lens, Position, Reference};

/// A place that the camera sees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Place {
    /// In the middle of the picture, except for rounding.
    pub(super) point: DVec3,
    /// A length that is about a tenth of the distance from the eye.
    pub(super) size: f64,
}

/// The place in front of the camera, about as far away as its reference point, but on this side of the boards.
pub(super) fn in_front(world: &mut World) -> Place {
    let mut cameras = world.query::<(&CameraPose, Option<&Lens>, Option<&Reference>)>();
    let camera = cameras.iter(world).next();
    let (pose, lens, reference) =
        camera.map_or_else(Default::default, |(pose, lens, at)| (*pose, lens.copied(), at.copied()));
    let nearest = lens.map_or(0.0, |lens| 2.0 * lens.near);
    let wanted = reference.unwrap_or_default().distance.max(nearest);
    let mut boards = world.query_filtered::<&Position, With<Checkerboard>>();
    let distances = boards.iter(world).filter_map(|board| distance_to_board(&pose, board.0.z));
    let distance = distances.map(|distance| 0.75 * distance).fold(wanted, f64::min).max(nearest);
    let size = significant(distance / 10.0, 1);
    let unit = power_of_ten(size);
    let point = (pose.position + pose.l * distance).to_array().map(|coordinate| {
        let rounded = significant((coordinate / unit).round() * unit, 12);
        // Adding 0 turns -0 into 0.
        if COORDINATE.contains(rounded) { rounded + 0.0 } else { 0.0 }
    });
    Place { point: DVec3::from_array(point), size }
}

/// Along `l`; `None` if the board is not ahead.
fn distance_to_board(pose: &CameraPose, height: f64) -> Option<f64> {
    let distance = (height - pose.position.z) / pose.l.z;
    (distance > 0.0 && distance.is_finite()).then_some(distance)
}

/// The largest power of ten that is not greater than a positive number.
fn power_of_ten(value: f64) -> f64 {
    10.0_f64.powf(value.log10().floor())
}

/// A number rounded to so many significant decimal digits.
pub(crate) fn significant(value: f64, digits: usize) -> f64 {
    format!("{value:.*e}", digits.saturating_sub(1)).parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn significant_digits_are_counted_from_the_first_that_is_not_0() {
        assert_eq!(significant(0.1 + 0.2, 6), 0.3);
        assert_eq!(significant(-1234.5678, 6), -1234.57);
        assert_eq!(significant(15.0, 1), 20.0);
        assert_eq!(significant(1.0e-70, 3), 1.0e-70);
        assert_eq!(significant(f64::INFINITY, 6), f64::INFINITY);
    }

    #[test]
    fn the_default_camera_sees_what_is_new_in_the_middle() {
        let mut world = World::new();
        world.spawn(CameraPose::default());
        assert_eq!(in_front(&mut world), Place { point: DVec3::new(0.0, 0.0, 50.0), size: 20.0 });
    }

    #[test]
    fn nothing_new_is_put_behind_a_board() {
        let mut world = World::new();
        let down = DVec3::new(0.0, 1.0, -1.0);
        world.spawn(CameraPose::looking(DVec3::new(0.0, -30.0, 50.0), down, DVec3::Z).unwrap());
        assert!(in_front(&mut world).point.z < 0.0);
        world.spawn(Checkerboard { cell: 10.0 });
        let Place { point, size } = in_front(&mut world);
        assert!(point.z > size, "{point} has no room for {size}");
    }

    #[test]
    fn it_is_beyond_the_near_plane() {
        let mut world = World::new();
        let lens = Lens { near: 1000.0, far: 5000.0, fovy: 60.0, aspect: 1.0 };
        world.spawn((CameraPose::default(), lens));
        assert!(in_front(&mut world).point.y > 850.0);
    }
}

//! The camera as the shaders have it.

use glam::{DVec2, DVec3};

use crate::components::{CameraPose, Lens};

use super::rows::{narrow, pairs};

/// A camera and the size of its picture.
#[derive(Clone, Copy, Debug)]
pub(super) struct View {
    pub(super) eye: DVec3,
    floats: [[f32; 4]; 5],
}

impl View {
    /// The square picture of `side` pixels that the trace takes with the same pose and lens. Rays start at depth
    /// `near` and end `far` beyond it, both along `l`.
    pub(super) fn new(pose: &CameraPose, lens: &Lens, side: u32) -> Self {
        let half_extent = |degrees: f64| (0.5 * degrees.to_radians()).tan();
        let [eye_high, eye_low] = pairs(pose.position, 0.0);
        let with = |v: [f32; 4], last: f64| [v[0], v[1], v[2], narrow(last)];
        let axis = |axis: DVec3, last: f64| with(pairs(axis, 0.0)[0], last);
        let floats = [
            with(eye_high, depth(lens.near)),
            with(eye_low, depth(lens.near + lens.far)),
            axis(pose.l, half_extent(lens.fovx())),
            axis(pose.r, half_extent(lens.fovy)),
            axis(pose.u, f64::from(side)),
        ];
        Self { eye: pose.position, floats }
    }

    /// The uniform block `View` of the shaders, in this machine's byte order.
    pub(super) fn to_bytes(self) -> Vec<u8> {
        self.floats.as_flattened().iter().flat_map(|number| number.to_ne_bytes()).collect()
    }

    /// The eye's place in a pattern that repeats every two cells: in cells from `origin`, 0 to 2 along each axis.
    /// Taken here, where there are digits enough, because the shader only has those of the place itself.
    pub(super) fn phase(&self, origin: DVec2, cell: f64) -> [f32; 2] {
        let place = self.eye.truncate() - origin;
        [place.x, place.y].map(|along| narrow(along.rem_euclid(2.0 * cell) / cell))
    }
}

/// A depth that a float can hold and be divided by.
fn depth(depth: f64) -> f64 {
    depth.clamp(1e-30, 1e37)
}

//! Rays that go much the same way, as boxes see them.

use crate::geometry::Real;

use super::WIDTH;
use super::fit::Node;
use super::ray::{Found, inverse, larger, slack, smaller};

/// Rays that all go the same way along an axis.
#[derive(Clone, Copy, Debug)]
pub(in crate::trace) struct AxisBeam<T> {
    /// The origins farthest from near and from far planes.
    near_origin: T,
    far_origin: T,
    /// The least and the greatest inverse of the direction.
    least: T,
    most: T,
    /// Which of a node's bounds are near, and which far.
    near: usize,
    far: usize,
}

impl<T: Real> AxisBeam<T> {
    /// Of rays whose origins and directions along the axis of this number lie between these, and whose origins may be
    /// wrong by `pad`; `None` where they part.
    #[inline(always)]
    pub(in crate::trace) fn new(axis: usize, origins: [T; 2], directions: [T; 2], pad: T) -> Option<Self> {
        let [low, high] = [origins[0] - pad, origins[1] + pad];
        let backwards = directions[1] < T::ZERO;
        if backwards != (directions[0] < T::ZERO) {
            return None;
        }
        let (most, least) = (inverse(directions[0], backwards), inverse(directions[1], backwards));
        let (near_origin, far_origin) = if backwards { (low, high) } else { (high, low) };
        let (near, far) = if backwards { (axis + 3, axis) } else { (axis, axis + 3) };
        Some(Self { near_origin, far_origin, least, most, near, far })
    }

    /// Not after any of the rays passes a near plane.
    #[inline(always)]
    fn earliest(&self, plane: T) -> T {
        let way = plane - self.near_origin;
        smaller(way * self.least, way * self.most)
    }

    /// Not before any of the rays passes a far plane.
    #[inline(always)]
    fn latest(&self, plane: T) -> T {
        let way = plane - self.far_origin;
        larger(way * self.least, way * self.most)
    }
}

/// The same along every axis.
#[derive(Clone, Copy, Debug)]
pub(in crate::trace) struct Beam<T>(pub(in crate::trace) [AxisBeam<T>; 3]);

impl<T: Real> Beam<T> {
    /// In which children any of the rays may meet something at up to a limit with slack, and where the first enters them.
    /// Rounding is as for one ray.
    #[inline(always)]
    pub(super) fn enter(&self, node: &Node<T>, limit: T, found: &mut Found<T>) {
        let [x, y, z] = &self.0;
        let bounds = &node.bounds;
        let (near_x, near_y, near_z) = (&bounds[x.near], &bounds[y.near], &bounds[z.near]);
        let (far_x, far_y, far_z) = (&bounds[x.far], &bounds[y.far], &bounds[z.far]);
        for slot in 0..WIDTH {
            let entry = larger(x.earliest(near_x[slot]), y.earliest(near_y[slot]));
            let entry = larger(entry, larger(z.earliest(near_z[slot]), T::ZERO));
            let exit = smaller(x.latest(far_x[slot]), y.latest(far_y[slot]));
            let exit = smaller(smaller(exit, z.latest(far_z[slot])) * slack(), limit);
            found.distances[slot] = entry;
            found.flags[slot] = u8::from(entry <= exit);
        }
    }
}

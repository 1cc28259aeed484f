//! Sixteen shapes side by side.

use crate::geometry::{Bounded, CubeShape, PyramidShape, Real, SphereShape, Straight, Vector};

use super::WIDTH;

/// A shape that a leaf can hold sixteen of.
pub trait Packed<T: Real>: Straight<T> + Bounded<T> + Send + Sync {
    /// Sixteen shapes, number by number.
    type Block: Copy + Send + Sync + core::fmt::Debug;

    /// Packs shapes.
    fn pack(shapes: &[Self; WIDTH]) -> Self::Block;

    /// One of them.
    fn unpack(block: &Self::Block, slot: usize) -> Self;
}

/// Numbers of sixteen shapes, `N` each.
type Columns<T, const N: usize> = [[T; WIDTH]; N];

impl<T: Real> Packed<T> for SphereShape<T> {
    type Block = Columns<T, 4>;

    fn pack(shapes: &[Self; WIDTH]) -> Self::Block {
        let column = |part: fn(&Self) -> T| core::array::from_fn(|slot| part(&shapes[slot]));
        [column(|s| s.center.x), column(|s| s.center.y), column(|s| s.center.z), column(|s| s.radius)]
    }

    #[inline(always)]
    fn unpack(block: &Self::Block, slot: usize) -> Self {
        let [x, y, z, radius] = block;
        Self { center: Vector::new(x[slot], y[slot], z[slot]), radius: radius[slot] }
    }
}

impl<T: Real> Packed<T> for CubeShape<T> {
    type Block = Columns<T, 6>;

    fn pack(shapes: &[Self; WIDTH]) -> Self::Block {
        let column = |part: fn(&Self) -> T| core::array::from_fn(|slot| part(&shapes[slot]));
        let min = [column(|c| c.min.x), column(|c| c.min.y), column(|c| c.min.z)];
        let max = [column(|c| c.max.x), column(|c| c.max.y), column(|c| c.max.z)];
        let ([a, b, c], [d, e, f]) = (min, max);
        [a, b, c, d, e, f]
    }

    #[inline(always)]
    fn unpack(block: &Self::Block, slot: usize) -> Self {
        let [a, b, c, d, e, f] = block;
        Self { min: Vector::new(a[slot], b[slot], c[slot]), max: Vector::new(d[slot], e[slot], f[slot]) }
    }
}

impl<T: Real> Packed<T> for PyramidShape<T> {
    type Block = Columns<T, 6>;

    fn pack(shapes: &[Self; WIDTH]) -> Self::Block {
        let column = |part: fn(&Self) -> T| core::array::from_fn(|slot| part(&shapes[slot]));
        let [x, y, z] = [column(|p| p.apex.x), column(|p| p.apex.y), column(|p| p.apex.z)];
        [x, y, z, column(|p| p.base), column(|p| p.half_width), column(|p| p.height)]
    }

    #[inline(always)]
    fn unpack(block: &Self::Block, slot: usize) -> Self {
        let [x, y, z, base, half_width, height] = block;
        Self {
            apex: Vector::new(x[slot], y[slot], z[slot]),
            base: base[slot],
            half_width: half_width[slot],
            height: height[slot],
        }
    }
}

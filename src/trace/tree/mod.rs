//! A tree over the rows of one table, sixteen children a node, sixteen rows a leaf.
//!
//! It only says which rows a ray need not be tested against; the answer is that of the kernels, and of two equally near
//! surfaces the one that comes first, whatever the tree looks like. Boxes are larger than their shapes by what the
//! kernels may be wrong, and slabs are compared with room for their own rounding, so nothing is missed.

mod beam;
mod build;
mod collapse;
mod fit;
mod pack;
mod prefetch;
mod ray;
mod searches;
mod split;
mod stack;
mod swarm;
mod traverse;

use crate::geometry::Real;

use super::ShapeColumns;
use build::{Topology, topology};
use fit::Node;

pub(super) use beam::{AxisBeam, Beam};
pub use build::{Fork, Sequential};
pub use fit::refit_tree;
pub use pack::Packed;
pub(super) use ray::{RayNumbers, TreeRay};
pub(super) use searches::{Any, NO_ROW, Nearest};
pub(super) use stack::Stack;
pub(super) use swarm::{SWARM, SwarmStack};
pub(super) use traverse::{BeamSearch, TreeSearch, Walk, Walks};

/// Children of a node, and rows of a leaf.
pub(super) const WIDTH: usize = 16;

/// A table with fewer rows is searched row by row.
pub const SMALLEST_TREE: usize = 24;

/// The tree of one table of shapes `S`.
#[derive(Clone, Debug)]
pub struct Tree<T: Real, S: Packed<T>> {
    /// The first is the root; children come after their parents.
    nodes: Vec<Node<T>>,
    leaves: Vec<Leaf<S::Block>>,
    /// For each row its leaf.
    leaf_of: Vec<u32>,
    /// For each leaf its node, and for each node its parent; the root is its own.
    leaf_parents: Vec<u32>,
    parents: Vec<u32>,
    /// Rows that moved since the tree was built.
    moved: usize,
    /// How large leaves are, and all of them together: the mean and the whole, along the longest axis.
    leaf_size: T,
    size: T,
    /// The largest rounding of a shape, see [`Ball`](crate::geometry::Ball).
    rounding: T,
}

/// Sixteen rows and their shapes. Where there are fewer, the last one is repeated.
#[derive(Clone, Copy, Debug)]
#[repr(align(32))]
struct Leaf<B> {
    block: B,
    rows: [u32; WIDTH],
}

/// What a child is, in one number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Child {
    Node(u32),
    Leaf(u32),
    Nothing,
}

impl Child {
    const LEAF: u32 = 1 << 31;
    const NOTHING: u32 = u32::MAX;

    #[inline(always)]
    fn of(code: u32) -> Self {
        match code {
            Self::NOTHING => Self::Nothing,
            leaf if leaf & Self::LEAF != 0 => Self::Leaf(leaf & !Self::LEAF),
            node => Self::Node(node),
        }
    }
}

impl<T: Real, S: Packed<T>> Tree<T, S> {
    /// The tree of a table; `None` where it has too few rows to be worth one. Work that can be done at the same time is
    /// handed to `fork`; the tree does not depend on what that makes of it.
    pub fn build<C: ShapeColumns<T, Shape = S> + Sync>(shapes: &C, fork: &impl Fork) -> Option<Self> {
        (shapes.len() >= SMALLEST_TREE).then(|| Self::of_topology(topology(shapes, fork), shapes, fork))
    }

    /// Bytes on the heap.
    pub fn bytes(&self) -> usize {
        size_of_val(&*self.nodes)
            + size_of_val(&*self.leaves)
            + size_of_val(&*self.leaf_of)
            + size_of_val(&*self.leaf_parents)
            + size_of_val(&*self.parents)
    }

    /// For each row its leaf, for each leaf its node, for each node its parent.
    fn links(topology: &Topology, rows: usize) -> [Vec<u32>; 3] {
        let Topology { nodes, leaves } = topology;
        let mut leaf_of = vec![0; rows];
        for (leaf, held) in (0..).zip(leaves) {
            held.iter().for_each(|&row| leaf_of[row as usize] = leaf);
        }
        let mut leaf_parents = vec![0; leaves.len()];
        let mut parents = vec![0; nodes.len()];
        for (node, children) in (0..).zip(nodes) {
            for &code in children {
                match Child::of(code) {
                    Child::Node(child) => parents[child as usize] = node,
                    Child::Leaf(leaf) => leaf_parents[leaf as usize] = node,
                    Child::Nothing => {}
                }
            }
        }
        [leaf_of, leaf_parents, parents]
    }
}

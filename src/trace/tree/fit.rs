//! Boxes, from the leaves up.

use std::sync::Arc;

use crate::geometry::{Bounds3, Real, Vector};
use crate::trace::ShapeColumns;

use super::build::{Fork, Topology, fill};
use super::{Child, Leaf, Packed, Tree, WIDTH};

/// Sixteen children and their boxes, bound by bound: low x, y, z, high x, y, z.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(super) struct Node<T> {
    pub(super) bounds: [[T; WIDTH]; 6],
    pub(super) children: [u32; WIDTH],
}

impl<T: Real> Node<T> {
    /// A node whose children have no boxes yet: nothing meets them.
    fn new(children: [u32; WIDTH]) -> Self {
        let (low, high) = ([T::INFINITY; WIDTH], [-T::INFINITY; WIDTH]);
        Self { bounds: [low, low, low, high, high, high], children }
    }

    fn set(&mut self, slot: usize, bounds: &Bounds3<T>) {
        let (low, high) = (bounds.low, bounds.high);
        for (column, value) in self.bounds.iter_mut().zip([low.x, low.y, low.z, high.x, high.y, high.z]) {
            column[slot] = value;
        }
    }

    /// The box around all children.
    fn around(&self) -> Bounds3<T> {
        (0..WIDTH).fold(Bounds3::EMPTY, |all, slot| {
            let [a, b, c, d, e, f] = core::array::from_fn(|column| self.bounds[column][slot]);
            all.with(&Bounds3 { low: Vector::new(a, b, c), high: Vector::new(d, e, f) })
        })
    }
}

impl<T: Real, S: Packed<T>> Tree<T, S> {
    pub(super) fn of_topology<C>(topology: Topology, shapes: &C, fork: &impl Fork) -> Self
    where
        C: ShapeColumns<T, Shape = S> + Sync,
    {
        let [leaf_of, leaf_parents, parents] = Self::links(&topology, shapes.len());
        let Topology { nodes, leaves: rows } = topology;
        let nodes = nodes.into_iter().map(Node::new).collect();
        let mut leaves: Vec<_> =
            rows.first().map(|&held| vec![Leaf::of(shapes, held); rows.len()]).unwrap_or_default();
        fill(fork, 0, &mut leaves, &|leaf| Leaf::of(shapes, rows[leaf]));
        let mut tree = Self {
            nodes,
            leaves,
            leaf_of,
            leaf_parents,
            parents,
            moved: 0,
            leaf_size: T::ZERO,
            size: T::ZERO,
            rounding: T::ZERO,
        };
        tree.fit_nodes();
        tree.size = tree.nodes.first().map_or(T::ZERO, |root| root.around().longest_side());
        tree
    }

    /// Every node from the boxes of its children: the last first, because children come after their parents.
    fn fit_nodes(&mut self) {
        let share = T::ONE / T::from_u32(u32::try_from(self.leaves.len()).unwrap_or(u32::MAX));
        for index in (0..self.nodes.len()).rev() {
            let mut node = self.nodes[index];
            for slot in 0..WIDTH {
                match Child::of(node.children[slot]) {
                    Child::Node(child) => node.set(slot, &self.nodes[child as usize].around()),
                    Child::Leaf(leaf) => {
                        let bounds = self.fit_leaf(leaf);
                        self.leaf_size += bounds.longest_side() * share;
                        node.set(slot, &bounds);
                    }
                    Child::Nothing => {}
                }
            }
            self.nodes[index] = node;
        }
    }

    /// The box around a leaf's shapes with room for their rounding, which is taken account of.
    fn fit_leaf(&mut self, leaf: u32) -> Bounds3<T> {
        let block = &self.leaves[leaf as usize].block;
        let mut around = Bounds3::EMPTY;
        for slot in 0..WIDTH {
            let shape = S::unpack(block, slot);
            around = around.with(&shape.padded_bounds());
            self.rounding = self.rounding.at_least(shape.rounding());
        }
        around
    }

    /// Whether so many rows moved that the tree should be built again: boxes only fit as well as who is whose child.
    fn is_worn(&self) -> bool {
        self.moved > self.leaf_of.len() / 2
    }

    /// How many rows moved since it was built.
    pub fn moved(&self) -> usize {
        self.moved
    }

    /// Takes over the shapes of some rows that changed in the table, and moves the boxes above them.
    pub fn refit<C: ShapeColumns<T, Shape = S>>(&mut self, shapes: &C, rows: &[u32]) {
        self.moved += rows.len();
        for &row in rows {
            let leaf = self.leaf_of[row as usize];
            let held = self.leaves[leaf as usize].rows;
            self.leaves[leaf as usize] = Leaf::of(shapes, held);
            let bounds = self.fit_leaf(leaf);
            self.lift(self.leaf_parents[leaf as usize], Child::LEAF | leaf, bounds);
        }
    }

    /// Gives a child of a node its new box, and so on up to the root.
    fn lift(&mut self, node: u32, child: u32, bounds: Bounds3<T>) {
        let (mut node, mut child, mut bounds) = (node, child, bounds);
        loop {
            let at = &mut self.nodes[node as usize];
            if let Some(slot) = at.children.iter().position(|&code| code == child) {
                at.set(slot, &bounds);
            }
            if node == 0 {
                return;
            }
            bounds = at.around();
            child = node;
            node = self.parents[node as usize];
        }
    }
}

/// Brings a tree, if there is one, up to date with some rows that changed; drops it if it is worn.
pub fn refit_tree<T: Real, C>(tree: &mut Option<Arc<Tree<T, C::Shape>>>, shapes: &C, rows: &[u32])
where
    C: ShapeColumns<T, Shape: Packed<T>>,
{
    if let Some(tree) = tree {
        Arc::make_mut(tree).refit(shapes, rows);
    }
    if tree.as_ref().is_some_and(|tree| tree.is_worn()) {
        *tree = None;
    }
}

impl<B> Leaf<B> {
    /// The shapes of some rows.
    fn of<T: Real, S: Packed<T, Block = B>>(
        shapes: &impl ShapeColumns<T, Shape = S>,
        rows: [u32; WIDTH],
    ) -> Self {
        Self { block: S::pack(&rows.map(|row| shapes.shape(row as usize))), rows }
    }
}

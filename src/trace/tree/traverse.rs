//! One ray down a tree, eight boxes or eight shapes at a time.

use crate::geometry::{Ray, Real, Vector};

use super::fit::Node;
use super::{Child, Leaf, Packed, Tree, WIDTH};

/// Seven children a level, and no tree is as deep as this asks.
const STACK_SIZE: usize = 512;

/// Where a ray has still to go.
#[derive(Clone, Debug)]
pub(in crate::trace) struct Stack<T> {
    entries: [(u32, T); STACK_SIZE],
    /// Where the children of the node just looked at are entered. It lies here and not in a register, because a store of
    /// eight numbers is what keeps a compiler doing eight at a time.
    distances: [T; WIDTH],
}

impl<T: Real> Stack<T> {
    pub(in crate::trace) fn new() -> Self {
        Self { entries: [(0, T::ZERO); STACK_SIZE], distances: [T::ZERO; WIDTH] }
    }
}

/// A ray as boxes see it.
#[derive(Clone, Copy, Debug)]
pub(in crate::trace) struct TreeRay<T> {
    ray: Ray<T>,
    /// Inverse direction; where that would be infinite, the largest number.
    inverse: Vector<T>,
    /// The origin moved away from near and from far planes by what rounding may do.
    near_origin: Vector<T>,
    far_origin: Vector<T>,
    /// Which of a node's bounds are near, and which far, along each axis.
    near: [usize; 3],
    far: [usize; 3],
}

impl<T: Real> TreeRay<T> {
    /// Prepares a ray for a tree whose shapes are found with this much rounding.
    #[inline(always)]
    pub(in crate::trace) fn new(ray: Ray<T>, rounding: T) -> Self {
        let origin = ray.origin;
        let pad = rounding * ((origin.x.abs() + origin.y.abs()) + origin.z.abs());
        let axis = |at: T, direction: T, number: usize| {
            let backwards = direction < T::ZERO;
            let towards = if backwards { -pad } else { pad };
            let planes = if backwards { (number + 3, number) } else { (number, number + 3) };
            (inverse(direction), at + towards, at - towards, planes)
        };
        let (ix, near_x, far_x, px) = axis(origin.x, ray.direction.x, 0);
        let (iy, near_y, far_y, py) = axis(origin.y, ray.direction.y, 1);
        let (iz, near_z, far_z, pz) = axis(origin.z, ray.direction.z, 2);
        Self {
            ray,
            inverse: Vector::new(ix, iy, iz),
            near_origin: Vector::new(near_x, near_y, near_z),
            far_origin: Vector::new(far_x, far_y, far_z),
            near: [px.0, py.0, pz.0],
            far: [px.1, py.1, pz.1],
        }
    }

    /// Where the ray enters the children in which it may meet something at up to `reach`; below 0 for the others.
    ///
    /// A bound of a slab is one subtraction, one inverse and one product: wrong by less than two units in the last
    /// place. Eight are allowed for, on the one side of the comparison that has both.
    #[inline(always)]
    fn enter(&self, node: &Node<T>, reach: T, entries: &mut [T; WIDTH]) {
        let [near_x, near_y, near_z] = self.near.map(|column| &node.bounds[column]);
        let [far_x, far_y, far_z] = self.far.map(|column| &node.bounds[column]);
        let slack = T::ONE + T::from_u32(8) * T::ULP;
        for slot in 0..WIDTH {
            let x = (near_x[slot] - self.near_origin.x) * self.inverse.x;
            let y = (near_y[slot] - self.near_origin.y) * self.inverse.y;
            let z = (near_z[slot] - self.near_origin.z) * self.inverse.z;
            let entry = larger(larger(x, y), larger(z, T::ZERO));
            let x = (far_x[slot] - self.far_origin.x) * self.inverse.x;
            let y = (far_y[slot] - self.far_origin.y) * self.inverse.y;
            let z = (far_z[slot] - self.far_origin.z) * self.inverse.z;
            let exit = smaller(smaller(x, y), smaller(z, reach));
            entries[slot] = if entry <= exit * slack { entry } else { -T::ONE };
        }
    }
}

#[inline(always)]
fn larger<T: Real>(a: T, b: T) -> T {
    if a > b { a } else { b }
}

#[inline(always)]
fn smaller<T: Real>(a: T, b: T) -> T {
    if a < b { a } else { b }
}

/// A slab that a ray runs along is entered long ago or never: the largest number tells as well as infinity, and makes no
/// NaN with 0.
#[inline(always)]
fn inverse<T: Real>(direction: T) -> T {
    let inverse = T::ONE / direction;
    if inverse.abs() < T::MAX { inverse } else { T::MAX.copysign(direction) }
}

/// What a ray looks for in a tree.
pub(in crate::trace) trait TreeSearch<T: Real> {
    /// How far it still looks.
    fn reach(&self) -> T;

    /// Told of a crossing up to there with a row.
    fn meet(&mut self, row: u32, t: T);

    /// Whether it has seen enough.
    fn is_done(&self) -> bool;
}

impl<T: Real, S: Packed<T>> Tree<T, S> {
    /// How much rounding a ray must be prepared for.
    #[inline(always)]
    pub(in crate::trace) fn rounding(&self) -> T {
        self.rounding
    }

    /// Tells a search of every row that the ray meets up to its reach, other than `departed`; and of no row twice for
    /// nothing: near boxes come first if `SORTED`.
    #[inline(always)]
    pub(in crate::trace) fn search<const SORTED: bool>(
        &self,
        ray: &TreeRay<T>,
        departed: u32,
        search: &mut impl TreeSearch<T>,
        stack: &mut Stack<T>,
    ) {
        let mut height = 1;
        stack.entries[0] = (0, T::ZERO);
        let slack = T::ONE + T::from_u32(8) * T::ULP;
        while height > 0 {
            height -= 1;
            let (code, entry) = stack.entries[height % STACK_SIZE];
            if entry > search.reach() * slack {
                continue;
            }
            match Child::of(code) {
                Child::Node(node) => {
                    height =
                        descend::<T, SORTED>(ray, &self.nodes[node as usize], search.reach(), stack, height);
                }
                Child::Leaf(leaf) => {
                    test::<T, S>(&self.leaves[leaf as usize], ray, departed, search);
                    if search.is_done() {
                        return;
                    }
                }
                Child::Nothing => {}
            }
        }
    }
}

/// Puts the children that the ray enters on the stack, the nearest on top.
#[inline(always)]
fn descend<T: Real, const SORTED: bool>(
    ray: &TreeRay<T>,
    node: &Node<T>,
    reach: T,
    stack: &mut Stack<T>,
    height: usize,
) -> usize {
    ray.enter(node, reach, &mut stack.distances);
    let mut bits = 0_u32;
    for slot in 0..WIDTH {
        bits |= u32::from(stack.distances[slot] >= T::ZERO) << slot;
    }
    let entries = &mut stack.entries;
    let mut top = height;
    while bits != 0 {
        let slot = bits.trailing_zeros() as usize % WIDTH;
        bits &= bits - 1;
        let entry = (node.children[slot], stack.distances[slot]);
        let mut place = top;
        while SORTED && place > height && entries[(place - 1) % STACK_SIZE].1 < entry.1 {
            entries[place % STACK_SIZE] = entries[(place - 1) % STACK_SIZE];
            place -= 1;
        }
        entries[place % STACK_SIZE] = entry;
        top += 1;
    }
    top
}

#[inline(always)]
fn test<T: Real, S: Packed<T>>(
    leaf: &Leaf<S::Block>,
    ray: &TreeRay<T>,
    departed: u32,
    search: &mut impl TreeSearch<T>,
) {
    let mut worthwhile = false;
    for slot in 0..WIDTH {
        worthwhile |= S::unpack(&leaf.block, slot).may_meet(&ray.ray);
    }
    if !worthwhile {
        return;
    }
    let mut found = [T::ZERO; WIDTH];
    let (mut bits, mut unsure) = (0, 0);
    let reach = search.reach();
    for (slot, found) in found.iter_mut().enumerate() {
        let met = S::unpack(&leaf.block, slot).meet(&ray.ray);
        let counts = leaf.rows[slot] != departed;
        *found = met.t;
        bits |= u32::from((met.t <= reach) & counts) << slot;
        unsure |= u32::from(met.unsure & counts) << slot;
    }
    while bits != 0 {
        let slot = bits.trailing_zeros() as usize & (WIDTH - 1);
        bits &= bits - 1;
        search.meet(leaf.rows[slot], found[slot]);
    }
    if unsure != 0 {
        settle::<T, S>(leaf, ray, unsure, search);
    }
}

/// Tells a search of those rows of which rounding could not tell whether they are met, if they are.
#[cold]
#[inline(never)]
fn settle<T: Real, S: Packed<T>>(
    leaf: &Leaf<S::Block>,
    ray: &TreeRay<T>,
    unsure: u32,
    search: &mut impl TreeSearch<T>,
) {
    for slot in (0..WIDTH).filter(|slot| unsure >> slot & 1 == 1) {
        if let Some(crossing) = S::unpack(&leaf.block, slot).intersect(&ray.ray)
            && crossing.t <= search.reach()
        {
            search.meet(leaf.rows[slot], crossing.t);
        }
    }
}

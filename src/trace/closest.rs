//! The nearest surface along a ray.

use crate::geometry::{Convex, Crossing, Ray, Real};

use super::hit::DepartedRow;
use super::tree::{self, NO_ROW, Packed, Stack, Tree, TreeRay, Walk};
use super::{Departure, Hit, Kind, ObjectId, SceneTables, ShapeColumns, ShapeTable};

/// The nearest crossing with `t <= reach`. Among crossings at the same `t` the lowest scene order wins, then the
/// kind, then the row: never the order in which the World keeps its entities. Tables that have a tree are searched
/// through it.
#[inline(always)]
pub fn closest_hit<T: Real>(
    tables: &SceneTables<T>,
    ray: &Ray<T>,
    departure: &Departure,
    reach: T,
) -> Option<Hit<T>> {
    closest_hit_with(tables, ray, departure, reach, &mut None)
}

/// [`closest_hit`], with a stack for the trees that is made where there is none yet.
#[inline(always)]
pub(super) fn closest_hit_with<T: Real>(
    tables: &SceneTables<T>,
    ray: &Ray<T>,
    departure: &Departure,
    reach: T,
    stack: &mut Option<Stack>,
) -> Option<Hit<T>> {
    let mut nearest = Nearest { tables, reach, name: ObjectId::NOBODY, crossing: None };
    // The boards first: what lies behind one is out of the question.
    nearest.search(&tables.boards, ray, departure);
    let trees = &tables.trees;
    match &trees.spheres {
        Some(tree) => nearest.search_tree(&tables.spheres, tree, ray, departure, stack),
        None => nearest.search(&tables.spheres, ray, departure),
    }
    match &trees.cubes {
        Some(tree) => nearest.search_tree(&tables.cubes, tree, ray, departure, stack),
        None => nearest.search(&tables.cubes, ray, departure),
    }
    match &trees.pyramids {
        Some(tree) => nearest.search_tree(&tables.pyramids, tree, ray, departure, stack),
        None => nearest.search(&tables.pyramids, ray, departure),
    }
    nearest.hit()
}

/// The crossing of one row, given how the ray starts.
#[inline(always)]
pub(super) fn cross_row<T: Real, C: ShapeColumns<T>>(
    shapes: &C,
    row: u32,
    ray: &Ray<T>,
    departed: DepartedRow,
) -> Option<Crossing<T>> {
    if row == departed.skipped {
        return None;
    }
    let shape = shapes.shape(row as usize);
    if row == departed.within { Some(shape.exit(ray, departed.face)) } else { shape.intersect(ray) }
}

/// Whether of two objects at the same distance, by their packed names, the first one shows; anything shows before
/// nobody.
#[inline(never)]
pub(super) fn comes_first<T: Real>(tables: &SceneTables<T>, name: u32, other: u32) -> bool {
    if other == ObjectId::NOBODY {
        return true;
    }
    (order_of(tables, name), name) < (order_of(tables, other), other)
}

fn order_of<T: Real>(tables: &SceneTables<T>, name: u32) -> u32 {
    let ObjectId { kind, row } = ObjectId::unpacked(name);
    let order = match kind {
        Kind::Sphere => &tables.spheres.order,
        Kind::Cube => &tables.cubes.order,
        Kind::Pyramid => &tables.pyramids.order,
        Kind::Board => &tables.boards.order,
    };
    order[row as usize]
}

/// The nearest crossing so far.
struct Nearest<'a, T: Real> {
    tables: &'a SceneTables<T>,
    reach: T,
    /// Packed name of its object.
    name: u32,
    crossing: Option<Crossing<T>>,
}

impl<T: Real> Nearest<'_, T> {
    #[inline(always)]
    fn hit(self) -> Option<Hit<T>> {
        self.crossing.map(|crossing| Hit { object: ObjectId::unpacked(self.name), crossing })
    }

    #[inline(always)]
    fn search<C: ShapeColumns<T>>(&mut self, table: &ShapeTable<T, C>, ray: &Ray<T>, departure: &Departure) {
        let departed = departure.rows(C::KIND);
        for row in (0..).take(table.order.len()) {
            self.test(table, row, ray, departed);
        }
    }

    #[inline(always)]
    fn search_tree<C: ShapeColumns<T, Shape: Packed<T>>>(
        &mut self,
        table: &ShapeTable<T, C>,
        tree: &Tree<T, C::Shape>,
        ray: &Ray<T>,
        departure: &Departure,
        stack: &mut Option<Stack>,
    ) {
        let departed = departure.rows(C::KIND);
        // A tree knows no exits.
        if departed.within != NO_ROW {
            self.test(table, departed.within, ray, departed);
        }
        let nearest =
            tree::Nearest { tables: self.tables, kind: C::KIND, t: self.reach, name: self.name, face: 0 };
        let mut walk = Walk::new(TreeRay::new(*ray, tree.rounding()), departed.row(), nearest);
        tree.search::<true, _>(&mut walk, stack.get_or_insert_with(Stack::new));
        if walk.search.name != self.name {
            self.test(table, ObjectId::unpacked(walk.search.name).row, ray, departed);
        }
    }

    /// Takes a row if it is nearer, or as near and comes first.
    #[inline(always)]
    fn test<C: ShapeColumns<T>>(
        &mut self,
        table: &ShapeTable<T, C>,
        row: u32,
        ray: &Ray<T>,
        departed: DepartedRow,
    ) {
        let Some(crossing) = cross_row(&table.shapes, row, ray, departed) else { return };
        let name = ObjectId::packed(C::KIND, row);
        let is_tie = crossing.t == self.reach;
        if crossing.t < self.reach || (is_tie && comes_first(self.tables, name, self.name)) {
            self.reach = crossing.t;
            self.name = name;
            self.crossing = Some(crossing);
        }
    }
}

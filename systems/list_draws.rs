//! The World to what the preview draws.

use bevy_ecs::prelude::*;

use crate::components::{
    Checkerboard, Cube, Directional, Light, Order, Position, Pyramid, Sphere, SpotCone, Textured,
};
use crate::preview::{DrawList, Placed};

use super::Muted;
use super::object_rows::{ObjectRow, Objects, gather};
use super::shape_tables::Shape;

/// What the preview draws, as of the last run of [`list_schedule`](super::list_schedule).
#[derive(Resource, Default)]
pub struct Drawn(pub DrawList);

/// A shape component that has its own part of the list.
pub(super) trait ListShape: Shape {
    /// Replaces that part.
    fn list(rows: Vec<ObjectRow<Self>>, list: &mut DrawList);
}

/// Replaces the objects with shape `S`, in the order of the tables: ties go to the same object as in the trace.
pub(super) fn list_objects<S: ListShape>(
    objects: Objects<S>,
    muted: Option<Res<Muted>>,
    mut drawn: ResMut<Drawn>,
) {
    let muted = muted.map_or_else(Muted::default, |muted| *muted);
    S::list(gather(&objects, muted).rows().collect(), &mut drawn.0);
}

/// Lights that are somewhere.
type Lights<'w, 's> = Query<
    'w,
    's,
    (&'static Position, Option<&'static SpotCone>, Option<&'static Order>),
    (With<Light>, Without<Directional>),
>;

/// Replaces the lights.
pub(super) fn list_lights(lights: Lights, mut drawn: ResMut<Drawn>) {
    let mut rows: Vec<_> = lights.iter().collect();
    rows.sort_by_key(|(_, _, order)| order.map_or(u32::MAX, |order| order.0));
    let rows: Vec<_> = rows.iter().map(|(position, cone, _)| (position.0, cone.copied())).collect();
    drawn.0.set_lights(&rows);
}

fn placed<S: Shape>(row: &ObjectRow<S>) -> Placed<S> {
    Placed { shape: row.shape, position: row.position, color: row.color, order: row.order }
}

fn all_placed<S: Shape>(rows: &[ObjectRow<S>]) -> Vec<Placed<S>> {
    rows.iter().map(placed).collect()
}

impl ListShape for Sphere {
    fn list(rows: Vec<ObjectRow<Self>>, list: &mut DrawList) {
        list.set_spheres(&all_placed(&rows));
    }
}

impl ListShape for Cube {
    fn list(rows: Vec<ObjectRow<Self>>, list: &mut DrawList) {
        list.set_cubes(&all_placed(&rows));
    }
}

impl ListShape for Pyramid {
    fn list(rows: Vec<ObjectRow<Self>>, list: &mut DrawList) {
        list.set_pyramids(&all_placed(&rows));
    }
}

impl ListShape for Checkerboard {
    fn list(rows: Vec<ObjectRow<Self>>, list: &mut DrawList) {
        let boards: Vec<(Placed<Self>, Option<Textured>)> =
            rows.into_iter().map(|row| (placed(&row), row.on_board.texture)).collect();
        list.set_boards(&boards);
    }
}

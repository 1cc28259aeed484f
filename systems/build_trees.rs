//! Tables to trees.

use std::sync::Arc;

use bevy_ecs::prelude::*;

use crate::geometry::Real;
use crate::trace::Fork;

use super::{Tables, Workers};

/// Builds the trees of tables that changed.
pub(super) fn build_trees<T: Real>(mut tables: ResMut<Tables<T>>, workers: Res<Workers>) {
    let scene = &mut tables.scene;
    workers.pool.install(|| Arc::make_mut(scene).build_trees(&Join));
}

/// Whether a tree is lacking. Values that cannot be traced get none: they are reported, and their boxes mean nothing.
pub(super) fn trees_are_lacking<T: Real>(tables: Res<Tables<T>>) -> bool {
    tables.scene.lacks_trees() && tables.problems.values().all(Vec::is_empty)
}

/// Work for the threads of the pool that asks.
struct Join;

impl Fork for Join {
    fn join<A: Send, B: Send>(
        &self,
        first: impl FnOnce() -> A + Send,
        second: impl FnOnce() -> B + Send,
    ) -> (A, B) {
        rayon::join(first, second)
    }
}

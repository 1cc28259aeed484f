//! Which entities the list shows, and in which order; looked up anew only when entities came or went.

use bevy_ecs::prelude::*;
use bevy_ecs::system::SystemState;
use bevy_ecs::world::WorldId;

use crate::components::{Checkerboard, Cube, Light, Order, Pyramid, Sphere};

use super::name::Kind;

type IsListed = Or<(With<Sphere>, With<Cube>, With<Pyramid>, With<Checkerboard>, With<Light>)>;
type Came =
    Or<(Added<Sphere>, Added<Cube>, Added<Pyramid>, Added<Checkerboard>, Added<Light>, Changed<Order>)>;
type Look = SystemState<Query<'static, 'static, (), (IsListed, Came)>>;

/// Objects, then checkerboards, then lights, each in the scene's order.
#[derive(Default)]
pub(super) struct Listing {
    entities: Vec<Entity>,
    arrivals: u64,
    look: Option<(WorldId, Look)>,
}

impl Listing {
    /// The entities as of now. `arrivals` is the editor's number for entities that it makes come or go.
    pub(super) fn update(&mut self, world: &mut World, arrivals: u64) -> &[Entity] {
        let came = self.came(world);
        let count = world.query_filtered::<(), IsListed>().iter(world).len();
        if came || arrivals != self.arrivals || count != self.entities.len() {
            self.arrivals = arrivals;
            self.entities = list(world);
        }
        &self.entities
    }

    fn came(&mut self, world: &mut World) -> bool {
        if self.look.as_ref().is_none_or(|(of, _)| *of != world.id()) {
            self.look = Some((world.id(), Look::new(world)));
        }
        let Some((_, look)) = &mut self.look else { return true };
        look.get(world).is_ok_and(|came| !came.is_empty())
    }
}

fn list(world: &mut World) -> Vec<Entity> {
    let mut all = world.query_filtered::<(EntityRef, Option<&Order>), IsListed>();
    let mut rows: Vec<_> = all
        .iter(world)
        .map(|(entity, order)| {
            ((group(entity), order.is_none(), order, entity.id().index_u32()), entity.id())
        })
        .collect();
    rows.sort_unstable_by_key(|&(key, _)| key);
    rows.into_iter().map(|(_, entity)| entity).collect()
}

fn group(entity: EntityRef<'_>) -> u8 {
    match Kind::of(entity) {
        Some(Kind::Board) => 1,
        Some(kind) if kind.is_light() => 2,
        _ => 0,
    }
}

#[cfg(test)]
mod tests {
    use crate::viewer::editor::{Editor, New};

    use super::*;

    #[test]
    fn it_follows_whatever_comes_and_goes() {
        let (mut world, mut editor, mut listing) = (World::new(), Editor::default(), Listing::default());
        let light = world.spawn((Light, Order(0))).id();
        let board = world.spawn((Checkerboard { cell: 1.0 }, Order(1))).id();
        let second = world.spawn((Sphere { radius: 1.0 }, Order(1))).id();
        let first = world.spawn((Cube { side: 1.0 }, Order(0))).id();
        let nameless = world.spawn(Sphere { radius: 2.0 }).id();
        let mut look = |world: &mut World, editor: &Editor| listing.update(world, editor.arrivals()).to_vec();
        assert_eq!(look(&mut world, &editor), [first, second, nameless, board, light]);
        world.clear_trackers();
        world.despawn(nameless);
        let other = world.spawn(Pyramid { width: 1.0, height: 1.0 }).id();
        assert_eq!(look(&mut world, &editor), [first, second, other, board, light], "one for another");
        world.entity_mut(first).insert(Order(7));
        assert_eq!(look(&mut world, &editor), [second, first, other, board, light]);
        editor.select(Some(other));
        editor.delete(&mut world);
        assert_eq!(look(&mut world, &editor), [second, first, board, light]);
        editor.undo(&mut world);
        editor.select(Some(first));
        editor.delete(&mut world);
        assert_eq!(look(&mut world, &editor), [second, other, board, light], "gone and come back at once");
        let new = editor.add(&mut world, New::Sphere);
        assert_eq!(look(&mut world, &editor), [second, new, other, board, light]);
        let mut another = World::new();
        let sphere = another.spawn(Sphere { radius: 1.0 }).id();
        assert_eq!(look(&mut another, &editor), [sphere]);
    }
}

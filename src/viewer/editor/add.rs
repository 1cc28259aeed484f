//! New entities.

use bevy_ecs::prelude::*;
use bevy_ecs::query::QueryFilter;
use glam::DVec3;

use crate::components::{
    Ambient, CameraPose, Checkerboard, Color, Cube, Diffuse, Light, Order, Position, Pyramid, Sphere,
    SpotCone,
};

use super::edit::{ComponentEdit, Edit, Presence};
use super::history::Step;
use super::place::{Place, in_front};
use super::{Editor, is_camera, is_there};

/// What can be added to a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum New {
    /// A sphere.
    Sphere,
    /// A cube.
    Cube,
    /// A pyramid.
    Pyramid,
    /// A checkerboard. A scene file holds exactly one.
    Checkerboard,
    /// A light that shines in all directions.
    Light,
    /// A light within a cone.
    Spotlight,
}

impl New {
    /// Everything that can be added, with its name.
    pub(crate) const ALL: [(Self, &'static str); 6] = [
        (Self::Sphere, "sphere"),
        (Self::Cube, "cube"),
        (Self::Pyramid, "pyramid"),
        (Self::Checkerboard, "board"),
        (Self::Light, "light"),
        (Self::Spotlight, "spotlight"),
    ];
}

/// Colours of new objects, in turn.
const COLORS: [DVec3; 6] = [
    DVec3::new(0.9, 0.45, 0.25),
    DVec3::new(0.3, 0.6, 0.85),
    DVec3::new(0.95, 0.8, 0.35),
    DVec3::new(0.45, 0.75, 0.4),
    DVec3::new(0.7, 0.5, 0.8),
    DVec3::new(0.85, 0.85, 0.85),
];

impl Editor {
    /// Adds an entity in front of the camera, last in the scene's order, and selects it.
    pub(crate) fn add(&mut self, world: &mut World, what: New) -> Entity {
        let place = in_front(world);
        let entity = match what {
            New::Sphere => spawn_object(world, Sphere { radius: place.size }, place.point),
            New::Cube => {
                spawn_object(world, Cube { side: 2.0 * place.size }, place.point - DVec3::splat(place.size))
            }
            New::Pyramid => {
                let shape = Pyramid { width: 2.0 * place.size, height: 2.0 * place.size };
                spawn_object(world, shape, place.point - DVec3::splat(place.size))
            }
            New::Checkerboard => spawn_board(world, place),
            New::Light => spawn_light(world, place),
            New::Spotlight => {
                let light = spawn_light(world, place);
                world.entity_mut(light).insert(SpotCone { target: place.point, cutoff: 30.0 });
                light
            }
        };
        self.arrive(world, "add", entity);
        entity
    }

    /// Adds a copy of the selected entity beside it, with every component that can be cloned, and selects it. There
    /// is no second camera.
    pub(crate) fn duplicate(&mut self, world: &mut World) -> Option<Entity> {
        let original =
            self.selected.filter(|&entity| is_there(world, entity) && !is_camera(world, entity))?;
        let entity = world.entity_mut(original).clone_and_spawn();
        let step = beside(world, entity);
        if let Some(mut position) = world.get_mut::<Position>(entity) {
            position.0 += step;
        }
        self.arrive(world, "duplicate", entity);
        Some(entity)
    }

    /// Gives an entity its place in the scene's order and makes its arrival a step.
    fn arrive(&mut self, world: &mut World, what: &'static str, entity: Entity) {
        world.entity_mut(entity).remove::<Order>();
        let (order, moved) = last_place(world, entity);
        world.entity_mut(entity).insert(order);
        moved.iter().for_each(|edit| edit.make(world));
        let arrival = Step::new(what).and(Presence { entities: vec![entity], present: true });
        let step = moved.into_iter().fold(arrival, Step::and);
        self.selected = Some(entity);
        self.commit(world, step);
    }
}

type IsSolid = Or<(With<Sphere>, With<Cube>, With<Pyramid>)>;

/// The place after the last entity of the same kind. Boards that stand there move up: at the same distance a solid
/// shows in front of them, as it does when the scene is read from a file.
fn last_place(world: &mut World, entity: Entity) -> (Order, Vec<ComponentEdit<Order>>) {
    if world.get::<Light>(entity).is_some() {
        (after_last::<With<Light>>(world), Vec::new())
    } else if world.get::<Checkerboard>(entity).is_some() {
        (after_last::<Without<Light>>(world), Vec::new())
    } else {
        let order = after_last::<IsSolid>(world);
        (order, boards_moved_up(world, order))
    }
}

fn after_last<F: QueryFilter>(world: &mut World) -> Order {
    let mut orders = world.query_filtered::<&Order, F>();
    orders.iter(world).max().map_or(Order(0), |last| next(*last))
}

fn next(order: Order) -> Order {
    Order(order.0.saturating_add(1))
}

fn boards_moved_up(world: &mut World, place: Order) -> Vec<ComponentEdit<Order>> {
    let mut boards = world.query_filtered::<(Entity, &Order), With<Checkerboard>>();
    if boards.iter(world).all(|(_, &order)| order != place) {
        return Vec::new();
    }
    let behind = boards.iter(world).filter(|&(_, &order)| order >= place);
    let moved = behind.map(|(entity, &order)| {
        let (before, after) = (Some(order), Some(next(order)));
        ComponentEdit { entity, before, after }
    });
    moved.collect()
}

fn spawn_object(world: &mut World, shape: impl Component, position: DVec3) -> Entity {
    let count = world.query_filtered::<(), IsSolid>().iter(world).count();
    let color = COLORS[count % COLORS.len()];
    world.spawn((shape, Position(position), Color(color), Ambient(0.2), Diffuse(0.8))).id()
}

/// The first board is the ground; another one goes below it.
fn spawn_board(world: &mut World, place: Place) -> Entity {
    let mut boards = world.query_filtered::<&Position, With<Checkerboard>>();
    let lowest = boards.iter(world).map(|position| position.0.z).reduce(f64::min);
    let height = lowest.map_or(0.0, |lowest| lowest - place.size);
    let shape = Checkerboard { cell: place.size };
    world.spawn((shape, Position::new(0.0, 0.0, height), Ambient(0.2), Diffuse(0.8))).id()
}

/// Lights hang above the middle of the picture.
fn spawn_light(world: &mut World, place: Place) -> Entity {
    world.spawn((Light, Position(place.point + DVec3::Z * 3.0 * place.size))).id()
}

/// From an entity to the place of its copy: along the axis that runs to the right in the picture, boards downwards.
fn beside(world: &mut World, entity: Entity) -> DVec3 {
    let size = in_front(world).size;
    let mut cameras = world.query::<&CameraPose>();
    let right = cameras.iter(world).next().map_or(DVec3::X, |pose| nearest_axis(pose.r));
    let entity = world.entity(entity);
    if let Some(board) = entity.get::<Checkerboard>() {
        return -DVec3::Z * board.cell;
    }
    let sphere = entity.get::<Sphere>().map(|sphere| 2.0 * sphere.radius);
    let cube = entity.get::<Cube>().map(|cube| cube.side);
    let pyramid = entity.get::<Pyramid>().map(|pyramid| pyramid.width);
    right * sphere.or(cube).or(pyramid).unwrap_or(size)
}

fn nearest_axis(direction: DVec3) -> DVec3 {
    let axes = [DVec3::X, DVec3::Y, DVec3::Z].into_iter().flat_map(|axis| [axis, -axis]);
    let nearest = axes.max_by(|a, b| a.dot(direction).total_cmp(&b.dot(direction)));
    nearest.unwrap_or(DVec3::X)
}

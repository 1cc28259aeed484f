//! [`Description`] to entities and back: the one file that knows both.

use core::mem::{Discriminant, discriminant};

use bevy_ecs::prelude::*;
use thiserror::Error;

use crate::components::{
    Ambient, CameraPose, Checkerboard, Color, Cube, Diffuse, Falloff, Gloss, Lens, Light, Mirror, Order,
    Position, Pyramid, Snapshot, Sphere, SpotCone,
};

use super::description::{
    BoardDescription, Description, LightDescription, ObjectDescription, ShapeDescription, SpotDescription,
    SurfaceDescription,
};

/// Spawns everything in a description, the camera in its starting pose, and sets [`Snapshot`]. An effect whose
/// coefficient is 0 becomes no component.
pub fn spawn(world: &mut World, description: &Description) {
    let Description { near, far, fovy, aspect, level, pixels, .. } = *description;
    world.insert_resource(Snapshot { pixels, level });
    world.spawn((CameraPose::default(), Lens { near, far, fovy, aspect }));
    let mut order = 0;
    for objects in description.objects.chunk_by(|a, b| kind(a) == kind(b)) {
        spawn_alike(world, order, objects);
        order = u32::try_from(objects.len()).map_or(u32::MAX, |count| order.saturating_add(count));
    }
    // The board comes last: at the same distance an object shows in front of it.
    spawn_board(world, Order(order), &description.board);
    let points = description.lights.iter().map(|light| (light, None));
    let spots = description.spots.iter().map(|spot| (&spot.light, Some(spot)));
    for (order, (light, spot)) in orders().zip(points.chain(spots)) {
        spawn_light(world, order, light, spot);
    }
}

fn orders() -> impl Iterator<Item = Order> {
    (0..).map(Order)
}

fn spawn_board(world: &mut World, order: Order, board: &BoardDescription) {
    let shape = Checkerboard { cell: board.cell };
    let mut entity = world.spawn((shape, order, Ambient(board.ambient), Diffuse(board.diffuse)));
    if let Some(mirror) = mirror(board.reflection) {
        entity.insert(mirror);
    }
}

/// Spawns objects that will have the same components, numbered from `first` on. At once: one by one, a million took an
/// eighth longer.
fn spawn_alike(world: &mut World, first: u32, objects: &[ObjectDescription]) {
    match objects.first().map(|object| object.shape) {
        Some(ShapeDescription::Sphere { .. }) => spawn_shaped(world, first, objects, |shape| match shape {
            ShapeDescription::Sphere { radius } => Some(Sphere { radius }),
            _ => None,
        }),
        Some(ShapeDescription::Cube { .. }) => spawn_shaped(world, first, objects, |shape| match shape {
            ShapeDescription::Cube { side } => Some(Cube { side }),
            _ => None,
        }),
        Some(ShapeDescription::Pyramid { .. }) => spawn_shaped(world, first, objects, |shape| match shape {
            ShapeDescription::Pyramid { width, height } => Some(Pyramid { width, height }),
            _ => None,
        }),
        None => {}
    }
}

/// Spawns each object with all that it will have: one that gains components later is moved from table to table.
fn spawn_shaped<S: Component>(
    world: &mut World,
    first: u32,
    objects: &[ObjectDescription],
    shape: impl Fn(ShapeDescription) -> Option<S>,
) {
    let bodies = (first..).map(Order).zip(objects).filter_map(|(order, object)| {
        let SurfaceDescription { color, ambient, diffuse, specular, reflection, shininess } = object.surface;
        let place = (Position(object.position), order);
        let look = (Color(color), Ambient(ambient), Diffuse(diffuse));
        Some(((shape(object.shape)?, place, look), Gloss { specular, shininess }, Mirror(reflection)))
    });
    let Some((_, has_gloss, has_mirror)) = objects.first().map(kind) else { return };
    match (has_gloss, has_mirror) {
        (false, false) => drop(world.spawn_batch(bodies.map(|(body, ..)| body))),
        (true, false) => drop(world.spawn_batch(bodies.map(|(body, gloss, _)| (body, gloss)))),
        (false, true) => drop(world.spawn_batch(bodies.map(|(body, _, mirror)| (body, mirror)))),
        (true, true) => drop(world.spawn_batch(bodies)),
    }
}

/// What decides which components an object will have: its kind of shape, and whether it has gloss and is a mirror.
fn kind(object: &ObjectDescription) -> (Discriminant<ShapeDescription>, bool, bool) {
    let SurfaceDescription { specular, reflection, .. } = object.surface;
    (discriminant(&object.shape), specular != 0.0, reflection != 0.0)
}

fn mirror(reflection: f64) -> Option<Mirror> {
    (reflection != 0.0).then_some(Mirror(reflection))
}

fn spawn_light(world: &mut World, order: Order, light: &LightDescription, spot: Option<&SpotDescription>) {
    let mut entity = world.spawn((Light, Position(light.position), order));
    if light.falloff != 0.0 {
        entity.insert(Falloff(light.falloff));
    }
    if let Some(spot) = spot {
        entity.insert(SpotCone { target: spot.target, cutoff: spot.cutoff });
    }
}

/// Why a World has no scene file.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum DescribeError {
    /// A file has exactly one camera.
    #[error("a scene file has one camera, but the World has {0}")]
    Cameras(usize),
    /// A file has exactly one checkerboard.
    #[error("a scene file has one checkerboard, but the World has {0}")]
    Checkerboards(usize),
    /// The file's checkerboard is at the origin, white and without gloss.
    #[error("entity {0}: a scene file cannot move, tint or polish its checkerboard")]
    Board(Entity),
    /// An object or light lacks something that a file says of each.
    #[error("entity {0}: an object needs Position, Color, Ambient and Diffuse, a light needs Position")]
    Incomplete(Entity),
    /// An entity is one object.
    #[error("entity {0}: a scene file cannot give one object two shapes")]
    Shapes(Entity),
}

/// The description of a World, with objects and lights in their [`Order`] (those without one last, in the order of
/// their entities). Camera pose and texture are not part of a scene file and are left out.
///
/// Spawned again, it gives the same World if it came from a file: gloss without a specular part, a mirror that
/// reflects nothing and a falloff of 0 are not kept.
pub fn describe(world: &mut World) -> Result<Description, DescribeError> {
    refuse_incomplete(world)?;
    let Lens { near, far, fovy, aspect } = describe_lens(world)?;
    let Snapshot { pixels, level } = world.get_resource::<Snapshot>().copied().unwrap_or_default();
    let board = describe_board(world)?;
    let objects = describe_objects(world)?;
    let (lights, spots) = describe_lights(world);
    Ok(Description { near, far, fovy, aspect, level, pixels, board, objects, lights, spots })
}

fn refuse_incomplete(world: &mut World) -> Result<(), DescribeError> {
    type IsDescribed = Or<(With<Sphere>, With<Cube>, With<Pyramid>, With<Checkerboard>)>;
    type Lacking = Or<(Without<Position>, Without<Color>, Without<Ambient>, Without<Diffuse>)>;
    let mut objects = world.query_filtered::<Entity, (IsDescribed, Lacking)>();
    let mut lights = world.query_filtered::<Entity, (With<Light>, Without<Position>)>();
    let lacking = objects.iter(world).chain(lights.iter(world)).next();
    lacking.map_or(Ok(()), |entity| Err(DescribeError::Incomplete(entity)))
}

fn describe_lens(world: &mut World) -> Result<Lens, DescribeError> {
    let mut lenses = world.query_filtered::<&Lens, With<CameraPose>>();
    lenses.single(world).copied().map_err(|_| DescribeError::Cameras(lenses.iter(world).len()))
}

fn describe_board(world: &mut World) -> Result<BoardDescription, DescribeError> {
    let mut boards = world.query::<(Entity, &Checkerboard, &Position, &Color, SurfaceParts)>();
    let count = boards.iter(world).count();
    let Ok((entity, board, position, color, surface)) = boards.single(world) else {
        return Err(DescribeError::Checkerboards(count));
    };
    let (ambient, diffuse, gloss, mirror) = surface;
    if *position != Position::default() || *color != Color::default() || gloss.is_some() {
        return Err(DescribeError::Board(entity));
    }
    let reflection = mirror.map_or(0.0, |mirror| mirror.0);
    Ok(BoardDescription { cell: board.cell, ambient: ambient.0, diffuse: diffuse.0, reflection })
}

type SurfaceParts = (&'static Ambient, &'static Diffuse, Option<&'static Gloss>, Option<&'static Mirror>);
type Shapes = (Option<&'static Sphere>, Option<&'static Cube>, Option<&'static Pyramid>);
type IsObject = Or<(With<Sphere>, With<Cube>, With<Pyramid>)>;

fn describe_objects(world: &mut World) -> Result<Vec<ObjectDescription>, DescribeError> {
    let mut query =
        world.query_filtered::<(Entity, Option<&Order>, &Position, &Color, SurfaceParts, Shapes), IsObject>();
    let mut objects = Vec::new();
    for (entity, order, position, color, (ambient, diffuse, gloss, mirror), shapes) in query.iter(world) {
        let shape = match shapes {
            (Some(sphere), None, None) => ShapeDescription::Sphere { radius: sphere.radius },
            (None, Some(cube), None) => ShapeDescription::Cube { side: cube.side },
            (None, None, Some(pyramid)) => {
                ShapeDescription::Pyramid { width: pyramid.width, height: pyramid.height }
            }
            _ => return Err(DescribeError::Shapes(entity)),
        };
        let surface = SurfaceDescription {
            color: color.0,
            ambient: ambient.0,
            diffuse: diffuse.0,
            specular: gloss.map_or(0.0, |gloss| gloss.specular),
            reflection: mirror.map_or(0.0, |mirror| mirror.0),
            shininess: gloss.map_or(0.0, |gloss| gloss.shininess),
        };
        objects.push((place(order, entity), ObjectDescription { position: position.0, shape, surface }));
    }
    Ok(in_order(objects))
}

fn describe_lights(world: &mut World) -> (Vec<LightDescription>, Vec<SpotDescription>) {
    let mut query = world.query_filtered::<LightParts, With<Light>>();
    let (mut lights, mut spots) = (Vec::new(), Vec::new());
    for (entity, order, position, falloff, cone) in query.iter(world) {
        let light =
            LightDescription { position: position.0, falloff: falloff.map_or(0.0, |falloff| falloff.0) };
        let place = place(order, entity);
        match cone {
            Some(&SpotCone { target, cutoff }) => {
                spots.push((place, SpotDescription { light, target, cutoff }));
            }
            None => lights.push((place, light)),
        }
    }
    (in_order(lights), in_order(spots))
}

type LightParts =
    (Entity, Option<&'static Order>, &'static Position, Option<&'static Falloff>, Option<&'static SpotCone>);

/// Scene order, then age: an entity's own ordering says nothing about which was spawned first.
type Place = (u32, u32);

fn place(order: Option<&Order>, entity: Entity) -> Place {
    (order.map_or(u32::MAX, |order| order.0), entity.index_u32())
}

fn in_order<I>(mut items: Vec<(Place, I)>) -> Vec<I> {
    items.sort_by_key(|&(place, _)| place);
    items.into_iter().map(|(_, item)| item).collect()
}

//! Changes of a whole scene, camera included, that a picture must not show.

use archetrace::components::{
    Absorption, Aperture, AreaLight, CameraPose, Checkerboard, Cube, Falloff, Fog, Lens, Position, Pyramid,
    Sphere, SpotCone, Velocity,
};
use archetrace::scene::{ObjectDescription, ShapeDescription};
use bevy_ecs::component::Mutable;
use bevy_ecs::prelude::*;
use glam::DVec3;

use crate::support::case::Case;

/// Everything larger by a factor.
pub(crate) fn scaled(case: &Case, factor: f64) -> Case {
    let mut case = case.clone();
    let scene = &mut case.description;
    scene.near *= factor;
    scene.far *= factor;
    scene.board.cell *= factor;
    for object in &mut scene.objects {
        match &mut object.shape {
            ShapeDescription::Sphere { radius: length } | ShapeDescription::Cube { side: length } => {
                *length *= factor;
            }
            ShapeDescription::Pyramid { width, height } => {
                *width *= factor;
                *height *= factor;
            }
        }
    }
    let lights = scene.lights.iter_mut();
    for light in lights.chain(scene.spots.iter_mut().map(|spot| &mut spot.light)) {
        light.falloff /= factor * factor;
    }
    for_points(&mut case, |point| *point *= factor);
    case
}

/// Everything in a World larger by a factor; what is so much per length is less by it.
pub(crate) fn scale_world(world: &mut World, factor: f64) {
    each::<Position>(world, |position| position.0 *= factor);
    each::<Sphere>(world, |sphere| sphere.radius *= factor);
    each::<Cube>(world, |cube| cube.side *= factor);
    each::<Pyramid>(world, |pyramid| {
        pyramid.width *= factor;
        pyramid.height *= factor;
    });
    each::<Checkerboard>(world, |board| board.cell *= factor);
    each::<Velocity>(world, |velocity| velocity.0 *= factor);
    each::<Absorption>(world, |absorption| absorption.0 /= factor);
    each::<Fog>(world, |fog| fog.density /= factor);
    each::<Falloff>(world, |falloff| falloff.0 /= factor * factor);
    each::<SpotCone>(world, |cone| cone.target *= factor);
    each::<AreaLight>(world, |area| area.radius *= factor);
    each::<CameraPose>(world, |pose| pose.position *= factor);
    each::<Lens>(world, |lens| {
        lens.near *= factor;
        lens.far *= factor;
    });
    each::<Aperture>(world, |aperture| {
        aperture.radius *= factor;
        aperture.focus *= factor;
    });
}

fn each<C: Component<Mutability = Mutable>>(world: &mut World, change: impl Fn(&mut C)) {
    for mut component in world.query::<&mut C>().iter_mut(world) {
        change(&mut component);
    }
}

/// Everything moved.
pub(crate) fn moved(case: &Case, by: DVec3) -> Case {
    let mut case = case.clone();
    for_points(&mut case, |point| *point += by);
    case
}

/// Everything mirrored, x to -x. The picture is flipped.
pub(crate) fn mirrored_x(case: &Case) -> Case {
    let flip = |v: DVec3| DVec3::new(-v.x, v.y, v.z);
    let mut case = turned(case, flip);
    // A camera stays right-handed.
    case.pose.r = -case.pose.r;
    case
}

/// Everything turned by a quarter about z, x to y.
pub(crate) fn quarter_turned(case: &Case) -> Case {
    turned(case, |v: DVec3| DVec3::new(-v.y, v.x, v.z))
}

/// Everything taken to where `map` takes it: a linear map that keeps z and takes axes to axes.
fn turned(case: &Case, map: impl Fn(DVec3) -> DVec3) -> Case {
    let mut case = case.clone();
    for object in &mut case.description.objects {
        object.position = least_corner(object, &map);
    }
    // The white cell from the origin is a corner, too.
    let cell = case.description.board.cell;
    case.board_origin = map(case.board_origin).min(map(case.board_origin + DVec3::new(cell, cell, 0.0)));
    for light in &mut case.description.lights {
        light.position = map(light.position);
    }
    for spot in &mut case.description.spots {
        spot.light.position = map(spot.light.position);
        spot.target = map(spot.target);
    }
    let pose = &mut case.pose;
    for vector in [&mut pose.position, &mut pose.l, &mut pose.r, &mut pose.u] {
        *vector = map(*vector);
    }
    case
}

/// Where the point that places an object comes to lie.
fn least_corner(object: &ObjectDescription, map: impl Fn(DVec3) -> DVec3) -> DVec3 {
    let width = match object.shape {
        ShapeDescription::Sphere { .. } => 0.0,
        ShapeDescription::Cube { side } => side,
        ShapeDescription::Pyramid { width, .. } => width,
    };
    let opposite = object.position + DVec3::new(width, width, 0.0);
    map(object.position).min(map(opposite))
}

fn for_points(case: &mut Case, mut change: impl FnMut(&mut DVec3)) {
    let scene = &mut case.description;
    for object in &mut scene.objects {
        change(&mut object.position);
    }
    for light in &mut scene.lights {
        change(&mut light.position);
    }
    for spot in &mut scene.spots {
        change(&mut spot.light.position);
        change(&mut spot.target);
    }
    change(&mut case.pose.position);
    change(&mut case.board_origin);
}

//! Cameras that look at a scene from where it is hard.

use archetrace::components::{CameraPose, Cube, Lens, Position, Pyramid, Sphere};
use bevy_ecs::prelude::*;
use glam::DVec3;

use super::support::random::Random;

/// A view: what it is good for, the pose, the lens.
pub(crate) type View = (String, CameraPose, Lens);

/// A point within an object, and about how large it is.
type Target = (DVec3, f64);

/// At least sixteen views of a World: the start, by hand around its objects, and at random.
pub(crate) fn views(world: &mut World, seed: u64) -> Vec<View> {
    let random = &mut Random::new(seed);
    let lens = *world.query::<&Lens>().single(world).unwrap();
    let targets = targets(world);
    let mut views = vec![
        ("start".to_owned(), CameraPose::default(), lens),
        view("down", DVec3::new(3.0, -7.0, 400.0), DVec3::new(0.1, 0.2, -1.0), lens),
        view("below", DVec3::new(31.0, -120.0, -35.0), DVec3::new(-0.2, 1.0, 0.25), lens),
        view("grazing", DVec3::new(-17.0, -90.0, 0.25), DVec3::new(0.1, 1.0, 0.0), lens),
        view("far away", DVec3::new(-3000.0, -9000.0, 2000.0), DVec3::new(3000.0, 9000.0, -1990.0), lens),
    ];
    let wide = Lens { fovy: 130.0, aspect: 0.6, ..lens };
    views.push(("wide".to_owned(), CameraPose::default(), wide));
    for &(center, size) in targets.iter().take(3) {
        let from = random.direction();
        views.push(view("inside", center + 0.05 * size * from, random.direction(), lens));
        // The near plane runs through the object, the far plane through the scene.
        let distance = 3.0 * size;
        let cut = Lens { near: distance, far: 1.5 * distance, ..lens };
        views.push(view("cut", center - distance * from, from, cut));
        views.push(view("close", center - 1.2 * size * from, from, Lens { near: 0.01 * size, ..lens }));
    }
    while views.len() < 20 {
        views.push(random_view(random, &targets, lens));
    }
    views
}

fn view(name: &str, position: DVec3, look: DVec3, lens: Lens) -> View {
    (name.to_owned(), CameraPose::looking(position, look, DVec3::Z).unwrap(), lens)
}

fn random_view(random: &mut Random, targets: &[Target], lens: Lens) -> View {
    let (center, size) = if targets.is_empty() { (DVec3::ZERO, 30.0) } else { random.pick(targets) };
    let mut position = center + random.direction() * size * random.pick(&[1.5, 4.0, 10.0, 40.0]);
    if !random.one_in(4) {
        position.z = position.z.abs();
    }
    let look = center + random.direction() * 0.5 * size - position;
    let up = if random.one_in(2) { DVec3::Z } else { random.direction() };
    let lens = if lens.fovy < 1.0 { Lens { fovy: random.pick(&[0.1, 1.0, 60.0]), ..lens } } else { lens };
    ("random".to_owned(), CameraPose::looking(position, look, up).unwrap(), lens)
}

/// The middle and size of every object that ends somewhere, smallest first.
fn targets(world: &mut World) -> Vec<Target> {
    type Shapes<'a> = (Option<&'a Sphere>, Option<&'a Cube>, Option<&'a Pyramid>);
    let mut objects = world.query::<(&Position, Shapes<'static>)>();
    let target = |(position, shapes): (&Position, Shapes<'_>)| match shapes {
        (Some(Sphere { radius }), ..) => Some((position.0, 2.0 * radius)),
        (_, Some(Cube { side }), _) => Some((position.0 + DVec3::splat(0.5 * side), *side)),
        (_, _, Some(Pyramid { width, height })) => {
            let middle = position.0 + DVec3::new(0.5 * width, 0.5 * width, 0.25 * height);
            Some((middle, width.min(*height)))
        }
        _ => None,
    };
    let mut targets: Vec<Target> = objects.iter(world).filter_map(target).collect();
    targets.sort_by(|(_, a), (_, b)| a.total_cmp(b));
    targets
}

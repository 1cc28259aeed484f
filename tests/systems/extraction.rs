//! Tables: what the World holds, in an order of their own, rebuilt only when they must be.

use std::sync::Arc;

use archetrace::components::{
    Ambient, Checkerboard, Color, Cube, Diffuse, Falloff, Gloss, Light, Mirror, Order, Position, Pyramid,
    Sphere, SpotCone, Textured,
};
use archetrace::effects::Effect;
use archetrace::geometry::Vector;
use archetrace::systems::{Tables, extract_schedule, prepare};
use archetrace::trace::{SceneTables, ShapeColumns};
use bevy_ecs::prelude::*;
use bevy_ecs::schedule::Schedule;
use glam::DVec3;

use crate::support::parts::rebuilt;
use crate::support::random::Random;
use crate::support::scenes::{full_case, textured_case};
use crate::support::tracing::workers;

/// A World, prepared, with the schedule that fills its tables.
struct Extracted {
    world: World,
    schedule: Schedule,
}

impl Extracted {
    fn new(mut world: World) -> Self {
        prepare::<f64>(&mut world, workers(1));
        let mut extracted = Self { world, schedule: extract_schedule::<f64>() };
        extracted.run();
        extracted
    }

    fn run(&mut self) {
        self.schedule.run(&mut self.world);
    }

    fn scene(&self) -> &SceneTables<f64> {
        &self.world.resource::<Tables<f64>>().scene
    }

    /// Empties every table behind the back of the systems: what is full after the next run was rebuilt.
    fn empty_tables(&mut self) {
        self.world.resource_mut::<Tables<f64>>().scene = Arc::new(SceneTables::default());
    }

    /// Rows of each table: spheres, cubes, pyramids, checkerboards, lights.
    fn rows(&self) -> [usize; 5] {
        self.scene().table_counts().map(|count| count.rows)
    }

    /// An entity with a component of this kind.
    fn first<C: Component>(&mut self) -> Entity {
        self.world.query_filtered::<Entity, With<C>>().iter(&self.world).next().unwrap()
    }
}

const FULL: [usize; 5] = [3, 3, 2, 1, 5];

#[test]
fn every_row_is_what_its_entity_says() {
    let mut world = World::new();
    let position = DVec3::new(1.0, 2.0, 3.0);
    let gloss = Gloss { specular: 0.3, shininess: 9.0 };
    let look = (Color::new(0.1, 0.2, 0.3), Ambient(0.4), Diffuse(0.5), gloss, Mirror(0.6));
    world.spawn((Sphere { radius: 4.0 }, Position(position), look, Order(7)));
    world.spawn((Cube { side: 5.0 }, Position(position)));
    world.spawn((Pyramid { width: 6.0, height: 8.0 }, Position(position)));
    world.spawn((Checkerboard { cell: 2.0 }, Position(position)));
    let target = DVec3::new(9.0, 2.0, 3.0);
    world.spawn((Light, Position(position), Falloff(0.01), SpotCone { target, cutoff: 30.0 }));
    let extracted = Extracted::new(world);
    let scene = extracted.scene();

    let point = Vector::from_dvec3(position);
    let sphere = scene.spheres.shapes.shape(0);
    assert_eq!((sphere.center, sphere.radius), (point, 4.0));
    assert_eq!(scene.spheres.order, [7]);
    let surface = scene.spheres.surfaces.row(0);
    assert_eq!(surface.color.to_f64(), [0.1, 0.2, 0.3]);
    assert_eq!((surface.ambient, surface.diffuse, surface.effects.mirror), (0.4, 0.5, Some(0.6)));
    let row = surface.effects.gloss.unwrap();
    assert_eq!((row.specular, row.shininess), (0.3, 9.0));

    let cube = scene.cubes.shapes.shape(0);
    assert_eq!((cube.min, cube.max), (point, Vector::new(6.0, 7.0, 8.0)));
    let plain = scene.cubes.surfaces.row(0);
    assert_eq!(plain.color.to_f64(), [1.0; 3]);
    assert_eq!((plain.ambient, plain.diffuse, plain.effects.mirror), (0.0, 0.0, None));
    assert!(plain.effects.gloss.is_none());
    assert_eq!(scene.pyramids.shapes.shape(0).apex, Vector::new(4.0, 5.0, 11.0));
    assert_eq!(scene.boards.shapes.shape(0).height, 3.0);
    let light = scene.lights.row(0);
    assert_eq!((light.position, light.effects.falloff), (point, Some(0.01)));
    assert!(light.effects.spot_cone.unwrap().contains(Vector::new(1.0, 0.5, 0.0)));
    assert!(!light.effects.spot_cone.unwrap().contains(Vector::new(1.0, 0.6, 0.0)));
}

#[test]
fn rows_are_in_scene_order_and_those_without_come_last_by_value() {
    let spheres = [(3.0, Some(9)), (4.0, None), (1.0, None), (8.0, Some(2)), (2.0, None)];
    for seed in 1..=5 {
        let mut shuffled = spheres;
        Random::new(seed).shuffle(&mut shuffled);
        let mut world = World::new();
        for (radius, order) in shuffled {
            let mut entity = world.spawn(Sphere { radius });
            if let Some(order) = order {
                entity.insert(Order(order));
            }
        }
        let extracted = Extracted::new(world);
        let table = &extracted.scene().spheres;
        let radii: Vec<f64> = (0..5).map(|row| table.shapes.shape(row).radius).collect();
        assert_eq!(radii, [8.0, 3.0, 1.0, 2.0, 4.0], "seed {seed}");
        assert_eq!(table.order, [2, 9, u32::MAX, u32::MAX, u32::MAX]);
    }
}

#[test]
fn lights_are_in_scene_order_and_those_without_come_last_by_value() {
    let lights = [(3.0, Some(9)), (4.0, None), (1.0, None), (8.0, Some(2)), (2.0, None)];
    for seed in 1..=5 {
        let mut shuffled = lights;
        Random::new(seed).shuffle(&mut shuffled);
        let mut world = World::new();
        for (x, order) in shuffled {
            let mut entity = world.spawn((Light, Position::new(x, 0.0, 0.0)));
            if let Some(order) = order {
                entity.insert(Order(order));
            }
        }
        let extracted = Extracted::new(world);
        let table = &extracted.scene().lights;
        let places: Vec<f64> = (0..5).map(|row| table.row(row).position.x).collect();
        assert_eq!(places, [8.0, 3.0, 1.0, 2.0, 4.0], "seed {seed}");
    }
}

#[test]
fn tables_do_not_depend_on_where_the_world_keeps_its_entities() {
    let mut world = textured_case().world();
    let usual = format!("{:?}", Extracted::new(textured_case().world()).scene());
    for seed in 1..=5 {
        let other = rebuilt(&mut world, |parts| Random::new(seed).shuffle(parts));
        let other = Extracted::new(other);
        assert_eq!(other.rows(), FULL);
        assert!(format!("{:?}", other.scene()) == usual, "seed {seed}: tables differ");
    }
}

#[test]
fn what_would_show_nothing_gets_no_row() {
    let mut world = World::new();
    let gloss = Gloss { specular: 0.0, shininess: 5.0 };
    world.spawn((Sphere { radius: 1.0 }, Mirror(0.0), gloss));
    let cone = SpotCone { target: DVec3::X, cutoff: 180.0 };
    world.spawn((Light, Falloff(0.0), cone));
    let extracted = Extracted::new(world);
    assert_eq!(extracted.rows(), [1, 0, 0, 0, 1]);
    for count in extracted.scene().effect_counts() {
        assert_eq!(count.rows, 0, "{}", count.effect.name());
    }
}

#[test]
fn nothing_is_rebuilt_when_nothing_changed() {
    let mut extracted = Extracted::new(full_case().world());
    assert_eq!(extracted.rows(), FULL);
    extracted.empty_tables();
    for _ in 0..3 {
        extracted.run();
        assert_eq!(extracted.rows(), [0; 5]);
    }
}

#[test]
fn only_the_table_of_the_changed_kind_is_rebuilt() {
    fn check<C: Component>(rows: [usize; 5], change: impl Fn(&mut EntityWorldMut<'_>)) {
        let mut extracted = Extracted::new(full_case().world());
        let entity = extracted.first::<C>();
        extracted.empty_tables();
        change(&mut extracted.world.entity_mut(entity));
        extracted.run();
        assert_eq!(extracted.rows(), rows);
        extracted.empty_tables();
        extracted.run();
        assert_eq!(extracted.rows(), [0; 5], "a change counts once");
    }
    fn touch<C: Component<Mutability = bevy_ecs::component::Mutable>>(entity: &mut EntityWorldMut<'_>) {
        entity.get_mut::<C>().unwrap().set_changed();
    }
    let [spheres, cubes, pyramids, boards, lights] = FULL;
    check::<Sphere>([spheres, 0, 0, 0, 0], touch::<Position>);
    check::<Sphere>([spheres, 0, 0, 0, 0], touch::<Sphere>);
    check::<Sphere>([spheres, 0, 0, 0, 0], touch::<Color>);
    check::<Cube>([0, cubes, 0, 0, 0], touch::<Cube>);
    check::<Cube>([0, cubes, 0, 0, 0], touch::<Ambient>);
    check::<Pyramid>([0, 0, pyramids, 0, 0], touch::<Diffuse>);
    check::<Pyramid>([0, 0, pyramids, 0, 0], touch::<Order>);
    check::<Checkerboard>([0, 0, 0, boards, 0], touch::<Checkerboard>);
    check::<Light>([0, 0, 0, 0, lights], touch::<Position>);
    check::<SpotCone>([0, 0, 0, 0, lights], touch::<SpotCone>);
    check::<Cube>([0, cubes, 0, 0, 0], |entity| {
        entity.insert(Gloss { specular: 0.1, shininess: 1.0 });
    });
}

#[test]
fn a_component_that_nobody_reads_rebuilds_nothing() {
    #[derive(Component)]
    struct Name;
    let mut extracted = Extracted::new(full_case().world());
    extracted.empty_tables();
    let sphere = extracted.first::<Sphere>();
    extracted.world.entity_mut(sphere).insert(Name);
    extracted.world.spawn((Name, Position::default()));
    extracted.run();
    assert_eq!(extracted.rows(), [0; 5]);
}

#[test]
fn an_effect_that_no_entity_carries_leaves_no_column() {
    let mut extracted = Extracted::new(textured_case().world());
    let counts = |extracted: &Extracted| extracted.scene().effect_counts();
    let there = [Effect::Gloss, Effect::Mirror, Effect::Texture, Effect::Falloff, Effect::SpotCone];
    for count in counts(&extracted) {
        assert_eq!((count.rows > 0, count.bytes > 0), [there.contains(&count.effect); 2].into(), "{count:?}");
    }
    let entities = crate::support::parts::scene_entities(&mut extracted.world);
    for entity in entities {
        extracted.world.entity_mut(entity).remove::<(Gloss, Mirror, Textured, Falloff, SpotCone)>();
    }
    extracted.run();
    assert!(counts(&extracted).iter().all(|count| count.rows == 0 && count.bytes == 0));
    assert_eq!(extracted.rows(), FULL);
}

//! Worlds larger or smaller by powers of two: the same picture to the bit, whatever the World has, on every path.

use archetrace::components::Sampling;
use archetrace::geometry::{Real, Unit};
use archetrace::systems::Tables;
use bevy_ecs::prelude::World;

use crate::crowds::{CROWDS, crowd};
use crate::gallery::exhibits::{EXHIBITS, Exhibit};
use crate::gallery::small;
use crate::paths::check_world;
use crate::support::picture::assert_same;
use crate::support::scenes::random_case;
use crate::support::tracing::trace;
use crate::transforms::scale_world;

const EXPONENTS: [i32; 4] = [-190, -60, 60, 190];

fn scaled_to(mut world: World, exponent: i32) -> World {
    scale_world(&mut world, 2_f64.powi(exponent));
    world
}

#[test]
fn r06_no_effect_has_a_length_of_its_own() {
    fn check<T: Real>(exhibit: &Exhibit, side: u32) {
        let world = || {
            let mut world = small(exhibit);
            world.insert_resource(Sampling { side });
            world
        };
        let usual = trace::<T>(&mut world());
        for exponent in EXPONENTS {
            let mut other = scaled_to(world(), exponent);
            let traced = trace::<T>(&mut other);
            let name = format!("{}: {} scaled by 2^{exponent}", T::NAME, exhibit.name);
            assert_same(&name, &usual.picture, &traced.picture);
            assert_eq!(usual.counts, traced.counts, "{name}");
            let is_usual = other.resource::<Tables<T>>().scene.unit == Unit::WORLD;
            // Double precision holds all of these as they are.
            assert_eq!(is_usual, T::NAME == "f64", "{name}");
        }
    }
    for exhibit in EXHIBITS {
        // Lens and shutter take several samples.
        let side = if exhibit.name == "all" { 4 } else { 2 };
        check::<f64>(exhibit, side);
        check::<f32>(exhibit, side);
    }
}

/// The picture of a World on every path, and of the same World scaled.
fn check_paths<T: Real>(name: &str, world: impl Fn() -> World) {
    let usual = check_world::<T>(name, world());
    for exponent in [-60, 60] {
        let name = format!("{name} scaled by 2^{exponent}");
        let other = check_world::<T>(&name, scaled_to(world(), exponent));
        assert!(usual == other, "{}: {name}", T::NAME);
    }
}

#[test]
fn r06_scaled_scenes_are_the_same_to_the_bit_on_every_path() {
    for seed in 1..=12 {
        let world = || random_case(0x6_0000 + seed, 37).world();
        check_paths::<f64>(&format!("random scene {seed}"), world);
        check_paths::<f32>(&format!("random scene {seed}"), world);
    }
}

#[test]
fn r06_scaled_crowds_are_the_same_to_the_bit_with_trees_and_without() {
    for kind in CROWDS {
        let world = || crowd(kind, 150, 77, 25).world();
        check_paths::<f64>(&format!("{kind:?}"), world);
        check_paths::<f32>(&format!("{kind:?}"), world);
    }
}

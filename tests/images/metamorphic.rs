//! Changes that must not show: not in one bit of the film.

use archetrace::components::Order;
use archetrace::geometry::Real;
use bevy_ecs::prelude::*;
use glam::DVec3;

use crate::support::case::Case;
use crate::support::parts::{Parts, rebuilt, scene_entities, take_parts};
use crate::support::picture::{Picture, assert_same, assert_same_levels};
use crate::support::random::Random;
use crate::support::scenes::{full_case, textured_case};
use crate::support::tracing::{trace, trace_with, workers};
use crate::transforms::{mirrored_x, moved, quarter_turned, scaled};

fn picture<T: Real>(case: &Case) -> Picture {
    let traced = trace::<T>(&mut case.world());
    let variety = traced.picture.variety();
    assert!(variety > 1000, "the scene shows only {variety} colours");
    assert!(traced.counts.rays.mirror > 1000, "the scene mirrors too little");
    traced.picture
}

fn assert_scale_shows_nowhere<T: Real>() {
    for case in [full_case(), textured_case()] {
        let usual = picture::<T>(&case);
        for exponent in [-60, -20, 20, 60] {
            let factor = 2_f64.powi(exponent);
            let other = picture::<T>(&scaled(&case, factor));
            assert_same(&format!("{} scaled by 2^{exponent}", T::NAME), &usual, &other);
        }
    }
}

#[test]
fn powers_of_two_as_scale_do_not_show() {
    assert_scale_shows_nowhere::<f64>();
    assert_scale_shows_nowhere::<f32>();
}

#[test]
fn powers_of_ten_as_scale_do_not_show_in_8_bits() {
    for case in [full_case(), textured_case()] {
        let usual = picture::<f64>(&case);
        for factor in [1e-6, 1e6] {
            let other = picture::<f64>(&scaled(&case, factor));
            assert_same_levels(&format!("scaled by {factor:e}"), &usual, &other);
        }
    }
}

#[test]
fn moving_by_whole_cells_does_not_show_in_8_bits() {
    let case = full_case();
    let by = DVec3::new(1024.0, 2048.0, 0.0);
    let with_origin = moved(&case, by);
    // The same pattern with its origin where it was: both are even numbers of cells.
    let without = Case { board_origin: DVec3::ZERO, ..with_origin.clone() };
    assert!([by.x, by.y].iter().all(|by| by % (2.0 * case.description.board.cell) == 0.0));
    let usual = picture::<f64>(&case);
    assert_same_levels("moved with the board", &usual, &picture::<f64>(&with_origin));
    assert_same_levels("moved over the board", &usual, &picture::<f64>(&without));
}

#[test]
fn mirroring_flips_the_picture() {
    fn check<T: Real>() {
        let case = full_case();
        let other = picture::<T>(&mirrored_x(&case));
        let name = format!("{} mirrored", T::NAME);
        assert_same(&name, &picture::<T>(&case), &other.flipped());
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn a_quarter_turn_does_not_show() {
    fn check<T: Real>() {
        let case = full_case();
        let mut other = case.clone();
        for quarter in 1..4 {
            other = quarter_turned(&other);
            let name = format!("{} turned by {quarter} quarters", T::NAME);
            assert_same(&name, &picture::<T>(&case), &picture::<T>(&other));
        }
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn a_transform_is_no_identity() {
    // Were these equal, the tests above would say nothing.
    let case = full_case();
    let usual = picture::<f64>(&case);
    assert_ne!(usual, usual.flipped());
    let moved_by_a_cell = Case { board_origin: DVec3::ZERO, ..moved(&case, DVec3::new(32.0, 0.0, 0.0)) };
    assert_ne!(usual, picture::<f64>(&moved_by_a_cell));
    let mut turned = quarter_turned(&case);
    turned.pose = case.pose;
    assert_ne!(usual, picture::<f64>(&turned));
}

/// The same entities, spawned in another order.
fn shuffled(world: &mut World, seed: u64, keep: impl Fn(Order) -> Option<Order>) -> World {
    rebuilt(world, |parts| {
        Random::new(seed).shuffle(parts);
        for part in parts {
            part.order = part.order.and_then(&keep);
        }
    })
}

#[test]
fn the_order_of_spawning_does_not_show() {
    fn check<T: Real>() {
        let case = full_case();
        let usual = picture::<T>(&case);
        for seed in 1..=4 {
            let mut other = shuffled(&mut case.world(), seed, Some);
            let name = format!("{} spawned in order {seed}", T::NAME);
            assert_same(&name, &usual, &trace::<T>(&mut other).picture);
        }
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn without_order_the_order_of_spawning_does_not_show_either() {
    fn check<T: Real>() {
        let case = full_case();
        let usual = trace::<T>(&mut shuffled(&mut case.world(), 0, |_| None)).picture;
        for seed in 1..=4 {
            let mut other = shuffled(&mut case.world(), seed, |_| None);
            let name = format!("{} without Order, spawned in order {seed}", T::NAME);
            assert_same(&name, &usual, &trace::<T>(&mut other).picture);
        }
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn twins_without_order_show_the_same_whichever_was_first() {
    // Two cubes in one place that differ in one value each time: ties go by value, not by storage.
    let case = full_case();
    let changes: [fn(&mut Parts); 4] = [
        |part| part.color.as_mut().unwrap().0.y = 0.123,
        |part| part.ambient.as_mut().unwrap().0 = 0.456,
        |part| part.mirror.as_mut().unwrap().0 = 0.789,
        |part| part.gloss.as_mut().unwrap().shininess = 3.0,
    ];
    for (index, change) in changes.into_iter().enumerate() {
        let pictures = [1, 2, 3].map(|seed| {
            let mut world = case.world();
            let shiny_cube = |part: &Parts| part.cube.is_some() && part.gloss.is_some();
            let mut twin = take_parts(&mut world).into_iter().find(shiny_cube).unwrap();
            change(&mut twin);
            twin.spawn(&mut world);
            trace::<f64>(&mut shuffled(&mut world, seed, |_| None)).picture
        });
        let name = format!("twins without Order, change {index}");
        assert_same(&name, &pictures[0], &pictures[1]);
        assert_same(&name, &pictures[0], &pictures[2]);
    }
}

#[test]
fn despawning_and_spawning_again_does_not_show() {
    fn check<T: Real>() {
        let case = full_case();
        let mut world = case.world();
        let entities = scene_entities(&mut world);
        for entity in entities.into_iter().step_by(2) {
            let parts = Parts::of(world.entity(entity));
            world.despawn(entity);
            parts.spawn(&mut world);
        }
        let other = trace::<T>(&mut world).picture;
        assert_same("despawned and spawned again", &picture::<T>(&case), &other);
    }
    check::<f64>();
    check::<f32>();
}

#[derive(Component)]
struct Marker;

#[test]
fn a_marker_component_does_not_show() {
    fn check<T: Real>() {
        let case = full_case();
        let usual = picture::<T>(&case);
        let mut world = case.world();
        let entities = scene_entities(&mut world);
        for &entity in entities.iter().step_by(3) {
            world.entity_mut(entity).insert(Marker);
        }
        assert_same("marked", &usual, &trace::<T>(&mut world).picture);
        for &entity in entities.iter().step_by(2) {
            world.entity_mut(entity).remove::<Marker>();
        }
        assert_same("marks removed", &usual, &trace::<T>(&mut world).picture);
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn threads_and_tiles_do_not_show() {
    fn check<T: Real>() {
        let case = textured_case();
        let usual = trace::<T>(&mut case.world());
        for threads in [1, 2, 3, 7] {
            for tile in [1, 7, 8, 32, 64, 1000] {
                let workers = workers(threads).with_tile_size(tile);
                let other = trace_with::<T>(&mut case.world(), workers);
                let name = format!("{} by {threads} threads in tiles of {tile}", T::NAME);
                assert_same(&name, &usual.picture, &other.picture);
                assert_eq!(usual.counts, other.counts, "{name}");
            }
        }
    }
    check::<f64>();
    check::<f32>();
}

use bevy_ecs::prelude::*;
use glam::DVec3;

use crate::components::{
    Ambient, CameraPose, Checkerboard, Diffuse, Gloss, Lens, Light, Mirror, Position, Snapshot, Sphere,
    SpotCone,
};
use crate::effects::Effect;
use crate::film::Film;
use crate::systems::{Muted, Workers, prepare};

use super::{Ablation, Difference, ablate, draw_bars};

fn film(levels: [[f64; 3]; 4]) -> Film {
    let mut film = Film::new(2).unwrap();
    let mut levels = levels.into_iter();
    for pixel in film.pixels_mut() {
        *pixel = levels.next().unwrap().map(|level| (level + 0.5) / 255.0);
    }
    film
}

#[test]
fn differences_are_those_counted_by_hand() {
    let black = film([[0.0; 3]; 4]);
    let other = film([[0.0; 3], [1.0, 0.0, 0.0], [0.0, 9.0, 0.0], [0.0, 3.0, 51.0]]);
    let difference = Difference::between(&black, &other).unwrap();
    assert_eq!((difference.worst_level, difference.over1, difference.over8), (51, 0.5, 0.5));
    let squares = difference.rmse.powi(2) * 12.0 * 255.0_f64.powi(2);
    assert_eq!(squares.round(), 1.0 + 81.0 + 9.0 + 51.0 * 51.0);
    // Half of a decibel is 6 % of an amplitude.
    assert_eq!(difference.psnr_db().round(), 25.0);
}

#[test]
fn equal_pictures_do_not_differ_and_others_cannot_be_compared() {
    let picture = film([[7.0; 3]; 4]);
    let difference = Difference::between(&picture, &picture).unwrap();
    assert_eq!(difference, Difference::default());
    assert_eq!(difference.psnr_db(), f64::INFINITY);
    assert_eq!(Difference::between(&picture, &Film::new(3).unwrap()), None);
    assert_eq!(Difference::between(&Film::default(), &Film::default()), None);
}

/// A mirror under a lamp and a spotlight that lights half of the board.
fn world() -> World {
    let mut world = World::new();
    let lens = Lens { near: 1.0, far: 1000.0, fovy: 60.0, aspect: 1.0 };
    world.spawn((CameraPose::default(), lens));
    world.spawn((
        Sphere { radius: 20.0 },
        Position::new(0.0, 0.0, 30.0),
        Ambient(0.2),
        Diffuse(0.4),
        Mirror(0.4),
    ));
    world.spawn((
        Checkerboard { cell: 10.0 },
        Ambient(0.5),
        Diffuse(0.5),
        Gloss { specular: 0.0, shininess: 1.0 },
    ));
    world.spawn((Light, Position::new(0.0, -50.0, 200.0)));
    let cone = SpotCone { target: DVec3::ZERO, cutoff: 10.0 };
    world.spawn((Light, Position::new(100.0, 0.0, 100.0), cone));
    world.insert_resource(Snapshot { pixels: 24, level: 3 });
    prepare::<f64>(&mut world, Workers::new(None).unwrap());
    world
}

fn priced(rounds: u32) -> (Ablation, World) {
    let mut world = world();
    // Every look at the clock is a millisecond after the one before.
    let mut now = 0.0;
    let mut frames = Vec::new();
    let clock = || {
        now += 1.0;
        now
    };
    let ablation = ablate::<f64>(&mut world, rounds, clock, |done, all| frames.push((done, all))).unwrap();
    // The frame as it is, without mirrors, without cones.
    let all = 3 * rounds;
    assert!(frames.into_iter().eq((1..=all).map(|done| (done, all))));
    (ablation, world)
}

#[test]
fn only_what_matters_is_taken_away() {
    let (ablation, world) = priced(2);
    assert_eq!((ablation.frame.median, ablation.frame.iqr), (1.0, 0.0));
    assert!(ablation.effects.iter().map(|price| price.count.effect).eq(Effect::ALL));
    for price in &ablation.effects {
        let is_present = [Effect::Mirror, Effect::SpotCone].contains(&price.count.effect);
        assert_eq!(price.is_present(), is_present, "{price:?}");
        assert_eq!(price.without.is_some(), is_present, "{price:?}");
        if !is_present {
            assert_eq!((price.rays(), price.count.rows, price.count.bytes), (0, 0, 0), "{price:?}");
        }
    }
    let price = |effect| ablation.effects.iter().find(|price| price.count.effect == effect).unwrap();
    assert!(price(Effect::Mirror).rays() > 0 && price(Effect::SpotCone).rays() < 0);
    assert!(price(Effect::Mirror).without.unwrap().picture.worst_level > 0);
    // Asked for, with a value that does nothing.
    assert_eq!(price(Effect::Gloss).entities, 1);
    assert_eq!(world.resource::<Muted>(), &Muted::default());
}

#[test]
fn all_but_the_time_is_the_same_on_every_run() {
    let [a, b] = [1, 3].map(|rounds| priced(rounds).0);
    assert_eq!(a.rays, b.rays);
    for (a, b) in a.effects.iter().zip(&b.effects) {
        assert_eq!((a.count, a.entities, a.rays()), (b.count, b.entities, b.rays()));
        assert_eq!(a.without.map(|without| without.picture), b.without.map(|without| without.picture));
    }
}

#[test]
fn bars_are_drawn_even_where_there_is_none() {
    let mut ablation = priced(1).0;
    assert!(draw_bars("a title", &ablation).unwrap().contains("a title"));
    ablation.effects.clear();
    assert!(draw_bars("nothing", &ablation).unwrap().contains("nothing"));
}

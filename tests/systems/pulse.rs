//! An effect from outside: a component, its arithmetic, and one system before extraction; the trace needs to know nothing.

use archetrace::components::{FrameTime, Light, LightColor, Position};
use archetrace::effects::Effect;
use archetrace::systems::{Stage, Survey, Tables, frame_schedule, prepare};
use bevy_ecs::prelude::*;
use glam::DVec3;

use crate::support::scenes::full_case;
use crate::support::tracing::{run, workers};

/// A light that swells and fades, once in so many seconds.
#[derive(Component, Clone, Copy)]
struct Pulse {
    period: f64,
}

/// The share of its light that a pulsing light gives: all of it at second 0, none after half a period.
fn pulse(seconds: f64, period: f64) -> f64 {
    let share = (seconds / period).rem_euclid(1.0);
    (2.0 * share - 1.0).abs()
}

fn pulse_lights(time: Res<FrameTime>, mut lights: Query<(&Pulse, &mut LightColor)>) {
    for (&Pulse { period }, mut color) in &mut lights {
        color.set_if_neq(LightColor(DVec3::splat(pulse(time.seconds, period))));
    }
}

/// What a World with a pulsing light shows at a time: the sum of all channels, and the revision of its tables.
struct Pulsing {
    world: World,
    schedule: Schedule,
}

impl Pulsing {
    fn new(lights: usize) -> Self {
        let mut world = full_case().world();
        world.init_resource::<FrameTime>();
        for number in 0..lights {
            let place = Position::new(0.0, -60.0, 90.0 + number as f64);
            world.spawn((Light, place, LightColor(DVec3::ONE), Pulse { period: 2.0 }));
        }
        prepare::<f64>(&mut world, workers(1));
        let mut schedule = frame_schedule::<f64>();
        schedule.add_systems(pulse_lights.before(Stage::Extract));
        Self { world, schedule }
    }

    fn at(&mut self, seconds: f64) -> (f64, u64) {
        self.world.resource_mut::<FrameTime>().seconds = seconds;
        let picture = run(&mut self.world, &mut self.schedule).unwrap().picture;
        (picture.pixels.iter().flatten().sum(), self.world.resource::<Tables<f64>>().revision())
    }

    fn rows(&self) -> usize {
        let counts = self.world.resource::<Tables<f64>>().effect_counts();
        counts.iter().filter(|count| count.effect == Effect::LightColor).map(|count| count.rows).sum()
    }
}

#[test]
fn a_system_of_ones_own_adds_an_effect() {
    let mut scene = Pulsing::new(1);
    let (bright, _) = scene.at(0.0);
    // At full strength a coloured light is a plain one, and has no row.
    assert_eq!(scene.rows(), 0);
    let (half, _) = scene.at(0.5);
    assert_eq!(scene.rows(), 1);
    let (dark, _) = scene.at(1.0);
    assert!(dark < half && half < bright, "{dark} {half} {bright}");
    assert_eq!(scene.at(2.0).0, bright);
}

#[test]
fn nobody_pays_for_what_nobody_carries() {
    let mut scene = Pulsing::new(0);
    let (first, revision) = scene.at(0.0);
    // Nothing is extracted again, and nothing is asked for.
    assert_eq!(scene.at(0.5), (first, revision));
    assert_eq!(scene.rows(), 0);
    assert!(!scene.world.resource::<Survey>().asked().contains(Effect::LightColor));
}

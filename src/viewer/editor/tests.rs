//! Edits against a model of plain values, and what single edits promise.

mod model;
mod random;
mod steps;

use core::num::NonZeroUsize;

use bevy_ecs::prelude::*;
use bevy_ecs::schedule::Schedule;

use crate::components::{Sampling, Snapshot};
use crate::scene::{Description, parse, spawn};
use crate::systems::{Tables, Workers, extract_schedule, prepare};

/// A World and the schedule that follows it.
struct Followed {
    world: World,
    extract: Schedule,
}

impl Followed {
    fn new(world: World) -> Self {
        Self::with_workers(world, workers())
    }

    fn with_workers(mut world: World, workers: Workers) -> Self {
        prepare::<f64>(&mut world, workers);
        Self { world, extract: extract_schedule::<f64>() }
    }

    fn of_file(name: &str) -> Self {
        let mut world = World::new();
        spawn(&mut world, &description(name));
        Self::new(world)
    }

    /// Everything that the tables hold, every number to its last digit.
    fn tables(&mut self) -> String {
        self.extract.run(&mut self.world);
        let tables = self.world.resource::<Tables<f64>>();
        let [snapshot, sampling] = [
            format!("{:?}", self.world.get_resource::<Snapshot>()),
            format!("{:?}", self.world.get_resource::<Sampling>()),
        ];
        let problems = tables.problems().len();
        format!("{:#?}\n{:#?}\n{snapshot}\n{sampling}\n{problems}", tables.scene, tables.camera)
    }
}

fn workers() -> Workers {
    Workers::new(NonZeroUsize::new(1)).unwrap()
}

fn description(name: &str) -> Description {
    let path = format!("{}/scenes/{name}", env!("CARGO_MANIFEST_DIR"));
    parse(&std::fs::read_to_string(path).unwrap()).unwrap().0
}

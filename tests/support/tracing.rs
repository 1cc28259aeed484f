//! World to picture.

use core::num::NonZeroUsize;

use archetrace::geometry::Real;
use archetrace::systems::{Frame, FrameError, Workers, frame_schedule, prepare};
use archetrace::trace::Counts;
use bevy_ecs::prelude::*;
use bevy_ecs::schedule::Schedule;

use super::picture::Picture;

/// A picture and what was counted while it was traced.
#[derive(Clone, Debug)]
pub(crate) struct Traced {
    pub(crate) picture: Picture,
    pub(crate) counts: Counts,
}

/// One frame of a World that can be traced, by a fresh schedule on two threads.
pub(crate) fn trace<T: Real>(world: &mut World) -> Traced {
    trace_with::<T>(world, workers(2))
}

/// The same on these workers.
pub(crate) fn trace_with<T: Real>(world: &mut World, workers: Workers) -> Traced {
    prepare::<T>(world, workers);
    run(world, &mut frame_schedule::<T>()).expect("the World can be traced")
}

/// One more frame. No scene of the tests may give a radiance that is not finite.
pub(crate) fn run(world: &mut World, schedule: &mut Schedule) -> Result<Traced, FrameError> {
    schedule.run(world);
    let (film, &counts) = world.resource::<Frame>().traced()?;
    assert_eq!(counts.non_finite, 0, "radiance that is not finite");
    Ok(Traced { picture: Picture::from(film), counts })
}

/// This many threads.
pub(crate) fn workers(threads: usize) -> Workers {
    let threads = NonZeroUsize::new(threads).expect("at least one thread");
    Workers::new(Some(threads)).expect("threads can be started")
}

//! A warm frame takes no memory: allocations are counted in a binary of their own, across all threads.
#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test fails by panicking")]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    reason = "what tests share says its figures in floating point"
)]
#![allow(unsafe_code, reason = "an allocator can be made in no other way; this one only counts")]

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering};

use archetrace::geometry::Real;
use archetrace::scene::{ObjectDescription, ShapeDescription};
use archetrace::systems::{Frame, extract_schedule, prepare, trace_schedule};
use bevy_ecs::prelude::World;
use bevy_ecs::schedule::Schedule;
use support::random::Random;
use support::scenes::full_case;
use support::tracing::workers;

mod support;

/// The system's allocator, with a count.
struct Counting;

static COUNT: AtomicUsize = AtomicUsize::new(0);

// SAFETY: every call is handed on as it is.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        COUNT.fetch_add(1, Ordering::Relaxed);
        // SAFETY: the caller keeps the promises.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: the caller keeps the promises.
        unsafe { System.dealloc(pointer, layout) }
    }

    unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        COUNT.fetch_add(1, Ordering::Relaxed);
        // SAFETY: the caller keeps the promises.
        unsafe { System.realloc(pointer, layout, size) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Frames that are looked at.
const FRAMES: usize = 62;

/// In so many of them something may be allocated that is not ours: the queue through which work comes to rayon from
/// outside takes a block of memory every 31 pieces of work, one a frame, and cleans up after itself now and then; the test
/// harness says that a test takes long.
const EXCEPTIONS: usize = 4;

/// Every shape, light and effect of scene files, and enough spheres for a tree.
fn world() -> World {
    let mut case = full_case();
    let (random, surface) = (&mut Random::new(7), case.description.objects[0].surface);
    let sphere = |random: &mut Random| ObjectDescription {
        position: random.point(60.0),
        shape: ShapeDescription::Sphere { radius: 2.0 },
        surface,
    };
    case.description.objects.extend((0..200).map(|_| sphere(random)));
    case.description.pixels = 70;
    case.world()
}

fn allocations(world: &mut World, schedule: &mut Schedule) -> usize {
    let before = COUNT.load(Ordering::Relaxed);
    schedule.run(world);
    COUNT.load(Ordering::Relaxed) - before
}

fn check<T: Real>() {
    let mut world = world();
    prepare::<T>(&mut world, workers(2));
    extract_schedule::<T>().run(&mut world);
    let mut trace = trace_schedule::<T>();
    for _ in 0..3 {
        trace.run(&mut world);
    }
    let counts: Vec<usize> = (0..FRAMES).map(|_| allocations(&mut world, &mut trace)).collect();
    assert!(world.resource::<Frame>().traced().is_ok());
    let exceptions = counts.iter().filter(|&&count| count > 0).count();
    assert!(exceptions <= EXCEPTIONS && counts.iter().all(|&count| count <= 2), "{counts:?}");
}

// One test, because others at the same time would be counted, too.
#[test]
fn a_warm_frame_allocates_nothing() {
    check::<f32>();
    check::<f64>();
    assert!(COUNT.load(Ordering::Relaxed) > 0);
}

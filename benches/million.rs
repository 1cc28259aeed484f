//! What a large scene costs before its first ray: time of each step, bytes, and one edit.
//!
//! `cargo bench --bench million -- [SPHERES [ROUNDS [f32|f64]]]` prints a line `NAME VALUE` for every measurement of every
//! round: milliseconds on the wall, or bytes an entity. `benches/peers.sh` makes a table of them.

#![expect(unsafe_code, reason = "an allocator that counts; see its SAFETY comment")]
#![expect(clippy::print_stdout, reason = "this is what it is for")]
#![expect(clippy::cast_precision_loss, reason = "bytes by entities, to a few digits")]

#[path = "support/crowd.rs"]
mod crowd;
#[path = "../tests/support/random.rs"]
#[allow(
    dead_code,
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    reason = "shared with the tests: small whole numbers, and not all of it is used here"
)]
mod random;

use std::alloc::{GlobalAlloc, Layout, System};
use std::error::Error;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

use archetrace::components::{Position, Sphere};
use archetrace::geometry::Real;
use archetrace::scene::{parse, spawn};
use archetrace::systems::{Tables, Workers, build_schedule, extract_schedule, prepare, tables_schedule};
use bevy_ecs::prelude::*;

use crowd::crowd;

/// The system's allocator, with a count of the bytes that are in use.
struct Counting;

static IN_USE: AtomicUsize = AtomicUsize::new(0);

#[global_allocator]
static ALLOCATOR: Counting = Counting;

// SAFETY: every call goes to the system's allocator as it came.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        IN_USE.fetch_add(layout.size(), Ordering::Relaxed);
        // SAFETY: as above.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, place: *mut u8, layout: Layout) {
        IN_USE.fetch_sub(layout.size(), Ordering::Relaxed);
        // SAFETY: as above.
        unsafe { System.dealloc(place, layout) }
    }

    unsafe fn realloc(&self, place: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        IN_USE.fetch_add(size, Ordering::Relaxed);
        IN_USE.fetch_sub(layout.size(), Ordering::Relaxed);
        // SAFETY: as above.
        unsafe { System.realloc(place, layout, size) }
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    // `cargo bench` adds a flag of its own.
    let arguments: Vec<String> = std::env::args().skip(1).filter(|word| word != "--bench").collect();
    let word =
        |index: usize, default: &str| arguments.get(index).cloned().unwrap_or_else(|| default.to_owned());
    let (count, rounds) = (word(0, "1000000").parse()?, word(1, "3").parse()?);
    let text = crowd(count, 64).to_string();
    for _ in 0..rounds {
        match word(2, "f32").as_str() {
            "f64" => round::<f64>(&text, count)?,
            _ => round::<f32>(&text, count)?,
        }
    }
    Ok(())
}

/// From text to tables and trees, step by step, and then one edit after the other.
fn round<T: Real>(text: &str, count: u32) -> Result<(), Box<dyn Error>> {
    let start = Instant::now();
    let (description, _) = timed("parse", || parse(text)).map_err(|_| "the scene does not parse")?;
    let mut world = World::new();
    timed("spawn", || spawn(&mut world, &description));
    timed("forget", || drop(description));
    prepare::<T>(&mut world, Workers::new(None)?);
    let of_the_world = IN_USE.load(Ordering::Relaxed);
    timed("extract", || tables_schedule::<T>().run(&mut world));
    timed("build", || build_schedule::<T>().run(&mut world));
    show("in_all", milliseconds(start));
    show("bytes", (IN_USE.load(Ordering::Relaxed) - of_the_world) as f64 / f64::from(count));
    edits::<T>(&mut world);
    timed("drop", || drop(world));
    Ok(())
}

/// Moves one sphere after the other, and has the tables and the tree brought up to date each time.
fn edits<T: Real>(world: &mut World) {
    const EDITS: usize = 20;
    let mut schedule = extract_schedule::<T>();
    schedule.run(world);
    let spheres: Vec<Entity> = world.query_filtered::<Entity, With<Sphere>>().iter(world).collect();
    let before = world.resource::<Tables<T>>().revision();
    for &sphere in spheres.iter().step_by(spheres.len().div_ceil(EDITS)) {
        if let Some(mut position) = world.get_mut::<Position>(sphere) {
            position.0.x += 1.0;
        }
        timed("edit", || schedule.run(world));
    }
    show("revisions", (world.resource::<Tables<T>>().revision() - before) as f64);
}

fn timed<R>(name: &str, work: impl FnOnce() -> R) -> R {
    let start = Instant::now();
    let result = work();
    show(name, milliseconds(start));
    result
}

fn milliseconds(start: Instant) -> f64 {
    start.elapsed().as_secs_f64() * 1e3
}

fn show(name: &str, value: f64) {
    println!("{name} {value:.3}");
}

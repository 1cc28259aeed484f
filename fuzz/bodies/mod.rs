//! What is done with hostile bytes: by the fuzz targets beside this folder, and by `tests/hostile`, which is bounded.
//!
//! Whatever the bytes are, nothing panics, and no picture holds a number that is not one.

mod bytes;
mod worlds;

use archetrace::components::Snapshot;
use archetrace::geometry::Real;
use archetrace::image_file::decode_texture;
use archetrace::scene::{Description, Source, describe, spawn};
use archetrace::systems::{Frame, Workers, frame_schedule, prepare};
use bevy_ecs::prelude::World;
use core::num::NonZeroUsize;

use bytes::Bytes;

/// Objects of a scene that is still traced: more would only cost time.
const MOST_OBJECTS: usize = 200;

/// What came of some bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Outcome {
    /// They were refused, with a reason.
    Refused,
    /// They were read, but not traced.
    Read,
    /// A picture was traced.
    Traced,
}

/// A scene file: read or refused; what was read is written, read again, and traced small.
pub(crate) fn scene(bytes: &[u8]) -> Outcome {
    let text = String::from_utf8_lossy(bytes);
    let loaded = match Source::new("scene.txt", text).load() {
        Ok(loaded) => loaded,
        Err(error) => {
            assert!(error.to_string().starts_with("error: "), "{error}");
            return Outcome::Refused;
        }
    };
    let mut world = spawned(&loaded.description);
    let written = describe(&mut world).expect("a scene that was spawned can be described").to_string();
    let again = Source::new("again.txt", written.as_str()).load().expect("what was written can be read");
    let written_again = describe(&mut spawned(&again.description)).expect("it can be described again");
    assert_eq!(written_again.to_string(), written);
    if loaded.description.objects.len() > MOST_OBJECTS {
        return Outcome::Read;
    }
    let mut snapshot = world.resource_mut::<Snapshot>();
    snapshot.pixels = snapshot.pixels.min(8);
    snapshot.level = snapshot.level.min(6);
    trace_in_both(&mut world)
}

fn spawned(description: &Description) -> World {
    let mut world = World::new();
    spawn(&mut world, description);
    world
}

/// An image: a texture of texels that can all be read, or none.
pub(crate) fn texture(bytes: &[u8]) -> Outcome {
    let Some(texture) = decode_texture(bytes) else { return Outcome::Refused };
    assert!(texture.width() > 0 && texture.height() > 0);
    for row in [0, texture.height() - 1] {
        for column in [0, texture.width() - 1] {
            let _ = texture.texel(column, row);
        }
    }
    Outcome::Read
}

/// A World of the entities that the bytes ask for: traced, or refused with a reason.
pub(crate) fn world(bytes: &[u8]) -> Outcome {
    trace_in_both(&mut worlds::world(&mut Bytes::new(bytes)))
}

fn trace_in_both(world: &mut World) -> Outcome {
    trace::<f64>(world).max(trace::<f32>(world))
}

fn trace<T: Real>(world: &mut World) -> Outcome {
    let workers = Workers::new(Some(NonZeroUsize::MIN)).expect("one thread can be started");
    prepare::<T>(world, workers);
    frame_schedule::<T>().run(world);
    match world.resource::<Frame>().traced() {
        Ok((film, counts)) => {
            assert_eq!(counts.non_finite, 0, "{}: radiance that is not finite", T::NAME);
            let is_color = |channel: &f64| (0.0..=1.0).contains(channel);
            assert!(film.pixels().iter().flatten().all(is_color));
            Outcome::Traced
        }
        Err(error) => {
            assert!(!error.to_string().is_empty());
            Outcome::Refused
        }
    }
}

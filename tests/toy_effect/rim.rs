//! What comes of the effect that README adds. Not a part of this crate: it is compiled in a copy of the sources that knows of
//! the effect, and fails by panicking.

use core::num::NonZeroUsize;

use archetrace::components::*;
use archetrace::effects::{Effect, EffectSet};
use archetrace::film::Film;
use archetrace::systems::*;
use archetrace::trace::{EffectCount, Exposure, Kernel};
use bevy_ecs::prelude::*;
use glam::DVec3;

const PIXELS: u32 = 41;
const DISTANCE: f64 = 10.0;
const RADIUS: f64 = 3.0;
const AMBIENT: f64 = 0.25;
const RIM: Rim = Rim { strength: 0.5, sharpness: 2.0 };

/// A ball with its own light only, and a schedule that traces it.
struct Toy {
    world: World,
    schedule: Schedule,
    ball: Entity,
}

impl Toy {
    fn new() -> Self {
        let mut world = World::new();
        world.insert_resource(Snapshot { pixels: PIXELS, level: 4 });
        let pose = CameraPose::looking(DVec3::ZERO, DVec3::Y, DVec3::Z).unwrap();
        world.spawn((pose, Lens { near: 1.0, far: 100.0, fovy: 60.0, aspect: 1.0 }));
        let surface = (Color::new(1.0, 0.5, 0.0), Ambient(AMBIENT), Diffuse(0.0));
        let ball = (Sphere { radius: RADIUS }, Position::new(0.0, DISTANCE, 0.0));
        let ball = world.spawn((ball, surface)).id();
        prepare::<f64>(&mut world, workers());
        Self { world, schedule: frame_schedule::<f64>(), ball }
    }

    fn give(&mut self, component: impl Bundle) {
        self.world.entity_mut(self.ball).insert(component);
    }

    fn film(&mut self) -> Film {
        self.schedule.run(&mut self.world);
        self.world.resource::<Frame>().traced().unwrap().0.clone()
    }

    /// Entities that carry the effect, and what it takes.
    fn census(&self) -> (usize, EffectCount) {
        let counts = self.world.resource::<Tables<f64>>().effect_counts();
        let count = counts.into_iter().find(|count| count.effect == Effect::Rim).unwrap();
        (self.world.resource::<Survey>().entities(Effect::Rim), count)
    }

    /// The same picture by some kernel.
    fn by(&self, kernel: Kernel) -> Film {
        let tables = self.world.resource::<Tables<f64>>();
        let camera = tables.camera.as_ref().unwrap();
        let exposure = Exposure { kernel, ..Exposure::new(&tables.scene, camera, 4) };
        let mut film = Film::new(PIXELS).unwrap();
        trace_picture(&exposure, &mut film, &workers(), &Monitor::default());
        film
    }
}

fn workers() -> Workers {
    Workers::new(NonZeroUsize::new(1)).unwrap()
}

/// The cosine between the normal and the way to the eye where the ray of a pixel of the middle row meets the ball, by the law
/// of sines: the ray leaves the line of centres at some angle, and meets the surface at a larger one.
fn cosine(column: u32) -> Option<f64> {
    let half = f64::from(PIXELS / 2);
    let across = (f64::from(column) - half) / (half + 0.5) * 30.0_f64.to_radians().tan();
    let sine = across.atan().sin() * DISTANCE / RADIUS;
    (sine.abs() <= 1.0).then(|| (1.0 - sine * sine).sqrt())
}

fn it_has_a_name_and_a_bit() {
    assert_eq!(Effect::Rim.name(), "rim");
    assert!(EffectSet::COMPILED.contains(Effect::Rim) && Effect::ALL.len() == 19);
}

fn it_shows_what_paper_says() {
    let mut toy = Toy::new();
    toy.give(RIM);
    let film = toy.film();
    let mut met = 0;
    for column in 0..PIXELS {
        let share = cosine(column).map_or(0.0, |cosine| {
            met += 1;
            AMBIENT + RIM.strength * (1.0 - cosine).powf(RIM.sharpness)
        });
        let found = film.pixels()[(PIXELS / 2 * PIXELS + column) as usize];
        for (found, own) in found.into_iter().zip([1.0, 0.5, 0.0]) {
            assert!((found - own * share).abs() < 1e-14, "column {column}: {found}, not {}", own * share);
        }
    }
    assert!((10..30).contains(&met), "{met} pixels of the ball");
}

fn it_is_counted_and_follows_edits() {
    let mut toy = Toy::new();
    let plain = toy.film();
    let (carriers, nothing) = toy.census();
    assert_eq!((carriers, nothing.rows, nothing.bytes), (0, 0, 0));

    toy.give(RIM);
    let bright = toy.film();
    let (carriers, count) = toy.census();
    assert!(bright != plain && (carriers, count.rows) == (1, 1) && count.bytes > 0);

    toy.give(Rim { strength: 0.75, ..RIM });
    assert!(toy.film() != bright, "another value is not seen");
    toy.give(RIM);
    assert!(toy.film() == bright);

    toy.world.insert_resource(Muted(EffectSet::of(&[Effect::Rim])));
    assert!(toy.film() == plain, "it cannot be switched off");
    toy.world.insert_resource(Muted::default());
    assert!(toy.film() == bright);

    toy.give(Rim { strength: 0.0, ..RIM });
    assert!(toy.film() == plain, "it is not neutral at zero");
    let (carriers, count) = toy.census();
    assert_eq!((carriers, count), (1, nothing));

    toy.world.entity_mut(toy.ball).remove::<Rim>();
    assert!(toy.film() == plain);
    assert_eq!(toy.census(), (0, nothing));
}

fn kernels_with_it_and_without_it_agree() {
    let mut toy = Toy::new();
    let plain = toy.film();
    for kernel in Kernel::all_for(EffectSet::NONE).chain([Kernel::Stages(EffectSet::of(&[Effect::Rim]))]) {
        assert!(toy.by(kernel) == plain, "{kernel:?}");
    }
    toy.give(RIM);
    let bright = toy.film();
    let rim = EffectSet::of(&[Effect::Rim]);
    assert_eq!(Kernel::smallest_for(rim), Kernel::Stages(rim));
    assert!(toy.by(Kernel::EVERYTHING) == bright);
    assert!(toy.by(Kernel::Stages(EffectSet::NONE)) == plain, "code without it knows of it");
}

fn what_it_does_not_allow_is_refused_by_name() {
    let mut toy = Toy::new();
    toy.give(Rim { strength: 1.5, ..RIM });
    toy.schedule.run(&mut toy.world);
    let error = toy.world.resource::<Frame>().traced().unwrap_err().to_string();
    assert!(error.ends_with("Rim.strength is 1.5, but must be a number from 0 to 1"), "{error}");
}

fn main() {
    it_has_a_name_and_a_bit();
    it_shows_what_paper_says();
    it_is_counted_and_follows_edits();
    kernels_with_it_and_without_it_agree();
    what_it_does_not_allow_is_refused_by_name();
}

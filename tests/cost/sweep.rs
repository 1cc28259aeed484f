//! The sweep itself: what must hold of its rows, and that its floor is real.

use archetrace::components::{AreaLight, Light, Precision, Snapshot};
use archetrace::scene::{Source, spawn};
use archetrace::study::{
    Chooser, Difference, Lab, Preset, Setting, Sweep, SweepPlan, Watch, Wish, adaptive_gains, choose,
    front_of_rows, knob_steps, next_6_db, sweep,
};
use archetrace::systems::Workers;
use bevy_ecs::prelude::*;

struct Unwatched;

impl Watch for Unwatched {
    fn before(&mut self, _: &str, _: usize, _: usize) {}

    fn is_cancelled(&self) -> bool {
        false
    }
}

/// Each look at it is a millisecond later.
fn clock() -> impl FnMut() -> f64 {
    let mut now = 0.0;
    move || {
        now += 1.0;
        now
    }
}

fn world() -> World {
    let scene = Source::read(concat!(env!("CARGO_MANIFEST_DIR"), "/scenes/official.txt").as_ref()).unwrap();
    let mut world = World::new();
    spawn(&mut world, &scene.load().unwrap().description);
    world.resource_mut::<Snapshot>().pixels = 40;
    world
}

fn swept() -> Sweep {
    let mut world = world();
    let scene = Setting::of(&mut world, Precision::F64);
    let plan = SweepPlan { quick: true, rounds: 2 };
    let mut lab = Lab::new(&mut world, &Workers::new(None).unwrap());
    sweep(&mut lab, scene, plan, &mut clock(), &mut Unwatched).unwrap()
}

#[test]
fn what_must_grow_grows() {
    let found = swept();
    let of = |knob: &str| found.rows.iter().filter(|row| row.knob == knob).collect::<Vec<_>>();
    assert_eq!(found.rows[0].setting, "assignment");
    assert!(found.rows.iter().all(|row| row.milliseconds.median == 1.0), "one look at the clock to the next");
    for pair in of("samples").windows(2) {
        assert!(pair[0].rays < pair[1].rays, "{}", pair[1].setting);
        // A grid may meet the cells of a board by luck, and the next one not; but none is as bad as a single sample.
        assert!(pair[1].psnr_db > found.rows[0].psnr_db + 3.0, "{}", pair[1].setting);
    }
    for pair in of("level").windows(2) {
        assert!(pair[0].rays <= pair[1].rays, "{}", pair[1].setting);
        assert!(pair[0].alone_rmse >= pair[1].alone_rmse, "{}", pair[1].setting);
    }
    for row in &found.rows {
        assert_eq!(row.rays, row.primary + row.shadow + row.mirror + row.refracted, "{}", row.setting);
        assert!(row.rmse >= found.reference.floor_rmse, "{}", row.setting);
        assert!(row.psnr_db <= found.reference.floor_psnr_db, "{}", row.setting);
    }
    let names: std::collections::BTreeSet<_> = found.rows.iter().map(|row| &row.setting).collect();
    assert_eq!(names.len(), found.rows.len(), "names are unique");
}

#[test]
fn a_reference_of_another_grid_agrees_within_the_floor() {
    let found = swept();
    let mut world = world();
    let scene = Setting::of(&mut world, Precision::F64);
    let mut lab = Lab::new(&mut world, &Workers::new(None).unwrap());
    let deep = Setting { side: 14, level: 64, cutoff: 1.0 / 65536.0, ..scene };
    let other = lab.shoot(deep, &mut clock()).unwrap();
    let apart = Difference::between(&other.film, &found.truth).unwrap();
    assert!(apart.rmse <= found.reference.floor_rmse, "{} {}", apart.rmse, found.reference.floor_rmse);
    assert!(apart.rmse > 0.0);
}

/// Shadow rays and texture filters are parts of entities: a trial that turns them must not do so for the next.
#[test]
fn every_row_is_that_of_its_setting_alone() {
    let with_area_light = || {
        let mut world = world();
        let light = world.query_filtered::<Entity, With<Light>>().iter(&world).next().unwrap();
        world.entity_mut(light).insert(AreaLight { radius: 20.0, samples: 4 });
        world.resource_mut::<Snapshot>().pixels = 12;
        world
    };
    let mut world = with_area_light();
    let scene = Setting::of(&mut world, Precision::F64);
    let plan = SweepPlan { quick: true, rounds: 2 };
    let mut lab = Lab::new(&mut world, &Workers::new(None).unwrap());
    let found = sweep(&mut lab, scene, plan, &mut clock(), &mut Unwatched).unwrap();
    assert!(found.rows.iter().any(|row| row.knob == "light_samples"));
    for (name, side, light_samples) in
        [("assignment", 1, 4), ("samples 4", 2, 4), ("light samples 16", 1, 16)]
    {
        let row = found.rows.iter().find(|row| row.setting == name).unwrap();
        let mut world = with_area_light();
        let mut lab = Lab::new(&mut world, &Workers::new(None).unwrap());
        let setting = Setting { side, light_samples: Some(light_samples), ..Preset::Assignment.of(scene) };
        let shot = lab.shoot(setting, &mut clock()).unwrap();
        assert_eq!(row.rays, shot.counts.rays.total(), "{name}");
    }
}

#[test]
fn a_front_is_what_nothing_beats() {
    let mut found = swept();
    // Times by rays, since the clock here knows none.
    for row in &mut found.rows {
        row.milliseconds.median = f64::from(u32::try_from(row.rays).unwrap()) / 1e4;
    }
    let front = front_of_rows(&found.rows);
    for &number in &front {
        let on_front = &found.rows[number];
        let beats = |row: &&archetrace::study::CostRow| {
            row.milliseconds.median <= on_front.milliseconds.median && row.rmse < on_front.rmse
        };
        assert_eq!(found.rows.iter().filter(beats).count(), 0, "{}", on_front.setting);
    }
    let steps = next_6_db(&found.rows, &front);
    assert!(!steps.is_empty());
    assert!(steps.iter().all(|step| step.to_db >= step.from_db + 6.0 && step.milliseconds > 0.0));
    let knobs = knob_steps(&found.rows, &found.changes_model);
    let samples = knobs.iter().find(|step| step.knob == "samples").unwrap();
    assert_eq!((samples.direction, samples.to.as_str()), ("truer", "samples 4"));
    assert!(knobs.iter().any(|step| step.knob == "checker_filter" && step.changes_model));
    let gains = adaptive_gains(&found.rows);
    assert_eq!(gains.len(), found.rows.iter().filter(|row| row.knob == "adaptive").count());
}

#[test]
fn the_chooser_is_the_same_every_time_and_keeps_what_is_fixed() {
    let chosen = |wish, free| {
        let mut world = world();
        let start = Preset::Assignment.of(Setting::of(&mut world, Precision::F64));
        let mut lab = Lab::new(&mut world, &Workers::new(None).unwrap());
        choose(&mut lab, start, free, wish, &mut clock()).unwrap()
    };
    let free = Chooser { precision: true, depth: true };
    let choice = chosen(Wish::Decibels(30.0), free);
    assert_eq!(choice, chosen(Wish::Decibels(30.0), free));
    assert!(choice.meets && choice.point.psnr_db() >= 30.0);
    assert!(choice.front.windows(2).all(|pair| pair[0].milliseconds <= pair[1].milliseconds));
    let fixed = chosen(Wish::Decibels(30.0), Chooser { precision: false, depth: false });
    assert_eq!((fixed.point.setting.precision, fixed.point.setting.level), (Precision::F64, 3));
    assert!(!chosen(Wish::Decibels(190.0), free).meets);
}

//! Whether wishes come true, and what adaptive samples save, over ten scenes: `cargo bench --bench wishes [-- SCENE...]`.
//!
//! For each scene a budget of 150 ms, a target of 40 dB and one of 2 levels, at 512 x 512 pixels: what was predicted, what
//! came out (the median of five traces, and the error against 17 x 17 samples at converged depth), and whether the wish was
//! kept: a budget within 20 %, a target as it stands. Then the rays that uniform samples need for the error of the best
//! adaptive setting, by those of the latter.
#![allow(clippy::print_stdout, reason = "prints the table")]

use std::path::{Path, PathBuf};
use std::time::Instant;

use archetrace::components::{Precision, Snapshot};
use archetrace::scene::{Source, spawn};
use archetrace::study::{
    Chooser, Difference, Lab, Preset, Setting, Spread, SweepPlan, Watch, Wish, adaptive_gains, choose, sweep,
};
use archetrace::systems::Workers;
use bevy_ecs::prelude::World;

type Failure = Box<dyn std::error::Error>;

const PIXELS: u32 = 512;
const SCENES: [&str; 10] = [
    "official",
    "below_board",
    "cone_edge",
    "depth_levels",
    "falloff",
    "grazing_floor",
    "highlights",
    "mirror_pair",
    "shadows_crossing",
    "sphere_on_board",
];
const WISHES: [(&str, Wish); 3] =
    [("150 ms", Wish::Budget(150.0)), ("40 dB", Wish::Decibels(40.0)), ("2 levels", Wish::Levels(2.0))];

fn main() -> Result<(), Failure> {
    // Cargo adds arguments of its own.
    let named: Vec<PathBuf> =
        std::env::args().skip(1).filter(|word| word != "--bench").map(PathBuf::from).collect();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes");
    let own = SCENES.map(|name| folder.join(name).with_extension("txt")).to_vec();
    println!("| scene | wish | predicted ms | ms | predicted dB | dB | kept | setting |");
    println!("|---|---|---|---|---|---|---|---|");
    let scenes = if named.is_empty() { own } else { named };
    for scene in &scenes {
        grant(scene)?;
    }
    println!("\n| scene | adaptive setting | rays of uniform samples for the same error |\n|---|---|---|");
    for scene in &scenes {
        gain(scene)?;
    }
    Ok(())
}

fn world(scene: &Path, pixels: u32) -> Result<World, Failure> {
    let mut world = World::new();
    spawn(&mut world, &Source::read(scene)?.load()?.description);
    world.resource_mut::<Snapshot>().pixels = pixels;
    Ok(world)
}

fn name_of(scene: &Path) -> String {
    scene.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default()
}

fn grant(scene: &Path) -> Result<(), Failure> {
    let began = Instant::now();
    let mut clock = || began.elapsed().as_secs_f64() * 1e3;
    let mut world = world(scene, PIXELS)?;
    let start = Preset::Assignment.of(Setting::of(&mut world, Precision::F64));
    let workers = Workers::new(None)?;
    let mut lab = Lab::new(&mut world, &workers);
    let deep = Setting { side: 17, level: 64, cutoff: 1.0 / 65536.0, ..start };
    let truth = lab.shoot(deep, &mut clock)?.film;
    for (words, wish) in WISHES {
        let free = Chooser { precision: true, depth: true };
        let choice = choose(&mut lab, start, free, wish, &mut clock)?;
        let mut times = Vec::new();
        let mut film = None;
        for _ in 0..5 {
            let shot = lab.shoot(choice.point.setting, &mut clock)?;
            times.push(shot.milliseconds);
            film = Some(shot.film);
        }
        let milliseconds = Spread::of(&times).median;
        let error = film.and_then(|film| Difference::between(&film, &truth)).ok_or("no film")?;
        let kept = match wish {
            Wish::Budget(most) => milliseconds <= 1.2 * most,
            Wish::Decibels(least) => error.psnr_db() >= least,
            Wish::Levels(most) => error.rmse * 255.0 <= most,
        };
        println!(
            "| {} | {words} | {:.1} | {milliseconds:.1} | {:.1} | {:.1} | {} | {} |",
            name_of(scene),
            choice.point.milliseconds,
            choice.point.psnr_db(),
            error.psnr_db(),
            match (choice.meets, kept) {
                (true, true) => "yes",
                (true, false) => "NO",
                (false, _) => "said to be impossible",
            },
            choice.point.setting.flags()
        );
    }
    Ok(())
}

fn gain(scene: &Path) -> Result<(), Failure> {
    struct Unwatched;
    impl Watch for Unwatched {
        fn before(&mut self, _: &str, _: usize, _: usize) {}
        fn is_cancelled(&self) -> bool {
            false
        }
    }
    let began = Instant::now();
    let mut clock = || began.elapsed().as_secs_f64() * 1e3;
    let mut world = world(scene, PIXELS / 2)?;
    let own = Setting::of(&mut world, Precision::F64);
    let workers = Workers::new(None)?;
    let mut lab = Lab::new(&mut world, &workers);
    let found = sweep(&mut lab, own, SweepPlan { quick: true, rounds: 1 }, &mut clock, &mut Unwatched)?;
    let gains = adaptive_gains(&found.rows).into_iter().filter_map(|gain| Some((gain.gain?, gain.setting)));
    if let Some((gain, setting)) = gains.max_by(|a, b| a.0.total_cmp(&b.0)) {
        println!("| {} | {setting} | {gain:.2} times |", name_of(scene));
    }
    Ok(())
}

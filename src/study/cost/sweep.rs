//! Every setting traced, timed in turns and compared with the reference.

use crate::film::Film;
use crate::study::{Difference, Lab, Setting, Shot, Spread, mean_ssim};
use crate::systems::FrameError;

use super::plan::{Knobbed, Trial, converged, trials};
use super::report::{CostRow, Reference};

/// How much of a study is done, and whether it is to go on.
pub trait Watch {
    /// Told before each picture what it is, with how many of how many are done.
    fn before(&mut self, what: &str, done: usize, all: usize);
    /// Whether to stop.
    fn is_cancelled(&self) -> bool;
}

/// What a sweep found.
#[derive(Debug)]
pub struct Sweep {
    /// The truth.
    pub reference: Reference,
    /// Its picture.
    pub truth: Film,
    /// One for each setting that was tried, `assignment` first.
    pub rows: Vec<CostRow>,
    /// The settings of the rows.
    pub settings: Vec<Setting>,
    /// Whether the knob of each row changes what is computed.
    pub changes_model: Vec<bool>,
    /// Pictures of the rows, from the first round.
    pub shots: Vec<Shot>,
    /// Rounds that were complete.
    pub rounds: u32,
    /// Whether it was cancelled.
    pub interrupted: bool,
}

/// How a study is made.
#[derive(Clone, Copy, Debug)]
pub struct SweepPlan {
    /// Fewer settings, and references of fewer samples.
    pub quick: bool,
    /// How often each setting is traced, in turns; at least once.
    pub rounds: u32,
}

/// Sample points along each side of a pixel of the two reference pictures: co-prime, and prime to the settings'.
fn reference_sides(quick: bool) -> [u32; 2] {
    if quick { [11, 13] } else { [17, 19] }
}

/// Tries every setting on a World whose own setting is `scene`. `clock` tells milliseconds. What is done when the watch
/// cancels is kept: an error only where there is nothing yet to compare with.
pub fn sweep(
    lab: &mut Lab<'_>,
    scene: Setting,
    plan: SweepPlan,
    clock: &mut dyn FnMut() -> f64,
    watch: &mut dyn Watch,
) -> Result<Sweep, FrameError> {
    let trials = trials(scene, Knobbed::of(lab.world()), plan.quick);
    let rounds = plan.rounds.max(1);
    // Far fewer than 2^32 pictures.
    let all = 2 + trials.len() * rounds as usize;
    let (reference, truth) = refer(lab, trials[0].setting, plan.quick, clock, (watch, all))?;
    let mut found = Sweep {
        reference,
        truth,
        rows: Vec::new(),
        settings: Vec::new(),
        changes_model: Vec::new(),
        shots: Vec::new(),
        rounds: 0,
        interrupted: false,
    };
    let mut times: Vec<Vec<f64>> = Vec::new();
    'rounds: for round in 0..rounds {
        for (number, trial) in trials.iter().enumerate() {
            watch.before(&trial.name, 2 + round as usize * trials.len() + number, all);
            if watch.is_cancelled() {
                found.interrupted = true;
                break 'rounds;
            }
            match found.take(lab, (round, number), trial, &mut times, clock) {
                Err(FrameError::Cancelled) => {
                    found.interrupted = true;
                    break 'rounds;
                }
                taken => taken?,
            }
        }
        found.rounds = round + 1;
    }
    for (row, times) in found.rows.iter_mut().zip(&times) {
        row.milliseconds = Spread::of(times);
    }
    Ok(found)
}

/// Two pictures at converged depth with many samples, and how far they are apart.
fn refer(
    lab: &mut Lab<'_>,
    start: Setting,
    quick: bool,
    clock: &mut dyn FnMut() -> f64,
    (watch, all): (&mut dyn Watch, usize),
) -> Result<(Reference, Film), FrameError> {
    let sides = reference_sides(quick);
    let deep = converged(start);
    let mut shots = Vec::new();
    for (number, side) in sides.into_iter().enumerate() {
        watch.before("reference", number, all);
        shots.push(lab.shoot(Setting { side, threshold: None, ..deep }, clock)?);
    }
    let apart = Difference::between(&shots[0].film, &shots[1].film).unwrap_or_default();
    let mut truth = shots[0].film.clone();
    for (mean, other) in truth.pixels_mut().iter_mut().flatten().zip(shots[1].film.pixels().iter().flatten())
    {
        *mean = 0.5 * (*mean + other);
    }
    let reference = Reference {
        sides,
        level: deep.level,
        cutoff: deep.cutoff,
        floor_rmse: apart.rmse,
        floor_psnr_db: apart.psnr_db(),
        floor_worst_level: apart.worst_level,
        milliseconds: shots.iter().map(|shot| shot.milliseconds).sum(),
    };
    Ok((reference, truth))
}

impl Sweep {
    /// Traces a setting once more.
    fn take(
        &mut self,
        lab: &mut Lab<'_>,
        (round, number): (u32, usize),
        trial: &Trial,
        times: &mut Vec<Vec<f64>>,
        clock: &mut dyn FnMut() -> f64,
    ) -> Result<(), FrameError> {
        let shot = lab.shoot(trial.setting, clock)?;
        let milliseconds = shot.milliseconds;
        if round == 0 {
            self.add(lab, trial, shot, clock)?;
            times.push(Vec::new());
        }
        times[number].push(milliseconds);
        Ok(())
    }

    fn add(
        &mut self,
        lab: &mut Lab<'_>,
        trial: &Trial,
        mut shot: Shot,
        clock: &mut dyn FnMut() -> f64,
    ) -> Result<(), FrameError> {
        let alone = match trial.truest {
            Some(truest) if truest != trial.setting => {
                let truest = lab.shoot(truest, clock)?;
                Difference::between(&shot.film, &truest.film).map(|difference| difference.rmse)
            }
            Some(_) => Some(0.0),
            None => None,
        };
        if shot.film.side() != self.truth.side() {
            shot.film = shot.film.enlarged(self.truth.side()).ok_or(FrameError::Memory(self.truth.side()))?;
        }
        self.rows.push(self.row(trial, &shot, alone));
        self.settings.push(trial.setting);
        self.changes_model.push(trial.changes_model);
        self.shots.push(shot);
        Ok(())
    }

    fn row(&self, trial: &Trial, shot: &Shot, alone_rmse: Option<f64>) -> CostRow {
        let difference = Difference::between(&shot.film, &self.truth).unwrap_or_default();
        let floor = &self.reference;
        let at_floor = difference.rmse <= floor.floor_rmse;
        let uniform = f64::from(trial.setting.side * trial.setting.side);
        let rays = shot.counts.rays;
        // A picture of fewer pixels has fewer samples for each of the pixels that it is compared by.
        let coverage = (f64::from(trial.setting.pixels) / f64::from(self.truth.side().max(1))).powi(2);
        CostRow {
            setting: trial.name.clone(),
            knob: trial.knob,
            flags: trial.setting.flags(),
            knobs: trial.setting.knobs(),
            samples: coverage * shot.refinement.as_ref().map_or(uniform, |samples| samples.mean_samples()),
            milliseconds: Spread::default(),
            rays: rays.total(),
            primary: rays.primary,
            shadow: rays.shadow,
            mirror: rays.mirror,
            refracted: rays.refracted,
            instructions: None,
            rmse: difference.rmse.max(floor.floor_rmse),
            psnr_db: difference.psnr_db().min(floor.floor_psnr_db),
            at_floor,
            worst_level: difference.worst_level,
            over1: difference.over1,
            over8: difference.over8,
            ssim: mean_ssim(&shot.film, &self.truth).unwrap_or(1.0),
            alone_rmse,
        }
    }
}

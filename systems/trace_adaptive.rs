//! Tables to film, with more samples where they matter.

use rayon::prelude::*;

use crate::film::Film;
use crate::geometry::Real;
use crate::trace::{Counts, Exposure, RefinedBand, Refinement};

use super::{Monitor, Workers};

/// Traces the points of the exposure's grid in passes, each pixel until its error is expected to be no more than the
/// threshold (0 to 1), and leaves the mean of its samples in the film, which must have the camera's size or be a part of its
/// picture. Returns how many samples each pixel has, too.
pub fn trace_adaptive<T: Real>(
    exposure: &Exposure<'_, T>,
    threshold: f64,
    film: &mut Film,
    workers: &Workers,
    monitor: &Monitor,
) -> (Counts, Refinement) {
    let mut refinement = Refinement::new(film.side(), threshold);
    let mut counts = Counts::default();
    let effects = exposure.camera.effects();
    film.set_transfer(effects.transfer);
    let (side, passes) = (exposure.grid.side(), exposure.grid.count());
    for pass in 0..passes {
        if refinement.is_done() || monitor.is_cancelled() {
            break;
        }
        let tables = exposure.tables.at(T::from_f64(effects.second(exposure.grid, pass)));
        let exposure = Exposure { tables: &tables, ..*exposure };
        let is_checked = Refinement::is_checked_after(pass + 1, side);
        let later = u64::from(passes - pass - 1);
        counts += workers.pool.install(|| {
            let trace = |band: &mut RefinedBand<'_>| {
                let wanting = band.wanting();
                let counts = band.trace(&exposure, workers.simd, pass);
                let done = if is_checked && pass > 0 { band.look_inside() } else { 0 };
                monitor.tile_done(wanting + done * later);
                counts
            };
            let each = refinement.bands(film).into_par_iter();
            each.map(|mut band| if monitor.is_cancelled() { Counts::default() } else { trace(&mut band) })
                .reduce(Counts::default, |mut sum, counts| {
                    sum += counts;
                    sum
                })
        });
        if pass == 0 && passes > 1 && !monitor.is_cancelled() {
            monitor.tile_done(refinement.look_around(film) * later);
        }
    }
    refinement.divide(film);
    (counts, refinement)
}

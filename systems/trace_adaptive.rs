//! Tables to film, with more samples where they matter.

use rayon::prelude::*;

use crate::film::Film;
use crate::geometry::Real;
use crate::trace::{BandAround, Counts, Exposure, RefinedBand, Refinement};

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
    film.set_transfer(effects.transfer());
    let (grid, total) = (exposure.grid, exposure.grid.count());
    let mut first = 0;
    while first < total && !refinement.is_done() && !monitor.is_cancelled() {
        // Until pixels are asked again, nobody waits for anybody; but things that move have tables for each pass.
        let until_checked = (first + 1..total).find(|&done| Refinement::is_checked_after(done, grid.side()));
        let next = if exposure.tables.moving.is_empty() { until_checked.unwrap_or(total) } else { first + 1 };
        let tables = exposure.tables.at(T::from_f64(effects.second(grid, first)));
        let exposure = Exposure { tables: &tables, ..*exposure };
        let is_checked = first > 0 && Refinement::is_checked_after(next, grid.side());
        let later = u64::from(total - next);
        counts += workers.pool.install(|| {
            let trace = |mut band: RefinedBand<'_>| {
                let (mut counts, wanting) = (Counts::default(), band.wanting());
                for pass in (first..next).take_while(|_| !monitor.is_cancelled()) {
                    counts += band.trace(&exposure, workers.simd, pass);
                }
                let done = if is_checked { band.look_inside() } else { 0 };
                monitor.tile_done(wanting * u64::from(next - first) + done * later);
                counts
            };
            refinement.bands(film).into_par_iter().map(trace).reduce(Counts::default, |mut sum, counts| {
                sum += counts;
                sum
            })
        });
        if first == 0 && total > 1 && !monitor.is_cancelled() {
            monitor.tile_done(look_around(&mut refinement, film, workers) * later);
        }
        first = next;
    }
    refinement.divide(film);
    (counts, refinement)
}

/// Lets the pixels go that what is around them says enough of. Returns how many.
fn look_around(refinement: &mut Refinement, film: &Film, workers: &Workers) -> u64 {
    let mut bands: Vec<_> = refinement.bands_around(film).collect();
    workers.pool.install(|| bands.par_iter_mut().map(BandAround::look).sum())
}

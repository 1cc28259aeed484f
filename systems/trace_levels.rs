//! Tables to bytes.

use bevy_ecs::prelude::*;
use rayon::prelude::*;

use crate::film::{FilmBand, Tone, room_for_levels};
use crate::geometry::Real;
use crate::trace::{Counts, Exposure};

use super::trace::{Settings, expose, sum, trace_band};
use super::{Frame, FrameError, Monitor, Tables, Workers};

/// Traces the frame to bytes, the very ones that [`to_rgb8`](crate::film::Film::to_rgb8) makes of its film. Where a pixel has
/// one sample there is no film, but a band of one for each thread: its memory is eight times that of the bytes, and takes
/// longer to get than they do to make.
pub(super) fn trace_levels<T: Real>(tables: Res<Tables<T>>, settings: Settings, mut frame: ResMut<Frame>) {
    let frame = &mut *frame;
    frame.counts = Counts::default();
    frame.error = settings.exposure(&tables).and_then(|exposure| develop(&exposure, &settings, frame)).err();
}

fn develop<T: Real>(
    exposure: &Exposure<'_, T>,
    settings: &Settings,
    frame: &mut Frame,
) -> Result<(), FrameError> {
    let (workers, monitor) = (&settings.workers, &settings.monitor);
    if exposure.grid.count() > 1 || settings.threshold().is_some() {
        expose(exposure, settings, frame)?;
        frame.levels = workers.run(|| frame.film.to_rgb8());
        return Ok(());
    }
    let side = exposure.camera.pixels();
    frame.levels = room_for_levels(side).ok_or(FrameError::Memory(side))?;
    frame.refinement = None;
    frame.counts = trace_bands(exposure, &mut frame.levels, workers, monitor);
    if monitor.is_cancelled() { Err(FrameError::Cancelled) } else { Ok(()) }
}

/// Traces one sample of each pixel, band by band, in parallel.
fn trace_bands<T: Real>(
    exposure: &Exposure<'_, T>,
    levels: &mut [u8],
    workers: &Workers,
    monitor: &Monitor,
) -> Counts {
    let effects = exposure.camera.effects();
    let tone = Tone::of(effects.transfer());
    let tables = exposure.tables.at(T::from_f64(effects.second(exposure.grid, 0)));
    let exposure = Exposure { tables: &tables, ..*exposure };
    let (side, height) = (exposure.camera.pixels(), workers.tile_size);
    let length = (side as usize * height.max(1) as usize).max(1);
    workers.run(|| {
        let bands = levels.par_chunks_mut(3 * length).with_max_len(1).enumerate();
        let film = || vec![[0.0; 3]; length];
        let each = bands.map_init(film, |film, (number, levels)| {
            let pixels = &mut film[..levels.len() / 3];
            let mut band = FilmBand::new(side, height, number, pixels);
            let counts = trace_band(&exposure, 0, &mut band, workers, monitor);
            tone.put_levels(film.as_flattened(), 1, levels);
            counts
        });
        each.reduce(Counts::default, sum)
    })
}

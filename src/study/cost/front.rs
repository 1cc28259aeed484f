//! What the rows of a study say: the front, the next 6 dB, the knobs one step up and down.

use super::report::{AdaptiveGain, CostRow, KnobStep, NextSixDb};

/// Numbers of the rows that no other row beats in both time and error, the fastest first. Equal errors (at the floor, say)
/// are won by the faster.
pub fn front_of_rows(rows: &[CostRow]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..rows.len()).collect();
    order.sort_by(|&a, &b| {
        let times = rows[a].milliseconds.median.total_cmp(&rows[b].milliseconds.median);
        times.then(rows[a].rmse.total_cmp(&rows[b].rmse))
    });
    let mut least = f64::INFINITY;
    order.retain(|&number| {
        let is_better = rows[number].rmse < least;
        least = least.min(rows[number].rmse);
        is_better
    });
    order
}

/// What each further 6 dB cost, from the fastest row of the front on: each step goes to the first row that is so much
/// better.
pub fn next_6_db(rows: &[CostRow], front: &[usize]) -> Vec<NextSixDb> {
    const STEP: f64 = 6.0;
    let mut steps = Vec::new();
    let Some(&first) = front.first() else { return steps };
    let mut from = &rows[first];
    while let Some(to) =
        front.iter().map(|&number| &rows[number]).find(|row| row.psnr_db >= from.psnr_db + STEP)
    {
        steps.push(NextSixDb {
            from_db: from.psnr_db,
            from: from.setting.clone(),
            to_db: to.psnr_db,
            to: to.setting.clone(),
            milliseconds: to.milliseconds.median - from.milliseconds.median,
            rays: more(to.rays, from.rays),
        });
        from = to;
    }
    steps
}

/// Each knob one step away from the first row, `assignment`: of the rows of a knob the nearest in rays that has more, and the
/// nearest that has fewer; where rays are the same, the one row that is there.
pub fn knob_steps(rows: &[CostRow], changes_model: &[bool]) -> Vec<KnobStep> {
    let Some(start) = rows.first() else { return Vec::new() };
    let mut knobs: Vec<&'static str> = Vec::new();
    for row in rows.iter().filter(|row| !matches!(row.knob, "preset" | "grid")) {
        if !knobs.contains(&row.knob) {
            knobs.push(row.knob);
        }
    }
    let mut steps = Vec::new();
    for knob in knobs {
        let of_knob = || rows.iter().zip(changes_model).filter(move |(row, _)| row.knob == knob);
        let distance = |(row, _): &(&CostRow, &bool)| row.rays.abs_diff(start.rays);
        let truer = of_knob().filter(|(row, _)| row.psnr_db >= start.psnr_db).min_by_key(distance);
        let faster = of_knob().filter(|(row, _)| row.psnr_db < start.psnr_db).min_by_key(distance);
        for (direction, found) in [("truer", truer), ("faster", faster)] {
            steps.extend(found.map(|(row, &changes_model)| KnobStep {
                knob,
                direction,
                to: row.setting.clone(),
                milliseconds: row.milliseconds.median - start.milliseconds.median,
                rays: more(row.rays, start.rays),
                decibels: row.psnr_db - start.psnr_db,
                changes_model,
            }));
        }
    }
    steps
}

/// What adaptive sampling saves: for each adaptive row the rays of uniform sampling at the same error, along a straight line
/// between its two neighbours there in logarithms of rays and error.
pub fn adaptive_gains(rows: &[CostRow]) -> Vec<AdaptiveGain> {
    let mut uniform: Vec<&CostRow> = rows.iter().take(1).collect();
    uniform.extend(rows.iter().filter(|row| row.knob == "samples"));
    uniform.retain(|row| !row.at_floor);
    uniform.sort_by_key(|row| row.rays);
    let adaptive = rows.iter().filter(|row| row.knob == "adaptive");
    let gain = |row: &CostRow| {
        let pair = uniform.windows(2).find(|pair| pair[1].rmse <= row.rmse && row.rmse <= pair[0].rmse)?;
        let [more, fewer] = [pair[0].rmse.ln(), pair[1].rmse.ln()];
        let share = if more > fewer { (more - row.rmse.ln()) / (more - fewer) } else { 0.0 };
        let [few, many] = [log_rays(pair[0]), log_rays(pair[1])];
        Some((few + share * (many - few) - log_rays(row)).exp())
    };
    adaptive.map(|row| AdaptiveGain { setting: row.setting.clone(), gain: gain(row) }).collect()
}

#[expect(clippy::cast_precision_loss, reason = "a ratio needs no more")]
fn log_rays(row: &CostRow) -> f64 {
    (row.rays.max(1) as f64).ln()
}

/// Far fewer than 2^63.
fn more(a: u64, b: u64) -> i64 {
    a.wrapping_sub(b).cast_signed()
}

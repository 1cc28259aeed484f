//! Which settings a study tries.

use bevy_ecs::prelude::*;

use crate::components::{AreaLight, Checkerboard, Precision, TextureFilter, Textured};
use crate::study::{Preset, Setting};

/// A setting to be tried, and why.
#[derive(Clone, Debug)]
pub(super) struct Trial {
    /// Unique.
    pub(super) name: String,
    /// The knob that it turns, `preset` or `grid`.
    pub(super) knob: &'static str,
    pub(super) setting: Setting,
    /// The same with that knob at its truest, which tells the error of the knob alone.
    pub(super) truest: Option<Setting>,
    /// Whether the knob changes what is computed, not only how closely.
    pub(super) changes_model: bool,
}

/// What a scene has that knobs can be turned of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Knobbed {
    plain_boards: bool,
    /// How its images are read, if it has any.
    images: Option<TextureFilter>,
    /// Shadow rays towards its area lights, the first one's if they differ.
    area_lights: Option<u32>,
}

impl Knobbed {
    pub(super) fn of(world: &mut World) -> Self {
        let boards =
            world.query_filtered::<(), (With<Checkerboard>, Without<Textured>)>().iter(world).count();
        let mut images = world.query_filtered::<Option<&TextureFilter>, With<Textured>>();
        Self {
            plain_boards: boards > 0,
            images: images.iter(world).next().map(|filter| filter.copied().unwrap_or_default()),
            area_lights: world.query::<&AreaLight>().iter(world).next().map(|light| light.samples),
        }
    }
}

/// How deep mirrors are followed where nothing shall be missed.
pub(super) fn converged(setting: Setting) -> Setting {
    Setting { level: setting.level.max(64), cutoff: 1.0 / 65536.0, ..setting }
}

/// Every trial for a scene with this setting of its own, `assignment` first.
pub(super) fn trials(scene: Setting, has: Knobbed, quick: bool) -> Vec<Trial> {
    // Each trial says how images are read and lights sampled, lest it take over what the one before it has set.
    let scene = Setting {
        texture_filter: scene.texture_filter.or(has.images),
        light_samples: scene.light_samples.or(has.area_lights),
        ..scene
    };
    let start = Preset::Assignment.of(scene);
    let mut trials = vec![Trial {
        name: Preset::Assignment.name().to_owned(),
        knob: "preset",
        setting: start,
        truest: None,
        changes_model: false,
    }];
    let others = [Preset::Draft, Preset::Fine, Preset::Reference];
    trials.extend(others.into_iter().filter(|&preset| !(quick && preset == Preset::Reference)).map(
        |preset| {
            let setting = preset.of(scene);
            Trial {
                name: preset.name().to_owned(),
                knob: "preset",
                setting,
                truest: None,
                changes_model: false,
            }
        },
    ));
    sampling(&mut trials, start, quick);
    depth(&mut trials, start, quick);
    model(&mut trials, start, has, quick);
    grid(&mut trials, start, has, quick);
    // A knob may turn out as a preset, or the scene's own setting.
    let mut seen: Vec<Setting> = Vec::new();
    trials.retain(|trial| {
        let is_new = !seen.contains(&trial.setting);
        seen.push(trial.setting);
        is_new
    });
    trials
}

fn knob(name: String, knob: &'static str, setting: Setting, truest: Option<Setting>) -> Trial {
    Trial { name, knob, setting, truest, changes_model: false }
}

fn sampling(trials: &mut Vec<Trial>, start: Setting, quick: bool) {
    let sides: &[u32] = if quick { &[2, 3, 4, 5] } else { &[2, 3, 4, 5, 6, 8, 12] };
    let name = |side: u32| format!("samples {}", side * side);
    trials.extend(sides.iter().map(|&side| knob(name(side), "samples", Setting { side, ..start }, None)));
    let adaptive: &[(u32, f64)] = if quick {
        &[(3, 64.0), (5, 64.0), (5, 128.0)]
    } else {
        &[(3, 16.0), (3, 64.0), (5, 64.0), (5, 128.0), (9, 128.0), (9, 256.0), (15, 512.0)]
    };
    trials.extend(adaptive.iter().map(|&(side, parts)| {
        let name = format!("adaptive {}, 1/{parts}", side * side);
        knob(name, "adaptive", Setting { side, threshold: Some(1.0 / parts), ..start }, None)
    }));
    let parts: &[u32] = if quick { &[2] } else { &[2, 4] };
    for part in parts.iter().filter(|&&part| start.pixels.is_multiple_of(part)) {
        let pixels = start.pixels / part;
        trials.push(knob(format!("resolution {pixels}"), "resolution", Setting { pixels, ..start }, None));
    }
}

fn depth(trials: &mut Vec<Trial>, start: Setting, quick: bool) {
    let deep = Setting { level: start.level.max(64), ..start };
    let levels = 1..=if quick { 4 } else { 8 };
    trials.extend(
        levels.map(|level| knob(format!("level {level}"), "level", Setting { level, ..start }, Some(deep))),
    );
    let cutoffs: &[(u32, f64)] = if quick { &[(16, 16.0)] } else { &[(8, 8.0), (32, 32.0), (256, 256.0)] };
    trials.extend(cutoffs.iter().map(|&(name, parts)| {
        let cutoff = 1.0 / parts;
        knob(format!("level 64, cutoff 1/{name}"), "cutoff", Setting { cutoff, ..deep }, Some(deep))
    }));
}

fn model(trials: &mut Vec<Trial>, start: Setting, has: Knobbed, quick: bool) {
    let single = Setting { precision: Precision::F32, ..start };
    trials.push(knob("f32".to_owned(), "precision", single, Some(start)));
    if has.plain_boards && !start.checker_filter {
        let setting = Setting { checker_filter: true, ..start };
        trials.push(Trial {
            changes_model: true,
            ..knob("checker filter".to_owned(), "checker_filter", setting, None)
        });
    }
    if has.images.is_some() {
        for (name, filter) in [("bilinear", TextureFilter::Bilinear), ("mip", TextureFilter::Mip)] {
            let setting = Setting { texture_filter: Some(filter), ..start };
            let trial = knob(format!("texture {name}"), "texture_filter", setting, None);
            trials.push(Trial { changes_model: true, ..trial });
        }
    }
    if has.area_lights.is_some() {
        let truest = Setting { light_samples: Some(256), ..start };
        let counts: &[u32] = if quick { &[1, 4, 16] } else { &[1, 4, 16, 64] };
        trials.extend(counts.iter().map(|&count| {
            let setting = Setting { light_samples: Some(count), ..start };
            knob(format!("light samples {count}"), "light_samples", setting, Some(truest))
        }));
    }
}

/// Samples by depth by precision, and by filter where there is a board.
fn grid(trials: &mut Vec<Trial>, start: Setting, has: Knobbed, quick: bool) {
    let samplings: &[(u32, Option<f64>)] = if quick {
        &[(3, None), (5, Some(1.0 / 128.0))]
    } else {
        &[(2, None), (4, None), (5, Some(1.0 / 128.0)), (9, Some(1.0 / 256.0))]
    };
    let depths = [("", start.level, start.cutoff), (", deep", 64, 1.0 / 4096.0)];
    let filters: &[bool] = if has.plain_boards { &[false, true] } else { &[false] };
    for &(side, threshold) in samplings {
        for (depth, level, cutoff) in depths {
            for &filtered in filters {
                let checker_filter = filtered || start.checker_filter;
                let precision = Precision::F32;
                let setting = Setting { side, threshold, level, cutoff, precision, checker_filter, ..start };
                let kind = if threshold.is_some() { "adaptive" } else { "samples" };
                let filter = if filtered { ", checker filter" } else { "" };
                let name = format!("{kind} {}, f32{depth}{filter}", side * side);
                trials.push(Trial { changes_model: filtered, ..knob(name, "grid", setting, None) });
            }
        }
    }
}

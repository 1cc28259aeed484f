//! From faster to truer: the settings of the slider, which keys go through one by one.

use bevy_ecs::prelude::*;

use crate::study::{FrontPoint, Preset, Setting};

use super::editor::{accuracy, own_level};
use super::report::Happened;
use super::session::Session;

/// Which way a step goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Way {
    Faster,
    Truer,
}

impl Session {
    /// Chooses the next setting on this side of the present one, if there is one.
    pub(super) fn step_accuracy(&mut self, way: Way) {
        let now = accuracy(&mut self.world);
        let steps = steps(&self.world, now, &self.fronts.front().points);
        let place = nearest(&steps, &now);
        let next = match way {
            Way::Faster => place.checked_sub(1),
            Way::Truer => Some(place + 1),
        };
        if let Some(setting) = next.and_then(|next| steps.get(next)) {
            self.editor.end_gesture();
            self.editor.change_accuracy(&mut self.world, setting);
            self.report.event(&Happened::Accuracy { flags: &setting.flags() });
        }
    }
}

/// The settings of the slider, from faster to truer: of the scene's front, in a picture as it is asked for now.
pub(super) fn steps(world: &World, now: Setting, points: &[FrontPoint]) -> Vec<Setting> {
    if points.is_empty() {
        let scene = Setting { level: own_level(world).unwrap_or(now.level), ..now };
        return Preset::ALL.map(|preset| preset.of(scene)).to_vec();
    }
    let as_now = |point: &FrontPoint| {
        let Setting { side, threshold, level, cutoff, precision, .. } = point.setting;
        Setting { side, threshold, level, cutoff, precision, ..now }
    };
    points.iter().map(as_now).collect()
}

/// Whether what the slider moves is the same.
pub(super) fn is_at(a: &Setting, b: &Setting) -> bool {
    let Setting { side, threshold, level, cutoff, precision, .. } = *a;
    Setting { side, threshold, level, cutoff, precision, ..*b } == *b
}

/// The place of a setting, or of the one with about as many samples and rays in a row.
pub(super) fn nearest(steps: &[Setting], now: &Setting) -> usize {
    let effort = |setting: &Setting| f64::from(setting.side) * f64::from(setting.level.clamp(1, 8)).sqrt();
    let distance = |setting: &Setting| {
        if is_at(setting, now) { -1.0 } else { (effort(setting) / effort(now)).ln().abs() }
    };
    let places = steps.iter().enumerate().map(|(place, setting)| (place, distance(setting)));
    places.min_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |(place, _)| place)
}

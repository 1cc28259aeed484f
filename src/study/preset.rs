//! Settings with names.

use crate::components::Precision;

use super::Setting;

/// A choice of every knob that has a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Preset {
    /// A quick look: single precision, at most one mirror image, and none that is faint.
    Draft,
    /// Exactly the assignment: one sample in the middle of each pixel, the scene's level, double precision.
    Assignment,
    /// To be shown: up to 25 samples where they matter, deeper mirrors.
    Fine,
    /// To compare with: 256 samples everywhere, mirrors as deep as they are visible.
    Reference,
}

impl Preset {
    /// All, the fastest first.
    pub const ALL: [Self; 4] = [Self::Draft, Self::Assignment, Self::Fine, Self::Reference];

    /// Its name on the command line and in reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Draft => "draft",
            Self::Assignment => "assignment",
            Self::Fine => "fine",
            Self::Reference => "reference",
        }
    }

    /// What it means for a scene with this setting of its own; size, filters and shadow rays stay the scene's.
    #[must_use]
    pub fn of(self, scene: Setting) -> Setting {
        let plain = Setting { side: 1, threshold: None, cutoff: 0.0, precision: Precision::F64, ..scene };
        match self {
            Self::Draft => {
                Setting { level: scene.level.min(2), cutoff: 1.0 / 16.0, precision: Precision::F32, ..plain }
            }
            Self::Assignment => plain,
            Self::Fine => Setting {
                side: 5,
                threshold: Some(1.0 / 128.0),
                level: scene.level.max(8),
                cutoff: 1.0 / 512.0,
                ..plain
            },
            Self::Reference => {
                Setting { side: 16, level: scene.level.max(64), cutoff: 1.0 / 65536.0, ..plain }
            }
        }
    }
}

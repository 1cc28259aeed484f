//! Which values are allowed, in one place: the scene reader and the systems both ask here.

/// An interval of allowed numbers and the words for it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    low: f64,
    high: f64,
    open: bool,
    /// The interval in words, to follow "must be".
    pub words: &'static str,
}

impl Range {
    const fn closed(low: f64, high: f64, words: &'static str) -> Self {
        Self { low, high, open: false, words }
    }

    /// Whether a number is allowed; NaN never is.
    pub fn contains(&self, value: f64) -> bool {
        if self.open {
            self.low < value && value < self.high
        } else {
            self.low <= value && value <= self.high
        }
    }

    /// The allowed number that is closest to a value; `None` for NaN.
    pub fn nearest(&self, value: f64) -> Option<f64> {
        let ends =
            if self.open { (self.low.next_up(), self.high.next_down()) } else { (self.low, self.high) };
        (!value.is_nan()).then(|| value.clamp(ends.0, ends.1))
    }
}

/// A coordinate. The bound keeps every product of the kernels finite.
pub const COORDINATE: Range = Range::closed(-1e70, 1e70, "a number from -1e70 to 1e70");
/// A length: a radius, side, width, height, or distance of a clipping plane.
pub const LENGTH: Range = Range::closed(1e-70, 1e70, "a length from 1e-70 to 1e70");
/// A colour component.
pub const COLOR: Range = Range::closed(0.0, 1.0, "a number from 0 to 1");
/// A coefficient of a surface.
pub const COEFFICIENT: Range = Range::closed(0.0, 1.0, "a number from 0 to 1");
/// A Phong exponent.
pub const SHININESS: Range = Range::closed(0.0, 1e9, "a number from 0 to 1e9");
/// A falloff in 1/unit^2.
pub const FALLOFF: Range = Range::closed(0.0, 1e150, "a number from 0 to 1e150");
/// Red, green or blue of a light.
pub const LIGHT_COLOR: Range = Range::closed(0.0, 1e6, "a number from 0 to 1e6");
/// A radius that may be 0.
pub const EXTENT: Range = Range::closed(0.0, 1e70, "a length from 0 to 1e70");
/// An index of refraction inside by that outside.
pub const INDEX: Range = Range::closed(0.1, 10.0, "a number from 0.1 to 10");
/// A density of fog or absorption in 1/unit.
pub const DENSITY: Range = Range::closed(0.0, 1e150, "a number from 0 to 1e150");
/// Shadow rays towards one light.
pub const LIGHT_SAMPLES: Range = Range::closed(1.0, MAX_LIGHT_SAMPLES as f64, "a number from 1 to 4096");
/// The angle between axis and side of a spot cone, in degrees.
pub const CUTOFF: Range = Range::closed(0.0, 180.0, "an angle from 0 to 180 degrees");
/// A field of view in degrees.
pub const FIELD_OF_VIEW: Range =
    Range { low: 0.0, high: 180.0, open: true, words: "an angle above 0 and below 180 degrees" };
/// The radius of a lens as a share of the distance it is focused on.
pub const OPENING: Range = Range::closed(0.0, 1.0, "a number from 0 to 1");
/// An exposure in stops.
pub const STOPS: Range = Range::closed(-100.0, 100.0, "a number from -100 to 100");
/// A time in seconds.
pub const SECONDS: Range = Range::closed(-1e9, 1e9, "a number from -1e9 to 1e9");
/// A ratio of two lengths.
pub const RATIO: Range = Range::closed(1e-6, 1e6, "a ratio from 1e-6 to 1e6");

/// Most pixels along one side of a picture.
pub const MAX_PIXELS: u32 = 8192;
/// Most rays that follow each other through mirrors, the camera's own included.
pub const MAX_LEVEL: u32 = 1000;
/// Most sample points along one side of a pixel.
pub const MAX_GRID: u32 = 64;
/// Most shadow rays towards one light.
pub const MAX_LIGHT_SAMPLES: u32 = 4096;

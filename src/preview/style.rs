//! What the preview shows besides the objects, and where.

/// How the preview is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PreviewStyle {
    /// Where nothing is: linear red, green and blue, each 0 to 1.
    pub background: [f32; 3],
    /// Whether lights are shown as markers, with their cones.
    pub lights: bool,
    /// Whether the world's axes are shown at its origin: x red, y green, z blue.
    pub axes: bool,
    /// Samples a pixel, as far as GL has them; with 0 or 1 every pixel shows one object alone.
    pub samples: u32,
}

impl Default for PreviewStyle {
    /// Black behind the scene, as the trace has it; lights and axes shown; four samples.
    fn default() -> Self {
        Self { background: [0.0; 3], lights: true, axes: true, samples: 4 }
    }
}

/// Which pictures the window shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Layout {
    /// The preview.
    #[default]
    Preview,
    /// The traced picture.
    Traced,
    /// The left half of the preview and the right half of the traced picture, with a thin line between.
    Split,
}

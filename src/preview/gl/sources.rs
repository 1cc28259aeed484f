//! The shaders, put together from their parts.

const HEAD: &str = include_str!("../shaders/head.glsl");
const RAY: &str = include_str!("../shaders/ray.glsl");
const PAIRS: &str = include_str!("../shaders/pairs.glsl");

/// Asks for a run of the fragment shader for each sample, so that what rays meet has a smooth outline.
const PER_SAMPLE: &str = "#define PER_SAMPLE\n";

/// Vertices of a triangle that covers the whole target; it needs no camera.
pub(super) const SCREEN: &str = concat!("#version 330 core\n", include_str!("../shaders/screen.vert"));
/// Copies pictures of any sizes into the window.
pub(super) const PRESENT: &str = include_str!("../shaders/present.frag");
/// Copies one picture that is as large as it is shown.
pub(super) const PLAIN: &str = include_str!("../shaders/plain.frag");

/// A vertex shader that places things relative to the eye.
fn placing(source: &str) -> String {
    [HEAD, PAIRS, source].concat()
}

/// A fragment shader that meets a body with the ray of each sample.
fn casting(source: &str) -> String {
    [HEAD, PER_SAMPLE, RAY, source].concat()
}

/// Spheres.
pub(super) fn sphere() -> [String; 2] {
    [placing(include_str!("../shaders/sphere.vert")), casting(include_str!("../shaders/sphere.frag"))]
}

/// Cubes and pyramids.
pub(super) fn solid() -> [String; 2] {
    [placing(include_str!("../shaders/solid.vert")), casting(include_str!("../shaders/solid.frag"))]
}

/// A checkerboard; the vertices are those of [`SCREEN`].
pub(super) fn board() -> String {
    [HEAD, PER_SAMPLE, RAY, PAIRS, include_str!("../shaders/board.frag")].concat()
}

/// Lights.
pub(super) fn marker() -> [String; 2] {
    [placing(include_str!("../shaders/marker.vert")), [HEAD, include_str!("../shaders/marker.frag")].concat()]
}

/// Axes, cones and outlines.
pub(super) fn line() -> [String; 2] {
    [placing(include_str!("../shaders/line.vert")), [HEAD, include_str!("../shaders/line.frag")].concat()]
}

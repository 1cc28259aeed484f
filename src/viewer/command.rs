//! What the window can be asked to do.

use crate::components::CameraMove;

/// What a key asks for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Command {
    /// One step of the camera, at plain speed; it goes on while the key is held down.
    Camera(CameraMove),
    /// Read the scene file again.
    Reload,
    /// Trace the view and write it.
    Trace,
    /// Stop tracing, or close a message.
    Cancel,
    /// Texture on or off.
    ToggleTexture,
    /// Preview, traced picture, both, in turn.
    NextMode,
    /// The traced picture, its errors, its rays, in turn.
    NextShows,
    /// The strip of figures on or off.
    ToggleStrip,
    /// The next faster setting of what accuracy costs.
    Faster,
    /// The next truer one.
    Truer,
    /// Panel on or off.
    TogglePanel,
    /// Markers of the lights on or off.
    ToggleLights,
    /// World axes on or off.
    ToggleAxes,
    /// Take the last edit back.
    Undo,
    /// Make the edit again that was taken back last.
    Redo,
    /// Save the scene under a name that is not in use.
    Save,
    /// Another one of what is selected.
    Duplicate,
    /// Delete what is selected.
    Delete,
    /// Close the window.
    Quit,
}

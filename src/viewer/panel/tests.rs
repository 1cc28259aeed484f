//! The panel without a window: what is clicked, dragged and typed there, and what becomes of it.

mod accuracy;
mod asking;
mod editing;
mod effects;
mod listing;
mod saving;
mod screen;
mod session;

/// A folder that goes with its owner.
type Folder = tempfile::TempDir;

fn folder() -> Folder {
    tempfile::tempdir().unwrap()
}

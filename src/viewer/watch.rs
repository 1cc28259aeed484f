//! Watches the scene file for changes on disk.

use std::path::{Path, PathBuf};

use notify::event::{Event, EventKind};
use notify::{RecommendedWatcher, RecursiveMode, Watcher};

/// Calls back whenever the file may have changed, from a thread of its own, until dropped.
pub(super) struct Watch {
    _watcher: RecommendedWatcher,
}

impl Watch {
    /// Watches the folder of `file`, because editors replace files instead of writing into them.
    pub(super) fn new(file: &Path, changed: impl Fn() + Send + 'static) -> notify::Result<Self> {
        let file = file.canonicalize().map_err(notify::Error::io)?;
        let folder = file.parent().map_or_else(|| PathBuf::from("."), Path::to_owned);
        let mut watcher = notify::recommended_watcher(move |event: notify::Result<Event>| {
            if event.is_ok_and(|event| concerns(&event, &file)) {
                changed();
            }
        })?;
        watcher.watch(&folder, RecursiveMode::NonRecursive)?;
        Ok(Self { _watcher: watcher })
    }
}

/// Reading the file is an event too, and must not cause another read.
fn concerns(event: &Event, file: &Path) -> bool {
    let writes = matches!(event.kind, EventKind::Create(_) | EventKind::Modify(_) | EventKind::Remove(_));
    writes && event.paths.iter().any(|path| path == file)
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::sync::mpsc;
    use std::time::Duration;

    use super::*;

    #[test]
    fn a_write_and_a_replacement_are_told_and_a_read_is_not() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("scene.txt");
        fs::write(&file, "1").unwrap();
        let (sender, told) = mpsc::channel();
        let _watch = Watch::new(&file, move || sender.send(()).unwrap_or_default()).unwrap();
        let at_most = Duration::from_secs(10);

        fs::write(&file, "2").unwrap();
        told.recv_timeout(at_most).expect("a write is told");
        fs::write(folder.path().join("next"), "3").unwrap();
        fs::rename(folder.path().join("next"), &file).unwrap();
        told.recv_timeout(at_most).expect("a replacement is told");
        std::thread::sleep(Duration::from_millis(100));
        while told.try_recv().is_ok() {}

        fs::read(&file).unwrap();
        fs::write(folder.path().join("other.txt"), "4").unwrap();
        assert!(told.recv_timeout(Duration::from_millis(200)).is_err());
    }
}

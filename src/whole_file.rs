//! Files that appear whole or not at all.

use std::fs::{self, Permissions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use tempfile::{Builder, NamedTempFile};
use thiserror::Error;

/// A file that cannot be written.
#[derive(Debug, Error)]
#[error("cannot write {path}: {reason}")]
pub struct WriteError {
    path: PathBuf,
    reason: io::Error,
}

/// Whether a file could be written here: its folder exists and takes files, and the file, if there is one, is
/// neither a folder nor protected. Asked before work whose result would be lost.
pub fn check_writable(path: &Path) -> Result<(), WriteError> {
    refuse_target(path).and_then(|()| temporary(path).map(drop)).map_err(|reason| wrap(path, reason))
}

/// Writes a file in one step: the bytes go to a temporary file beside it, which takes its name once complete. A
/// failure leaves whatever was there before.
pub fn write_whole(path: &Path, bytes: &[u8]) -> Result<(), WriteError> {
    let write = || {
        refuse_target(path)?;
        let mut file = temporary(path)?;
        file.write_all(bytes)?;
        file.as_file().sync_all()?;
        file.persist(path)?;
        Ok(())
    };
    write().map_err(|reason| wrap(path, reason))
}

fn temporary(path: &Path) -> io::Result<NamedTempFile> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut builder = Builder::new();
    builder.prefix(".archetrace-");
    // The umask applies: the file gets the mode that any new file would.
    #[cfg(unix)]
    builder.permissions(<Permissions as std::os::unix::fs::PermissionsExt>::from_mode(0o666));
    builder.tempfile_in(folder).map_err(plain)
}

fn refuse_target(path: &Path) -> io::Result<()> {
    match fs::metadata(path) {
        Ok(target) if target.is_dir() => Err(io::Error::other("is a directory")),
        Ok(target) if target.permissions().readonly() => Err(io::Error::other("is read-only")),
        _ => Ok(()),
    }
}

/// The operating system's own reason, without the name of a temporary file that nobody asked for.
fn plain(error: io::Error) -> io::Error {
    error.raw_os_error().map_or_else(|| io::Error::from(error.kind()), io::Error::from_raw_os_error)
}

fn wrap(path: &Path, reason: io::Error) -> WriteError {
    WriteError { path: path.to_owned(), reason }
}

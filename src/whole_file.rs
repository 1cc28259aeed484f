//! Files that appear whole or not at all.

use std::fs;
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

/// Whether a file could be written here: its folder exists and takes files, and the file, if there is one, is a
/// regular one and not protected. Asked before work whose result would be lost.
pub fn check_writable(path: &Path) -> Result<(), WriteError> {
    let check = || temporary(&target(path)?).map(drop);
    check().map_err(|reason| wrap(path, reason))
}

/// Writes a file in one step: the bytes go to a temporary file beside it, which takes its name once complete. A
/// failure leaves whatever was there before. A link is followed, and a file that is replaced keeps its mode.
pub fn write_whole(path: &Path, bytes: &[u8]) -> Result<(), WriteError> {
    let write = || {
        let target = target(path)?;
        let mut file = temporary(&target)?;
        if let Ok(replaced) = target.metadata() {
            file.as_file().set_permissions(replaced.permissions())?;
        }
        file.as_file_mut().write_all(bytes)?;
        file.as_file().sync_all()?;
        file.persist(&target)?;
        Ok(())
    };
    write().map_err(|reason| wrap(path, reason))
}

/// What the path stands for, if that is something that can be replaced or made.
fn target(path: &Path) -> io::Result<PathBuf> {
    match fs::metadata(path) {
        Ok(found) if found.is_dir() => Err(io::Error::other("is a directory")),
        Ok(found) if !found.is_file() => Err(io::Error::other("not a regular file")),
        Ok(found) if found.permissions().readonly() => Err(io::Error::other("is read-only")),
        Ok(_) => fs::canonicalize(path),
        Err(_) => Ok(path.to_owned()),
    }
}

fn temporary(target: &Path) -> io::Result<NamedTempFile> {
    let folder = target.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut builder = Builder::new();
    builder.prefix(".archetrace-");
    // The umask applies: a new file gets the mode that any new file would.
    #[cfg(unix)]
    builder.permissions(<fs::Permissions as std::os::unix::fs::PermissionsExt>::from_mode(0o666));
    // A folder that is none is told best by the system itself. Of a temporary file's failure only the kind is told:
    // its name is nobody's business.
    fs::read_dir(folder)?;
    builder.tempfile_in(folder).map_err(|error| error.kind().into())
}

fn wrap(path: &Path, reason: io::Error) -> WriteError {
    WriteError { path: path.to_owned(), reason }
}

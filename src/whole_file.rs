//! Files that appear whole or not at all.

use std::ffi::OsString;
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

/// Whether a folder takes new files. Asked before work whose result would be lost.
pub fn check_folder(folder: &Path) -> Result<(), WriteError> {
    temporary_in(folder).map(drop).map_err(|reason| wrap(folder, reason))
}

/// Writes a new file in one step, under the first name of a folder that nothing has yet, and gives back its path. Who
/// else takes a name in between keeps it, and the next one is tried.
pub fn write_new(
    folder: &Path,
    names: impl IntoIterator<Item = OsString>,
    bytes: &[u8],
) -> Result<PathBuf, WriteError> {
    let write = || {
        let mut file = temporary_in(folder)?;
        file.as_file_mut().write_all(bytes)?;
        file.as_file().sync_all()?;
        for name in names {
            let path = folder.join(name);
            match file.persist_noclobber(&path) {
                Ok(_) => return Ok(path),
                Err(taken) if taken.error.kind() == io::ErrorKind::AlreadyExists => file = taken.file,
                Err(failed) => return Err(failed.error),
            }
        }
        Err(io::Error::other("no name is free"))
    };
    write().map_err(|reason| wrap(folder, reason))
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
    temporary_in(target.parent().unwrap_or(Path::new("")))
}

fn temporary_in(folder: &Path) -> io::Result<NamedTempFile> {
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
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

#[cfg(test)]
mod tests {
    use super::*;

    fn names() -> impl Iterator<Item = OsString> {
        (1..=3).map(|number| format!("{number}.txt").into())
    }

    fn contents(folder: &Path) -> Vec<(String, Vec<u8>)> {
        let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap());
        let mut contents: Vec<_> = entries
            .map(|entry| {
                (entry.file_name().into_string().unwrap(), fs::read(entry.path()).unwrap_or_default())
            })
            .collect();
        contents.sort();
        contents
    }

    #[test]
    fn the_first_free_name_is_taken_and_nothing_is_replaced() {
        let folder = tempfile::tempdir().unwrap();
        // A folder, and a link to nothing, have their names too.
        fs::create_dir(folder.path().join("1.txt")).unwrap();
        #[cfg(unix)]
        std::os::unix::fs::symlink("nowhere", folder.path().join("2.txt")).unwrap();
        assert_eq!(write_new(folder.path(), names(), b"new").unwrap(), folder.path().join("3.txt"));
        assert_eq!(fs::read(folder.path().join("3.txt")).unwrap(), b"new");

        let before = contents(folder.path());
        let error = write_new(folder.path(), names(), b"newer").unwrap_err();
        assert!(error.to_string().ends_with(": no name is free"), "{error}");
        assert_eq!(contents(folder.path()), before);
    }

    #[test]
    fn many_writers_at_once_take_a_name_each() {
        let folder = tempfile::tempdir().unwrap();
        let names = || (0..64).map(|number| OsString::from(number.to_string()));
        let path = folder.path();
        let written: Vec<PathBuf> = std::thread::scope(|scope| {
            let write = |byte| scope.spawn(move || write_new(path, names(), &[byte; 9999]).unwrap());
            let writers: Vec<_> = (0..16).map(write).collect();
            writers.into_iter().map(|writer| writer.join().unwrap()).collect()
        });
        for (byte, path) in (0..).zip(&written) {
            assert_eq!(fs::read(path).unwrap(), [byte; 9999], "{}", path.display());
        }
        assert_eq!(contents(folder.path()).len(), 16);
    }

    #[test]
    fn a_folder_that_takes_no_files_is_told() {
        let folder = tempfile::tempdir().unwrap();
        check_folder(folder.path()).unwrap();
        check_folder(Path::new("")).unwrap();
        assert_eq!(contents(folder.path()), []);
        for wrong in [folder.path().join("none"), "/proc".into()] {
            let expected = format!("cannot write {}: ", wrong.display());
            let checked = check_folder(&wrong).unwrap_err().to_string();
            let written = write_new(&wrong, names(), b"").unwrap_err().to_string();
            assert!(checked.starts_with(&expected) && written == checked, "{checked}, {written}");
            assert!(!checked.contains(".archetrace-"), "{checked}");
        }
    }
}

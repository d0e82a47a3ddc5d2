//! Replacing a file in one step.
//!
//! The new text is written to a temporary file in the same folder, made durable, and renamed over the old file; then
//! the folder is made durable. A crash, a kill or a full disk at any moment leaves the old file or the new one, whole.

use std::{
    fs::{self, File, Metadata, TryLockError},
    io::{self, Write},
    path::{Path, PathBuf},
    thread,
    time::{Duration, Instant, SystemTime},
};

use tempfile::NamedTempFile;

use super::{FileError, Fingerprint, failed, ordinary, read_bytes, system};

/// Precondition of a save: the state of the file on disk.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Before {
    /// There must be none.
    Absent,
    /// It must be what was opened, or last saved.
    Was(Fingerprint),
    /// Whatever it is: the user said "overwrite".
    Whatever,
}

/// Replaces the content of the file, or leaves it as it is. A symbolic link is kept, and its target replaced; permissions,
/// group and, where the system allows it, owner are kept; a hard link is left with the old text.
///
/// The answer is what the file is now, for the next [`Before::Was`].
pub fn save(path: &Path, content: impl AsRef<[u8]>, before: Before) -> Result<Fingerprint, FileError> {
    save_with(path, content, before, &mut |_| Ok(()))
}

/// Saves files that belong together: the first where that is as it must be, then the others over what is there. The
/// answer names the first, or the one that could not be written.
pub fn save_all(files: &[(PathBuf, Vec<u8>)], before: Before) -> (PathBuf, Result<(), FileError>) {
    let mut before = before;
    for (path, content) in files {
        if let Err(error) = save(path, content, before) {
            return (path.clone(), Err(error));
        }
        before = Before::Whatever;
    }
    (files.first().map(|(path, _)| path.clone()).unwrap_or_default(), Ok(()))
}

/// Removes what crashed programs left in a folder: their temporary files, older than a minute, whose process has
/// ended. Answers how many were removed; what cannot be examined is left.
pub fn remove_leftovers(folder: &Path) -> usize {
    remove_leftovers_older(folder, Duration::from_mins(1))
}

/// A step of a save, reported before it is done. Tests let each of them fail.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Step {
    Create,
    /// The next 64 KiB of the text.
    Write,
    Permit,
    Sync,
    Rename,
    SyncFolder,
}

pub(super) fn save_with(
    path: &Path,
    content: impl AsRef<[u8]>,
    before: Before,
    step: &mut dyn FnMut(Step) -> io::Result<()>,
) -> Result<Fingerprint, FileError> {
    let content = content.as_ref();
    if !folder_of(path).is_dir() {
        return Err(FileError::NoFolder(folder_of(path).to_owned()));
    }
    let (target, old) = resolve(path)?;
    let folder = folder_of(&target);
    // Another instance may be between its check and its rename.
    let _lock = lock(folder);
    match (before, &old) {
        (Before::Absent, Some(_)) => return Err(FileError::Exists(path.to_owned())),
        (Before::Was(_), None) => return Err(FileError::Removed(path.to_owned())),
        (Before::Was(opened), Some(_)) if Fingerprint::of(&read_bytes(&target)?) != opened => {
            return Err(FileError::Changed(path.to_owned()));
        }
        _ => {}
    }
    if old.is_some() && !system::is_writable(&target) {
        return Err(FileError::ReadOnly(path.to_owned()));
    }

    // Dropped on any error below, which removes it.
    let mut file = step(Step::Create)
        .and_then(|()| temporary(folder, old.is_some()))
        .map_err(failed("write in the folder of", path))?;
    for part in content.chunks(64 * 1024) {
        step(Step::Write).and_then(|()| file.write_all(part)).map_err(failed("write", path))?;
    }
    if let Some(old) = old {
        step(Step::Permit)
            .and_then(|()| system::permit(file.as_file(), &old))
            .map_err(failed("keep the permissions of", path))?;
    }
    step(Step::Sync).and_then(|()| file.as_file().sync_all()).map_err(failed("write", path))?;
    step(Step::Rename)
        .and_then(|()| match before {
            Before::Absent => file.persist_noclobber(&target).map_err(|error| error.error),
            _ => file.persist(&target).map_err(|error| error.error),
        })
        .map_err(|error| match error.kind() {
            io::ErrorKind::AlreadyExists => FileError::Exists(path.to_owned()),
            _ => failed("replace", path)(error),
        })?;
    remove_leftovers(folder);
    step(Step::SyncFolder)
        .and_then(|()| system::sync_folder(folder))
        .map_err(failed("make sure of", path))?;
    Ok(Fingerprint::of(content))
}

pub(super) fn remove_leftovers_older(folder: &Path, age: Duration) -> usize {
    let Ok(entries) = fs::read_dir(folder) else { return 0 };
    entries
        .flatten()
        .filter(|entry| {
            let name = entry.file_name();
            let owner = name
                .to_str()
                .and_then(|name| name.strip_prefix(PREFIX)?.strip_suffix(SUFFIX)?.split('-').next());
            let Some(owner) = owner.and_then(|owner| owner.parse().ok()) else { return false };
            // Not through a link: a name of ours can be planted.
            let Ok(metadata) = entry.path().symlink_metadata() else { return false };
            let written = metadata.modified().unwrap_or_else(|_| SystemTime::now());
            metadata.is_file()
                && !system::runs(owner)
                && written.elapsed().is_ok_and(|past| past >= age)
                && fs::remove_file(entry.path()).is_ok()
        })
        .count()
}

/// A new file beside the target that nobody else has: random name, created exclusively, with the process in its name.
/// One that takes the place of another is its owner's alone until it has the permissions of that one.
fn temporary(folder: &Path, is_private: bool) -> io::Result<NamedTempFile> {
    let prefix = format!("{PREFIX}{}-", std::process::id());
    let mut file = tempfile::Builder::new();
    file.prefix(&prefix).suffix(SUFFIX);
    system::begin(&mut file, is_private);
    file.tempfile_in(folder)
}

const PREFIX: &str = ".dalembert-";
const SUFFIX: &str = ".tmp";

/// The file itself, behind all links, and its metadata if it exists.
fn resolve(path: &Path) -> Result<(PathBuf, Option<Metadata>), FileError> {
    match fs::canonicalize(path) {
        Ok(target) => {
            let metadata = fs::metadata(&target).map_err(failed("inspect", path))?;
            ordinary(path, metadata.file_type())?;
            Ok((target, Some(metadata)))
        }
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            // A new file, or a link to one that is not there: the link must not be replaced by a file.
            let target = match fs::read_link(path) {
                Ok(link) => folder_of(path).join(link),
                Err(_) => path.to_owned(),
            };
            let name = target.file_name().ok_or_else(|| FileError::Folder(path.to_owned()))?;
            let folder = fs::canonicalize(folder_of(&target)).map_err(failed("open the folder of", path))?;
            Ok((folder.join(name), None))
        }
        Err(error) => Err(failed("find", path)(error)),
    }
}

pub(super) fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// An advisory lock on the folder, until it is dropped. Where there is none to be had, the save goes ahead without.
fn lock(folder: &Path) -> Option<File> {
    let handle = File::open(folder).ok()?;
    let start = Instant::now();
    loop {
        match handle.try_lock() {
            Ok(()) => return Some(handle),
            // Ours hold it for a moment only; whoever holds it longer is another program.
            Err(TryLockError::WouldBlock) if start.elapsed() < Duration::from_secs(2) => {
                thread::sleep(Duration::from_millis(5));
            }
            Err(_) => return None,
        }
    }
}

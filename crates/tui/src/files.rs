//! Files of the user: read with limits, saved whole or not at all, kept aside against a crash.
//!
//! A problem file is small and precious. So [`read`] takes regular files of UTF-8 up to [`LARGEST`] and nothing else;
//! [`save`] replaces a file in one step, after asking whether it is still the one that was opened; [`Autosave`] keeps
//! unsaved work where the next start finds it. Every message names the file and says what to do.

mod autosave;
mod memory;
mod save;
mod system;
mod table;

#[cfg(test)]
#[cfg(unix)]
mod tests;

use std::{
    fs::{self, FileType},
    hash::{DefaultHasher, Hash, Hasher},
    io::{self, Read},
    path::{Component, Path, PathBuf},
};

pub use autosave::{Autosave, Crashed, autosave_path};
pub use dalembert_import::holds_data;
pub use memory::{Memory, recall, remember, remembered_path, sets, sets_path};
pub use save::{Before, remove_leftovers, save, save_all};
pub use table::{preview_table, read_table};

use dalembert_core::{Locale, Text, file};

use crate::glyphs::filter_untrusted;

/// The largest file that is read, in bytes.
pub const LARGEST: u64 = 256 * 1024 * 1024;

/// So many faults of a file are listed.
const MOST_FAULTS: usize = 8;

/// So many names of a folder are listed.
const MOST_NAMES: usize = 1_000;

/// Reason for which a file was not read or written.
#[derive(Debug, thiserror::Error)]
pub enum FileError {
    /// There is no such file.
    #[error("file `{}` not found: check its name and folder", shown(.0))]
    Missing(PathBuf),
    /// The folder that a file is to be written into is missing.
    #[error("folder `{}` not found: create it or choose another one", shown(.0))]
    NoFolder(PathBuf),
    /// It is a folder.
    #[error("`{}` is a folder: give a file in it", shown(.0))]
    Folder(PathBuf),
    /// A pipe, a device or a socket.
    #[error("`{}` is a {kind}: only ordinary files are read and written", shown(.path))]
    NotOrdinary {
        /// Path.
        path: PathBuf,
        /// Type of the file, in words.
        kind: &'static str,
    },
    /// It holds more than [`LARGEST`].
    #[error("`{}` is larger than {} MiB: not a problem file, or holds data that belong in a file of their own", shown(.0), LARGEST / (1024 * 1024))]
    TooLarge(PathBuf),
    /// It is to be read into a table, and holds more than [`LARGEST`].
    #[error("`{}` is too large for a table (limit {} MiB): keep every tenth row, or the range of interest", shown(.0), LARGEST / (1024 * 1024))]
    TooLargeForTable(PathBuf),
    /// It is not UTF-8.
    #[error("`{}` is not UTF-8 text: invalid byte {byte} in line {line}{}", shown(.path), if *utf16 { ", and the file looks like UTF-16; save it as UTF-8" } else { "; save it as UTF-8" })]
    NotUtf8 {
        /// Path.
        path: PathBuf,
        /// Bytes before the first that is wrong.
        byte: usize,
        /// The line of that byte, from 1.
        line: usize,
        /// It begins with the mark of UTF-16.
        utf16: bool,
    },
    /// The user may not write it.
    #[error("`{}` is read-only: save under another name, or change its permissions", shown(.0))]
    ReadOnly(PathBuf),
    /// Another program wrote it after it was opened.
    #[error("`{}` was changed on disk since it was opened: reload it, save under another name, or overwrite it", shown(.0))]
    Changed(PathBuf),
    /// Another program removed it after it was opened.
    #[error("`{}` was removed since it was opened: overwrite to write it again, or save under another name", shown(.0))]
    Removed(PathBuf),
    /// A new file was to be written, and there is one.
    #[error("`{}` exists already: choose another name, or overwrite it", shown(.0))]
    Exists(PathBuf),
    /// The system has no place for a program's state.
    #[error("no automatic backup of unsaved work: {0}; save often")]
    NoAutosave(String),
    /// It is ours, and cannot be understood.
    #[error("`{}` cannot be read and is left unchanged: {why}", shown(.path))]
    Broken {
        /// Path.
        path: PathBuf,
        /// Reason.
        why: String,
    },
    /// It is read, and gives no table.
    #[error("`{}`: {}", shown(.path), .why.english())]
    NoTable {
        /// Path.
        path: PathBuf,
        /// Reason.
        why: Text,
    },
    /// A call to the system failed.
    #[error("could not {action} `{}`: {source}{}", shown(.path), advice(.source))]
    Failed {
        /// Action that failed, as a verb.
        action: &'static str,
        /// With which file or folder.
        path: PathBuf,
        /// Error of the system.
        source: io::Error,
    },
}

impl FileError {
    /// Message as a translatable sentence.
    pub fn text(&self) -> Text {
        match self {
            FileError::Missing(path) => {
                Text::new("file {file} not found: check its name and folder").with("file", shown(path))
            }
            FileError::NoFolder(path) => {
                Text::new("folder {file} not found: create it or choose another one").with("file", shown(path))
            }
            FileError::Folder(path) => {
                Text::new("{file} is a folder: give a file in it").with("file", shown(path))
            }
            FileError::NotOrdinary { path, kind } => {
                Text::new("{file} is a {kind}: only ordinary files are read and written")
                    .with("file", shown(path))
                    .with_text("kind", *kind)
            }
            FileError::TooLarge(path) => Text::new("{file} is larger than {most} MiB: not a problem file")
                .with("file", shown(path))
                .with("most", LARGEST >> 20),
            FileError::TooLargeForTable(path) => {
                Text::new("{file} is too large for a table (limit {most} MiB): keep every tenth row, or the range of interest")
                    .with("file", shown(path))
                    .with("most", LARGEST >> 20)
            }
            FileError::NotUtf8 { path, byte, line, .. } => {
                Text::new("{file} is not UTF-8 text: invalid byte {byte} in line {line}")
                    .with("file", shown(path))
                    .with("byte", byte)
                    .with("line", line)
            }
            FileError::ReadOnly(path) => {
                Text::new("{file} is read-only: save under another name").with("file", shown(path))
            }
            FileError::Changed(path) | FileError::Removed(path) => {
                Text::new("{file} was changed by another program since it was opened.")
                    .with("file", shown(path))
            }
            FileError::Exists(path) => Text::new("{file} already exists.").with("file", shown(path)),
            FileError::NoAutosave(why) => {
                Text::new("no automatic backup of unsaved work: {why}; save often").with("why", why)
            }
            FileError::Broken { path, why } => {
                Text::new("{file} cannot be read and is left unchanged: {why}")
                    .with("file", shown(path))
                    .with("why", filter_untrusted(why))
            }
            FileError::NoTable { path, why } => {
                Text::new("{file}: {why}").with("file", shown(path)).with_text("why", why.clone())
            }
            FileError::Failed { path, source, .. } => Text::new("{file} could not be read or written: {why}")
                .with("file", shown(path))
                .with("why", source),
        }
    }
}

/// Fingerprint of the content of a file: equal when its bytes are equal. Times are not examined; copying and
/// synchronising change them without a change, and a quick edit may not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fingerprint {
    length: usize,
    hash: u64,
}

impl Fingerprint {
    /// That of these bytes.
    pub fn of(bytes: &[u8]) -> Self {
        let mut hasher = DefaultHasher::new();
        bytes.hash(&mut hasher);
        Self { length: bytes.len(), hash: hasher.finish() }
    }
}

/// A file that was read.
#[derive(Clone, Debug, PartialEq)]
pub struct Opened {
    /// Text, without a byte-order mark.
    pub text: String,
    /// Fingerprint of the content, for [`Before::Was`].
    pub fingerprint: Fingerprint,
    /// Texts of the problem files that it links to.
    pub linked: LinkedTexts,
}

/// Texts of the problem files that a problem file links to, by their paths from its folder; or why one was not read.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LinkedTexts(Vec<(String, Result<String, Text>)>);

impl LinkedTexts {
    /// Reads the files that the text of a file at a path links to.
    pub fn of(path: &Path, text: &str) -> Self {
        let mut found = Vec::new();
        if text.contains('@') {
            // What is wrong with the problem is reported where it is read.
            let _ = file::parse_with(text, &mut |linked| {
                let read = read_linked(path, linked);
                found.push((linked.to_owned(), read.clone()));
                read
            });
        }
        Self(found)
    }

    /// The text of the file at a path, or why it was not read; `None` of a file that nothing linked to.
    pub fn text(&self, path: &str) -> Option<&Result<String, Text>> {
        self.0.iter().find(|(known, _)| known == path).map(|(_, text)| text)
    }

    /// Takes the text that a file has now, where it is one of these. `beside` is the path of the file that links to them.
    pub fn take(&mut self, beside: &Path, path: &Path, text: &str) {
        for (linked, known) in &mut self.0 {
            if is_same_file(&beside_file(Some(beside), linked), path) {
                *known = Ok(text.to_owned());
            }
        }
    }

    /// Returns true if nothing is linked.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

/// Path of a file that the one at `beside` links to.
pub fn beside_file(beside: Option<&Path>, linked: &str) -> PathBuf {
    beside.and_then(Path::parent).unwrap_or(Path::new("")).join(linked)
}

/// Returns true if two paths are written for the same place, whether from the present folder or from the root.
pub fn is_same_file(one: &Path, other: &Path) -> bool {
    let whole = |path: &Path| {
        let mut parts = Vec::new();
        for part in std::path::absolute(path).as_deref().unwrap_or(path).components() {
            match part {
                Component::CurDir => {}
                Component::ParentDir => drop(parts.pop()),
                part => parts.push(part.as_os_str().to_owned()),
            }
        }
        parts
    };
    whole(one) == whole(other)
}

/// Text of a problem file that the file at `beside` links to, by its path from there.
pub fn read_linked(beside: &Path, linked: &str) -> Result<String, Text> {
    let bytes = read_bytes(&beside_file(Some(beside), linked)).map_err(|error| error.text())?;
    opened(Path::new(linked), bytes).map(|opened| opened.text).map_err(|error| error.text())
}

/// Reads a regular file of UTF-8 text of at most [`LARGEST`] bytes. Never waits for a pipe, never reads a device. What
/// killed saves left beside it is removed.
pub fn read(path: &Path) -> Result<Opened, FileError> {
    let bytes = read_bytes(path)?;
    if let Ok(target) = fs::canonicalize(path) {
        remove_leftovers(save::folder_of(&target));
    }
    let mut opened = opened(path, bytes)?;
    opened.linked = LinkedTexts::of(path, &opened.text);
    Ok(opened)
}

/// Reads a stream of UTF-8 text of at most [`LARGEST`] bytes to its end; messages call it `name`.
pub fn read_from(stream: impl Read, name: &Path) -> Result<Opened, FileError> {
    let mut bytes = Vec::new();
    stream.take(LARGEST + 1).read_to_end(&mut bytes).map_err(failed("read", name))?;
    if bytes.len() as u64 > LARGEST {
        return Err(FileError::TooLarge(name.to_owned()));
    }
    opened(name, bytes)
}

fn opened(path: &Path, bytes: Vec<u8>) -> Result<Opened, FileError> {
    let fingerprint = Fingerprint::of(&bytes);
    let text = String::from_utf8(bytes).map_err(|error| {
        let byte = error.utf8_error().valid_up_to();
        let bytes = error.as_bytes();
        FileError::NotUtf8 {
            path: path.to_owned(),
            byte,
            line: bytes[..byte].split(|&byte| byte == b'\n').count(),
            utf16: bytes.starts_with(b"\xFF\xFE") || bytes.starts_with(b"\xFE\xFF"),
        }
    })?;
    let text = text.strip_prefix('\u{FEFF}').map(str::to_owned).unwrap_or(text);
    Ok(Opened { text, fingerprint, linked: LinkedTexts::default() })
}

/// Contents of a folder, in the order of names; folders end in `/`. Nothing where it cannot be read.
pub fn list(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten().take(MOST_NAMES);
    let mut names: Vec<String> = entries
        .filter_map(|entry| {
            let end = if entry.path().is_dir() { "/" } else { "" };
            entry.file_name().into_string().ok().map(|name| name + end)
        })
        .collect();
    names.sort_by_key(|name| name.to_lowercase());
    names
}

/// The bytes of a regular file, at most [`LARGEST`].
pub fn read_bytes(path: &Path) -> Result<Vec<u8>, FileError> {
    // Before it is opened: opening alone can have an effect on a device.
    ordinary(path, fs::metadata(path).map_err(failed("read", path))?.file_type())?;
    let file = system::open(path).map_err(failed("open", path))?;
    let metadata = file.metadata().map_err(failed("read", path))?;
    ordinary(path, metadata.file_type())?;
    let mut bytes = Vec::new();
    if metadata.len() <= LARGEST {
        // It may grow while it is read, and files of `/proc` say they are empty.
        file.take(LARGEST + 1).read_to_end(&mut bytes).map_err(failed("read", path))?;
    }
    if metadata.len().max(bytes.len() as u64) > LARGEST {
        return Err(FileError::TooLarge(path.to_owned()));
    }
    Ok(bytes)
}

fn ordinary(path: &Path, kind: FileType) -> Result<(), FileError> {
    let path = path.to_owned();
    let kind = match kind {
        kind if kind.is_file() => return Ok(()),
        kind if kind.is_dir() => return Err(FileError::Folder(path)),
        kind => system::kind(kind),
    };
    Err(FileError::NotOrdinary { path, kind })
}

/// `failed("read", path)` for `map_err`.
fn failed(action: &'static str, path: &Path) -> impl FnOnce(io::Error) -> FileError {
    move |source| match source.kind() {
        io::ErrorKind::NotFound => FileError::Missing(path.to_owned()),
        _ => FileError::Failed { action, path: path.to_owned(), source },
    }
}

fn advice(error: &io::Error) -> &'static str {
    match error.kind() {
        io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded | io::ErrorKind::FileTooLarge => {
            "; free some space, or save to another disk"
        }
        io::ErrorKind::PermissionDenied | io::ErrorKind::ReadOnlyFilesystem => "; save to another folder",
        _ => "",
    }
}

/// A path for a message; a file name can hold anything but a zero byte and a slash.
pub(crate) fn shown(path: &Path) -> String {
    filter_untrusted(&path.to_string_lossy()).replace('\n', "\u{FFFD}")
}

/// Lists the faults of the text of a problem, each with its line.
pub(crate) fn faults(text: &str, errors: &[file::FileError], locale: &Locale) -> Vec<String> {
    let mut lines: Vec<String> = errors
        .iter()
        .take(MOST_FAULTS)
        .map(|error| {
            let line = error.span.as_ref().map(|span| file::line_of(text, span.start));
            let text = match line {
                Some(line) => Text::new("line {line}: {why}").with("line", line),
                None => Text::new("{why}"),
            };
            filter_untrusted(&text.with_text("why", error.why.clone()).render(locale)).into_owned()
        })
        .collect();
    if errors.len() > MOST_FAULTS {
        let more = Text::new("and {more} more").with("more", errors.len() - MOST_FAULTS);
        lines.push(more.render(locale));
    }
    lines
}

/// `~/` at the beginning of a path is the user's home.
pub(crate) fn at_home(path: PathBuf) -> PathBuf {
    match (path.strip_prefix("~"), std::env::var_os("HOME")) {
        (Ok(rest), Some(home)) => Path::new(&home).join(rest),
        _ => path,
    }
}

//! Unsaved work, kept where the next start finds it.
//!
//! One file a problem in a folder that only the user can open (`$XDG_STATE_HOME/dalembert/autosave`). Its first
//! line says whose it is; the rest is the text. A file whose process has ended is the work of a session that crashed.

use std::{
    collections::BTreeMap,
    fs,
    path::{Path, PathBuf},
    process,
    sync::{Mutex, MutexGuard, PoisonError},
    time::{Duration, SystemTime},
};

use etcetera::{BaseStrategy, choose_base_strategy};

use super::{
    Before, FileError, LinkedTexts, failed, read,
    save::{remove_leftovers, save},
    system::{self, began, host, runs},
};

/// The unsaved work of this session, by the numbers of its problems.
///
/// [`note`](Self::note) is cheap and belongs after every change; [`flush`](Self::flush) writes what was noted last
/// and belongs on a timer and in the [`autosave`](crate::terminal::Options::autosave) of the terminal, from any
/// thread; [`forget`](Self::forget) belongs after a save and at the end.
#[derive(Debug, Default)]
pub struct Autosave {
    /// `None`: there is nowhere to keep anything.
    folder: Option<PathBuf>,
    work: Mutex<BTreeMap<u64, Work>>,
}

#[derive(Debug, Default)]
struct Work {
    original: Option<PathBuf>,
    text: String,
    written: bool,
    file: Option<PathBuf>,
}

/// The folder of unsaved work: `$XDG_STATE_HOME/dalembert/autosave`. `None` without a home.
pub fn autosave_path() -> Option<PathBuf> {
    let base = choose_base_strategy().ok()?;
    Some(base.state_dir().unwrap_or_else(|| base.data_dir()).join("dalembert").join("autosave"))
}

/// Work recovered from a crashed session.
#[derive(Clone, Debug, PartialEq)]
pub struct Crashed {
    /// The file it worked on; `None` if it had no name yet.
    pub original: Option<PathBuf>,
    /// The unsaved text.
    pub text: String,
    /// Time of the autosave.
    pub kept: SystemTime,
    /// Texts of the files that it links to, from the folder of that file.
    pub linked: LinkedTexts,
    file: PathBuf,
}

impl Autosave {
    /// The autosave of this session, in the folder of the user's state. Without one (no home, a read-only disk) it
    /// keeps nothing, and the error reports it once; the program goes on.
    pub fn open() -> (Self, Option<FileError>) {
        let folder =
            autosave_path().ok_or_else(|| FileError::NoAutosave("there is no home folder".to_owned()));
        match folder.and_then(Self::in_folder) {
            Ok(autosave) => (autosave, None),
            Err(error) => (Self::default(), Some(error)),
        }
    }

    /// The autosave in a folder of the user's own, which is created if it is not there.
    pub fn in_folder(folder: PathBuf) -> Result<Self, FileError> {
        system::private_folder(&folder)?;
        remove_leftovers(&folder);
        Ok(Self { folder: Some(folder), work: Mutex::default() })
    }

    /// Remembers the work on a problem as it is now.
    pub fn note(&self, problem: u64, original: Option<&Path>, text: String) {
        let mut all = self.work();
        let work = all.entry(problem).or_default();
        *work = Work { original: original.map(Path::to_owned), text, written: false, file: work.file.take() };
    }

    /// Writes what was noted last of each problem, unless it is written already. Every one is tried; the error is the
    /// first.
    pub fn flush(&self) -> Result<(), FileError> {
        let Some(folder) = &self.folder else { return Ok(()) };
        let mut all = self.work();
        let mut unwritten = all.values_mut().filter(|work| !work.written).map(|work| work.write(folder));
        let first = unwritten.find(Result::is_err);
        unwritten.for_each(drop);
        first.unwrap_or(Ok(()))
    }

    /// The work on a problem is saved, or given up: nothing of it is kept any more.
    pub fn forget(&self, problem: u64) {
        if let Some(file) = self.work().remove(&problem).and_then(|work| work.file) {
            // If it stays, it is offered at the next start, which does no harm.
            let _ = fs::remove_file(file);
        }
    }

    /// Autosaves of crashed sessions, the newest first. A file that is not ours, or cannot be read, is passed over.
    pub fn crashed(&self) -> Vec<Crashed> {
        let Some(entries) = self.folder.as_ref().and_then(|folder| fs::read_dir(folder).ok()) else {
            return Vec::new();
        };
        let mut found: Vec<Crashed> = entries.flatten().filter_map(|entry| crashed(entry.path())).collect();
        found.sort_by_key(|crashed| std::cmp::Reverse(crashed.kept));
        found
    }

    fn work(&self) -> MutexGuard<'_, BTreeMap<u64, Work>> {
        self.work.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Work {
    fn write(&mut self, folder: &Path) -> Result<(), FileError> {
        let text = format!("{}\n{}", header(self.original.as_deref()), self.text);
        let file = match &self.file {
            Some(file) => file.clone(),
            None => new_name(folder)?,
        };
        save(&file, &text, Before::Whatever)?;
        self.file = Some(file);
        self.written = true;
        Ok(())
    }
}

impl Crashed {
    /// Removes it: its text was taken over, or is not wanted.
    pub fn discard(self) -> Result<(), FileError> {
        fs::remove_file(&self.file).map_err(failed("remove", &self.file))
    }
}

/// A file of a name that nobody can have guessed, created exclusively.
fn new_name(folder: &Path) -> Result<PathBuf, FileError> {
    let file = tempfile::Builder::new()
        .prefix(&format!("{}-", process::id()))
        .suffix(EXTENSION)
        .tempfile_in(folder)
        .map_err(failed("write in the folder", folder))?;
    let (_, path) = file.keep().map_err(|error| failed("write in the folder", folder)(error.error))?;
    Ok(path)
}

const EXTENSION: &str = ".toml";
const MARK: &str = "# dalembert autosave";
/// A session on another machine that shares the folder cannot be seen; after this long it has ended.
const FORGOTTEN: Duration = Duration::from_hours(24);

/// The first line of an autosave: a comment to every reader of TOML.
fn header(original: Option<&Path>) -> String {
    let path = original.map_or_else(String::new, |path| {
        let path = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
        format!(" path={}", escape(&system::bytes_of(&path)))
    });
    let began = began("self").map_or_else(String::new, |began| format!(" began={began}"));
    format!("{MARK} pid={}{began} host={}{path}", process::id(), escape(host().as_bytes()))
}

fn crashed(file: PathBuf) -> Option<Crashed> {
    // Not through a link: the folder is private, but what is in it may be planted by a careless copy.
    let metadata = file.symlink_metadata().ok().filter(fs::Metadata::is_file)?;
    let text = read(&file).ok()?.text;
    let (header, text) = text.split_once('\n')?;
    let field = |name: &str| header.strip_prefix(MARK)?.split(' ').find_map(|part| part.strip_prefix(name));
    let process: i32 = field("pid=")?.parse().ok()?;
    let kept = metadata.modified().ok()?;
    let ended = match field("host=").map(unescape) {
        Some(theirs) if theirs == host().as_bytes() => {
            // A number that is used again belongs to a process that began later.
            let another = match (field("began="), began(&process.to_string())) {
                (Some(noted), Some(now)) => noted != now,
                _ => false,
            };
            another || !runs(process)
        }
        _ => kept.elapsed().is_ok_and(|past| past > FORGOTTEN),
    };
    let original = field("path=").map(|path| system::path_of(unescape(path)));
    ended.then(|| {
        let linked = LinkedTexts::of(original.as_deref().unwrap_or(Path::new("")), text);
        Crashed { original, text: text.to_owned(), kept, linked, file }
    })
}

/// Printable ASCII without space and `%`; every other byte as `%` and two digits.
fn escape(bytes: &[u8]) -> String {
    bytes
        .iter()
        .map(|&byte| match byte {
            b'!'..=b'~' if byte != b'%' => char::from(byte).to_string(),
            _ => format!("%{byte:02X}"),
        })
        .collect()
}

/// The inverse of [`escape`]; a `%` without two digits stands for itself.
fn unescape(text: &str) -> Vec<u8> {
    let mut rest = text.as_bytes();
    let mut plain = Vec::with_capacity(rest.len());
    while let Some((&byte, after)) = rest.split_first() {
        let code = (byte == b'%').then(|| after.get(..2)).flatten();
        let code = code.and_then(|code| u8::from_str_radix(std::str::from_utf8(code).ok()?, 16).ok());
        plain.push(code.unwrap_or(byte));
        rest = if code.is_some() { &after[2..] } else { after };
    }
    plain
}

//! The file of what is remembered from one session to the next, written by a thread of its own.

use std::{
    fs, io,
    path::{Path, PathBuf},
    sync::mpsc::{self, Receiver, Sender},
    thread,
    time::Duration,
};

use dalembert_core::exercises::{self, Exercises};
use etcetera::{BaseStrategy, choose_base_strategy};

use super::{Before, FileError, failed, read, save};
use crate::{
    remembered::{self, HistoryChange, Remembered},
    settings::Fault,
};

/// So long the end of the program waits for the last changes to be written.
const PATIENCE: Duration = Duration::from_secs(1);
/// So often a change is tried again when another session was quicker.
const TRIES: usize = 4;

/// Writes changes to the file, one after the other, beside what other sessions write there.
#[derive(Debug)]
pub struct Memory {
    /// `None` once the end has come.
    changes: Option<Sender<HistoryChange>>,
    done: Receiver<()>,
}

impl Memory {
    /// A writer of this file; `trouble` is reported, from another thread, what could not be written.
    pub fn of(path: PathBuf, trouble: impl Fn(FileError) + Send + 'static) -> io::Result<Self> {
        let (changes, incoming) = mpsc::channel::<HistoryChange>();
        let (finished, done) = mpsc::channel();
        thread::Builder::new().name("memory".into()).spawn(move || {
            for change in incoming {
                if let Err(error) = remember(&path, &change) {
                    trouble(error);
                }
            }
            // Nobody may wait for it any more.
            let _ = finished.send(());
        })?;
        Ok(Self { changes: Some(changes), done })
    }

    /// Has a change written, some time soon.
    pub fn note(&self, change: HistoryChange) {
        if let Some(changes) = &self.changes {
            // A thread that has ended has reported its trouble.
            let _ = changes.send(change);
        }
    }
}

impl Drop for Memory {
    fn drop(&mut self) {
        self.changes = None;
        // A disk that does not answer holds up nobody.
        let _ = self.done.recv_timeout(PATIENCE);
    }
}

/// The file of what is remembered: `$XDG_STATE_HOME/dalembert/remembered.toml`. `None` without a home.
pub fn remembered_path() -> Option<PathBuf> {
    let base = choose_base_strategy().ok()?;
    Some(base.state_dir().unwrap_or_else(|| base.data_dir()).join("dalembert").join("remembered.toml"))
}

/// The folder of the user's own lists of exercises: `$XDG_CONFIG_HOME/dalembert/sets`. `None` without a home.
pub fn sets_path() -> Option<PathBuf> {
    Some(choose_base_strategy().ok()?.config_dir().join("dalembert").join("sets"))
}

/// Content of the history file; empty if there is none.
pub fn recall(path: &Path) -> Result<Remembered, FileError> {
    match read(path) {
        Ok(opened) => remembered::read(&opened.text).map_err(|why| broken(path, &why)),
        Err(FileError::Missing(_)) => Ok(Remembered::default()),
        Err(error) => Err(error),
    }
}

/// Writes a change into the file, which another session may write to as well. A file that cannot be read is left.
pub fn remember(path: &Path, change: &HistoryChange) -> Result<(), FileError> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(failed("make the folder", folder))?;
    }
    let mut tries = TRIES;
    loop {
        let (text, before) = match read(path) {
            Ok(opened) => (opened.text, Before::Was(opened.fingerprint)),
            Err(FileError::Missing(_)) => (String::new(), Before::Absent),
            Err(error) => return Err(error),
        };
        let mut all = remembered::read(&text).map_err(|why| broken(path, &why))?;
        if !all.take(change) {
            return Ok(());
        }
        tries -= 1;
        match save(path, remembered::write(&all, &text), before) {
            Err(FileError::Changed(_) | FileError::Exists(_) | FileError::Removed(_)) if tries > 0 => {}
            result => return result.map(|_| ()),
        }
    }
}

/// The lists of exercises in a folder, in the order of their names, and what is wrong in which of its files.
pub fn sets(folder: &Path) -> (Vec<Exercises>, Vec<(PathBuf, Vec<Fault>)>) {
    let Ok(entries) = fs::read_dir(folder) else { return (Vec::new(), Vec::new()) };
    let mut paths: Vec<PathBuf> = entries
        .flatten()
        .map(|entry| entry.path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "toml"))
        .collect();
    paths.sort();
    let (mut found, mut wrong) = (Vec::new(), Vec::new());
    for path in paths {
        let faults = match read(&path) {
            Ok(opened) => {
                let errors = match exercises::read(&opened.text) {
                    Ok(list) => {
                        found.push(list);
                        exercises::unknown(&opened.text)
                    }
                    Err(errors) => errors,
                };
                errors.into_iter().map(|error| Fault::of(&opened.text, error.span, error.why)).collect()
            }
            Err(error) => vec![Fault { line: 1, why: error.text() }],
        };
        if !faults.is_empty() {
            wrong.push((path, faults));
        }
    }
    (found, wrong)
}

fn broken(path: &Path, why: &str) -> FileError {
    FileError::Broken { path: path.to_owned(), why: why.to_owned() }
}

//! Watch of the open file for changes by other programs. Its date and length are examined once a second, and only while
//! a file is open; a watch of the system would cost a dependency, and is blind on the network drives of a laboratory.

use std::{
    fs,
    path::PathBuf,
    time::{Duration, Instant, SystemTime},
};

use crate::{
    files::{self, Fingerprint},
    model::{Model, Msg},
};

/// So often.
const PERIOD: Duration = Duration::from_secs(1);

/// The open file.
pub(super) struct WatchedFile {
    path: PathBuf,
    /// Modification time and length; `None` if the file does not exist.
    stamp: Option<(SystemTime, u64)>,
    /// Time of the next examination.
    pub(super) next: Instant,
}

impl WatchedFile {
    /// Watches the file of the problem that is worked on, if there is one.
    pub(super) fn follow<'w>(watched: &'w mut Option<Self>, model: &Model) -> Option<&'w Self> {
        let open = model
            .bench
            .as_ref()
            .and_then(|bench| bench.problem.document.file.as_ref())
            .map(|file| &file.path);
        if watched.as_ref().map(|watched| &watched.path) != open {
            // What happened to it while another one was open is found at the first look.
            *watched =
                open.map(|path| Self { path: path.clone(), stamp: None, next: Instant::now() + PERIOD });
        }
        watched.as_ref()
    }

    /// Looks, when it is time, and reads the file if its date or length is another; reports it if it holds something else
    /// than what is `known` of it.
    pub(super) fn look(&mut self, known: Option<Fingerprint>) -> Option<Msg> {
        if Instant::now() < self.next {
            return None;
        }
        self.next = Instant::now() + PERIOD;
        let stamp = self.now();
        let before = std::mem::replace(&mut self.stamp, stamp);
        if stamp == before {
            return None;
        }
        let result = files::read(&self.path);
        let same = result.as_ref().is_ok_and(|opened| Some(opened.fingerprint) == known);
        (!same).then(|| Msg::FileChanged { path: self.path.clone(), result })
    }

    /// Accepts the present state: it was written by the user's own editor.
    pub(super) fn seen(&mut self) {
        self.stamp = self.now();
    }

    fn now(&self) -> Option<(SystemTime, u64)> {
        let of = |data: fs::Metadata| Some((data.modified().ok()?, data.len()));
        fs::metadata(&self.path).ok().and_then(of)
    }
}

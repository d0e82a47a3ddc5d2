//! Effects: actions outside of the model, as plain values.

use std::path::PathBuf;

use dalembert_core::{Entry, Field};

use crate::{
    dialog::Editing,
    files::{Before, Crashed},
    remembered::HistoryChange,
    solver::Job,
    terminal::Fault,
};

/// Something to be done outside of the model.
#[derive(Debug)]
pub enum Effect {
    /// Solve; [`Msg::Solved`](crate::Msg) tells the outcome.
    Solve(Job),
    /// Answer what is asked beside the results; [`Msg::Asked`](crate::Msg).
    Ask(Job),
    /// Stop solving: nobody waits for the outcome any more.
    Cancel,
    /// Compare the cases of an analysis with what was printed; [`Msg::CheckedCase`](crate::Msg).
    Judge(&'static Entry),
    /// Write a file; [`Msg::Saved`](crate::Msg).
    Save {
        /// Path.
        path: PathBuf,
        /// Text to write.
        text: String,
        /// The condition: what must stand there now.
        before: Before,
    },
    /// Write files that belong together, the first under this condition; [`Msg::Exported`](crate::Msg).
    Export {
        /// Paths and contents.
        files: Vec<(PathBuf, Vec<u8>)>,
        /// The condition: what must stand there now.
        before: Before,
    },
    /// Read a file; [`Msg::Opened`](crate::Msg).
    Open(PathBuf),
    /// Read the files that a problem links to; [`Msg::LinkedRead`](crate::Msg).
    ReadLinked {
        /// The number of the problem.
        problem: u64,
        /// The file it belongs to.
        path: PathBuf,
        /// The problem, as its file would say it.
        text: String,
    },
    /// Write the plan of a study; [`Msg::PlanSaved`](crate::Msg).
    SavePlan {
        /// Path.
        path: PathBuf,
        /// Text to write.
        text: String,
        /// The condition: what must stand there now.
        before: Before,
    },
    /// Read the plan of a study; [`Msg::PlanRead`](crate::Msg).
    ReadPlan(PathBuf),
    /// Look into a folder; [`Msg::Listed`](crate::Msg).
    List(PathBuf),
    /// Read the file of a table; [`Msg::TableRead`](crate::Msg).
    ReadTable {
        /// The field of the table.
        field: String,
        /// The file.
        path: PathBuf,
        /// The columns of the table.
        columns: &'static [Field],
    },
    /// Remember the unsaved work against a crash.
    Keep {
        /// The number of the problem.
        problem: u64,
        /// The file it belongs to.
        original: Option<PathBuf>,
        /// The work, as a problem file.
        text: String,
    },
    /// The problem of this number has no unsaved work any more.
    Forget(u64),
    /// Remove what a crashed session left.
    Discard(Crashed),
    /// Remember this for later sessions.
    Remember(HistoryChange),
    /// Put a text on the clipboard.
    Copy(String),
    /// Edit a file in the user's editor; [`Msg::Edited`](crate::Msg).
    Edit(Editing),
    /// Remove a copy that was edited and is read.
    Remove(PathBuf),
    /// Take the mouse, or leave it to the terminal.
    Mouse(bool),
    /// Commit a fault on this thread.
    Fault(Fault),
    /// Give the terminal to the shell for a while.
    Suspend,
    /// Draw everything again.
    Redraw,
    /// End the program.
    Quit,
}

impl Effect {
    /// True if it may wait for other keys that are there already: nothing that they lead to depends on it.
    pub fn may_wait(&self) -> bool {
        matches!(self, Effect::Solve(_)) || self.keeps().is_some()
    }

    /// True if a newer effect makes it idle: of keys that waited together the last decides.
    pub fn is_idle_after(&self, newer: &Effect) -> bool {
        let solves = |effect: &Effect| matches!(effect, Effect::Solve(_));
        solves(self) && solves(newer) || self.keeps().is_some() && self.keeps() == newer.keeps()
    }

    /// The problem that it keeps against a crash, or keeps no more.
    fn keeps(&self) -> Option<u64> {
        match self {
            Effect::Keep { problem, .. } | Effect::Forget(problem) => Some(*problem),
            _ => None,
        }
    }
}

//! History kept from one session to the next: pinned and recent analyses, and progress of the published cases. Plain
//! data; [`files::Memory`](crate::files::Memory) keeps it in a file.

use std::collections::BTreeMap;

use toml_edit::{Array, ArrayOfTables, DocumentMut, Item, Table, value};

/// So many recent analyses are remembered.
const MOST_RECENT: usize = 8;

/// History of the user.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Remembered {
    /// The ids of pinned analyses, in the order of pinning.
    pub pinned: Vec<String>,
    /// The ids of the analyses that were opened last, the newest first.
    pub recent: Vec<String>,
    /// Progress of each case, by the id of its analysis and its name.
    pub progress: BTreeMap<(String, String), Progress>,
}

/// Progress of a case.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Progress {
    /// It was not examined yet.
    #[default]
    NotBegun,
    /// It was opened.
    Opened,
    /// It was solved by hand: the answers that it asks for were right.
    Solved,
    /// The user says that it is done.
    Done,
}

/// Something to be remembered.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum HistoryChange {
    /// An analysis is pinned or unpinned.
    Pin(String, bool),
    /// An analysis was opened.
    Open(String),
    /// A case is worked through so far.
    Reach {
        /// The id of the analysis.
        analysis: String,
        /// The name of the case.
        case: String,
        /// New progress.
        progress: Progress,
    },
}

impl Progress {
    /// Every one, from nothing to done.
    pub const ALL: [Progress; 4] = [Progress::NotBegun, Progress::Opened, Progress::Solved, Progress::Done];

    /// Name in the file.
    pub fn name(self) -> &'static str {
        match self {
            Progress::NotBegun => "not started",
            Progress::Opened => "opened",
            Progress::Solved => "solved by hand",
            Progress::Done => "done",
        }
    }

    /// Returns true if nothing is left to do.
    pub fn is_done(self) -> bool {
        self >= Progress::Solved
    }
}

impl Remembered {
    /// Progress of a case.
    pub fn progress(&self, analysis: &str, case: &str) -> Progress {
        self.progress.get(&(analysis.to_owned(), case.to_owned())).copied().unwrap_or_default()
    }

    /// Takes a change; whether it was one.
    pub fn take(&mut self, change: &HistoryChange) -> bool {
        let before = self.clone();
        match change {
            HistoryChange::Pin(id, pinned) => {
                self.pinned.retain(|other| other != id);
                if *pinned {
                    self.pinned.push(id.clone());
                }
            }
            HistoryChange::Open(id) => {
                self.recent.retain(|other| other != id);
                self.recent.insert(0, id.clone());
                self.recent.truncate(MOST_RECENT);
            }
            HistoryChange::Reach { analysis, case, progress } => {
                self.progress.insert((analysis.clone(), case.clone()), *progress);
            }
        }
        *self != before
    }
}

/// Reads the history from the text of its file. `Err` says why it cannot be read.
pub fn read(text: &str) -> Result<Remembered, String> {
    let document: DocumentMut =
        text.parse().map_err(|error: toml_edit::TomlError| error.message().to_owned())?;
    let strings = |name: &str| -> Result<Vec<String>, String> {
        let Some(item) = document.get(name) else { return Ok(Vec::new()) };
        item.as_array()
            .and_then(|array| array.iter().map(|one| one.as_str().map(str::to_owned)).collect())
            .ok_or_else(|| format!("`{name}` is not a list of texts"))
    };
    let mut progress = BTreeMap::new();
    for table in document.get("progress").and_then(Item::as_array_of_tables).into_iter().flatten() {
        let word = |name: &str| table.get(name).and_then(Item::as_str);
        let reached = Progress::ALL.into_iter().find(|one| word("state") == Some(one.name()));
        if let (Some(analysis), Some(case), Some(reached)) = (word("analysis"), word("case"), reached) {
            progress.insert((analysis.to_owned(), case.to_owned()), reached);
        }
    }
    Ok(Remembered { pinned: strings("pinned")?, recent: strings("recent")?, progress })
}

/// The text of a file with this in it; what else stands in the file stays there.
pub fn write(remembered: &Remembered, over: &str) -> String {
    let mut document: DocumentMut = over.parse().unwrap_or_default();
    let list = |ids: &[String]| value(ids.iter().collect::<Array>());
    document["pinned"] = list(&remembered.pinned);
    document["recent"] = list(&remembered.recent);
    let mut tables = ArrayOfTables::new();
    for ((analysis, case), progress) in &remembered.progress {
        let mut table = Table::new();
        table["analysis"] = value(analysis);
        table["case"] = value(case);
        table["state"] = value(progress.name());
        tables.push(table);
    }
    document["progress"] = Item::ArrayOfTables(tables);
    document.to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn reach(case: &str, progress: Progress) -> HistoryChange {
        HistoryChange::Reach { analysis: "x/y".into(), case: case.into(), progress }
    }

    #[test]
    fn what_is_written_is_read_again_and_nothing_else_is_lost() {
        let mut remembered = Remembered::default();
        for n in 0..12 {
            assert!(remembered.take(&HistoryChange::Open(format!("x/{n}"))));
        }
        assert!(remembered.take(&HistoryChange::Pin("x/1".into(), true)));
        assert!(!remembered.take(&HistoryChange::Pin("x/1".into(), true)));
        assert!(remembered.take(&reach("a \"case\"", Progress::Solved)));
        assert!(remembered.take(&HistoryChange::Open("x/9".into())));
        assert_eq!(remembered.recent[..3], ["x/9", "x/11", "x/10"]);
        assert_eq!(remembered.recent.len(), MOST_RECENT);
        let text = write(&remembered, "# mine\nwindow = 3\npinned = [\"x/0\"]\n");
        assert_eq!(read(&text), Ok(remembered.clone()));
        assert!(text.starts_with("# mine\nwindow = 3\n"), "{text}");
        assert_eq!(write(&remembered, &text), text, "written again it is the same");
        assert_eq!(remembered.progress("x/y", "a \"case\""), Progress::Solved);
        assert_eq!(remembered.progress("x/y", "another"), Progress::NotBegun);
    }

    #[test]
    fn a_broken_file_is_said_to_be() {
        assert_eq!(read(""), Ok(Remembered::default()));
        assert!(read("pinned = 3").unwrap_err().contains("pinned"));
        assert!(read("pinned = [").is_err());
    }
}

//! Everything the workbench knows, what can happen to it, and what it asks to be done.

use std::path::{Path, PathBuf};

use dalembert_core::{
    Entry, Language, Locale, Text, cases,
    exercises::{self, Exercises},
    file,
};
use dalembert_import::Sample;
use dalembert_units::Decimal;
use ratatui::{
    crossterm::event::{KeyEvent, MouseEvent},
    layout::Rect,
};

use crate::{
    bench::Bench,
    dialog::{After, Dialog, Editing},
    files::{Crashed, FileError, Fingerprint, LinkedTexts, Opened, beside_file, is_same_file},
    keys::{Action, KeyContext, KeyMap},
    layout::Focus,
    look::Appearance,
    pane::{Pane, Tab, Ui},
    picker::{Contents, Heading, Leaf, Listing, Picker, Row},
    playback::Playback,
    plot::Marker,
    problem::Problem,
    remembered::Remembered,
    settings::{Fault as SettingFault, Settings},
    solver::{CheckedCase, JobOutcome},
};

/// So many problems are open at once.
pub(crate) const MOST_PROBLEMS: usize = 9;

/// Everything the workbench knows.
#[derive(Debug)]
#[expect(
    clippy::struct_excessive_bools,
    reason = "each is a switch of its own, set by a key or at the start"
)]
pub struct Model {
    /// Analyses to pick from.
    pub listings: Vec<Listing>,
    /// The lists of exercises.
    pub sets: Vec<Exercises>,
    /// History of earlier sessions.
    pub remembered: Remembered,
    /// The screen that is shown.
    pub screen: Screen,
    /// The list of analyses.
    pub picker: Picker,
    /// The problem that is worked on; kept while the list is shown.
    pub bench: Option<Bench>,
    /// The other open problems.
    pub others: Vec<Bench>,
    /// Dialog over the screen, which takes the keys.
    pub dialog: Option<Dialog>,
    /// A message to the user, until the next key.
    pub notice: Option<Notice>,
    /// The language of everything that is written.
    pub locale: Locale,
    /// Colours and pictograms.
    pub look: Appearance,
    /// Default marker of curves.
    pub marker: Marker,
    /// Key map.
    pub keys: KeyMap,
    /// The decimal mark that the user wants in every language.
    pub decimal: Option<Decimal>,
    /// True if mouse events are captured.
    pub mouse: bool,
    /// The column that a plot is held at by the mouse.
    pub held: Option<u16>,
    /// The pane that reads what is under the mouse.
    pub under_pointer: Option<Tab>,
    /// True if animations play.
    pub playing: bool,
    /// Playback speed of animations, over their own.
    pub animation_speed: f64,
    /// Columns and rows of the screen.
    pub size: (u16, u16),
    /// Nothing is saved.
    pub readonly: bool,
    /// A session is played: it is asked what it was asked when it was recorded, though nothing is saved.
    pub is_replay: bool,
    /// The session that is played, while the keys are not the user's.
    pub playback: Option<Playback>,
    /// Line below the screen of a session that is played.
    pub caption: Option<Text>,
    /// True if `:fault` is a command.
    pub faults: bool,
    /// Action after a save.
    pub after_save: After,
    /// The file that is read again: it takes the place of the changes to it.
    pub reloading: Option<PathBuf>,
    /// The number of the newest job.
    pub generation: u64,
    /// Percentage of the job under way that is done, where it is known.
    pub progress: Option<u32>,
    /// Field mode is to begin with the first problem, or a blank one that is to be saved at this path.
    pub field: Option<Option<PathBuf>>,
}

/// A screen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Screen {
    /// The list of analyses.
    #[default]
    Picker,
    /// A problem.
    Bench,
}

/// A message to the user.
#[derive(Clone, Debug, PartialEq)]
pub struct Notice {
    /// Message.
    pub text: Text,
    /// Output of an external program, on a line of its own; may be empty.
    pub detail: String,
    /// True for an error.
    pub wrong: bool,
}

/// Reason for which an external edit gives no text.
#[derive(Debug, thiserror::Error)]
pub enum EditError {
    /// File error: the edited text cannot be read.
    #[error(transparent)]
    File(#[from] FileError),
    /// The editor could not be run, or said that it failed.
    #[error("`{0}` did not end well: set $VISUAL or $EDITOR, or `editor` in the settings")]
    Editor(String),
    /// There is no such editor.
    #[error("`{0}` was not found: set $VISUAL or $EDITOR, or `editor` in the settings")]
    NoEditor(String),
}

/// Message to the model.
#[derive(Debug)]
pub enum Msg {
    /// A key was pressed.
    Key(KeyEvent),
    /// A text was pasted.
    Paste(String),
    /// The screen has this many columns and rows.
    Resize(u16, u16),
    /// A job is done.
    Solved(JobOutcome),
    /// Percentage of the job under way that is done, where it is known.
    Progress(Option<u32>),
    /// The cases of an analysis were compared with what was printed.
    CheckedCase(&'static str, Vec<CheckedCase>),
    /// A file was written, or not.
    Saved {
        /// Path.
        path: PathBuf,
        /// Text that was saved.
        text: String,
        /// Fingerprint of the saved file, or the error.
        result: Result<Fingerprint, FileError>,
    },
    /// The worked solution was written, or not.
    Exported {
        /// Path.
        path: PathBuf,
        /// Success or the error.
        result: Result<(), FileError>,
    },
    /// A file was read, or not.
    Opened {
        /// Path.
        path: PathBuf,
        /// Content of the file, or the error.
        result: Result<Opened, FileError>,
    },
    /// The files that the problem of this number links to were read, as far as they could be.
    LinkedRead(u64, LinkedTexts),
    /// Contents of a folder, in order; folders end in `/`.
    Listed(PathBuf, Vec<String>),
    /// The file of a table was read, or not.
    TableRead {
        /// The field of the table.
        field: String,
        /// The path that was asked for, with its part.
        path: PathBuf,
        /// The text of the table.
        result: Result<String, FileError>,
        /// Columns of the file to choose from.
        sample: Sample,
    },
    /// The plan of a study was written, or not.
    PlanSaved {
        /// Path.
        path: PathBuf,
        /// The text.
        text: String,
        /// The mark of the file as it is now, or the error.
        result: Result<Fingerprint, FileError>,
    },
    /// The plan of a study was read, or not.
    PlanRead {
        /// Path.
        path: PathBuf,
        /// Content of the file, or the error.
        result: Result<Opened, FileError>,
    },
    /// Reply to a question beside the results.
    Asked(JobOutcome),
    /// The mouse did something.
    Mouse(MouseEvent),
    /// The editor was left.
    Edited {
        /// Object that was edited.
        file: Editing,
        /// Text after editing, or the error.
        result: Result<Opened, EditError>,
    },
    /// The file of the problem is not what it was a moment ago.
    FileChanged {
        /// Path.
        path: PathBuf,
        /// Present content of the file, or the error.
        result: Result<Opened, FileError>,
    },
    /// The next frame of an animation is due.
    Tick,
    /// Earlier sessions ended without saving.
    Crashed(Vec<Crashed>),
    /// Unsaved work could not be kept aside.
    Trouble(FileError),
    /// Files of the user's own, settings and lists of exercises, and what of each cannot be taken.
    Faulty(Vec<(PathBuf, Vec<SettingFault>)>),
    /// Something to tell.
    Notice(String),
}

impl Model {
    /// The list of these analyses.
    pub fn new(entries: &[&'static Entry], language: Language, look: Appearance, marker: Marker) -> Self {
        let mut model = Self {
            listings: entries.iter().map(|entry| Listing::of(entry)).collect(),
            sets: exercises::bundled().into_iter().flatten().collect(),
            remembered: Remembered::default(),
            screen: Screen::Picker,
            picker: Picker::default(),
            bench: None,
            others: Vec::new(),
            dialog: None,
            notice: None,
            locale: Locale::english(),
            look,
            marker,
            keys: KeyMap::default(),
            decimal: None,
            mouse: false,
            held: None,
            under_pointer: None,
            playing: false,
            animation_speed: 1.0,
            size: (80, 24),
            readonly: false,
            is_replay: false,
            playback: None,
            caption: None,
            faults: false,
            after_save: After::Stay,
            reloading: None,
            generation: 0,
            progress: None,
            field: None,
        };
        model.set_language(language);
        model
    }

    /// Takes what the user has set. The language is not among it: a word on the command line may overrule it.
    pub fn adopt(&mut self, settings: &Settings) {
        self.keys.clone_from(&settings.keys);
        self.look.theme = settings.theme;
        self.marker = settings.marker.filter(|_| !self.look.ascii).unwrap_or(self.marker);
        self.decimal = settings.decimal;
        self.locale.style.digits = settings.digits;
        if settings.animation_speed > 0.0 {
            self.animation_speed = settings.animation_speed;
        }
        self.set_language(self.locale.language);
    }

    /// Takes a language, with its decimal mark.
    pub fn set_language(&mut self, language: Language) {
        self.locale.language = language;
        self.locale.style.decimal = self.decimal.unwrap_or(match language {
            Language::English => Decimal::Point,
            Language::Portuguese => Decimal::Comma,
        });
        self.locale.style.ascii = self.look.ascii;
    }

    /// Makes the open problem the context of translations.
    pub fn translate_for_bench(&mut self) {
        let of =
            |bench: &Bench| bench.problem.inputs.form.analysis().unwrap_or(bench.problem.entry()).about.id;
        self.locale.place = self.bench.as_ref().map_or("", of);
    }

    /// Place of the key map in which keys are looked up.
    pub fn place(&self) -> KeyContext {
        match (&self.dialog, self.screen, &self.bench) {
            (Some(dialog), _, _) => dialog.place(),
            (None, Screen::Bench, Some(bench)) => bench.place(),
            (None, _, _) if self.picker.typing => KeyContext::Filter,
            _ => KeyContext::Picker,
        }
    }

    /// The usual key of an action in a place, as a user reads it; empty where there is none.
    pub fn key(&self, place: KeyContext, action: Action) -> String {
        self.keys.key(place, action).map_or_else(String::new, |key| key.name(&self.locale))
    }

    /// The problem, while it is on the screen.
    pub fn shown_bench(&self) -> Option<&Bench> {
        self.bench.as_ref().filter(|_| self.screen == Screen::Bench)
    }

    /// The surroundings of a pane of a problem, seen in an area.
    pub fn ui(&self, bench: &Bench, tab: Tab, area: Rect) -> Ui<'_> {
        Ui {
            look: &self.look,
            locale: &self.locale,
            keys: &self.keys,
            playing: self.playing,
            marker: bench.marker,
            focused: bench.focus == Focus::Pane && bench.tab == tab,
            edit: None,
            waits: bench.waits(tab),
            covered: bench.is_covered(),
            area,
            scroll: bench.scroll[tab.0],
        }
    }

    /// Lets a pane of the problem do something; `None` without a problem.
    pub fn with_pane<T>(
        &mut self,
        tab: Tab,
        area: Rect,
        does: impl FnOnce(&mut dyn Pane, &mut Problem, &Ui<'_>) -> T,
    ) -> Option<T> {
        let mut bench = self.bench.take()?;
        let ui = self.ui(&bench, tab, area);
        let done = does(&mut *bench.panes[tab.0], &mut bench.problem, &ui);
        self.bench = Some(bench);
        Some(done)
    }

    /// The cases of an analysis, compared with what was printed if they were before.
    pub fn cases_of(&self, entry: &'static Entry) -> Vec<CheckedCase> {
        let known = self.listings.iter().find(|listing| listing.entry.about.id == entry.about.id);
        if let Some(checked) = known.and_then(|listing| listing.checked.clone()) {
            return checked;
        }
        let cases =
            known.map_or_else(|| cases::cases(entry).unwrap_or_default(), |listing| listing.cases().to_vec());
        cases.into_iter().map(|case| CheckedCase { case, verdicts: None }).collect()
    }

    /// The problem of a file. A file that has the name of a case as its title holds that case, or held it before a
    /// change.
    pub fn problem_of(&self, read: file::ProblemFile) -> Problem {
        let cases = self.cases_of(read.entry);
        let origin =
            cases.iter().map(|checked| &checked.case).find(|case| case.is_named(&read.title)).cloned();
        let title = if origin.is_some() { String::new() } else { read.title };
        let mut problem = Problem::new(read.entry, title, read.draft, cases);
        (problem.document.origin, problem.document.units, problem.document.show) =
            (origin, read.units, read.show);
        problem.document.title_block = read.title_block;
        (problem.inputs.notes, problem.document.linked) = (read.notes, read.files);
        problem
    }

    /// The problem of a text at a path. Files that it links to and that are open are read as they are there, with what is not
    /// saved; of the others `linked` has the texts.
    ///
    /// # Errors
    /// Everything that is wrong with the text, and with the linked files.
    pub fn parse(
        &self,
        path: Option<&Path>,
        text: &str,
        linked: &LinkedTexts,
    ) -> Result<file::ProblemFile, Vec<file::FileError>> {
        let all = self.problems();
        let mut unsaved = Vec::new();
        let mut read = file::parse_with(text, &mut |name| {
            let path = beside_file(path, name);
            let is_it = |problem: &&Problem| {
                problem.document.file.as_ref().is_some_and(|file| is_same_file(&file.path, &path))
            };
            if let Some(open) = all.iter().map(|bench| &bench.problem).find(is_it) {
                if open.is_unsaved() {
                    unsaved.push(name.to_owned());
                    return Ok(open.as_text());
                }
                return Ok(open.text().to_owned());
            }
            let not_read = || Err("this file is not read yet: save and open again".into());
            linked.text(name).cloned().unwrap_or_else(not_read)
        })?;
        for name in &unsaved {
            read.mark_unsaved(name);
        }
        Ok(read)
    }

    /// Number of problems that can still be opened: one that is a published case and nothing else gives way.
    pub fn room(&self) -> usize {
        MOST_PROBLEMS.saturating_sub(self.problems().iter().filter(|bench| !gives_way(bench)).count())
    }

    /// Goes from the list to the cases of the chosen analysis, where it has some.
    pub fn go_to_cases(&mut self) {
        if self.picker.case.is_none()
            && let Some(Row::Leaf(leaf)) = self.picker.chosen(self.contents())
            && !self.listings[leaf.listing].cases().is_empty()
        {
            self.picker.case = Some(leaf.case.unwrap_or(0));
        }
    }

    /// The exercise of a list that the pointer is on: where it stands, and its case.
    pub fn chosen_exercise(&self) -> Option<(Leaf, usize)> {
        match self.picker.chosen(self.contents()) {
            Some(Row::Leaf(leaf @ Leaf { under: Some(Heading::Set(_)), case: Some(case), .. })) => {
                Some((leaf, case))
            }
            _ => None,
        }
    }

    /// Contents of the list.
    pub fn contents(&self) -> Contents<'_> {
        let Self { listings, sets, remembered, locale, .. } = self;
        Contents { listings, sets, remembered, locale }
    }

    /// Every open problem, in the order of opening.
    pub fn problems(&self) -> Vec<&Bench> {
        let mut all: Vec<&Bench> = self.bench.iter().chain(&self.others).collect();
        all.sort_by_key(|bench| bench.problem.number);
        all
    }

    /// Every open problem, to be changed.
    pub fn problems_mut(&mut self) -> impl Iterator<Item = &mut Bench> {
        self.bench.iter_mut().chain(&mut self.others)
    }

    /// The number of a new job.
    pub fn next_generation(&mut self) -> u64 {
        self.generation += 1;
        self.generation
    }

    /// Tells something.
    pub fn say(&mut self, text: impl Into<Text>) {
        self.notice = Some(Notice { text: text.into(), detail: String::new(), wrong: false });
    }

    /// Tells that something went wrong.
    pub fn report_error(&mut self, text: impl Into<Text>) {
        self.notice = Some(Notice { text: text.into(), detail: String::new(), wrong: true });
    }
}

/// True if a problem is closed where there is no room for another.
pub(crate) fn gives_way(bench: &Bench) -> bool {
    let problem = &bench.problem;
    !problem.is_unsaved() && problem.document.file.is_none() && problem.found.pinned.is_none()
}

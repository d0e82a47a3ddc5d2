//! A problem that is worked on: its form, what was found, the tab that shows it, and the file it belongs to.

use std::{borrow::Cow, path::PathBuf};

use dalembert_core::{
    Axis, Draft, Drawing, Entry, Exhibit, FieldError, Plot, Solution, TableExhibit, Text, View, cases::Case,
    file::Problem,
};

use crate::{
    ask::{self, Ask, Subject},
    files::Fingerprint,
    form::Form,
    keys::Place,
    panes::{sources::CheckedCase, working::Reading},
    plot,
    solver::Failure,
    tab::Tab,
};

/// A problem that is worked on.
#[derive(Debug)]
pub struct Bench {
    /// Its number among the open problems; those that were opened later have larger ones.
    pub number: u64,
    /// Its analysis.
    pub entry: &'static Entry,
    /// The title that the user gave it; may be empty.
    pub title: String,
    /// The published case that its inputs began as.
    pub origin: Option<Case>,
    /// How answers are shown: `(answer, unit and digits)`.
    pub show: Vec<(String, String)>,
    /// Whether that is otherwise than in the file.
    pub show_changed: bool,
    /// Its inputs.
    pub form: Form,
    /// What an older file left unsaid, and how it was read.
    pub notes: Vec<Text>,
    /// What is wrong with them.
    wrong: Vec<FieldError>,
    /// Which of them are still empty.
    needed: Vec<FieldError>,
    /// What was found.
    pub found: Found,
    /// The result that every later one is compared with.
    pub pinned: Option<Solution>,
    /// Its published cases.
    pub cases: Vec<CheckedCase>,
    /// Whether they are compared with what was printed, or about to be.
    pub judging: bool,
    /// The case under the cursor of the tab of sources.
    pub case: usize,
    /// What the keys act on.
    pub focus: Focus,
    /// Whether that has the whole screen.
    pub expanded: bool,
    /// What is shown.
    pub tab: Tab,
    /// The first line that each tab shows.
    pub scroll: [usize; Tab::ALL.len()],
    /// The plot that is shown, of several.
    pub plot: usize,
    /// The drawing that is shown, of several.
    pub drawing: usize,
    /// The frame that is shown of an animation.
    pub frame: usize,
    /// From where a scene in space is seen, where it was turned.
    pub view: Option<View>,
    /// How far the worked solution is read.
    pub reading: Reading,
    /// The cursor and the marks of the plot.
    pub plot_state: plot::State,
    /// What is asked beside the results.
    pub ask: Ask,
    /// Its file.
    pub file: Option<OpenFile>,
    /// What was edited of a problem without a file: a save keeps its comments.
    pub commented: String,
    /// Title and inputs as they are in the file, or as the case has them.
    saved: (String, Draft),
}

/// The file of a problem.
#[derive(Clone, Debug)]
pub struct OpenFile {
    /// Where it is.
    pub path: PathBuf,
    /// What it says: comments are kept from it.
    pub text: String,
    /// What it held when it was read or written; `None` where that is not known, after a crash.
    pub fingerprint: Option<Fingerprint>,
}

/// What was found for the inputs, and whether it still belongs to them.
#[derive(Debug, Default)]
pub struct Found {
    /// The newest solution there is.
    pub solution: Option<Solution>,
    /// The inputs that it belongs to.
    pub of: Option<Draft>,
    /// Why the present inputs have none.
    pub failure: Option<Failure>,
    /// Whether the present inputs are so far from those of the solution that its numbers are hidden until there is
    /// another.
    pub hidden: bool,
    /// Whether that belongs to the present inputs.
    pub state: State,
}

/// Whether what is shown belongs to the present inputs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum State {
    /// It does.
    Current,
    /// The job of this number is to find out.
    Solving(u64),
    /// The user stopped the job that was to find out.
    Stopped,
    /// The inputs cannot be read.
    #[default]
    Unread,
}

/// What a cell of a tab is for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CellOf {
    /// A user's own answer, by its name.
    Answer(String),
    /// The tolerance of an input, by its path.
    Tolerance(String),
    /// A cell of a study.
    Study(ask::Cell),
}

/// What the keys act on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Focus {
    /// The inputs.
    #[default]
    Form,
    /// What was found.
    Pane,
}

impl Bench {
    /// A problem of an analysis, filled in.
    pub fn new(entry: &'static Entry, title: String, draft: Draft, cases: Vec<CheckedCase>) -> Self {
        Self {
            number: 0,
            entry,
            saved: (title.clone(), draft.clone()),
            title,
            origin: None,
            show: Vec::new(),
            show_changed: false,
            form: Form::new(entry, draft),
            notes: Vec::new(),
            wrong: Vec::new(),
            needed: Vec::new(),
            found: Found::default(),
            pinned: None,
            cases,
            judging: false,
            case: 0,
            focus: Focus::Form,
            expanded: false,
            tab: Tab::Results,
            scroll: [0; Tab::ALL.len()],
            plot: 0,
            drawing: 0,
            frame: 0,
            view: None,
            reading: Reading::default(),
            plot_state: plot::State::default(),
            ask: Ask::default(),
            file: None,
            commented: String::new(),
        }
    }

    /// Where keys are typed.
    pub fn place(&self) -> Place {
        match self.focus {
            Focus::Form if self.form.edit.is_some() => Place::Edit,
            Focus::Form => Place::Form,
            Focus::Pane => match self.tab {
                Tab::Working => Place::Working,
                Tab::Plot => Place::Plot,
                Tab::Drawing => Place::Drawing,
                Tab::Results | Tab::Table | Tab::Sources => Place::Pane,
                Tab::Check | Tab::Sensitivity | Tab::Study if self.ask.edit.is_some() => Place::Cell,
                Tab::Check | Tab::Sensitivity | Tab::Study => Place::Cells,
            },
        }
    }

    /// To where these keys are typed; whether that is there.
    pub fn go_to(&mut self, place: Place) -> bool {
        let tab = match place {
            Place::Form => {
                self.focus = Focus::Form;
                return true;
            }
            Place::Working => Tab::Working,
            Place::Plot => Tab::Plot,
            Place::Drawing => Tab::Drawing,
            Place::Cells if !self.tab.has_cells() => Tab::Check,
            _ => self.tab,
        };
        let is_there = self.tabs().contains(&tab);
        if is_there {
            (self.focus, self.tab) = (Focus::Pane, tab);
        }
        is_there
    }

    /// Whether there is something to save.
    pub fn is_unsaved(&self) -> bool {
        self.show_changed || (&self.title, &self.form.draft) != (&self.saved.0, &self.saved.1)
    }

    /// What is on the screen is in the file now.
    pub fn mark_saved(&mut self) {
        self.show_changed = false;
        self.saved = (self.title.clone(), self.form.draft.clone());
    }

    /// What is on the screen is in no file: it comes from a crashed session.
    pub fn mark_unsaved(&mut self) {
        self.saved.1 = Draft::Absent;
    }

    /// The text that a save is written over, for its comments and its order.
    pub fn text(&self) -> &str {
        self.file.as_ref().map_or(&self.commented, |file| &file.text)
    }

    /// The problem as it is saved.
    pub fn problem(&self) -> Problem {
        let Self { entry, form, show, .. } = self;
        let title = match &self.origin {
            Some(case) if self.title.is_empty() && case.draft == form.draft => case.name.clone(),
            _ => self.title.clone(),
        };
        Problem { entry, title, draft: form.draft.clone(), show: show.clone(), notes: self.notes.clone() }
    }

    /// What it is called: its title, or the case it began as, which it is no more once an input was changed.
    pub fn name(&self) -> Text {
        match &self.origin {
            _ if !self.title.is_empty() => Text::verbatim(&self.title),
            Some(case) if case.draft == self.form.draft => case.title(),
            Some(case) => Text::new("{title} (changed)").with_text("title", case.title()),
            None => Text::from(""),
        }
    }

    /// Errors of what is written; an input that is still empty is [needed](Self::needed), not wrong.
    pub fn wrong(&self) -> impl Iterator<Item = &FieldError> {
        self.wrong.iter()
    }

    /// Errors of inputs that are still to be filled in.
    pub fn needed(&self) -> impl Iterator<Item = &FieldError> {
        self.needed.iter()
    }

    /// Takes what was found wrong with the inputs as they are now. Of inputs that differ in more than one field from
    /// those that were solved, or are at fault in several, the numbers found are hidden.
    pub fn find_wrong(&mut self, errors: Vec<FieldError>) {
        let hide = errors.len() > 1 || (!errors.is_empty() && !self.is_near_the_solved());
        self.found.hidden |= hide;
        (self.needed, self.wrong) = errors.into_iter().partition(|error| self.is_empty(error));
    }

    /// Whether the inputs differ in one field at most from those of the newest solution.
    pub fn is_near_the_solved(&self) -> bool {
        self.found.of.as_ref().is_some_and(|of| of.apart(&self.form.draft) <= 1)
    }

    /// Whether no number of the newest solution may stand beside these inputs.
    pub fn hides_numbers(&self) -> bool {
        self.found.hidden && self.is_stale()
    }

    /// How much is left to do before there can be a solution; `None` where there is nothing.
    pub fn to_do(&self) -> Option<Text> {
        match (self.wrong.len(), self.needed.len()) {
            (0, 0) => None,
            (0, 1) => Some(Text::new("1 value missing")),
            (0, needed) => Some(Text::new("{count} values missing").with("count", needed)),
            (1, _) => Some(Text::new("1 error")),
            (wrong, _) => Some(Text::new("{count} errors").with("count", wrong)),
        }
    }

    /// What the cell under the cursor of the tab is for.
    pub fn cell(&self) -> Option<CellOf> {
        match self.tab {
            Tab::Check => {
                let answers = &self.found.solution.as_ref()?.answers;
                let at = self.ask.check.cursor.min(answers.len().checked_sub(1)?);
                Some(CellOf::Answer(answers[at].name.to_string()))
            }
            Tab::Sensitivity => {
                let sensitivity = &self.ask.sensitivity;
                // The order must not change while a tolerance is typed.
                let sorted = sensitivity.sorted();
                let at = sensitivity.cursor.min(sorted.len().checked_sub(1)?);
                Some(CellOf::Tolerance(sorted[at].input.path.clone()))
            }
            Tab::Study => Some(CellOf::Study(self.ask.study.cell())),
            _ => None,
        }
    }

    /// How many plots or drawings a tab can show, one at a time.
    pub fn exhibits_of(&self, tab: Tab) -> usize {
        match tab {
            Tab::Plot => self.plots().count(),
            Tab::Drawing => self.drawings().count(),
            _ => 0,
        }
    }

    /// Which of several plots or drawings a tab shows, counted from 1, and how many there are; `None` of a single one.
    pub fn place_of_shown(&self, tab: Tab) -> Option<(usize, usize)> {
        let of = self.exhibits_of(tab);
        let at = if tab == Tab::Plot { self.plot } else { self.drawing };
        (of > 1).then(|| (at.min(of - 1) + 1, of))
    }

    /// The tabs that have something to show; the first and the last always do.
    pub fn tabs(&self) -> Vec<Tab> {
        let has = |tab: &Tab| match tab {
            Tab::Plot => self.plots().next().is_some(),
            Tab::Drawing => self.drawings().next().is_some(),
            Tab::Table => self.tables().next().is_some(),
            Tab::Check => self.found.solution.as_ref().is_some_and(|found| !found.answers.is_empty()),
            Tab::Sensitivity | Tab::Study => {
                self.found.solution.as_ref().is_some_and(|found| !ask::numbers(found).is_empty())
            }
            Tab::Results | Tab::Working | Tab::Sources => true,
        };
        Tab::ALL.into_iter().filter(has).collect()
    }

    /// The part of its page that the cursor of a tab stands on, where it has one: a case, an answer, a cell.
    pub fn part_mut(&mut self, tab: Tab) -> Option<&mut usize> {
        match tab {
            Tab::Check => Some(&mut self.ask.check.cursor),
            Tab::Sensitivity => Some(&mut self.ask.sensitivity.cursor),
            Tab::Study => Some(&mut self.ask.study.cursor),
            Tab::Sources => Some(&mut self.case),
            _ => None,
        }
    }

    /// What is studied; `None` while there are no inputs or answers to choose from.
    pub fn subject(&self) -> Option<Subject<'_>> {
        let record = self.form.draft.read(&self.entry.shape()).ok()?;
        Some(self.ask.study.subject(&record, self.found.solution.as_ref()?))
    }

    /// The plot of the study.
    pub fn studied(&self) -> Option<&Plot> {
        self.ask.study.found.as_ref()?.as_ref().ok()?.plot.as_ref()
    }

    /// The plots of the newest solution, and that of the study.
    pub fn plots(&self) -> impl Iterator<Item = &Plot> {
        plots_of(self.found.solution.iter()).chain(self.studied())
    }

    /// The plot that is shown, and the pinned one of the same axes.
    pub fn shown_plot(&self) -> Option<(&Plot, Option<&Plot>)> {
        self.plot_at(self.plot)
    }

    /// The same for a plot of some place, the last one where there are fewer.
    pub fn plot_at(&self, at: usize) -> Option<(&Plot, Option<&Plot>)> {
        let plot = Self::nth(self.plots(), at)?;
        let of_pinned = plots_of(self.pinned.iter());
        let same = |a: &Axis, b: &Axis| (&a.label, a.unit) == (&b.label, b.unit);
        let pinned =
            Self::nth(of_pinned, at).filter(|pinned| same(&pinned.x, &plot.x) && same(&pinned.y, &plot.y));
        Some((plot, pinned))
    }

    /// The drawings, animations and scenes of the newest solution.
    pub fn drawings(&self) -> impl Iterator<Item = &Exhibit> {
        self.exhibits().filter(|exhibit| exhibit.frames().0 > 0)
    }

    /// The drawing, animation or scene that is shown.
    pub fn sketch(&self) -> Option<&Exhibit> {
        Self::nth(self.drawings(), self.drawing)
    }

    /// What is drawn of it: the frame that is shown, from the side that it was turned to; while the results are
    /// covered, without what they add.
    pub fn drawing_seen(&self) -> Option<Cow<'_, Drawing>> {
        let drawing = self.sketch()?.projected(self.frame, self.view)?;
        Some(if self.reading.revealed.is_some() { Cow::Owned(drawing.unsolved()) } else { drawing })
    }

    /// The tables of the newest solution.
    pub fn tables(&self) -> impl Iterator<Item = &TableExhibit> {
        self.exhibits()
            .filter_map(|exhibit| if let Exhibit::Table(table) = exhibit { Some(table) } else { None })
    }

    /// The shown one of several, by its place; the last one where there are fewer now.
    pub fn nth<T>(mut all: impl Iterator<Item = T>, at: usize) -> Option<T> {
        let mut last = None;
        for _ in 0..=at {
            match all.next() {
                Some(one) => last = Some(one),
                None => break,
            }
        }
        last
    }

    /// Whether the newest solution does not belong to the present inputs.
    pub fn is_stale(&self) -> bool {
        self.found.state != State::Current || self.found.failure.is_some()
    }

    /// Whether a job is under way for it.
    pub fn is_working(&self) -> bool {
        matches!(self.found.state, State::Solving(_)) || self.ask.awaited.is_some()
    }

    fn is_empty(&self, error: &FieldError) -> bool {
        let place = self.form.draft.at(&self.entry.shape(), &error.path);
        match place {
            Ok((Draft::Leaf(text), _)) => text.trim().is_empty(),
            // Of a choice, none is made.
            Ok((Draft::Absent, _)) => true,
            _ => false,
        }
    }

    fn exhibits(&self) -> impl Iterator<Item = &Exhibit> {
        self.found.solution.iter().flat_map(|solution| &solution.exhibits)
    }
}

fn plots_of<'a>(solutions: impl Iterator<Item = &'a Solution>) -> impl Iterator<Item = &'a Plot> {
    solutions
        .flat_map(|solution| &solution.exhibits)
        .filter_map(|exhibit| if let Exhibit::Plot(plot) = exhibit { Some(plot) } else { None })
}

//! A problem that is worked on: its inputs, what was found for them, and the document it belongs to.

use std::path::PathBuf;

use dalembert_core::{
    Axis, Draft, Entry, Exhibit, FieldError, LinkedProblem, Plot, ProblemSteps, Record, Solution, SolveError,
    Statement, TableExhibit, Text, UnitSetting,
    cases::Case,
    draft,
    exams::FAMILY,
    file::{self, LinkedFile, TitleBlock},
    linked,
    vary::{self, VariedInput},
};

use dalembert_report::show_answers_in;

use crate::{
    ask::StudyResult,
    files::{Fingerprint, LinkedTexts},
    form::{Form, FormLine, Role},
    solver::{CheckedCase, JobFailure},
    typed::Typed,
};

/// A problem with so many other texts than a published case is a variation of it still.
const MOST_OF_A_CASE: usize = 3;

/// A problem that is worked on.
#[derive(Debug)]
pub struct Problem {
    /// The number among the open problems; those that were opened later have larger ones.
    pub number: u64,
    /// Title, file, and the way answers are shown.
    pub document: Document,
    /// The inputs.
    pub inputs: Inputs,
    /// Results for them.
    pub found: ProblemResults,
    /// Published cases of the analysis.
    pub cases: Vec<CheckedCase>,
    /// The analysis that they are of, and the names of answers that are shown in units of their own.
    known: &'static Entry,
    /// The case that is chosen among them.
    pub case: usize,
    /// True if they are compared with what was printed, or about to be.
    pub checking: bool,
}

/// The inputs of a problem.
#[derive(Debug)]
pub struct Inputs {
    /// Their form.
    pub form: Form,
    /// Notes on what an older file left unsaid, and how it was read.
    pub notes: Vec<Text>,
    /// The tolerances that were typed, by the paths of inputs.
    pub tolerances: Typed<String>,
    /// Errors of what is written.
    wrong: Vec<FieldError>,
    /// Errors of those that are still empty.
    needed: Vec<FieldError>,
}

/// The document that a problem is.
#[derive(Debug)]
pub struct Document {
    /// The title that the user gave it; may be empty.
    pub title: String,
    /// The published case that its inputs began as.
    pub origin: Option<Case>,
    /// True if it was opened as an exercise of a list.
    pub is_exercise: bool,
    /// Title block of its notes.
    pub title_block: TitleBlock,
    /// Units of everything that is shown.
    pub units: UnitSetting,
    /// Display of answers: `(answer, unit and digits)`.
    pub show: Vec<(String, String)>,
    /// True if one of these is otherwise than in the file.
    pub show_changed: bool,
    /// The file.
    pub file: Option<OpenFile>,
    /// The files that it links to, as they were read.
    pub linked: Vec<LinkedFile>,
    /// Texts of those files on disk.
    pub links: LinkedTexts,
    /// The text that was edited of a problem without a file: a save keeps its comments.
    pub commented: String,
    /// Title and inputs as they are in the file, or as the case has them.
    saved: (String, &'static Entry, Draft),
}

/// The file of a problem.
#[derive(Clone, Debug)]
pub struct OpenFile {
    /// The path.
    pub path: PathBuf,
    /// The text in it: comments are kept from it.
    pub text: String,
    /// The mark of its content when it was read or written; `None` where that is not known, after a crash.
    pub fingerprint: Option<Fingerprint>,
}

/// Results for the inputs, which may be those of earlier inputs.
#[derive(Debug, Default)]
pub struct ProblemResults {
    /// The newest solution there is.
    pub solution: Option<Solution>,
    /// The inputs that it belongs to.
    pub of: Option<Draft>,
    /// Reason for which the present inputs have no solution.
    pub failure: Option<JobFailure>,
    /// True if the present inputs are so far from those of the solution that its numbers are hidden until there is
    /// another.
    pub hidden: bool,
    /// True if that belongs to the present inputs.
    pub state: Freshness,
    /// The result that every later one is compared with.
    pub pinned: Option<Solution>,
    /// The number of steps that are revealed, with the answers they lead to; `None` where nothing is covered.
    pub revealed: Option<usize>,
    /// The answer whose steps alone are shown in the working; `None` for all steps.
    pub working_of: Option<String>,
    /// The result of a study, or of its points that are solved; `None` while there is none.
    pub studied: Option<Result<StudyResult, SolveError>>,
}

/// True if what is shown belongs to the present inputs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Freshness {
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

impl Problem {
    /// A problem of an analysis, filled in.
    pub fn new(entry: &'static Entry, title: String, draft: Draft, cases: Vec<CheckedCase>) -> Self {
        Self {
            number: 0,
            document: Document {
                saved: (title.clone(), entry, draft.clone()),
                title,
                origin: None,
                is_exercise: false,
                title_block: TitleBlock::default(),
                units: UnitSetting::default(),
                show: Vec::new(),
                show_changed: false,
                file: None,
                linked: Vec::new(),
                links: LinkedTexts::default(),
                commented: String::new(),
            },
            inputs: Inputs {
                form: Form::new(entry, draft),
                notes: Vec::new(),
                tolerances: Typed::default(),
                wrong: Vec::new(),
                needed: Vec::new(),
            },
            found: ProblemResults::default(),
            cases,
            known: entry,
            case: 0,
            checking: false,
        }
    }

    /// The analysis, or the linked problems.
    pub fn entry(&self) -> &'static Entry {
        self.inputs.form.entry()
    }

    /// The entry that the inputs are of, where it is another one than before.
    pub fn other_entry(&self) -> Option<&'static Entry> {
        Some(self.entry()).filter(|entry| !std::ptr::eq(*entry, self.known))
    }

    /// Follows the inputs to another entry: a problem that has a name or has none any more, whose
    /// answers are called otherwise, and which has other published cases.
    pub fn follow_entry(&mut self, cases: Vec<CheckedCase>) {
        let now = self.entry();
        let before = std::mem::replace(&mut self.known, now);
        (self.cases, self.case, self.checking) = (cases, 0, false);
        let name_in = |of: &'static Entry, entry: &Entry| {
            let is_it =
                |problem: &&LinkedProblem| problem.entry.about.id == entry.about.id && problem.file.is_none();
            of.linked().iter().find(is_it).map(|problem| problem.name)
        };
        let answers = self.document.show.iter_mut().map(|(answer, _)| answer);
        match (linked::unnamed(before), linked::unnamed(self.known)) {
            (Some(main), None) => {
                let Some(name) = name_in(self.known, main) else { return };
                let is_named = |answer: &str| {
                    before
                        .linked()
                        .iter()
                        .any(|other| answer.starts_with(other.name) && !other.name.is_empty())
                };
                answers
                    .filter(|answer| !is_named(answer))
                    .for_each(|answer| *answer = format!("{name}.{answer}"));
            }
            (None, Some(main)) => {
                let Some(name) = name_in(before, main) else { return };
                for answer in answers {
                    if let Some(rest) = answer.strip_prefix(name).and_then(|rest| rest.strip_prefix('.')) {
                        *answer = rest.to_owned();
                    }
                }
            }
            _ => {}
        }
    }

    /// True if there is something to save.
    pub fn is_unsaved(&self) -> bool {
        self.document.show_changed
            || (&self.document.title, &self.inputs.form.draft)
                != (&self.document.saved.0, &self.document.saved.2)
    }

    /// Marks what is on the screen as saved.
    pub fn mark_saved(&mut self) {
        self.document.show_changed = false;
        self.document.saved = (self.document.title.clone(), self.entry(), self.inputs.form.draft.clone());
    }

    /// Marks what is on the screen as in no file: it comes from a crashed session.
    pub fn mark_unsaved(&mut self) {
        self.document.saved.2 = Draft::Absent;
    }

    /// Takes the linked files as they were read again: that is no change of the problem itself.
    pub fn take_files(&mut self, read: file::ProblemFile) {
        self.inputs.form.take_files((read.entry, &read.draft));
        let (_, entry, draft) = &mut self.document.saved;
        (*entry, *draft) = linked::with_files(entry, draft, (read.entry, &read.draft), false);
        (self.inputs.notes, self.document.linked) = (read.notes, read.files);
    }

    /// The text that a save writes.
    pub fn as_text(&self) -> String {
        file::write(&self.as_file(), self.text())
    }

    /// The text that a save is written over, for its comments and its order.
    pub fn text(&self) -> &str {
        self.document.file.as_ref().map_or(&self.document.commented, |file| &file.text)
    }

    /// The problem as it is saved.
    pub fn as_file(&self) -> file::ProblemFile {
        let draft = &self.inputs.form.draft;
        let title = match &self.document.origin {
            Some(case) if self.document.title.is_empty() && case.draft == *draft => case.name.clone(),
            _ => self.document.title.clone(),
        };
        file::ProblemFile {
            entry: self.entry(),
            title,
            // It stands in the text that is written over.
            statement: Statement::default(),
            title_block: self.document.title_block.clone(),
            draft: draft.clone(),
            units: self.document.units,
            show: self.document.show.clone(),
            notes: self.inputs.notes.clone(),
            files: self.document.linked.clone(),
        }
    }

    /// The values of the inputs; `None` while they cannot be read.
    pub fn record(&self) -> Option<Record> {
        self.inputs.form.draft.read(&self.entry().shape()).ok()
    }

    /// A solution of the problem in the units that the problem is shown in: its system, then those chosen for answers.
    pub fn in_its_units(&self, solution: Solution) -> Solution {
        let (draft, shape) = (&self.inputs.form.draft, self.entry().shape());
        let mut solution = solution.in_units_of(self.document.units, draft, &shape);
        // What a file asks for and cannot be is shown as it would be without.
        let _ = show_answers_in(&mut solution, &self.document.show);
        solution
    }

    /// The tolerances that were typed and can be read, in SI.
    pub fn widths(&self, inputs: &[VariedInput]) -> Vec<(String, f64)> {
        let read = |(path, text): &(String, String)| {
            let input = inputs.iter().find(|input| input.path == *path)?;
            Some((path.clone(), input.tolerance(text).ok()?))
        };
        self.inputs.tolerances.0.iter().filter_map(read).collect()
    }

    /// The inputs that are numbers, of these values.
    pub fn numbers(record: &Record) -> Vec<VariedInput> {
        vary::inputs(record)
    }

    /// The name of the problem: its title, or the case it began as, which it is no more once an input was changed, and of
    /// which nothing is said once several were.
    pub fn name(&self) -> Text {
        match &self.document.origin {
            _ if !self.document.title.is_empty() => Text::verbatim(&self.document.title),
            Some(case) if case.draft == self.inputs.form.draft => case.title(),
            Some(case) if case.draft.apart(&self.inputs.form.draft) <= MOST_OF_A_CASE => {
                Text::new("{title} (changed)").with_text("title", case.title())
            }
            Some(_) => Text::from("own data"),
            None => Text::from(""),
        }
    }

    /// The published case that the inputs are, unchanged.
    pub fn published(&self) -> Option<&Case> {
        self.document.origin.as_ref().filter(|case| case.draft == self.inputs.form.draft)
    }

    /// Statement of the exercise or the exam question that the problem is; `None` once an input was changed.
    pub fn statement(&self) -> Option<&Text> {
        let is_one = self.document.is_exercise || self.entry().family() == FAMILY;
        let case = self.published().filter(|_| is_one)?;
        Some(&case.statement).filter(|statement| !statement.is_empty())
    }

    /// Names of the answers that the statement asks for; empty without one.
    pub fn asked(&self) -> &[String] {
        match self.published() {
            Some(case) if self.statement().is_some() => &case.asked,
            _ => &[],
        }
    }

    /// Errors of what is written; an input that is still empty is [needed](Self::needed), not wrong.
    pub fn wrong(&self) -> impl Iterator<Item = &FieldError> {
        self.inputs.wrong.iter()
    }

    /// Texts that the error of the field under the cursor offers in place of what is written there.
    pub fn repairs(&self) -> Vec<String> {
        let Some(FormLine { path, role: Role::Leaf { shape, text }, .. }) = self.inputs.form.line() else {
            return Vec::new();
        };
        if self.wrong().all(|error| error.path != path) {
            return Vec::new();
        }
        draft::repairs(&text, &shape)
    }

    /// Errors of inputs that are still to be filled in.
    pub fn needed(&self) -> impl Iterator<Item = &FieldError> {
        self.inputs.needed.iter()
    }

    /// Takes what was found wrong with the inputs as they are now. Of inputs that differ in more than one field from
    /// those that were solved, or are at fault in several, the numbers found are hidden.
    pub fn find_wrong(&mut self, errors: Vec<FieldError>) {
        let hide = errors.len() > 1 || (!errors.is_empty() && !self.is_near_the_solved());
        self.found.hidden |= hide;
        (self.inputs.needed, self.inputs.wrong) = errors.into_iter().partition(|error| self.is_empty(error));
    }

    /// True if the inputs differ in one field at most from those of the newest solution.
    pub fn is_near_the_solved(&self) -> bool {
        self.found.of.as_ref().is_some_and(|of| of.apart(&self.inputs.form.draft) <= 1)
    }

    /// True if no number of the newest solution may stand beside these inputs.
    pub fn hides_numbers(&self) -> bool {
        self.found.hidden && self.is_stale()
    }

    /// The number of errors, or of inputs that are still empty; `None` where a solution is possible.
    pub fn to_do(&self) -> Option<Text> {
        match (self.inputs.wrong.len(), self.inputs.needed.len()) {
            (0, 0) => None,
            (0, 1) => Some(Text::new("1 value missing")),
            (0, needed) => Some(Text::new("{count} values missing").with("count", needed)),
            (1, _) => Some(Text::new("1 error")),
            (wrong, _) => Some(Text::new("{count} errors").with("count", wrong)),
        }
    }

    /// Place of the first exhibit of a problem or configuration among those that a pane shows; `None` where it has none.
    pub fn first_of(&self, name: &str, is_shown: impl Fn(&Exhibit) -> bool) -> Option<usize> {
        let solution = self.found.solution.as_ref()?;
        let of = |of: &&ProblemSteps| {
            of.name == name && solution.exhibits[of.exhibits.clone()].iter().any(&is_shown)
        };
        let start = solution.problems.iter().find(of)?.exhibits.start;
        Some(solution.exhibits[..start].iter().filter(|exhibit| is_shown(exhibit)).count())
    }

    /// The plots of the newest solution, and those of the study.
    pub fn plots(&self) -> impl Iterator<Item = &Plot> {
        plots_of(self.found.solution.iter()).chain(self.studied())
    }

    /// The same for a plot of some place, the last one where there are fewer.
    pub fn plot_at(&self, at: usize) -> Option<(&Plot, Option<&Plot>)> {
        let plot = Self::nth(self.plots(), at)?;
        let of_pinned = plots_of(self.found.pinned.iter());
        let same = |a: &Axis, b: &Axis| (&a.label, a.unit) == (&b.label, b.unit);
        let pinned =
            Self::nth(of_pinned, at).filter(|pinned| same(&pinned.x, &plot.x) && same(&pinned.y, &plot.y));
        Some((plot, pinned))
    }

    /// The drawings, animations and scenes of the newest solution.
    pub fn drawings(&self) -> impl Iterator<Item = &Exhibit> {
        self.exhibits().filter(|exhibit| exhibit.frames().0 > 0)
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

    /// True if the newest solution does not belong to the present inputs.
    pub fn is_stale(&self) -> bool {
        self.found.state != Freshness::Current || self.found.failure.is_some()
    }

    fn is_empty(&self, error: &FieldError) -> bool {
        let place = self.inputs.form.draft.at(&self.entry().shape(), &error.path);
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

    /// The plots of the study, one for each answer.
    pub fn studied(&self) -> impl Iterator<Item = &Plot> {
        let found = self.found.studied.iter().filter_map(|found| found.as_ref().ok());
        found.flat_map(|found| &found.plots)
    }
}

fn plots_of<'a>(solutions: impl Iterator<Item = &'a Solution>) -> impl Iterator<Item = &'a Plot> {
    solutions
        .flat_map(|solution| &solution.exhibits)
        .filter_map(|exhibit| if let Exhibit::Plot(plot) = exhibit { Some(plot) } else { None })
}

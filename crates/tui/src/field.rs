//! Field mode: a job of balancing in the field as a sequence of pages that are followed without a manual.
//!
//! A job is an ordinary problem of `balancing/field`. A page is lines to be answered, each of which stands for inputs
//! of the problem; which pages there are, and how far the job is, follows from what is filled in. Every number that is
//! not typed comes from the solution of the problem.

mod entry;
pub(crate) mod face;
mod line;
mod lines;
mod words;

use std::path::PathBuf;

use dalembert_core::{Draft, Entry, Text};
use dalembert_units::Style;

use self::entry::{rows, text_at};
pub(crate) use self::{
    entry::{TypedLine, choose, is_answered, option, take, written},
    words::{Tone, remarks, task},
};
pub use self::{
    line::{Choice, FieldLine, Go, LineKind},
    lines::lines,
    words::title,
};
use crate::{keys::KeyContext, problem::Problem, text_entry::TextEntry};

dalembert_core::messages!("../locales/field.pt-BR.ftl");

/// The analysis that solves a job.
pub const ANALYSIS: &str = "balancing/field";

/// A page of a job.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FieldPage {
    /// Rotor and requirement.
    Job,
    /// Phase and angles, as instrument and technician count them.
    Instrument,
    /// The run without trial weights.
    Initial,
    /// A run with a trial weight, counted from 1.
    Trial(usize),
    /// The correction, or the trim after so many check runs.
    Correction(usize),
    /// A check run, counted from 1.
    Check(usize),
    /// The end.
    Report,
}

/// Field mode of a problem: the page and the line that are shown.
#[derive(Clone, Debug)]
pub struct FieldMode {
    /// The page.
    pub page: FieldPage,
    /// The line of the cursor.
    pub line: usize,
    /// The text in it, where it is one of text.
    pub input: TextEntry,
    /// Reason for which the text was not taken, or for which the job does not go on.
    pub fault: Option<Text>,
    /// The file that the job is to be saved in, while it is in none.
    pub path: Option<PathBuf>,
}

/// A blank job.
pub fn blank(entry: &'static Entry) -> Draft {
    let shape = entry.shape();
    let mut draft = Draft::blank(&shape);
    for (path, text) in [
        ("method", "least-squares"),
        ("measured.influence", "not-yet"),
        ("rotor.trial_share", "10 %"),
        ("view.mark", "0 deg"),
    ] {
        draft.set(&shape, path, text).expect("the inputs of field balancing have these");
    }
    draft
}

/// The pages of a job, as far as they are known by now.
pub fn pages(problem: &Problem) -> Vec<FieldPage> {
    let mut pages = vec![FieldPage::Job, FieldPage::Instrument, FieldPage::Initial];
    pages.extend((1..=entry::trials(problem)).map(FieldPage::Trial));
    let checks = rows(problem, "measured.checks");
    for check in 1..=checks.max(1) {
        pages.extend([FieldPage::Correction(check - 1), FieldPage::Check(check)]);
    }
    if is_met(problem) == Some(false) {
        pages.extend([FieldPage::Correction(checks), FieldPage::Check(checks + 1)]);
    }
    pages.push(FieldPage::Report);
    pages
}

/// Returns true if the last check run meets the requirement; `None` while that is not known.
pub fn is_met(problem: &Problem) -> Option<bool> {
    entry::answer(problem, "conformity")?.si().map(|ratio| ratio <= 1.0)
}

/// True if every line of a page that must be answered is.
pub fn is_complete(problem: &Problem, page: FieldPage) -> bool {
    lines(problem, page).iter().all(|line| !line.required || is_answered(problem, line))
}

/// The page at which a job goes on: the first that is not complete. A check run that has not begun is preceded by the
/// correction that it is to check.
fn resumed(problem: &Problem) -> FieldPage {
    let all = pages(problem);
    let at = all.iter().position(|page| !is_complete(problem, *page)).unwrap_or(all.len() - 1);
    match all[at] {
        FieldPage::Check(check) if text_at(problem, &lines::check(check, 1).0).is_empty() => all[at - 1],
        page => page,
    }
}

impl FieldMode {
    /// Field mode where a job goes on; `None` for a problem of another analysis.
    pub fn of(problem: &Problem, path: Option<PathBuf>, style: Style) -> Option<Self> {
        if problem.entry().about.id != ANALYSIS {
            return None;
        }
        let page = resumed(problem);
        let mut mode = Self { page, line: 0, input: TextEntry::default(), fault: None, path };
        mode.turn_to(problem, page, style);
        Some(mode)
    }

    /// The pages of the job, the one that is shown among them: whether a trim follows is not known while the problem is
    /// being solved.
    pub fn pages(&self, problem: &Problem) -> Vec<FieldPage> {
        let mut all = pages(problem);
        if !all.contains(&self.page) {
            all.insert(all.len() - 1, self.page);
        }
        all
    }

    /// The lines of the page.
    pub fn lines(&self, problem: &Problem) -> Vec<FieldLine> {
        lines(problem, self.page)
    }

    /// The line of the cursor.
    pub fn shown(&self, problem: &Problem) -> Option<FieldLine> {
        self.lines(problem).into_iter().nth(self.line)
    }

    /// The place where keys are typed.
    pub fn place(&self, problem: &Problem) -> KeyContext {
        match self.shown(problem) {
            Some(line) if line.is_text() => KeyContext::JobText,
            _ => KeyContext::Job,
        }
    }

    /// Shows a page, with the cursor on its first line that is still to be answered.
    pub fn turn_to(&mut self, problem: &Problem, page: FieldPage, style: Style) {
        self.page = page;
        let all = lines(problem, page);
        let open = |line: &FieldLine| {
            line.kind == LineKind::Title && problem.document.title.is_empty()
                || line.required && !is_answered(problem, line)
        };
        let last = all.iter().position(|line| matches!(line.kind, LineKind::Go(_))).unwrap_or(0);
        self.go_to(problem, all.iter().position(open).unwrap_or(last), style);
    }

    /// Puts the cursor on a line, with its text to be typed over.
    pub fn go_to(&mut self, problem: &Problem, line: usize, style: Style) {
        self.line = line;
        self.fault = None;
        let text = self.shown(problem).map_or_else(String::new, |line| written(problem, &line, style));
        self.input = TextEntry::selected(text);
    }

    /// The line after the one that was answered: the next that must be, or the way on. After the choice of the
    /// requirement it is its value: that of a grade has a default, which is to be seen before it is taken.
    pub fn next_line(&self, problem: &Problem) -> usize {
        let all = self.lines(problem);
        let is_requirement = |line: &FieldLine| {
            matches!(line.kind, LineKind::Choice(Choice::OneOf("rotor.requirement"), _))
                && is_answered(problem, line)
        };
        if all.get(self.line).is_some_and(is_requirement) {
            return self.line + 1;
        }
        let open = |at: &usize| all[*at].required && !is_answered(problem, &all[*at]);
        let after = (self.line + 1..all.len()).find(open);
        let way_on = all.iter().position(|line| matches!(line.kind, LineKind::Go(_)));
        after.or_else(|| (0..all.len()).find(open)).or(way_on).unwrap_or(self.line)
    }
}

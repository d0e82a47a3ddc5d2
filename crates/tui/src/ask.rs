//! Questions beside the results: check of the user's answers, sensitivity to the inputs, studies over an input.
//!
//! What takes time is asked as a job of its own, beside that which solves: see [`Question`].

mod study;

use std::{borrow::Borrow, collections::BTreeSet};

use dalembert_core::{
    Answer, Entry, Record, Refusal, Solution, SolveError, Stop,
    check::{self, Mistake, Verdict},
    sensitivity::{self, Influence},
    study::{Plan, Studied},
    vary,
};
use tui_input::Input;

use crate::tab::Tab;

pub use self::study::{Cell, Kind, Study, Subject};

/// Questions of a problem and their replies.
#[derive(Debug, Default)]
pub struct Ask {
    /// The user's own answers.
    pub check: Check,
    /// Sensitivity of an answer to the inputs.
    pub sensitivity: Sensitivity,
    /// Study of an answer over an input.
    pub study: Study,
    /// The cell that is being typed in.
    pub edit: Option<Input>,
    /// The number of the job that is under way, and the tab that asked.
    pub awaited: Option<(u64, Tab)>,
}

/// The user's own answers.
#[derive(Debug, Default)]
pub struct Check {
    /// The answer under the cursor.
    pub cursor: usize,
    /// Texts typed, by the name of the answer.
    pub typed: Vec<(String, String)>,
    /// The answers that the user asked to see.
    pub seen: BTreeSet<String>,
    /// The slips that give what was typed, for each wrong answer; `None` while they are searched for.
    pub slips: Option<Vec<(String, Vec<Mistake>)>>,
    /// True once the message that everything is right has been shown.
    pub praised: bool,
}

/// Sensitivity of an answer to the inputs.
#[derive(Debug, Default)]
pub struct Sensitivity {
    /// The line under the cursor.
    pub cursor: usize,
    /// The input that it begins with, by its path: that of the cursor of the form when the tab was turned to.
    pub begins: String,
    /// The answer that the user chose, by its name.
    pub answer: Option<String>,
    /// The tolerances that were typed, by the paths of inputs.
    pub tolerances: Vec<(String, String)>,
    /// Result; `None` while it is computed.
    pub found: Option<Result<sensitivity::Sensitivity, SolveError>>,
}

/// Question whose reply takes time.
#[derive(Clone, Debug)]
pub enum Question {
    /// Search for the mistakes that give these answers.
    Slips {
        /// The analysis.
        entry: &'static Entry,
        /// Inputs.
        record: Record,
        /// Their solution.
        solution: Box<Solution>,
        /// The user's answers.
        typed: Vec<(String, String)>,
    },
    /// Sensitivity of an answer to each input.
    Sensitivity {
        /// The analysis.
        entry: &'static Entry,
        /// Inputs.
        record: Record,
        /// The name of the answer.
        answer: String,
        /// The tolerances of inputs, as shares, by their paths.
        tolerances: Vec<(String, f64)>,
    },
    /// A study.
    Study {
        /// The analysis.
        entry: &'static Entry,
        /// Inputs.
        record: Record,
        /// Plan of the study.
        plan: Plan,
    },
}

/// The answer to a [`Question`].
#[derive(Clone, Debug)]
pub enum Reply {
    /// For each wrong answer the slips that give it.
    Slips(Vec<(String, Vec<Mistake>)>),
    /// Influence of each input.
    Sensitivity(Result<sensitivity::Sensitivity, SolveError>),
    /// Result of a study.
    Study(Box<Result<Studied, SolveError>>),
}

/// The tolerance of an input that none is typed for, in its steps.
pub const USUAL: f64 = 1.0;

impl Question {
    /// The answer; `None` when it was stopped.
    pub fn answer(&self, stop: &Stop) -> Option<Reply> {
        match self {
            Question::Slips { entry, record, solution, typed } => {
                match check::slips(entry, record, solution, typed, stop) {
                    Ok(slips) => Some(Reply::Slips(slips)),
                    Err(Refusal::Stopped) => None,
                    Err(Refusal::NoAnswer(_)) => Some(Reply::Slips(Vec::new())),
                }
            }
            Question::Sensitivity { entry, record, answer, tolerances } => {
                let tolerances = (tolerances.as_slice(), USUAL);
                unless_stopped(sensitivity::sensitivity(entry, record, answer, tolerances, stop))
                    .map(Reply::Sensitivity)
            }
            Question::Study { entry, record, plan } => {
                unless_stopped(dalembert_core::study::study(entry, record, plan, stop))
                    .map(|found| Reply::Study(Box::new(found)))
            }
        }
    }
}

impl Ask {
    /// Returns true if a tab waits for its reply. One that has none and does not wait was stopped.
    pub fn waits(&self, tab: Tab) -> bool {
        self.awaited.is_some_and(|(_, asked)| asked == tab)
    }

    /// Returns true if a tab has its reply.
    pub fn is_answered(&self, tab: Tab) -> bool {
        match tab {
            Tab::Check => self.check.slips.is_some(),
            Tab::Sensitivity => self.sensitivity.found.is_some(),
            Tab::Study => self.study.found.is_some(),
            _ => false,
        }
    }

    /// Discards the reply of a tab.
    pub fn forget(&mut self, tab: Tab) {
        match tab {
            Tab::Check => self.check.slips = None,
            Tab::Sensitivity => self.sensitivity.found = None,
            Tab::Study => self.study.found = None,
            _ => {}
        }
    }
}

impl Check {
    /// Text typed for an answer.
    pub fn text(&self, name: &str) -> &str {
        text_of(&self.typed, name)
    }

    /// Takes a text for an answer.
    pub fn set(&mut self, name: &str, text: String) {
        self.slips = None;
        put(&mut self.typed, name, text);
    }

    /// Verdict on the user's answer of that name; `None` where there is none.
    pub fn verdict(&self, solution: &Solution, name: &str) -> Option<Verdict> {
        let text = self.text(name);
        let answer = solution.answer(name).filter(|_| !text.trim().is_empty())?;
        Some(check::compare(answer, text))
    }

    /// Returns true if these answers are complete and right: all that no other of them depends on are present, and none
    /// is wrong.
    pub fn is_right(&self, solution: &Solution, wanted: &[&str]) -> bool {
        let verdict = |name: &str| self.verdict(solution, name);
        solution.last_of(wanted).into_iter().all(|name| verdict(name) == Some(Verdict::Right))
            && self.typed.iter().all(|(name, _)| verdict(name).is_none_or(|found| found == Verdict::Right))
    }
}

impl Sensitivity {
    /// The answers that are numbers, and the place of the one that is asked about.
    pub fn answers<'s>(&self, solution: &'s Solution) -> (Vec<&'s Answer>, usize) {
        chosen(solution, self.answer.as_deref(), &self.begins)
    }

    /// The tolerance that was typed for an input, as it was typed.
    pub fn text(&self, path: &str) -> &str {
        text_of(&self.tolerances, path)
    }

    /// Takes a tolerance.
    pub fn set(&mut self, path: &str, text: String) {
        put(&mut self.tolerances, path, text);
    }

    /// The tolerances that can be read, in SI.
    pub fn widths(&self, inputs: &[vary::Input]) -> Vec<(String, f64)> {
        let read = |(path, text): &(String, String)| {
            let input = inputs.iter().find(|input| input.path == *path)?;
            Some((path.clone(), input.tolerance(text).ok()?))
        };
        self.tolerances.iter().filter_map(read).collect()
    }

    /// The inputs that change the answer, the most influential first; those that do not, last.
    pub fn sorted(&self) -> Vec<&Influence> {
        let Some(Ok(found)) = &self.found else { return Vec::new() };
        let mut sorted: Vec<&Influence> = found.influences.iter().collect();
        let size = |one: &Influence| match one.change(found.value).abs() {
            change if change.is_nan() => 0.0,
            change => change,
        };
        sorted.sort_by(|a, b| size(b).total_cmp(&size(a)));
        sorted
    }
}

/// The answers that are numbers.
pub fn numbers(solution: &Solution) -> Vec<&Answer> {
    solution.answers.iter().filter(|answer| answer.si().is_some()).collect()
}

/// The answers that are numbers, and the place of the one that was chosen; of none, the first that may change with an
/// input.
fn chosen<'s>(solution: &'s Solution, name: Option<&str>, input: &str) -> (Vec<&'s Answer>, usize) {
    let numbers = numbers(solution);
    let named = name.and_then(|name| numbers.iter().position(|answer| answer.name.is(name)));
    let at = named.or_else(|| numbers.iter().position(|answer| solution.may_change(answer, input)));
    (numbers, at.unwrap_or(0))
}

/// The place so many further than `at` among `of`, round and round.
pub(crate) fn turned(at: usize, by: isize, of: usize) -> usize {
    let last = of.saturating_sub(1);
    (at.min(last) as isize + by).rem_euclid(of.max(1) as isize) as usize
}

/// Text typed for a key; empty if there is none.
fn text_of<'t, K: Borrow<Q>, Q: PartialEq + ?Sized>(typed: &'t [(K, String)], key: &Q) -> &'t str {
    typed.iter().find(|(known, _)| known.borrow() == key).map_or("", |(_, text)| text)
}

/// Takes a text for a key.
fn put<K: Borrow<Q>, Q: PartialEq + ToOwned<Owned = K> + ?Sized>(
    typed: &mut Vec<(K, String)>,
    key: &Q,
    text: String,
) {
    match typed.iter_mut().find(|(known, _)| (*known).borrow() == key) {
        Some((_, old)) => *old = text,
        None => typed.push((key.to_owned(), text)),
    }
}

fn unless_stopped<T>(result: Result<T, SolveError>) -> Option<Result<T, SolveError>> {
    if matches!(result, Err(SolveError::Refused(Refusal::Stopped))) { None } else { Some(result) }
}

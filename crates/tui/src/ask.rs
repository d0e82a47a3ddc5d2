//! What a person asks of a problem beside its results: whether an answer of their own is right.
//!
//! What takes time is asked as a job of its own, beside that which solves: see [`Question`].

use std::collections::BTreeSet;

use dalembert_core::{
    Entry, Record, Refusal, Solution, Stop,
    check::{self, Slip, Verdict},
};
use tui_input::Input;

/// What is asked, and what was found.
#[derive(Debug, Default)]
pub struct Ask {
    /// The person's own answers.
    pub check: Check,
    /// The cell that is being typed in.
    pub edit: Option<Input>,
    /// The number of the job that is under way.
    pub awaited: Option<u64>,
}

/// The person's own answers.
#[derive(Debug, Default)]
pub struct Check {
    /// The answer under the cursor.
    pub cursor: usize,
    /// What was typed, by the name of the answer.
    pub typed: Vec<(String, String)>,
    /// The answers that the person asked to see.
    pub seen: BTreeSet<String>,
    /// The slips that give what was typed, for each wrong answer; `None` while they are looked for.
    pub slips: Option<Vec<(String, Vec<Slip>)>>,
    /// Whether it was said that everything is right.
    pub praised: bool,
}

/// What takes time to be answered.
#[derive(Clone, Debug)]
pub enum Question {
    /// Which slips give these answers?
    Slips {
        /// The analysis.
        entry: &'static Entry,
        /// Its inputs.
        record: Record,
        /// Their solution.
        solution: Box<Solution>,
        /// The person's answers.
        typed: Vec<(String, String)>,
    },
}

/// The answer to a [`Question`].
#[derive(Clone, Debug)]
pub enum Reply {
    /// For each wrong answer the slips that give it.
    Slips(Vec<(String, Vec<Slip>)>),
}

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
        }
    }
}

impl Check {
    /// What was typed for an answer.
    pub fn text(&self, name: &str) -> &str {
        self.typed.iter().find(|(known, _)| known == name).map_or("", |(_, text)| text)
    }

    /// Takes a text for an answer.
    pub fn set(&mut self, name: &str, text: String) {
        self.slips = None;
        match self.typed.iter_mut().find(|(known, _)| known == name) {
            Some((_, old)) => *old = text,
            None => self.typed.push((name.to_owned(), text)),
        }
    }

    /// How the person's answer of that name compares with ours; `None` where there is none.
    pub fn verdict(&self, solution: &Solution, name: &str) -> Option<Verdict> {
        let text = self.text(name);
        let answer = solution.answer(name).filter(|_| !text.trim().is_empty())?;
        Some(check::compare(answer, text))
    }

    /// Whether all these answers are there and right.
    pub fn is_right<'n>(&self, solution: &Solution, mut wanted: impl Iterator<Item = &'n str>) -> bool {
        wanted.all(|name| self.verdict(solution, name) == Some(Verdict::Right))
    }
}

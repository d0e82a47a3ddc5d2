//! Questions that a pane asks of a problem beside its results, and that take time: a job of their own answers them,
//! beside that which solves.

use dalembert_core::{
    Entry, Record, Refusal, Solution, SolveError, Stop,
    check::{self, Mistake},
    sensitivity,
    study::{Plan, StudyResult},
};

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
    Study(Box<Result<StudyResult, SolveError>>),
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

fn unless_stopped<T>(result: Result<T, SolveError>) -> Option<Result<T, SolveError>> {
    if matches!(result, Err(SolveError::Refused(Refusal::Stopped))) { None } else { Some(result) }
}

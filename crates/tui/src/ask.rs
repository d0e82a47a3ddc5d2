//! Questions that a pane asks of a problem beside its results, and that take time: a job of their own answers them,
//! beside that which solves.

mod study;

use std::path::PathBuf;

use dalembert_core::{
    Answer, Entry, Record, Refusal, Solution, SolveError, Stop,
    check::{self, Causes},
    sensitivity,
    study::StudyPlan,
};

pub use study::{StudyProgress, StudyResult};

/// Question whose reply takes time.
#[derive(Clone, Debug)]
pub enum Question {
    /// Search for the mistakes that give these answers.
    Causes {
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
        /// Their answers.
        answers: Vec<Answer>,
        /// Plan of the study.
        plan: Box<StudyPlan>,
        /// The folder of the files that it names.
        folder: PathBuf,
    },
    /// Search for the values of an input at which an answer is a wanted one.
    Find {
        /// The analysis.
        entry: &'static Entry,
        /// Inputs.
        record: Record,
        /// The path of the input, and its range in SI.
        input: (String, [f64; 2]),
        /// The answer, and its wanted value in SI.
        answer: (Box<Answer>, f64),
    },
}

/// The answer to a [`Question`].
#[derive(Clone, Debug)]
pub enum Reply {
    /// For each wrong answer the causes that give it.
    Causes {
        /// Causes that were found.
        found: Causes,
        /// True if the search has come to its end.
        is_whole: bool,
    },
    /// Influence of each input.
    Sensitivity(Result<sensitivity::Sensitivity, SolveError>),
    /// Result of a study, of all its points or of those that are solved so far; of a search.
    Study(Box<Result<StudyResult, SolveError>>),
}

impl Question {
    /// The answer; `None` when it was stopped. What is found before the end is reported.
    pub fn answer(&self, stop: &Stop, report: &dyn Fn(Reply)) -> Option<Reply> {
        match self {
            Question::Causes { entry, record, solution, typed } => {
                let mut so_far = |found| report(Reply::Causes { found, is_whole: false });
                let found = check::causes(entry, record, solution, typed, stop, Some(&mut so_far));
                stop.check().is_ok().then_some(Reply::Causes { found, is_whole: true })
            }
            Question::Sensitivity { entry, record, answer, tolerances } => {
                let tolerances = (tolerances.as_slice(), sensitivity::USUAL);
                unless_stopped(sensitivity::sensitivity(entry, record, answer, tolerances, stop))
                    .map(Reply::Sensitivity)
            }
            Question::Study { entry, record, answers, plan, folder } => {
                let report = |so_far| report(Reply::Study(Box::new(Ok(so_far))));
                unless_stopped(study::carry_out((entry, record), answers, (plan, folder), stop, &report))
                    .map(|found| Reply::Study(Box::new(found)))
            }
            Question::Find { entry, record, input: (input, range), answer: (answer, wanted) } => {
                unless_stopped(study::find((entry, record), (input, *range), (answer, *wanted), stop))
                    .map(|found| Reply::Study(Box::new(found)))
            }
        }
    }
}

impl Reply {
    /// Returns true if more is to come.
    pub fn is_partial(&self) -> bool {
        match self {
            Reply::Causes { is_whole, .. } => !is_whole,
            Reply::Study(found) => found.as_ref().as_ref().is_ok_and(|found| found.progress.is_some()),
            Reply::Sensitivity(_) => false,
        }
    }
}

fn unless_stopped<T>(result: Result<T, SolveError>) -> Option<Result<T, SolveError>> {
    if matches!(result, Err(SolveError::Refused(Refusal::Stopped))) { None } else { Some(result) }
}

//! Causes of wrong answers: the one place that calls the search for them in `dalembert_core::check`.

use dalembert_core::{
    Answer, Entry, Record, Refusal, Solution, Stop, Text,
    check::{self, Change, Mistake, Place, Verdict},
};

/// Accelerations of gravity that people take.
const MOST_GRAVITIES: usize = 4;

/// Number that a usual mistake gives in place of an answer.
#[derive(Clone, Debug, PartialEq)]
pub struct CommonError {
    /// The number, in SI.
    pub si: f64,
    /// Description of the mistake.
    pub text: Text,
}

/// Probable cause of a wrong answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Cause {
    /// Kind, which decides on credit.
    pub kind: CauseKind,
    /// Description of the mistake.
    pub text: Text,
}

/// Kind of a cause.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CauseKind {
    /// The answer follows from wrong answers before it.
    CarriedForward,
    /// Sign or unit of the answer itself.
    SignOrUnit,
    /// Anything else.
    Other,
}

/// Values that usual mistakes give in place of an answer, at most `most` of them, the most frequent first. Another
/// acceleration of gravity is no mistake.
///
/// # Errors
/// [`Refusal::Stopped`] alone.
pub fn common_errors(
    entry: &Entry,
    record: &Record,
    solution: &Solution,
    (answer, most): (&str, usize),
    stop: &Stop,
) -> Result<Vec<CommonError>, Refusal> {
    // Some more, since another acceleration of gravity may be among them.
    let found = check::common_errors(entry, record, solution, (answer, most + MOST_GRAVITIES), stop)?;
    let is_error = |(_, mistake): &&(f64, Mistake)| !matches!(mistake.change, Change::Gravity(_));
    let errors = found.iter().filter(is_error).take(most);
    Ok(errors.map(|(si, mistake)| CommonError { si: *si, text: mistake.text(solution) }).collect())
}

/// For each wrong answer its probable cause; none where no usual mistake gives it.
///
/// # Errors
/// [`Refusal::Stopped`] alone.
pub fn causes(
    entry: &Entry,
    record: &Record,
    solution: &Solution,
    typed: &[(String, String)],
    stop: &Stop,
) -> Result<Vec<(String, Cause)>, Refusal> {
    let found = check::causes(entry, record, solution, typed, stop, None);
    stop.check()?;
    let first = |(name, causes): (String, Vec<check::Cause>)| {
        let cause = causes.into_iter().next().filter(|cause| cause.is_named)?;
        let kind = match (&cause.mistakes[..], &cause.mistakes.first()?.change) {
            (_, Change::Follows(_)) => CauseKind::CarriedForward,
            ([one], Change::Sign | Change::Unit { .. }) if one.place == Place::Answer => {
                CauseKind::SignOrUnit
            }
            _ => CauseKind::Other,
        };
        Some((name, Cause { kind, text: cause.text(solution) }))
    };
    Ok(found.into_iter().filter_map(first).collect())
}

/// Comparison of a typed answer with the computed one.
pub fn compare(answer: &Answer, typed: &str) -> Verdict {
    check::compare(answer, typed)
}

/// Value of a typed answer, in SI.
///
/// # Errors
/// Why it cannot be read.
pub fn value(answer: &Answer, typed: &str) -> Result<f64, Text> {
    check::value(answer, typed)
}

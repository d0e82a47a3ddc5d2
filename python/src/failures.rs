//! Failures of requests as exceptions of Python.

use dalembert::request::{FailureKind, RequestError, RequestFailure};
use dalembert_core::{FieldError, Locale, Refusal, SolveError, Text};
use dalembert_study::StudyError;
use pyo3::prelude::*;

/// The exception of a failure: `InputError`, `Refusal` or `InternalError`, each with its `errors`.
pub(crate) fn raised(py: Python<'_>, failure: RequestFailure) -> PyErr {
    let name = match failure.kind {
        FailureKind::Input => "InputError",
        FailureKind::Refusal => "Refusal",
        FailureKind::Internal => "InternalError",
    };
    let errors: Vec<_> = failure
        .errors
        .into_iter()
        .map(|error| (error.path, error.message, error.repair, error.line))
        .collect();
    let exception = py
        .import("dalembert._errors")
        .and_then(|module| module.getattr(name))
        .and_then(|class| class.call1((errors,)));
    exception.map_or_else(|error| error, PyErr::from_value)
}

/// A failure of the input at a path.
pub(crate) fn input(path: &str, why: &Text, locale: &Locale) -> RequestFailure {
    of_fields(vec![FieldError::new(path, why.clone())], locale)
}

/// Errors of inputs, or of a plan.
pub(crate) fn of_fields(errors: Vec<FieldError>, locale: &Locale) -> RequestFailure {
    let one = |error: FieldError| RequestError {
        message: format!("{}: {}", error.path, error.why.render(locale)),
        path: error.path,
        repair: None,
        line: None,
    };
    RequestFailure { kind: FailureKind::Input, errors: errors.into_iter().map(one).collect() }
}

/// Error of a solve.
pub(crate) fn of_solve(error: SolveError, locale: &Locale) -> RequestFailure {
    match error {
        SolveError::Fields(errors) => of_fields(errors, locale),
        SolveError::Refused(Refusal::NoAnswer(why)) => {
            RequestFailure { kind: FailureKind::Refusal, ..input("", &why, locale) }
        }
        SolveError::Refused(Refusal::Stopped) => {
            RequestFailure { kind: FailureKind::Internal, ..input("", &Text::verbatim("stopped"), locale) }
        }
    }
}

/// Error of a study.
pub(crate) fn of_study(error: StudyError, locale: &Locale) -> RequestFailure {
    match error {
        StudyError::Solve(error) => of_solve(error, locale),
        other => input("", &other.text(), locale),
    }
}

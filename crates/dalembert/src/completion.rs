//! Completion of a command line in a shell: ids of analyses, problem files, paths of inputs, names of answers.
//!
//! The shell calls the program for every completion ([`VARIABLE`]), so that what it offers belongs to the problem that
//! stands on the line.

use std::{
    ffi::{OsStr, OsString},
    fs,
    path::Path,
};

use clap_complete::engine::{ArgValueCompleter, CompletionCandidate, PathCompleter, ValueCompleter as _};
use dalembert_core::{Entry, Locale, Record, Stop, Text, cases, catalogue, file, find, vary};

use crate::console;

/// The environment variable by which a shell asks for completions.
pub(crate) const VARIABLE: &str = "DALEMBERT_COMPLETE";

/// Ids of analyses.
pub(crate) fn ids() -> ArgValueCompleter {
    ArgValueCompleter::new(|current: &OsStr| analyses(current))
}

/// Ids of analyses and files.
pub(crate) fn problems() -> ArgValueCompleter {
    ArgValueCompleter::new(|current: &OsStr| {
        let mut found = analyses(current);
        found.extend(PathCompleter::file().complete(current));
        found
    })
}

/// Paths of the inputs of the problem on the line, each followed by `=`.
pub(crate) fn settings() -> ArgValueCompleter {
    ArgValueCompleter::new(|current: &OsStr| {
        let mut found = Vec::new();
        if let Some((_, record)) = problem() {
            record.leaves(&mut |path, field, _| found.push((format!("{path}="), field.title())));
        }
        offered(found, current)
    })
}

/// Paths of the inputs of the problem on the line that are numbers.
pub(crate) fn numbers(end: &'static str) -> ArgValueCompleter {
    ArgValueCompleter::new(move |current: &OsStr| {
        let inputs = problem().map(|(_, record)| vary::inputs(&record)).unwrap_or_default();
        let all = inputs.into_iter().map(|input| (format!("{}{end}", input.path), input.label));
        offered(all, current)
    })
}

/// Names of the answers of the problem on the line.
pub(crate) fn answers(end: &'static str) -> ArgValueCompleter {
    ArgValueCompleter::new(move |current: &OsStr| {
        let solution = problem().and_then(|(entry, record)| entry.solve(&record, &Stop::new()).ok());
        let answers = solution.map(|solution| solution.answers).unwrap_or_default();
        let all = answers.into_iter().map(|answer| (format!("{}{end}", answer.name), answer.title()));
        offered(all, current)
    })
}

fn analyses(current: &OsStr) -> Vec<CompletionCandidate> {
    let all = catalogue().iter().map(|entry| (entry.about.id.to_owned(), Text::from(entry.about.title)));
    offered(all, current)
}

/// Those that begin with what is typed.
fn offered(all: impl IntoIterator<Item = (String, Text)>, current: &OsStr) -> Vec<CompletionCandidate> {
    let current = current.to_string_lossy();
    let locale = Locale::of(console::requested_language(&[], None));
    all.into_iter()
        .filter(|(value, _)| value.starts_with(&*current))
        .map(|(value, help)| CompletionCandidate::new(value).help(Some(help.render(&locale).into())))
        .collect()
}

/// The problem on the command line that is completed: the first case of an analysis, or a file.
fn problem() -> Option<(&'static Entry, Record)> {
    let words: Vec<OsString> = std::env::args_os().skip(1).collect();
    words.iter().filter_map(|word| word.to_str()).find_map(|word| {
        if let Some(entry) = find(word) {
            return Some((entry, cases::first(entry)?.record(entry).ok()?));
        }
        let text = fs::read_to_string(Path::new(word)).ok().filter(|text| file::is_problem(text))?;
        let problem = file::parse(&text).ok()?;
        let record = problem.draft.read(&problem.entry.shape()).ok()?;
        Some((problem.entry, record))
    })
}

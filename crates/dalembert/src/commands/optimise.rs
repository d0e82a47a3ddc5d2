//! `dalembert optimise`

use std::{ffi::OsStr, path::Path, process::ExitCode};

use dalembert_core::{Determined, Goal, Text};

use crate::{
    arguments::Optimise,
    commands::solve::{self, Destination},
    console::Console,
    failure::Failure,
    output,
    problem::{self, LoadedProblem, ProblemSource},
};

/// Finds the best values of the inputs, and prints the worked solution with them, or writes it or the problem to a file.
pub(crate) fn run(asked: &Optimise, console: &Console) -> Result<ExitCode, Failure> {
    let (changes, given) = requirements(asked)?;
    if let Some(path) = &asked.output {
        output::allowed(path, Path::new(&asked.problem), asked.force)?;
    }
    let source = ProblemSource {
        case: problem::first_case(&asked.problem, asked.case, &asked.set),
        changes: &changes,
        ask: &asked.ask,
        given: &given,
        ..ProblemSource::named(&asked.problem)
    };
    let problem = problem::read(&source, console)?;
    is_wanted(&problem)?;
    let outcome = solve::outcome(&problem)?;
    let path = asked.output.as_deref();
    if let Some(path) = path.filter(|path| path.extension() == Some(OsStr::new("toml"))) {
        let solution = outcome.map_err(Failure::Refused)?;
        let Some(found) = solution.determined.as_deref() else { return Err(nothing_wanted()) };
        output::write(path, &text_of_optimum(&problem, found)?, asked.force)?;
        return Ok(ExitCode::SUCCESS);
    }
    let destination = Destination {
        problem: &asked.problem,
        form: &asked.form,
        path,
        force: asked.force,
        digits: asked.digits,
        answers: &[],
    };
    solve::write(&problem, &outcome, &destination, console)
}

/// The inputs to change and the answers that something is required of, as `dalembert solve` has them.
fn requirements(asked: &Optimise) -> Result<(Vec<String>, Vec<String>), Failure> {
    let mut errors = Vec::new();
    let mut changes = asked.set.clone();
    for text in &asked.vary {
        match text.split_once('=') {
            Some((input, values)) if !values.trim().is_empty() => {
                changes.push(format!("{}=? {}", input.trim(), values.trim().trim_start_matches('?')));
            }
            _ => {
                let why = Text::new(
                    "--vary {text}: write an input and its range or values, as in --vary 'stiffness=20 kN/m .. 80 kN/m'",
                );
                errors.push(why.with("text", text));
            }
        }
    }
    let extremes = [(&asked.minimise, "minimum"), (&asked.maximise, "maximum")];
    let mut given: Vec<String> = extremes
        .into_iter()
        .flat_map(|(names, word)| names.iter().map(move |name| format!("{}={word}", name.trim())))
        .collect();
    for text in &asked.limit {
        match text.find(['<', '>', '≤', '≥']) {
            Some(at) if at > 0 => given.push(format!("{}={}", text[..at].trim(), &text[at..])),
            _ => {
                let why = Text::new(
                    "--limit {text}: write an answer and a value, as in --limit 'amplitude > 0.2 mm'",
                );
                errors.push(why.with("text", text));
            }
        }
    }
    if errors.is_empty() { Ok((changes, given)) } else { Err(Failure::Input(errors)) }
}

/// Refuses a problem in which no answer is to be the least or the largest.
fn is_wanted(problem: &LoadedProblem) -> Result<(), Failure> {
    if problem.record.goals().any(Goal::is_extreme) { Ok(()) } else { Err(nothing_wanted()) }
}

fn nothing_wanted() -> Failure {
    Failure::input(
        "no answer is to be the least or the largest: add --minimise or --maximise, as in --minimise amplitude, and inputs to choose, as in --vary 'stiffness=20 kN/m .. 80 kN/m'",
    )
}

/// The problem with the optimum in place of the unknowns, written over the text of its file where it has one.
fn text_of_optimum(problem: &LoadedProblem, found: &Determined) -> Result<String, Failure> {
    let mut draft = problem.draft.clone();
    draft
        .take_found(&problem.entry.shape(), found)
        .map_err(|error| Failure::Fault(format!("{}: {}", error.path, error.why.english())))?;
    Ok(problem.file_text(draft))
}

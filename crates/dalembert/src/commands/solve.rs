//! `dalembert solve`

use std::process::ExitCode;

use dalembert_core::{Locale, Text};
use dalembert_report::{Worked, csv, csv_tables, document, json, markdown, show_answer_in};
use dalembert_tui::files::{self, Before};

use crate::{
    arguments::{Format, Solve},
    console::{Console, print},
    failure::Failure,
    problem::{self, Problem},
    solving,
};

/// Solves a problem and prints what came of it.
pub(crate) fn run(solve: &Solve, console: &Console) -> Result<ExitCode, Failure> {
    let mut problem = problem::read(&solve.problem, solve.case, &solve.set, console)?;
    for asked in &solve.unit {
        let (answer, unit) = asked.split_once('=').ok_or_else(|| {
            let why = Text::new("--unit {asked}: write an answer and a unit, as in --unit amplitude=um");
            Failure::input(why.with("asked", asked))
        })?;
        problem.show.push((answer.trim().to_owned(), unit.trim().to_owned()));
    }
    let mut locale = console.locale;
    locale.style.digits = solve.digits.unwrap_or(locale.style.digits);
    let outcome = outcome(&problem)?;
    let worked = worked(&problem, &outcome);
    let text = match solve.format {
        Format::Text => console.laid_out(document(&worked, &locale)),
        Format::Markdown => markdown(&document(&worked, &locale).map(&|words| console.plain(words))),
        Format::Json => format!("{:#}\n", json(&worked, &locale)),
        Format::Csv => spreadsheet(&worked, &solve.table, &locale)?,
    };
    match &solve.output {
        Some(path) => drop(files::save(path, &text, Before::Whatever)?),
        None => print(&text)?,
    }
    status(&worked)
}

/// Prints the worked solution of a problem on the screen.
pub(crate) fn print_worked(problem: &Problem, console: &Console) -> Result<ExitCode, Failure> {
    let outcome = outcome(problem)?;
    let worked = worked(problem, &outcome);
    console.print(document(&worked, &console.locale))?;
    status(&worked)
}

/// What a problem comes to, its answers in the units that are asked for.
fn outcome(problem: &Problem) -> Result<solving::Outcome, Failure> {
    let mut outcome = solving::solve(problem.entry, &problem.record)?;
    if let Ok(solution) = &mut outcome {
        for (answer, unit) in &problem.show {
            show_answer_in(solution, answer, unit).map_err(Failure::input)?;
        }
    }
    Ok(outcome)
}

fn worked<'p>(problem: &'p Problem, outcome: &'p solving::Outcome) -> Worked<'p> {
    Worked {
        entry: problem.entry,
        case: &problem.name,
        source: &problem.source,
        note: &problem.note,
        draft: &problem.draft,
        record: &problem.record,
        outcome: outcome.as_ref(),
    }
}

fn spreadsheet(worked: &Worked<'_>, table: &str, locale: &Locale) -> Result<String, Failure> {
    csv(worked, table, locale).ok_or_else(|| {
        let why = Text::new("there is no table `{table}`; write one of {known}");
        Failure::input(why.with("table", table).with("known", csv_tables(worked).join(", ")))
    })
}

/// 1 for a refusal, a failed check or a defect.
fn status(worked: &Worked<'_>) -> Result<ExitCode, Failure> {
    let solution = worked.outcome.map_err(|why| Failure::Refused(why.clone()))?;
    let sound = solution.checks.iter().all(|check| check.passed) && solution.defects.is_empty();
    Ok(if sound { ExitCode::SUCCESS } else { ExitCode::from(1) })
}

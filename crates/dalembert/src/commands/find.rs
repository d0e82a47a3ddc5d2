//! `dalembert find`

use std::process::ExitCode;

use dalembert_core::{Determined, Locale, Solution, Text, find as analysis};
use dalembert_report::{json, json_text, unknown_formula};
use dalembert_units as units;

use crate::{
    arguments::Find,
    console::{Console, print},
    failure::Failure,
    problem::{self, ProblemOptions, ProblemSource},
    solving,
};

/// Makes an input unknown and gives an answer, and prints every solution in the range.
pub(crate) fn run(find: &Find, console: &Console) -> Result<ExitCode, Failure> {
    let range = match (&find.from, &find.to) {
        (Some(from), Some(to)) => format!("? {from} .. {to}"),
        _ => "?".to_owned(),
    };
    let changes = [format!("{}={range}", find.input)];
    let given = [find.answer.clone()];
    let asked = ProblemSource {
        case: find.case.or_else(|| analysis(&find.problem).map(|_| 1)),
        changes: &changes,
        given: &given,
        options: ProblemOptions {
            input: "--input",
            given: "--answer",
            given_form: "write an answer and its value, as in --answer 'natural_frequency=8.2 Hz'",
        },
        ..ProblemSource::named(&find.problem)
    };
    let problem = problem::read(&asked, console)?;
    let outcome = solving::solve(problem.entry, &problem.record)?;
    let mut locale = console.locale.at(problem.entry.about.id);
    locale.style.digits = find.digits.unwrap_or(locale.style.digits);
    let worked = problem.worked(&outcome);
    if find.json {
        let all = json(&worked, &locale);
        let keys = ["analysis", "notes", "unknowns", "warnings", "refusal"];
        let shown = keys.into_iter().map(|key| (key.to_owned(), all[key].clone())).collect();
        print(&json_text(&serde_json::Value::Object(shown)))?;
    }
    let solution = outcome.as_ref().map_err(|why| Failure::Refused(why.clone()))?;
    if let (false, Some(determined)) = (find.json, &solution.determined) {
        for line in lines(solution, determined, &locale) {
            print(&format!("{}\n", console.plain(&line)))?;
        }
    }
    Ok(ExitCode::SUCCESS)
}

/// Lines of the output: the question, each solution, and whether there are others.
fn lines(solution: &Solution, determined: &Determined, locale: &Locale) -> Vec<String> {
    let written = |si: f64, unit: &units::Unit| units::write_quantity(si, unit, locale.style);
    let mut lines = Vec::new();
    for unknown in &determined.unknowns {
        for given in &determined.givens {
            let text = Text::new("{unknown} for {answer} = {value}, from {from} to {to}:")
                .with_text("unknown", unknown.label.clone())
                .with_text("answer", given.label.clone())
                .with("value", written(given.given, &given.unit))
                .with("from", written(unknown.range[0], &unknown.unit))
                .with("to", written(unknown.range[1], &unknown.unit));
            lines.push(text.render(locale));
        }
    }
    for values in &determined.solutions {
        let values = determined.unknowns.iter().zip(values);
        let values =
            values.map(|(unknown, si)| format!("{} = {}", unknown.name, written(*si, &unknown.unit)));
        lines.push(format!("  {}", values.collect::<Vec<_>>().join(", ")));
    }
    let text = match unknown_formula(solution, locale) {
        Some(formula) => {
            Text::new("these are all solutions in the range: {formula}").with("formula", formula)
        }
        None if determined.unknowns.len() == 1 => {
            Text::new("found at {points} points of the range").with("points", determined.points)
        }
        None => Text::new("found from {points} starts").with("points", determined.points),
    };
    lines.push(text.render(locale));
    lines
}

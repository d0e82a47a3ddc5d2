//! `dalembert find`

mod limits;
mod proof;
mod reading;

use std::process::ExitCode;

use dalembert_core::{Determined, Locale, Solution, Text, find as analysis};
use dalembert_report::{json, json_text, unknown_formula};
use dalembert_study::ranges::{FoundRanges, Relation};
use dalembert_units as units;

use crate::{
    arguments::Find,
    console::{Console, print},
    failure::Failure,
    problem::{self, ProblemOptions, ProblemSource},
    solving,
};

/// Solutions nearer to each other than this share of themselves are one.
const SAME: f64 = 1e-7;

/// The values of an input that are asked for.
struct Asked<'f> {
    arguments: &'f Find,
    case: Option<u32>,
    input: &'f str,
    answer: &'f str,
    relation: Relation,
    value: &'f str,
}

/// Prints every value of an input in the range with which an answer is the given one, or within a limit.
pub(crate) fn run(find: &Find, console: &Console) -> Result<ExitCode, Failure> {
    let input = find.input.as_deref().or(find.input_option.as_deref()).unwrap_or_default();
    let wanted = find.answer.as_deref().or(find.answer_option.as_deref()).unwrap_or_default();
    let case = problem::first_case(&find.problem, find.case, &find.set);
    let (answer, relation, value) = requirement(wanted);
    let asked = Asked { arguments: find, case, input, answer, relation, value };
    match relation {
        Relation::Equal => equal(&asked, wanted, console),
        Relation::AtMost | Relation::AtLeast => limits::run(&asked, console),
    }
}

impl Asked<'_> {
    /// The inputs to change for the problem without an unknown: where it begins with none, the input is set to the beginning of
    /// its range.
    fn changes(&self) -> Vec<String> {
        let is_blank = self.case.is_none() && analysis(&self.arguments.problem).is_some();
        let begin = self.arguments.from.as_ref().filter(|_| is_blank);
        let begin = begin.map(|from| format!("{}={from}", self.input));
        self.arguments.set.iter().cloned().chain(begin).collect()
    }
}

/// Reads `ANSWER=VALUE`, `ANSWER<=VALUE` or `ANSWER>=VALUE`.
fn requirement(text: &str) -> (&str, Relation, &str) {
    let Some(at) = text.find(['<', '>', '≤', '≥']) else {
        let (answer, value) = text.split_once('=').unwrap_or((text, ""));
        return (answer.trim(), Relation::Equal, value.trim());
    };
    let (answer, rest) = text.split_at(at);
    let relation = if rest.starts_with(['<', '≤']) { Relation::AtMost } else { Relation::AtLeast };
    let value = rest.trim_start_matches(['<', '>', '≤', '≥']);
    (answer.trim(), relation, value.strip_prefix('=').unwrap_or(value).trim())
}

/// Makes an input unknown and gives an answer, and prints every solution in the range.
fn equal(asked: &Asked<'_>, wanted: &str, console: &Console) -> Result<ExitCode, Failure> {
    let find = asked.arguments;
    let range = match (&find.from, &find.to) {
        (Some(from), Some(to)) => format!("? {from} .. {to}"),
        _ => "?".to_owned(),
    };
    let changes: Vec<String> = find.set.iter().cloned().chain([format!("{}={range}", asked.input)]).collect();
    let given = [wanted.to_owned()];
    let source = ProblemSource {
        case: asked.case,
        changes: &changes,
        given: &given,
        options: ProblemOptions {
            input: "--input",
            given: "--answer",
            given_form: "write an answer and its value, as in --answer 'natural_frequency=8.2 Hz'",
        },
        ..ProblemSource::named(&find.problem)
    };
    let problem = problem::read(&source, console)?;
    let outcome = solving::solve(problem.entry, &problem.record)?;
    let mut locale = console.locale.at(problem.entry.about.id);
    locale.style.digits = find.digits.unwrap_or(locale.style.digits);
    let determined = outcome.as_ref().ok().and_then(|solution| solution.determined.as_deref());
    let proof = proof::of(asked, determined.map(|determined| determined.unknowns[0].range))?;
    let missed = proof.as_ref().map_or_else(Vec::new, |found| missed(found, determined));
    if find.json {
        let worked = problem.worked(&outcome);
        let all = json(&worked, &locale);
        let keys = ["analysis", "notes", "unknowns", "warnings", "refusal"];
        let mut shown: serde_json::Map<String, serde_json::Value> =
            keys.into_iter().map(|key| (key.to_owned(), all[key].clone())).collect();
        let proof = proof.as_ref().map(|found| proof::json(found, &locale));
        shown.insert("proof".to_owned(), proof.into());
        print(&json_text(&serde_json::Value::Object(shown)))?;
    } else {
        let mut lines = Vec::new();
        if let (Ok(solution), Some(determined)) = (&outcome, determined) {
            lines = solutions(solution, determined, &missed, &locale);
        } else if let Some(found) = &proof {
            let written = |si: &f64| units::write_quantity(*si, &found.input.unit, locale.style);
            lines.extend(missed.iter().map(|si| format!("  {} = {}", asked.input, written(si))));
        }
        lines.extend(proof.iter().flat_map(|found| proof::lines(found, &locale)));
        for line in lines {
            print(&format!("{}\n", console.plain(&line)))?;
        }
    }
    match outcome {
        Err(why) if missed.is_empty() => Err(Failure::Refused(why)),
        _ => Ok(ExitCode::SUCCESS),
    }
}

/// Proven solutions that the search has not found, in SI.
fn missed(found: &FoundRanges, determined: Option<&Determined>) -> Vec<f64> {
    let known: Vec<f64> =
        determined.iter().flat_map(|all| &all.solutions).filter_map(|all| all.first().copied()).collect();
    let middles = found.solutions().into_iter().map(|[from, to]| f64::midpoint(from, to));
    middles.filter(|x| !known.iter().any(|known| (known - x).abs() <= SAME * known.abs())).collect()
}

/// Lines of the output: the question, each solution, and whether there are others.
fn solutions(solution: &Solution, determined: &Determined, missed: &[f64], locale: &Locale) -> Vec<String> {
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
    let missed: Vec<Vec<f64>> = missed.iter().map(|x| vec![*x]).collect();
    for values in determined.solutions.iter().chain(&missed) {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_requirement_is_a_value_or_a_limit() {
        for (text, read) in [
            ("amplitude=2 mm", ("amplitude", Relation::Equal, "2 mm")),
            ("amplitude<=2 mm", ("amplitude", Relation::AtMost, "2 mm")),
            ("amplitude ≤ 2 mm", ("amplitude", Relation::AtMost, "2 mm")),
            ("force[2] < 3 N", ("force[2]", Relation::AtMost, "3 N")),
            ("speed>=-2 m/s", ("speed", Relation::AtLeast, "-2 m/s")),
            ("amplitude", ("amplitude", Relation::Equal, "")),
        ] {
            assert_eq!(requirement(text), read, "{text}");
        }
    }
}

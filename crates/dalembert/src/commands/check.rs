//! `dalembert check`

use std::process::ExitCode;

use dalembert_core::{
    Solution, Stop, Text,
    check::{self, Verdict},
    nearest,
};
use dalembert_report::checked_answers;
use serde_json::{Value as Json, json};

use crate::{
    arguments::Check,
    console::{Console, print, print_json},
    failure::Failure,
    problem::{self, ProblemSource},
    solving,
};

/// Version of the schema of the JSON.
const FORMAT: u32 = 1;

/// Compares answers with the computed ones, and prints the likeliest cause of each wrong one.
pub(crate) fn run(check: &Check, console: &Console) -> Result<ExitCode, Failure> {
    let asked =
        ProblemSource { case: check.case, changes: &check.set, ..ProblemSource::named(&check.problem) };
    let problem = problem::read(&asked, console)?;
    let solution = solving::solve(problem.entry, &problem.record)?.map_err(Failure::Refused)?;
    let locale = console.locale.at(problem.entry.about.id);
    let typed = typed(&check.answers, &solution)?;
    let causes = solving::guarded(problem.entry, || {
        check::causes(problem.entry, &problem.record, &solution, &typed, &Stop::new(), None)
    })?;
    let checked = checked_answers(&solution, &typed, &causes);
    if check.json {
        let answers: Vec<Json> = checked.iter().map(|one| one.json(&solution, &locale)).collect();
        print_json(&json!({ "format": FORMAT, "analysis": problem.entry.about.id, "answers": answers }))?;
    } else {
        for line in checked.iter().flat_map(|one| one.lines(&solution, check.reveal, &locale)) {
            print(&format!("{}\n", console.plain(&line)))?;
        }
    }
    let all_right = checked.iter().all(|one| one.verdict == Verdict::Right);
    Ok(if all_right { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// The answers as they were written: the name of each, and its value.
fn typed(answers: &[String], solution: &Solution) -> Result<Vec<(String, String)>, Failure> {
    let mut typed = Vec::new();
    for written in answers {
        let Some((name, value)) = written.split_once('=') else {
            let why = Text::new("`{written}`: write an answer and its value, as in `amplitude=19.5 mm`");
            return Err(Failure::input(why.with("written", written)));
        };
        let (name, value) = (name.trim(), value.trim());
        let Some(answer) = solution.answers.iter().find(|answer| answer.name.is(name)) else {
            let known: Vec<String> = solution.answers.iter().map(|one| one.name.to_string()).collect();
            let why = match nearest(name, known.iter().map(String::as_str)) {
                Some(near) => {
                    Text::new("there is no answer `{name}`; did you mean `{near}`?").with("near", near)
                }
                None => Text::new("there is no answer `{name}`; the answers are {known}")
                    .with("known", known.join(", ")),
            };
            return Err(Failure::input(why.with("name", name)));
        };
        if value.is_empty() {
            let why = Text::new("the value of `{name}` is missing, as in `{name}={example}`");
            let example = check::example(answer);
            return Err(Failure::input(why.with("name", name).with("example", example)));
        }
        typed.push((answer.name.to_string(), value.to_owned()));
    }
    Ok(typed)
}

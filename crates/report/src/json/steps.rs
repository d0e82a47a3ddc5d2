//! Steps of a worked solution as a graph: each with its number in SI and what its operands come from.

use dalembert_core::{
    AnswerValue, CommonError, Locale, Number, Solution, Text, printer,
    trace::{Id, Op},
};
use serde_json::{Value as Json, json};

use super::with_units;

/// A step as it is written, its value, and the steps, by their numbers, and inputs, by their paths, that its operands
/// come from; where the analysis knows errors that people commonly make in it, what they are and what each gives.
pub(super) fn step(solution: &Solution, n: usize, locale: &Locale) -> Json {
    let step = &solution.steps[n];
    let written = printer::step(solution, step, locale);
    let mut entry = json!({
        "number": n + 1,
        "why": written.why,
        "symbol": written.symbol,
        "formula": written.formula,
        "substitution": written.substitution,
        "result": written.result,
        "source": written.source,
    });
    let value = with_units(&|of| number(solution.trace.node(step.result).number, of), &step.unit);
    let operands = operands(solution, step.formula);
    if let Json::Object(entry) = &mut entry {
        entry.extend(value);
        entry.insert("from_steps".into(), operands.steps.into());
        entry.insert("from_inputs".into(), operands.inputs.into());
    }
    if let Some(problem) = solution.problems.iter().find(|problem| problem.steps.contains(&n)) {
        entry["problem"] = problem.name.into();
    }
    let errors = solution.common_errors.iter().filter(|error| error.step == n);
    let errors = errors.filter_map(|error| common_error(solution, error, &written.result, locale));
    let errors: Vec<Json> = errors.collect();
    if !errors.is_empty() {
        entry["common_errors"] = errors.into();
    }
    entry
}

/// A common error in words, and the number that it gives in place of that of its step; `None` where it is written as the right
/// one is.
fn common_error(solution: &Solution, error: &CommonError, right: &str, locale: &Locale) -> Option<Json> {
    let step = &solution.steps[error.step];
    let wrong = solution.trace.without_noise(error.formula);
    let result = printer::in_place_of_result(solution, step, wrong, locale.style);
    if result == right {
        return None;
    }
    let mut entry = with_units(&|of| number(wrong, of), &step.unit);
    entry.insert("what".into(), error.what.render(locale).into());
    entry.insert("result".into(), result.into());
    Some(Json::Object(entry))
}

/// The number of the step that an answer is the result of, counted from 1.
pub(super) fn step_of(solution: &Solution, value: &AnswerValue) -> Option<usize> {
    let AnswerValue::Number(_, id) = value else { return None };
    match solution.trace.node(*id).op {
        Op::Step(step) => Some(step + 1),
        _ => None,
    }
}

/// A number or a vector, each component written by `of`.
pub(super) fn number(number: Number, of: &dyn Fn(f64) -> f64) -> Json {
    match number {
        Number::Scalar(si) => json!(of(si)),
        Number::Vector(si) => json!(si.map(of)),
    }
}

/// Named operands of a formula: steps by their numbers, inputs by their paths, each once and in the order of the formula.
#[derive(Default)]
struct Operands {
    steps: Vec<usize>,
    inputs: Vec<String>,
}

fn operands(solution: &Solution, formula: Option<Id>) -> Operands {
    let mut found = Operands::default();
    let mut open: Vec<Id> = formula.into_iter().collect();
    let mut seen = std::collections::HashSet::new();
    while let Some(id) = open.pop() {
        if !seen.insert(id) {
            continue;
        }
        match &solution.trace.node(id).op {
            Op::Step(step) => found.steps.push(step + 1),
            // A constant of an analysis has no path.
            Op::Given { path, .. } if !path.is_empty() => found.inputs.push(path.clone()),
            _ => open.extend(solution.trace.operands(id).into_iter().rev()),
        }
    }
    let mut known = std::collections::HashSet::new();
    found.inputs.retain(|path| known.insert(path.clone()));
    found.steps.sort_unstable();
    found.steps.dedup();
    found
}

/// Words of a list in a language.
pub(super) fn words(all: &[Text], locale: &Locale) -> Json {
    all.iter().map(|text| text.render(locale)).collect()
}

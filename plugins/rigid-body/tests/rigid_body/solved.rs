//! Problems solved from their texts, and their answers.

use dalembert_core::{AnswerValue, Number, Solution, Stop, file};
use itertools::Itertools as _;

pub(crate) fn solve(text: &str) -> Solution {
    let problem = file::parse(text).unwrap_or_else(|errors| panic!("{errors:?}\n{text}"));
    let record =
        problem.draft.read(&problem.entry.shape()).unwrap_or_else(|errors| panic!("{errors:?}\n{text}"));
    problem.entry.solve(&record, &Stop::new()).unwrap_or_else(|err| panic!("{err}\n{text}"))
}

/// Every other way agrees, and there is one.
pub(crate) fn sound(solution: &Solution) {
    assert!(solution.defects.is_empty(), "{:?}", solution.defects);
    assert!(solution.checks.iter().all(|check| check.passed), "{:?}", solution.checks);
    assert!(!solution.checks.is_empty());
}

pub(crate) fn vector(solution: &Solution, name: &str) -> [f64; 3] {
    match solution.answer(name).map(|answer| &answer.value) {
        Some(AnswerValue::Number(Number::Vector(value), _)) => *value,
        other => panic!("{name} is no vector: {other:?}"),
    }
}

pub(crate) fn number(solution: &Solution, name: &str) -> f64 {
    solution
        .answer(name)
        .and_then(dalembert_core::Answer::si)
        .unwrap_or_else(|| panic!("{name} is not a number"))
}

pub(crate) fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip_eq(b).fold(0.0f64, |most, (a, b)| most.max((a - b).abs()))
}

pub(crate) fn size(a: [f64; 3]) -> f64 {
    distance(a, [0.0; 3])
}

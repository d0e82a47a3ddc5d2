//! The answers of a solution that are numbers.

use dalembert_core::{Answer, Solution};

/// The answers that are numbers.
pub(super) fn numbers(solution: &Solution) -> Vec<&Answer> {
    solution.answers.iter().filter(|answer| answer.si().is_some()).collect()
}

/// The answers that are numbers, and the place of the one that was chosen; of none, the first that may change with an
/// input.
pub(super) fn chosen<'s>(
    solution: &'s Solution,
    name: Option<&str>,
    input: &str,
) -> (Vec<&'s Answer>, usize) {
    let numbers = numbers(solution);
    let named = name.and_then(|name| numbers.iter().position(|answer| answer.name.is(name)));
    let at = named.or_else(|| numbers.iter().position(|answer| solution.may_change(answer, input)));
    (numbers, at.unwrap_or(0))
}

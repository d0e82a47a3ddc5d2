//! The answers of a solution that are numbers.

use dalembert_core::{Answer, Solution};

/// The answers that are numbers.
pub(super) fn numbers(solution: &Solution) -> Vec<&Answer> {
    solution.answers.iter().filter(|answer| answer.si().is_some()).collect()
}

/// Names of answers with the other limits of the sets that they are limits of: two branches are seen together.
pub(super) fn with_other_limits(solution: &Solution, mut names: Vec<String>) -> Vec<String> {
    for set in &solution.answers {
        let limits: Vec<String> =
            solution.limits_of(set).into_iter().map(|limit| limit.name.to_string()).collect();
        if limits.iter().any(|limit| names.contains(limit)) {
            let missing: Vec<String> = limits.into_iter().filter(|limit| !names.contains(limit)).collect();
            names.extend(missing);
        }
    }
    names
}

/// The answers that are numbers, and the place of the one that was chosen; of none, the first that may change with an
/// input, limits of the first answer before others where that is a set, and what is zero after them.
pub(super) fn chosen<'s>(
    solution: &'s Solution,
    name: Option<&str>,
    input: &str,
) -> (Vec<&'s Answer>, usize) {
    let numbers = numbers(solution);
    let named = name.and_then(|name| numbers.iter().position(|answer| answer.name.is(name)));
    let limits = solution.answers.first().map_or_else(Vec::new, |first| solution.limits_of(first));
    let place = |limit: &&Answer| numbers.iter().position(|answer| answer.name == limit.name);
    let limit = limits.iter().filter(|limit| solution.may_change(limit, input)).find_map(place);
    let changing = || numbers.iter().enumerate().filter(|(_, answer)| solution.may_change(answer, input));
    let nonzero = || changing().find(|(_, answer)| answer.si() != Some(0.0));
    let first = || nonzero().or_else(|| changing().next()).map(|(at, _)| at);
    let at = named.or(limit).or_else(first).unwrap_or(0);
    (numbers, at)
}
